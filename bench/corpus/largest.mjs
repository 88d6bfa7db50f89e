// Of the modules named on standard input, the N with the most instructions: "instructions file" each, the largest first.
import fs from "node:fs";

import {describe} from "./module.mjs";

const files = fs.readFileSync(0, "utf8").split("\n").filter(Boolean);
const sized = files.map((file) => [describe(fs.readFileSync(file)).instructions, file]);
sized.sort((a, b) => b[0] - a[0] || (a[1] < b[1] ? -1 : 1));
for (const [count, file] of sized.slice(0, Number(process.argv[2]))) console.log(`${count} ${file}`);
