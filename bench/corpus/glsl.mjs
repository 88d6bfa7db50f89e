// Mechanical text changes that make desktop, ES and WebGL GLSL into GLSL that glslangValidator takes for Vulkan with -R.
import fs from "node:fs";
import path from "node:path";

const kCalls = {
  texture1D: "texture", texture2D: "texture", texture3D: "texture", textureCube: "texture", texture2DRect: "texture",
  texture2DProj: "textureProj", texture2DLod: "textureLod", texture2DLodEXT: "textureLod", texture3DLod: "textureLod",
  textureCubeLod: "textureLod", textureCubeLodEXT: "textureLod", textureLodEXT: "textureLod", texture2DGrad: "textureGrad", texture2DGradEXT: "textureGrad",
  textureCubeGradEXT: "textureGrad", texture2DGradARB: "textureGrad", texture2DProjLodEXT: "textureProjLod", texture2DProjLod: "textureProjLod",
  texture2DArray: "texture", shadow2D: "texture", shadow2DProj: "textureProj",
};

// Names that were free and are words of GLSL 4.50; "texture" only where it is not called.
const kTakenNames = ["sample", "input", "output", "half", "buffer", "shared", "patch", "filter", "resource", "active", "partition", "common", "smooth", "flat", "sampler"];

const kOldBuiltIns = {
  gl_Color: "in vec4 old_Color;", gl_SecondaryColor: "in vec4 old_SecondaryColor;", gl_TexCoord: "in vec4 old_TexCoord[8];", gl_FogFragCoord: "in float old_FogFragCoord;",
  gl_ModelViewMatrix: "uniform mat4 old_ModelViewMatrix;", gl_ProjectionMatrix: "uniform mat4 old_ProjectionMatrix;",
  gl_ModelViewProjectionMatrix: "uniform mat4 old_ModelViewProjectionMatrix;", gl_NormalMatrix: "uniform mat3 old_NormalMatrix;",
  gl_ModelViewMatrixInverse: "uniform mat4 old_ModelViewMatrixInverse;", gl_TextureMatrix: "uniform mat4 old_TextureMatrix[8];",
  gl_ProjectionMatrixInverse: "uniform mat4 old_ProjectionMatrixInverse;", gl_ModelViewMatrixTranspose: "uniform mat4 old_ModelViewMatrixTranspose;",
  gl_Fog: "uniform struct { vec4 color; float density; float start; float end; float scale; } old_Fog;",
  gl_LightSource: "uniform struct { vec4 ambient; vec4 diffuse; vec4 specular; vec4 position; vec4 halfVector; vec3 spotDirection; float spotExponent; " +
      "float spotCutoff; float spotCosCutoff; float constantAttenuation; float linearAttenuation; float quadraticAttenuation; } old_LightSource[8];",
  gl_FrontMaterial: "uniform struct { vec4 emission; vec4 ambient; vec4 diffuse; vec4 specular; float shininess; } old_FrontMaterial;",
  gl_LightModel: "uniform struct { vec4 ambient; } old_LightModel;",
  gl_FrontLightModelProduct: "uniform struct { vec4 sceneColor; } old_FrontLightModelProduct;",
};

// Replaces each `#include "name"`, <name> too, by that file's text; each file once where `once` is set.
export function expandIncludes(text, folders, once = false, seen = new Set()) {
  return text.replace(/^[ \t]*#\s*include\s+["<]([^">]+)[">].*$/gm, (line, name) => {
    for (const folder of folders) {
      const file = path.join(folder, name);
      if (!fs.existsSync(file)) continue;
      if (once && seen.has(file)) return "";
      seen.add(file);
      return expandIncludes(fs.readFileSync(file, "utf8"), [path.dirname(file), ...folders], once, seen);
    }
    return line;
  });
}

export const defines = (names) => names.map((name) => `#define ${name.includes(" ") ? name : name + " 1"}\n`).join("");

// The text as GLSL 4.50: `before` (declarations and defines of ours) stands where #version stood.
export function modernize(text, before = "") {
  let body = text.replace(/\r/g, "").replace(/^\s*#\s*version.*$/gm, "").replace(/^[ \t]*#[ \t]*extension.*$/gm, "").replace(/^[ \t]*#[ \t]*pragma.*$/gm, "");
  const known = new Set();
  body = before.replace(/^#define (\w+).*\n/gm, (line, name) => (known.has(name) ? "" : (known.add(name), line))) + body;
  body = body.replace(/\bGL_ES\b/g, "ES_PROFILE");
  body = body.replace(/^[ \t]*(precision\s+\w+\s+\w+\s*;)/gm, "");
  body = body.replace(/\battribute\b(?=\s+\w+\s+\w+\s*;)/g, "in").replace(/\bvarying\b/g, "in");
  let head = "";
  for (const name of kTakenNames) if (new RegExp(`\\b${name}\\b(?!\\s+(in|out|varying)\\b)`).test(body.replace(/\/\/.*|\/\*[^]*?\*\//g, "")) && isVariable(body, name)) head += `#define ${name} ${name}_name\n`;
  if (isVariable(body, "texture")) body = body.replace(/\btexture\b(?!\s*\()/g, "texture_name");
  for (const [old, call] of Object.entries(kCalls))
    if (new RegExp(`\\b${old}\\b`).test(body) && !new RegExp(`\\w+\\s+${old}\\s*\\(\\s*(in\\s+)?(sampler|vec)\\w+\\s+\\w+`).test(body)) body = body.replace(new RegExp(`\\b${old}(?=\\s*\\()`, "g"), call);
  if (/\bgl_FragDepthEXT\b/.test(body)) body = body.replace(/\bgl_FragDepthEXT\b/g, "gl_FragDepth");
  for (const [name, line] of Object.entries(kOldBuiltIns)) {
    if (!new RegExp(`\\b${name}\\b`).test(body)) continue;
    head += line + "\n";
    body = body.replace(new RegExp(`\\b${name}\\b`, "g"), name.replace("gl_", "old_"));
  }
  if (/\bgl_FragColor\b/.test(body)) {
    head += "layout(location = 0) out vec4 old_FragColor;\n";
    body = body.replace(/\bgl_FragColor\b/g, "old_FragColor");
  }
  const targets = [...body.matchAll(/\bgl_FragData\s*\[\s*(\d+)\s*\]/g)].map((match) => Number(match[1]));
  if (targets.length) {
    head += `layout(location = 0) out vec4 old_FragData[${Math.max(...targets) + 1}];\n`;
    body = body.replace(/\bgl_FragData\b/g, "old_FragData");
  }
  return `#version 450\n#extension GL_EXT_control_flow_attributes : enable\n${head}${body.startsWith("\n") ? "" : "\n"}${body}`;
}

function isVariable(body, name) {
  return new RegExp(`\\b(float|int|uint|bool|[iub]?vec[234]|mat[234]|sampler\\w+)\\s+(\\w+\\s*,\\s*)*${name}\\s*[;=,)([]`).test(body);
}
