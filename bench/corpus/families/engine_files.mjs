// Fragment shaders that engines, toolkits and compositors keep in files.
import fs from "node:fs";
import path from "node:path";

import {defines, expandIncludes} from "../glsl.mjs";
import {askedNames, settings} from "./settings.mjs";
import {walk} from "./walk.mjs";

const read = (root, file) => fs.readFileSync(path.join(root, file), "utf8");

// One candidate for each setting of the file's #ifdefs.
function settled(file, text, count, before = "") {
  return settings(askedNames(text), file, count).map(({setting, names}) => ({path: file, setting, gl: text, before: before + defines(names)}));
}

const vulkanFiles = (folder, pattern) => (root) =>
  walk(root, folder, pattern).map((file) => ({path: file, vulkan: expandIncludes(read(root, file), [path.dirname(path.join(root, file))], true)}));

const glFiles = (folder, pattern, count = 0, before = "") => (root) =>
  walk(root, folder, pattern).flatMap((file) => settled(file, expandIncludes(read(root, file), [path.dirname(path.join(root, file))], true), count, before));

// gtk's own module files; those beside it in GLSL come out the same or nearly so.
const gtkVulkan = (root) => walk(root, "gsk/vulkan/resources", /\.frag\.spv$/).map((file) => ({path: file, spirv: fs.readFileSync(path.join(root, file))}));

function gtkGl(root) {
  const folder = "gsk/gl/resources", preamble = ["preamble.glsl", "preamble.fs.glsl"].map((file) => read(root, path.join(folder, file))).join("\n");
  const files = walk(root, folder, /\.glsl$/).filter((file) => !file.includes("preamble"));
  return files.map((file) => ({path: file, gl: (preamble + read(root, file).split("// FRAGMENT_SHADER:").pop()).replaceAll("gl_FragColor", "outputColor"), before: "#define GSK_GL3 1\n#define _IN_ in\n#define _OUT_ out\n#define _GSK_ROUNDED_RECT_UNIFORM_ GskRoundedRect\n"}));
}

// Godot's files hold both stages; marks stand for what a material adds, here: a rough metal of one texture.
function godot(folder, count) {
  return (root) => walk(root, folder, /\.glsl$/).flatMap((file) => {
    const text = expandIncludes(read(root, file), [path.dirname(path.join(root, file))]).split("[fragment]")[1];
    if (!text || !text.includes("void main")) return [];
    const scene = file.endsWith("scene.glsl");
    const filled = text.replace(/^MATERIAL_UNIFORMS$/gm, scene ? "vec4 tint; float rough;" : "vec4 tint;").replace(/^LIGHT_SHADER_CODE$/gm, "")
        .replace(/^FRAGMENT_SHADER_GLOBALS$/gm, "uniform sampler2D material_map;")
        .replace(/^FRAGMENT_SHADER_CODE$/gm, scene ? "{ vec4 t = texture2D(material_map, vertex_interp.xy); albedo = t.rgb; roughness = t.a; metallic = 0.5; }" : "");
    const common = folder.includes("gles2") ? "#define texture2D_screen texture2D\n" : "";
    return settled(file, filled, scene ? 24 : count, common + "#define USE_GLES_OVER_GL 1\n#define GLES_OVER_GL 1\n#define MAX_LIGHT_DATA_STRUCTS 8\n#define MAX_FORWARD_LIGHTS 8\n#define MAX_REFLECTION_DATA_STRUCTS 4\n#define MAX_SKELETON_BONES 8\n");
  });
}

// The names of the post-processing interface, declared as its documentation tells them.
const kDolphin = `#define float2 vec2
#define float3 vec3
#define float4 vec4
#define int2 ivec2
#define GetOption(x) (option_ ## x)
#define SampleOffset(o) textureOffset(samp0, v_place.xy, o)
uniform sampler2D samp0;
uniform Post { vec4 resolution; vec4 window; uint time; };
in vec2 v_place;
layout(location = 0) out vec4 old_target;
float4 Sample() { return texture(samp0, v_place); }
float4 SampleLocation(float2 place) { return texture(samp0, place); }
float4 SampleLayer(int layer) { return texture(samp0, v_place); }
float2 GetResolution() { return resolution.xy; }
float2 GetInvResolution() { return resolution.zw; }
float2 GetWindowResolution() { return window.xy; }
float2 GetCoordinates() { return v_place; }
uint GetTime() { return time; }
float GetTimeMs() { return float(time); }
void SetOutput(float4 color) { old_target = color; }
`;

const dolphin = (root) => walk(root, "usr/share/games/dolphin-emu/sys/Shaders", /\.glsl$/).map((file) => ({path: file, gl: read(root, file), before: kDolphin}));

// OpenMW's marks @name are switches that the engine writes as numbers, here by the file's and the name's length.
function openmw(root) {
  const folder = "usr/share/games/openmw/resources/shaders", files = walk(root, folder, /_fragment\.glsl$/);
  return files.flatMap((file) => {
    const text = expandIncludes(read(root, file), [path.join(root, folder)]);
    return [1, 2, 3].map((turn) => ({path: file, setting: `switches ${turn}`, gl: openmwText(text, turn), before: ""}));
  });
}

function openmwText(text, turn) {
  const loop = /@foreach\s+(\w+)\s+@(\w+)([^]*?)@endforeach/g;
  let filled = text.replace(loop, turn === 2 ? (all, name, list, body) => [0, 1].map((at) => body.replaceAll(`@${name}`, String(at))).join("\n") : "");
  filled = filled.replace(/@(startLight|endLight|maxLightsInScene|maxLights)\b/g, (all, name) => ({startLight: "0", endLight: "4"})[name] ?? "8");
  filled = filled.replace(/@getLight/g, "LightBuffer").replace(/@(lightingMethodFFP|useUBO|useGPUShader4)\b/g, "0").replace(/@lightingMethodPerObjectUniform\b/g, "1");
  return filled.replace(/@(\w+)/g, (all, name) => (/Start|End|limit|Overlap/i.test(name) ? "100.0" : String((name.length + turn) % 2)));
}

const kKodi = "#define XBMC_STRETCH 0\n#define XBMC_YV12 1\n#define METHOD 1\n#define USE1DTEXTURE 0\n#define HAS_FLOAT_TEXTURE 1\n#define KODI_TONE_MAPPING_REINHARD 1\n";
const kMinetest = "#define MATERIAL_TYPE 1\n#define TILE_MATERIAL_LIQUID_TRANSPARENT 2\n#define TILE_MATERIAL_BASIC 0\n#define TILE_MATERIAL_WAVING_LIQUID_BASIC 3\n" +
    "#define SHADOW_FILTER 2\n#define SOFTSHADOWRADIUS 2.0\n#define MAX_SHADOW_SAMPLES 16\n#define SHADOW_POISSON_FILTER 32\n#define FOG_START 0.4\n";
const kSpring = "#define USE_SHADOWS 1\n#define DEFERRED_MODE 0\n#define MAX_LIGHT_UNIFORM_VECS 12\n#define MDL_FRAGDATA_COUNT 5\n#define MAX_DYNAMIC_MODEL_LIGHTS 2\n#define NUM_LIGHTS 2\n#define BASE_DYNAMIC_MODEL_LIGHT 0\n" +
    "#define SMF_INTENSITY_MULT 0.8\n#define SQUARE_SIZE 8.0\n#define MAP_SIZE_X 512.0\n#define SHADOW_GEN_PROGRAM_MODEL 1\n";
const kKitty = "#define GLSL_VERSION 450\n#define WHICH_PROGRAM 1\n#define ALPHA_TYPE 1\n#define TRANSPARENT 1\n";
const kMark = "#define HAS_UNIFORM_u_color 1\n";

function kitty(root) {
  const text = (file) => read(root, file).replace(/^#define \{WHICH_PROGRAM\}$/gm, "").replace(/^#define (NOT_TRANSPARENT|ALPHA_TYPE)$/gm, "");
  return walk(root, "kitty", /_fragment\.glsl$/).flatMap((file) => settled(file, text(file), 6, kKitty));
}

// MapLibre's pragmas declare values that come from the style: here all of them are inputs of the fragment stage.
function maplibre(root) {
  const prelude = read(root, "src/shaders/glsl/_prelude.fragment.glsl");
  return walk(root, "src/shaders/glsl", /\.fragment\.glsl$/).filter((file) => !path.basename(file).startsWith("_")).flatMap((file) => {
    const text = read(root, file).replace(/#pragma maplibre: define (\w+) (\w+) (\w+)/g, "in $2 $3 $1;").replace(/#pragma maplibre: initialize.*/g, "");
    return settled(file, prelude + text, 3, kMark);
  });
}

export function engineFromFiles(root) {
  const family = (name, source, cap, list) => (root(source) ? [{kind: "engine", name, package: source, cap, candidates: list(root(source))}] : []);
  return [
    ...family("dolphin", "dolphin-emu-data", 8, dolphin),
    ...family("glmark2", "glmark2-data", 8, glFiles("usr/share/glmark2/shaders", /\.frag$/, 0, "#define HIGHP_OR_DEFAULT\nuniform vec4 LightSourcePosition, MaterialDiffuse;\nuniform vec3 LightSourceHalfVector;\n")),
    ...family("godot-gles2", "godot", 8, godot("drivers/gles2/shaders", 4)),
    ...family("godot-gles3", "godot", 12, godot("drivers/gles3/shaders", 4)),
    ...family("gtk-gl", "gtk4", 4, gtkGl),
    ...family("gtk-vulkan", "gtk4", 6, gtkVulkan),
    ...family("kitty", "kitty", 4, kitty),
    ...family("kodi", "kodi-data", 8, glFiles("usr/share/kodi/system/shaders", /\/(gles_.*\.frag|gl_(?!.*vert).*\.glsl)$/, 2, kKodi)),
    ...family("kwin", "kwin", 4, glFiles("src/effects", /_core\.frag$/)),
    ...family("maplibre", "maplibre-gl", 8, maplibre),
    ...family("minetest", "minetest-data", 8, glFiles("usr/share/games/minetest/client/shaders", /fragment\.glsl$/, 4, kMinetest)),
    ...family("openmw", "openmw-data", 8, openmw),
    ...family("spring", "spring", 8, glFiles("cont/base/springcontent/shaders/GLSL", /(Frag|FS)\w*\.glsl$/, 3, kSpring)),
    ...family("vkbasalt", "vkbasalt", 8, vulkanFiles("src/shader", /\.frag\.glsl$/)),
  ];
}
