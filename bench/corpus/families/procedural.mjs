// Images out of formulas: demos, transitions, generators, visualisers, noise.
import fs from "node:fs";
import {createRequire} from "node:module";
import path from "node:path";
import {pathToFileURL} from "node:url";

import {sha256} from "../compile.mjs";
import {expandIncludes} from "../glsl.mjs";
import {walk} from "./walk.mjs";

const read = (root, file) => fs.readFileSync(path.join(root, file), "utf8");

// The names that such texts find declared on their site.
const kToy = `uniform vec3 iResolution;
uniform float iTime, iGlobalTime, iTimeDelta, iSampleRate;
uniform int iFrame;
uniform float iChannelTime[4];
uniform vec3 iChannelResolution[4];
uniform vec4 iMouse, iDate;
uniform sampler2D iChannel0, iChannel1, iChannel2, iChannel3;
layout(location = 0) out vec4 toy_target;
`;
const kToyMain = "\nvoid main() { vec4 c = vec4(0.0, 0.0, 0.0, 1.0); mainImage(c, gl_FragCoord.xy); toy_target = c; }\n";

function toys(root, folder, pattern, declarations = "") {
  const files = walk(root, folder, pattern).filter((file) => /void\s+mainImage/.test(read(root, file)));
  return files.map((file) => ({path: file, gl: read(root, file) + kToyMain, before: kToy + declarations}));
}

function transitions(root) {
  const before = "uniform float progress, ratio;\nuniform sampler2D from_map, to_map;\nlayout(location = 0) in vec2 place;\nlayout(location = 0) out vec4 target;\n" +
      "vec4 getFromColor(vec2 at) { return texture(from_map, at); }\nvec4 getToColor(vec2 at) { return texture(to_map, at); }\n";
  return walk(root, "transitions", /\.glsl$/).map((file) => ({path: file, gl: read(root, file) + "\nvoid main() { target = transition(place); }\n", before}));
}

async function paper(root) {
  const all = await import(pathToFileURL(path.join(root, "dist/index.js")).href);
  return Object.keys(all).filter((name) => name.endsWith("FragmentShader")).sort().map((name) => ({path: `dist/index.js ${name}`, gl: all[name]}));
}

// Presets hold the bodies of two shaders, which the player puts into a frame of its own.
function presets(root, player) {
  const frames = [...read(player, "lib/butterchurn.js").matchAll(/this\.gl\.shaderSource\(fragShader, (.*fragShaderHeaderText.*)\);$/gm)].map((match) => match[1]);
  const folder = "presets/converted", files = walk(root, folder, /\.json$/).filter((file) => sha256(file).startsWith("0"));
  return files.flatMap((file) => {
    const preset = JSON.parse(read(root, file));
    return ["comp", "warp"].flatMap((part, at) => {
      const split = (preset[part] || "").split("shader_body");
      if (split.length < 2) return [];
      const body = split[1].slice(split[1].indexOf("{") + 1, split[1].lastIndexOf("}")).replace(/texture[23]D/g, "texture");
      const gl = new Function("fragShaderHeaderText", "fragShaderText", `return ${frames[at]}`).call({floatPrecision: "highp"}, split[0], body);
      const sizes = [...new Set(gl.match(/\btexsize_\w+/g))].filter((name) => !gl.includes(`uniform vec4 ${name};`));
      return [{path: file.replace(/[^\x20-\x7e]/g, "?"), setting: part, gl, before: sizes.map((name) => `uniform vec4 ${name};\n`).join("")}];
    });
  });
}

async function babylonTextures(root) {
  const files = walk(root, ".", /^\w+\/\w+\.fragment\.js$/);
  return files.map((file) => {
    const text = new Function(`return ${/const shader = (`[^]*?`);/.exec(read(root, file))[1]}`)();
    return {path: file, gl: text.replace(/#include<helperFunctions>/g, "float saturate(float x) { return clamp(x, 0.0, 1.0); }"),
            before: "#define CUSTOM_VERTEX_DEFINITIONS\n#define OCTAVES 5\n"};
  });
}

function isf(root) {
  const Parser = createRequire(import.meta.url)(path.join(root, "src/ISFParser.js"));
  return walk(root, ".", /\.fs$/).flatMap((file) => {
    const parser = new Parser();
    parser.parse(read(root, file), "");
    return parser.valid && parser.fragmentShader ? [{path: file, gl: parser.fragmentShader}] : [];
  });
}

// Sketches: a source, then four steps, drawn by hash from the package's own generators.
async function hydra(root) {
  const {default: Factory} = await import(pathToFileURL(path.join(root, "src/generator-factory.js")).href);
  const {default: functions} = await import(pathToFileURL(path.join(root, "src/glsl/glsl-functions.js")).href);
  const named = (types) => functions().filter((entry) => types.includes(entry.type) && !["src", "prev", "sum"].includes(entry.name)).map((entry) => entry.name).sort();
  const drawn = (list, seed) => list[parseInt(sha256(seed).slice(0, 8), 16) % list.length];
  const factory = new Factory({defaultUniforms: {time: 0, resolution: [1, 1]}, defaultOutput: {precision: "highp", uniforms: {}, render() {}}});
  const make = (seed) => factory.generators[drawn(named(["src"]), seed)]();
  return Array.from({length: 40}, (unused, at) => {
    let sketch = make(`${at}`);
    for (let step = 0; step < 4; ++step) {
      const name = drawn(named(["color", "coord", "combine", "combineCoord"]), `${at}/${step}`);
      sketch = sketch[name](...(named(["combine", "combineCoord"]).includes(name) ? [make(`${at}/${step}/other`)] : []));
    }
    return {path: "src/glsl/glsl-functions.js", setting: `sketch ${at}`, gl: sketch.glsl()[0].frag};
  });
}

// A library has no main: ours calls the file's functions of places and numbers, and adds what they give.
function lygia(root) {
  const given = {float: "place.x * 3.0 + 0.1", vec2: "place * 8.0", vec3: "vec3(place * 4.0, time)", vec4: "vec4(place * 4.0, time, 1.0)", sampler2D: "map", int: "3"};
  const widened = {float: (call) => `vec3(${call})`, vec2: (call) => `vec3(${call}, 0.0)`, vec3: (call) => call, vec4: (call) => `(${call}).rgb`};
  return ["generative", "sdf", "filter", "lighting", "draw", "distort", "animation"].flatMap((folder) => walk(root, folder, /^\w+\/\w+\.glsl$/)).map((file) => {
    const found = read(root, file).matchAll(/^(float|vec[234])\s+(\w+)\s*\(([^()]*)\)\s*\{/gm), calls = [];
    for (const [, type, name, list] of found) {
      const kinds = list.split(",").map((entry) => /^\s*(?:in\s+|const\s+)*(?:highp\s+)?(\w+)\s+\w+\s*$/.exec(entry)?.[1]);
      if (kinds.every((kind) => kind in given)) calls.push(widened[type](`${name}(${kinds.map((kind) => given[kind]).join(", ")})`));
    }
    const main = `\nvoid main() { target = vec4(${calls.slice(0, 3).join(" + ") || "no_call"}, 1.0); }\n`;
    return {path: file, gl: expandIncludes(read(root, file), [path.dirname(path.join(root, file))], true) + main,
            before: "uniform float time;\nuniform sampler2D map;\nlayout(location = 0) in vec2 place;\nlayout(location = 0) out vec4 target;\n"};
  });
}

const plain = (root) => walk(root, ".", /\.(frag|glsl)$/).filter((file) => /gl_FragColor/.test(read(root, file))).map((file) => ({path: file, gl: read(root, file)}));

export async function procedural(root) {
  const families = [];
  const add = async (name, source, cap, list) => {
    if (root(source)) families.push({kind: "procedural", name, package: source, cap, candidates: await list(root(source))});
  };
  await add("babylon-textures", "@babylonjs/procedural-textures", 10, babylonTextures);
  if (root("butterchurn")) await add("butterchurn", "butterchurn-presets", 16, (at) => presets(at, root("butterchurn")));
  await add("gl-renderer", "gl-renderer", 5, plain);
  await add("gl-transitions", "gl-transitions", 14, transitions);
  await add("hydra", "hydra-synth", 12, hydra);
  await add("isf", "interactive-shader-format", 8, isf);
  await add("lygia", "lygia", 14, lygia);
  await add("paper", "@paper-design/shaders", 16, paper);
  await add("shader-sandbox", "@stevejtrettel/shader-sandbox", 4, (at) => toys(at, "templates", /\.glsl$/, "uniform vec2 uOffset; uniform float uScale;\n"));
  await add("kodi-shadertoy", "kodi-visualization-shadertoy-data", 16, (at) => toys(at, "usr/share/kodi", /\.frag\.glsl$/));
  return families;
}
