// Chooses the modules of the list: 100 of each kind, by hash, whatever any tool says of them.
//
// A family is what one package holds of one sort. Its candidates come in the order of the hash of their name; the families of a kind take
// turns, and none gets more than its cap. Modules of fewer than 25 instructions are left out except among compiler tests, and so are doubles.
import {compile, sha256} from "./compile.mjs";

const kOfEachKind = 100, kTrivial = 25;

export function choose(all, folder) {
  const rows = [], seen = new Set();
  for (const kind of ["engine", "procedural", "compiler"]) {
    const families = all.filter((family) => family.kind === kind).map((family) => ({...family, taken: 0, rest: ordered(family.candidates)}));
    families.sort((a, b) => (a.name < b.name ? -1 : 1));
    const chosen = [];
    while (chosen.length < kOfEachKind && families.some((family) => family.rest.length && family.taken < family.cap))
      for (const family of families) {
        if (chosen.length === kOfEachKind || family.taken === family.cap) continue;
        const row = next(family, seen, folder);
        if (row) chosen.push(row), ++family.taken;
      }
    console.error(`${kind}: ${chosen.length} (${families.map((family) => `${family.name} ${family.taken}`).join(", ")})`);
    rows.push(...chosen.sort((a, b) => (a.sha256 < b.sha256 ? -1 : 1)));
  }
  return rows;
}

function ordered(candidates) {
  const hash = (candidate) => sha256(`${candidate.package}/${candidate.path}/${candidate.setting || ""}`);
  return candidates.map((candidate) => [hash(candidate), candidate]).sort((a, b) => (a[0] < b[0] ? -1 : 1)).map((pair) => pair[1]);
}

// The family's next candidate that compiles, or null if none is left.
function next(family, seen, folder) {
  while (family.rest.length) {
    const candidate = family.rest.shift(), built = compile(candidate, folder);
    if (!built.bytes || seen.has(built.sha256) || (family.kind !== "compiler" && built.instructions < kTrivial)) continue;
    seen.add(built.sha256);
    return {...candidate, sha256: built.sha256, instructions: built.instructions, how: built.how};
  }
  return null;
}
