// Fragment shaders that engines for browsers keep in their modules: read by importing these, put together as the engines do it.
import fs from "node:fs";
import path from "node:path";
import {pathToFileURL} from "node:url";

import {sha256} from "../compile.mjs";
import {defines} from "../glsl.mjs";
import {askedNames, settings} from "./settings.mjs";
import {walk} from "./walk.mjs";

const read = (root, file) => fs.readFileSync(path.join(root, file), "utf8");
const load = (root, file) => import(pathToFileURL(path.join(root, file)).href);

const settled = (file, text, count, before) =>
  settings(askedNames(text), file, count).map(({setting, names}) => ({path: file, setting, gl: text, before: before + defines(names)}));

const kLights = {NUM_DIR_LIGHT_SHADOWS: 1, NUM_SPOT_LIGHT_COORDS: 1, NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS: 1, NUM_SPOT_LIGHT_MAPS: 0, NUM_POINT_LIGHT_SHADOWS: 1, NUM_SPOT_LIGHT_SHADOWS: 1,
                 NUM_RECT_AREA_LIGHTS: 0, NUM_POINT_LIGHTS: 2, NUM_SPOT_LIGHTS: 1, NUM_DIR_LIGHTS: 2, NUM_HEMI_LIGHTS: 1, NUM_CLIPPING_PLANES: 0, UNION_CLIPPING_PLANES: 0};

// As three.js does it: chunks in, numbers of lights in, marked loops unrolled.
function threeText(text, chunks) {
  const include = (line) => line.replace(/^[ \t]*#include +<([\w\d./]+)>/gm, (all, name) => include(chunks[name] ?? ""));
  let full = include(text);
  for (const [name, value] of Object.entries(kLights)) full = full.replace(new RegExp(`\\b${name}\\b`, "g"), String(value));
  const loop = /#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;
  return full.replace(loop, (all, start, end, body) =>
    Array.from({length: Math.max(0, end - start)}, (unused, at) => body.replace(/\[\s*i\s*\]/g, `[ ${at} ]`).replace(/UNROLLED_LOOP_INDEX/g, String(at))).join("\n"));
}

const threeFrame = (chunks) => "uniform mat4 viewMatrix;\nuniform vec3 cameraPosition;\nuniform bool isOrthographic;\n#define TONE_MAPPING 1\n#define SHADOWMAP_TYPE_PCF 1\n#define USE_SHADOWMAP 1\n" +
    "#define ENVMAP_MAX_LOD 8.0\n#define ENVMAP_TYPE_CUBE 1\n#define ENVMAP_MODE_REFLECTION 1\n#define ENVMAP_BLENDING_MULTIPLY 1\n#define DEPTH_PACKING 3200\n#define CUBEUV_TEXEL_WIDTH 0.01\n#define CUBEUV_TEXEL_HEIGHT 0.01\n#define CUBEUV_MAX_MIP 8.0\n" +
    ["MAP", "NORMALMAP", "ROUGHNESSMAP", "METALNESSMAP", "EMISSIVEMAP", "AOMAP", "LIGHTMAP", "BUMPMAP", "SPECULARMAP", "ALPHAMAP", "CLEARCOATMAP", "CLEARCOAT_NORMALMAP", "CLEARCOAT_ROUGHNESSMAP",
     "TRANSMISSIONMAP", "THICKNESSMAP", "IRIDESCENCEMAP", "IRIDESCENCE_THICKNESSMAP", "SHEEN_COLORMAP", "SHEEN_ROUGHNESSMAP", "SPECULAR_COLORMAP", "SPECULAR_INTENSITYMAP", "ANISOTROPYMAP"]
        .map((name) => `#define ${name.replace("MAP", "MAP_UV") === "MAP_UV" ? "MAP_UV" : name + "_UV"} vMapUv\n`).join("") +
    chunks.tonemapping_pars_fragment + "\nvec3 toneMapping(vec3 color) { return ACESFilmicToneMapping(color); }\n" + chunks.colorspace_pars_fragment +
    "\nvec4 linearToOutputTexel(vec4 value) { return sRGBTransferOETF(value); }\nfloat luminance(const in vec3 rgb) { return dot(vec3(0.2126, 0.7152, 0.0722), rgb); }\n";

async function threeMaterials(root) {
  const {ShaderLib, ShaderChunk} = await load(root, "build/three.module.js");
  return Object.keys(ShaderLib).sort().flatMap((name) => {
    const text = threeText(ShaderLib[name].fragmentShader, ShaderChunk), count = /physical|standard|phong|toon|lambert|basic|matcap/.test(name) ? 12 : 1;
    return settled(`ShaderLib/${name}`, text, count, threeFrame(ShaderChunk)).map((candidate) => ({...candidate, before: withMapUvs(candidate.before)}));
  });
}

// Texture coordinates are declared where a material has any map.
const withMapUvs = (before) => (/#define USE_MAP\b/.test(before) ? before : before + "varying vec2 vMapUv;\n");

async function threePasses(root) {
  const {ShaderChunk} = await load(root, "build/three.module.js");
  const all = [];
  for (const file of [...walk(root, "examples/jsm/shaders", /\.js$/), ...walk(root, "examples/jsm/objects", /\/(Sky|Water|Water2|Reflector|Refractor|Lensflare)\.js$/)]) {
    let module;
    try { module = await load(root, file); } catch { continue; }
    for (const [name, entry] of Object.entries(module)) {
      const shader = entry?.fragmentShader ? entry : Object.values(entry ?? {}).find((inner) => inner?.fragmentShader);
      if (!shader) continue;
      const given = Object.entries(shader.defines ?? {}).map(([key, value]) => `#define ${key} ${value}\n`).join("");
      all.push({path: `${file} ${name}`, gl: threeText(shader.fragmentShader, ShaderChunk), before: given + threeFrame(ShaderChunk)});
    }
  }
  return all;
}

// Babylon's includes take the place of {X} for each light.
function babylonText(root, file) {
  const text = (name) => {
    const place = path.join(root, name);
    return fs.existsSync(place) ? new Function(`return ${/const shader = (`[^]*?`);\n/.exec(fs.readFileSync(place, "utf8"))[1]}`)() : "";
  };
  const expand = (body) => body.replace(/#include<(\w+)>(\(([^)]*)\))?(\[([^\]]*)\])?/g, (all, name, unused, swaps, array, range) => {
    name = name.replace(/^__decl__(\w+)$/, "$1Declaration");
    let inner = text(`Shaders/ShadersInclude/${name}.js`);
    const words = (swaps || "").split(",");
    for (let at = 0; swaps && at + 1 < words.length; at += 2) inner = inner.replaceAll(words[at], words[at + 1]);
    inner = inner.replace(/light\{X\}\.(\w+)/g, "$1{X}");
    if (range === undefined) return expand(inner);
    const [from, to] = range.includes("..") ? range.split("..") : [range, range];
    const last = isNaN(Number(to)) ? 2 : Number(to) + 1;
    return Array.from({length: last - Number(from)}, (none, at) => expand(inner.replace(/\{X\}/g, String(at + Number(from))))).join("\n");
  });
  const full = expand(text(file)).replaceAll("gl_FragColor", "glFragColor");
  return full.includes("glFragColor") ? "layout(location = 0) out vec4 glFragColor;\n" + full : full;
}

// Settings of materials: what the light includes ask for by number is lit by one lamp each of two kinds.
const kBabylon = "#define LIGHT0 1\n#define DIRLIGHT0 1\n#define LIGHT1 1\n#define POINTLIGHT1 1\n#define SPECULARTERM 1\n#define NORMAL 1\n#define MAINUV1 1\n#define UV1 1\n#define WEBGL2 1\n#define SAMPLER3DGREENDEPTH 1\n" +
    "#define OCTAVES 4\n#define MAXLIGHTCOUNT 2\n#define SAMPLES 16\n#define SAMPLER3DBGRMAP 1\n#define NUM_SAMPLES 16\n#define NUM_SAMPLES_FLOAT 16.0\n" +
    ["DIFFUSE", "ALBEDO", "OPACITY", "AMBIENT", "EMISSIVE", "SPECULAR", "BUMP", "REFLECTIVITY", "LIGHTMAP", "MICROSURFACEMAP"].map((name) => `#define ${name}DIRECTUV 1\n`).join("");

// A setting of a material that has hundreds of switches: one in ten of them.
function babylonMaterial(file, text, count) {
  const names = askedNames(text).filter((name) => !/DEBUG|PREPASS|MULTIVIEW|ORDER_INDEPENDENT|LOGARITHMIC|CLIPPLANE|LIGHTMAP|DIRECTUV|SHADOWONLY|DEPTHPEELING|LIGHT\d|SHADOW|UNLIT|NODE/.test(name));
  return Array.from({length: count}, (unused, at) => {
    const kept = names.filter((name) => parseInt(sha256(`${file}/${at}/${name}`).slice(0, 4), 16) % 10 === 0);
    return {path: file, setting: `defines ${at}`, gl: text, before: kBabylon + defines(kept)};
  });
}

function babylon(root, materials) {
  const big = /\/(pbr|default|standard|openpbr|background|geometry)\.fragment/;
  return walk(root, "Shaders", /^Shaders\/\w+\.fragment\.js$/).filter((file) => big.test(file) === materials)
      .flatMap((file) => (materials ? babylonMaterial(file, babylonText(root, file), 24) : settled(file, babylonText(root, file), 2, kBabylon)));
}

// Strings of a bundle that are whole fragment shaders.
async function exported(root, file, pattern) {
  const found = [];
  for (const [, quoted] of read(root, file).matchAll(pattern)) {
    let text;
    try { text = new Function(`return ${quoted}`)(); } catch { continue; }
    if (/void\s+main\s*\(/.test(text) && /gl_FragColor|out\s+vec4|finalColor/.test(text) && !/gl_Position/.test(text)) found.push(text);
  }
  return found;
}

async function postprocessing(root) {
  const texts = await exported(root, "build/index.js", /var \w+ = ("(?:[^"\\\n]|\\.)*"|`[^`$]*`);/g);
  const {ShaderChunk} = await load(path.join(root, "../three"), "build/three.module.js");
  const frame = threeFrame(ShaderChunk);
  return texts.flatMap((text, at) => settled(`build/index.js shader ${at}`, threeText(text, ShaderChunk), 2, frame + "#define KERNEL_SIZE 5\n#define SAMPLES_INT 9\n#define SAMPLES_FLOAT 9.0\n"));
}

async function pixi(root) {
  const all = [];
  for (const file of walk(root, "lib", /^lib\/[\w-]+\/[\w-]+\.mjs$/))
    for (const text of await exported(root, file, /var \w+ = ("(?:[^"\\\n]|\\.)*");/g)) all.push({path: file, gl: text});
  return all;
}

export async function engineFromPackages(root) {
  const families = [];
  const add = async (name, source, cap, list) => {
    if (root(source)) families.push({kind: "engine", name, package: source, cap, candidates: await list(root(source))});
  };
  await add("babylon-materials", "@babylonjs/core", 12, (at) => babylon(at, true));
  await add("babylon-passes", "@babylonjs/core", 10, (at) => babylon(at, false));
  await add("pixi-filters", "pixi-filters", 6, pixi);
  await add("postprocessing", "postprocessing", 6, postprocessing);
  await add("three-materials", "three", 14, threeMaterials);
  await add("three-passes", "three", 10, threePasses);
  return families;
}
