// Prints the verdicts of a JSON of `reprise check` by kind of module, their codes, what failed, and modules a second.
import fs from "node:fs";
import path from "node:path";

const [file, before, after] = process.argv.slice(2);
const {modules} = JSON.parse(fs.readFileSync(file, "utf8"));
const verdicts = ["verified", "refused", "unshown", "untestable", "failed", "crashed", "hung"];
for (const module of modules) if (!verdicts.includes(module.verdict)) verdicts.push(module.verdict);

const kindOf = (module) => path.basename(path.dirname(module.path));
const line = (name, list) => {
  const counts = verdicts.map((verdict) => String(list.filter((module) => module.verdict === verdict).length).padStart(11));
  console.log(name.padEnd(12) + String(list.length).padStart(8) + counts.join(""));
};

console.log("kind".padEnd(12) + "modules".padStart(8) + verdicts.map((verdict) => verdict.padStart(11)).join(""));
for (const kind of [...new Set(modules.map(kindOf))]) line(kind, modules.filter((module) => kindOf(module) === kind));
line("all", modules);
const share = (verdict) => `${((100 * modules.filter((module) => module.verdict === verdict).length) / modules.length).toFixed(1)}% ${verdict}`;
console.log(`\n${share("untestable")}, ${share("unshown")}`);

const codes = new Map();
for (const module of modules.filter((entry) => entry.verdict !== "verified")) {
  const name = `${module.verdict} ${module.code ?? ""}`.trim();
  codes.set(name, (codes.get(name) ?? 0) + 1);
}
console.log();
for (const [name, count] of [...codes].sort((a, b) => b[1] - a[1])) console.log(String(count).padStart(6) + "  " + name);

for (const module of modules.filter((entry) => ["failed", "crashed", "hung"].includes(entry.verdict))) console.log(`\n${module.verdict}  ${module.path}\n  ${module.reason ?? ""}`);

const seconds = after - before;
console.log(`\n${modules.length} modules in ${seconds.toFixed(1)} s: ${(modules.length / seconds).toFixed(2)} a second`);
