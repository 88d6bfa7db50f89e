#include "compiler/source/standard_vertex.h"

#include <algorithm>

#include "compiler/source/interface_names.h"
#include "compiler/source/stage_interface.h"

namespace reprise {
namespace {

struct Varying {
  const char *name, *type, *value;
};

constexpr Varying kVaryings[] = {
    {"world_position", "vec3", "world.xyz"},
    {"world_normal", "vec3", "mat3(normal_matrix) * n"},
    {"world_tangent", "vec4", "vec4(mat3(model) * t, tangent.w)"},
    {"object_position", "vec3", "position"},
    {"object_normal", "vec3", "normal"},
    {"uv", "vec2", "uv"},
    {"color", "vec4", "color"},
};

Error unknownVarying(const StageSlot& slot) {
  std::string known;
  for (const Varying& varying : kVaryings) known += (known.empty() ? "" : ", ") + std::string(varying.type) + " " + varying.name;
  return {ErrorKind::kInput, "source.varying",
          "the fragment shader reads '" + slot.type + " " + slot.name + "', which the standard vertex shader does not give; there are " + known +
              "; or name a vertex shader in [shader]", {}};
}

std::string head(const StandardVertexOptions& options, std::uint32_t set) {
  const std::string in_set = "layout(set = " + std::to_string(set) + ", std140, binding = ";
  std::string text =
      "#version 450\n"
      "layout(location = 0) in vec3 position;\nlayout(location = 1) in vec3 normal;\nlayout(location = 2) in vec4 tangent;\n";
  text += in_set + "0) uniform StandardFrame { mat4 view_projection; };\n";
  text += in_set + "1) uniform StandardObject { mat4 model; mat4 normal_matrix; };\n";
  if (options.joints > 0) {
    text += "layout(location = 5) in vec4 joints;\nlayout(location = 6) in vec4 weights;\n";
    text += in_set + "2) uniform StandardSkin { mat4 joint_matrices[" + std::to_string(options.joints) + "]; int joint_count; };\n";
  }
  for (std::size_t target = 0; target < options.morph_targets; ++target) {
    const std::string number = std::to_string(target);
    text += "layout(location = " + std::to_string(7 + 2 * target) + ") in vec3 morph_position_" + number + ";\n";
    text += "layout(location = " + std::to_string(8 + 2 * target) + ") in vec3 morph_normal_" + number + ";\n";
  }
  if (options.morph_targets > 0) text += in_set + "3) uniform StandardMorph { vec4 morph_weights; };\n";
  return text;
}

std::string deformation(const StandardVertexOptions& options) {
  std::string text = "  vec3 p = position, n = normal, t = tangent.xyz;\n";
  for (std::size_t target = 0; target < options.morph_targets; ++target) {
    const std::string number = std::to_string(target);
    text += "  p += morph_weights[" + number + "] * morph_position_" + number + ";\n  n += morph_weights[" + number + "] * morph_normal_" + number + ";\n";
  }
  if (options.joints > 0) {
    text += "  if (joint_count > 0) {\n    mat4 skin = mat4(0.0);\n";
    for (const char* j : {"0", "1", "2", "3"}) text += std::string("    skin += weights[") + j + "] * joint_matrices[int(joints[" + j + "])];\n";
    text += "    p = (skin * vec4(p, 1.0)).xyz;\n    n = mat3(skin) * n;\n    t = mat3(skin) * t;\n  }\n";
  }
  return text + "  vec4 world = model * vec4(p, 1.0);\n";
}

}  // namespace

Result<std::string> standardVertexText(std::span<const std::uint32_t> fragment_words, const StandardVertexOptions& options) {
  REPRISE_ASSIGN(const StageInterface fragment, reflectStage(fragment_words, ShaderStage::kFragment));
  std::uint32_t set = 0;
  for (const Descriptor& descriptor : fragment.descriptors) set = std::max(set, descriptor.set + 1);
  std::string text = head(options, set), body = deformation(options);
  for (const StageSlot& slot : fragment.inputs) {
    const std::string name = slot.name.find('.') == std::string::npos ? slot.name : attributeName(slot.name);  // of HLSL and Slang
    const auto varying = std::find_if(std::begin(kVaryings), std::end(kVaryings), [&](const Varying& known) { return name == known.name; });
    if (varying == std::end(kVaryings) || slot.type != varying->type) return unknownVarying(slot);
    const std::string out = "out_" + name;
    // Inputs that nobody reads would have to be bound all the same.
    if (name == "uv") text += "layout(location = 3) in vec2 uv;\n";
    if (name == "color") text += "layout(location = 4) in vec4 color;\n";
    text += "layout(location = " + std::to_string(slot.location) + ", component = " + std::to_string(slot.component) + ") out " + slot.type + " " + out + ";\n";
    body += "  " + out + " = " + varying->value + ";\n";
  }
  return text + "void main() {\n" + body + "  gl_Position = view_projection * world;\n}\n";
}

}  // namespace reprise
