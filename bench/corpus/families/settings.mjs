// Shaders of engines are made of #ifdefs. Settings of them, by hash, stand for the materials that an application has.
import {sha256} from "../compile.mjs";

const kPlatform = /^(GL_|GLES|WEBGL|OPENGL|HLSL|VULKAN|D3D|.*_H(_|$)|.*GLES_OVER_GL|USE_HIGHP_PRECISION|RENDER_DEPTH|DEBUG)/;

// Names that the text asks for and does not define itself.
export function askedNames(text) {
  const own = new Set([...text.matchAll(/^[ \t]*#[ \t]*define[ \t]+(\w+)/gm)].map((match) => match[1]));
  const asked = new Set();
  for (const [, words] of text.matchAll(/^[ \t]*#[ \t]*(?:ifdef|ifndef|if|elif)[ \t]+(.*)$/gm))
    for (const [, name, ifdef] of (/[()]|&&|\|\|/.test(words) ? words : `defined ${words}`).matchAll(/defined[ (]*([A-Za-z_]\w*)|^([A-Za-z_]\w*)$/g)) asked.add(name || ifdef);
  return [...asked].filter((name) => !own.has(name) && !kPlatform.test(name)).sort();
}

// [{setting, names}]: none of them, then `count` subsets of about half of them.
export function settings(names, key, count) {
  const list = [{setting: "", names: []}];
  for (let at = 1; names.length && at <= count; ++at)
    list.push({setting: `defines ${at}`, names: names.filter((name) => parseInt(sha256(`${key}/${at}/${name}`).slice(0, 2), 16) % 2)});
  return list;
}
