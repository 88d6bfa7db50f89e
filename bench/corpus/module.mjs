// Reads a SPIR-V binary as far as the list and the benchmarks need it.

// Words of one instruction each: [opcode, operands...].
function* instructions(bytes) {
  const words = new Uint32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
  for (let at = 5; at < words.length; at += Math.max(1, words[at] >>> 16)) yield [words[at] & 0xffff, ...words.subarray(at + 1, at + (words[at] >>> 16))];
}

const kSkipped = new Set([8, 317, 248, 54, 55, 56]);  // OpLine, OpNoLine, OpLabel, OpFunction, OpFunctionParameter, OpFunctionEnd

// instructions: those in function bodies, without labels and debug info. drawn: its one entry point is a fragment shader with an output at a location.
export function describe(bytes) {
  let entries = 0, fragment = false, count = 0, inside = false;
  const located = new Set(), outputs = [], debug = new Set();
  for (const [opcode, ...words] of instructions(bytes)) {
    if (opcode === 15) ++entries, fragment = words[0] === 4;
    if (opcode === 11 && Buffer.from(Uint32Array.from(words.slice(1)).buffer).toString("latin1").startsWith("NonSemantic")) debug.add(words[0]);
    if (opcode === 71 && words[1] === 30) located.add(words[0]);
    if (opcode === 59 && words[2] === 3) outputs.push(words[1]);
    if (opcode === 54) inside = true;
    if (inside && !kSkipped.has(opcode) && !(opcode === 12 && debug.has(words[2]))) ++count;
    if (opcode === 56) inside = false;
  }
  return {instructions: count, drawn: entries === 1 && fragment && outputs.some((id) => located.has(id))};
}
