// Compiles one candidate to a SPIR-V fragment module that passes spirv-val, and reads what the list tells of it.
import {spawnSync} from "node:child_process";
import {createHash} from "node:crypto";
import fs from "node:fs";
import path from "node:path";

import {modernize} from "./glsl.mjs";
import {describe} from "./module.mjs";

export const sha256 = (bytes) => createHash("sha256").update(bytes).digest("hex");

function run(program, words, cwd) {
  const result = spawnSync(program, words, {cwd, encoding: "utf8", timeout: 60000});
  return {ok: result.status === 0, text: (result.stdout || "") + (result.stderr || "")};
}

// People have plain modules, modules with debug info and optimised ones: a third each, by the candidate's hash.
export function variantOf(candidate) {
  const digest = sha256(`${candidate.kind}/${candidate.package}/${candidate.path}/${candidate.setting || ""}`);
  const choice = parseInt(digest.slice(0, 8), 16) % 12;
  const given = candidate.spirv || candidate.assembly;
  if (given) return choice < 8 ? "" : "-O";
  return choice < 4 ? "" : choice < 7 ? "-g" : choice < 8 ? "-gVS" : "-O";
}

// How a text is compiled, one way after the other until one succeeds.
function ways(candidate) {
  if (candidate.assembly) {
    const told = /; Version: 1\.(\d)/.exec(candidate.assembly);
    return [{how: `spirv-as spv1.${told ? told[1] : 0}`, file: "shader.spvasm", text: candidate.assembly, program: "spirv-as",
             words: ["--preserve-numeric-ids", "--target-env", `spv1.${told ? told[1] : 0}`], environment: "vulkan1.2"}];
  }
  const list = [];
  if (candidate.vulkan) {
    list.push({how: "glslangValidator -V", words: ["-V"], text: candidate.vulkan, environment: "vulkan1.0"});
    list.push({how: "glslangValidator -V --target-env vulkan1.2", words: ["-V", "--target-env", "vulkan1.2"], text: candidate.vulkan, environment: "vulkan1.2"});
  }
  if (candidate.gl) {
    list.push({how: "glslangValidator -V -R --aml --amb", words: ["-V", "-R", "--aml", "--amb"], text: modernize(candidate.gl, candidate.before), environment: "vulkan1.0"});
  }
  return list.map((way) => ({...way, file: "shader.frag", program: "glslangValidator"}));
}

function finish(folder, how, environment, variant) {
  const optimise = variant === "-O";
  if (optimise) {
    if (!run("spirv-opt", ["-O", "shader.spv", "-o", "optimised.spv"], folder).ok) return {why: "spirv-opt"};
    fs.renameSync(path.join(folder, "optimised.spv"), path.join(folder, "shader.spv"));
  }
  const valid = run("spirv-val", ["--target-env", environment, "shader.spv"], folder);
  if (!valid.ok) return {why: `spirv-val: ${valid.text.split("\n")[0]}`};
  const bytes = fs.readFileSync(path.join(folder, "shader.spv"));
  const told = describe(bytes);
  if (!told.drawn) return {why: "not one fragment shader with an output"};
  return {bytes, sha256: sha256(bytes), instructions: told.instructions, how: how + (optimise ? ", spirv-opt -O" : "")};
}

// {bytes, sha256, instructions, how} or {why}. The file is always named shader.frag: debug info holds its name.
export function compile(candidate, folder) {
  fs.rmSync(folder, {recursive: true, force: true});
  fs.mkdirSync(folder, {recursive: true});
  const variant = variantOf(candidate);
  if (candidate.spirv) {
    fs.writeFileSync(path.join(folder, "shader.spv"), candidate.spirv);
    return finish(folder, "as given", "vulkan1.2", variant);
  }
  let why = "";
  for (const way of ways(candidate)) {
    fs.writeFileSync(path.join(folder, way.file), way.text);
    const debug = variant.startsWith("-g") && way.program === "glslangValidator" ? [variant] : [];
    const built = run(way.program, [...way.words, ...debug, "-o", "shader.spv", way.file], folder);
    if (!built.ok) {
      why ||= built.text.split("\n").filter((line) => /ERROR|error/.test(line)).slice(0, 2).join(" | ") || built.text.slice(0, 200);
      continue;
    }
    const done = finish(folder, [way.how, ...debug].join(" "), way.environment, variant);
    if (!done.why) return done;
    why ||= done.why;
  }
  return {why};
}
