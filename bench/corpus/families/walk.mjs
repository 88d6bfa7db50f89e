// Files below a folder, sorted, by their path in the root.
import fs from "node:fs";
import path from "node:path";

export function walk(root, folder, pattern) {
  const found = [];
  const visit = (place) => {
    for (const entry of fs.readdirSync(path.join(root, place), {withFileTypes: true})) {
      const name = path.join(place, entry.name);
      if (entry.isDirectory() && entry.name !== ".pc") visit(name);
      else if (entry.isFile() && pattern.test(name)) found.push(name);
    }
  };
  if (fs.existsSync(path.join(root, folder))) visit(folder);
  return found.sort();
}
