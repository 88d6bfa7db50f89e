#include "compiler/source/harness_vertex.h"

#include <algorithm>

#include "compiler/source/stage_interface.h"
#include "runtime/package/interface_queries.h"

namespace reprise {
namespace {

constexpr const char* kHead = R"(#version 450
#extension GL_EXT_shader_explicit_arithmetic_types : enable
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(set = HARNESS_SET, binding = 0, std140) uniform HarnessScene {
  mat4 view_projection;
  mat4 model;
  uvec3 seed;
  uvec4 given[32];
} harness;

// In [-1, 1], from the seed and a number.
float coefficient(uint number) {
  uint bits = number * 0x9e3779b9u ^ harness.seed.x;
  bits = (bits ^ bits >> 16) * 0x7feb352du;
  bits = (bits ^ bits >> 15) * 0x846ca68bu;
  return float(bits >> 8) / 8388608.0 - 1.0;
}

// What depends on the block is selected, never branched on: lavapipe compiles a shader again, at every draw, for the uniform values that
// decide its branches.

// A coordinate, a direction or a place, or anything in about [-1, 1].
float smoothValue(uint number) {
  uint kind = (harness.seed.y + number / 4u) % 3u;
  uint part = number % 4u;
  float coordinate = part < 2u ? uv[part] : part == 2u ? 0.5 + 0.5 * position.z : 1.0;
  float direction = part < 3u ? normal[part] : 1.0;
  uint base = number * 5u;
  float any = 0.3 * coefficient(base) + 0.5 * dot(vec3(coefficient(base + 1u), coefficient(base + 2u), coefficient(base + 3u)), position);
  return mix(mix(any, direction, kind == 1u), coordinate, kind == 0u);
}

// The value of scalar `number`, in a range that goes with the style of the made-up values.
float wave(uint number) {
  float value = smoothValue(number);
  return mix(mix(value, 0.5 + 0.5 * value, harness.seed.z == 3u), value * 4.0, harness.seed.z == 2u);
}

uint whole(uint number) {
  uint given = number < 128u ? harness.given[number / 4u][number % 4u] : 0xffffffffu;
  return mix(uint(2.0 + 2.0 * clamp(smoothValue(number), -0.99, 0.99)), given, given != 0xffffffffu);
}

// The same in the whole draw, as indices into arrays of descriptors have to be, and within the shortest of them.
uint wholeIndex(uint number) {
  uint given = number < 128u ? harness.given[number / 4u][number % 4u] : 0xffffffffu;
  return mix(harness.seed.y + number, given, given != 0xffffffffu) % INDEX_LIMIT;
}

)";

bool isInteger(const std::string& type) {
  return type.find("int") != std::string::npos || type[0] == 'i' || type[0] == 'u';
}

int componentsOf(const std::string& type) {
  const char last = type.back();
  return type.find("vec") != std::string::npos ? last - '0' : 1;
}

}  // namespace

Result<std::string> harnessVertexText(std::span<const std::uint32_t> fragment_words) {
  ReflectOptions options;
  options.skip_unknown_members = options.any_arrays = options.any_bindings = true;
  REPRISE_ASSIGN(const StageInterface fragment, reflectStage(fragment_words, ShaderStage::kFragment, options));
  std::uint32_t set = 0;
  for (const Descriptor& descriptor : fragment.descriptors) set = std::max(set, descriptor.set + 1);
  std::string text = kHead, body;
  text.replace(text.find("HARNESS_SET"), 11, std::to_string(set));
  const std::optional<std::uint32_t> array = shortestDescriptorArray(fragment.descriptors);
  text.replace(text.find("INDEX_LIMIT"), 11, std::to_string(array.value_or(1)) + "u");
  const std::string integer = array ? "wholeIndex(" : "whole(";
  for (const StageSlot& slot : fragment.inputs) {
    if (slot.type.find(' ') != std::string::npos)
      return Error{ErrorKind::kInput, "source.unsupported", "the varying \"" + slot.name + "\" is of a type that no vertex shader writes", {}};
    const std::string name = "out_" + std::to_string(slot.location) + "_" + std::to_string(slot.component);
    std::string values;
    for (int component = 0; component < componentsOf(slot.type); ++component) {
      const std::string number = std::to_string(slot.location * 4 + slot.component + static_cast<std::uint32_t>(component)) + "u";
      values += (component > 0 ? ", " : "") + (isInteger(slot.type) ? integer : "wave(") + number + ")";
    }
    // Integers are flat whether the fragment shader says so or not; for others its word counts.
    text += "layout(location = " + std::to_string(slot.location) + ", component = " + std::to_string(slot.component) + ") " +
            (isInteger(slot.type) || slot.type[0] == 'd' ? "flat " : "") + "out " + slot.type + " " + name + ";\n";
    body += "  " + name + " = " + slot.type + "(" + values + ");\n";
  }
  return text + "void main() {\n" + body + "  gl_Position = harness.view_projection * harness.model * vec4(position, 1.0);\n}\n";
}

}  // namespace reprise
