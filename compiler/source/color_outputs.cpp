#include "compiler/source/color_outputs.h"

#include <algorithm>
#include <optional>
#include <spirv_cross/spirv_cross.hpp>
#include <utility>

namespace reprise {
namespace {

using spirv_cross::Compiler;
using spirv_cross::Resource;
using spirv_cross::SPIRType;

constexpr std::uint32_t kMostElements = 256;  // more locations than any device has

// 16-bit numbers are written to targets of the same kind as 32-bit ones.
std::optional<ScalarKind> scalarOf(const SPIRType& type) {
  switch (type.basetype) {
    case SPIRType::Half:
    case SPIRType::Float: return ScalarKind::kFloat;
    case SPIRType::Short:
    case SPIRType::Int: return ScalarKind::kInt;
    case SPIRType::UShort:
    case SPIRType::UInt: return ScalarKind::kUint;
    default: return std::nullopt;
  }
}

std::uint32_t elementsOf(const Compiler& compiler, const SPIRType& type) {
  std::uint32_t elements = 1;
  for (std::size_t i = 0; i < type.array.size(); ++i)
    elements *= type.array_size_literal[i] ? type.array[i] : compiler.get_constant(type.array[i]).scalar();
  return std::min(elements, kMostElements);
}

void add(std::vector<FragmentOutput>& outputs, const FragmentOutput& output) {
  const auto shared = std::find_if(outputs.begin(), outputs.end(), [&](const FragmentOutput& other) { return other.location == output.location; });
  if (shared == outputs.end()) {
    outputs.push_back(output);
  } else {
    shared->components = std::max(shared->components, output.components);
  }
}

}  // namespace

Result<std::vector<FragmentOutput>> colorOutputs(const Compiler& compiler, const spirv_cross::ShaderResources& resources) {
  std::vector<FragmentOutput> outputs;
  for (const Resource& resource : resources.stage_outputs) {
    const SPIRType& type = compiler.get_type(resource.type_id);
    FragmentOutput output;
    const std::string& given = compiler.get_name(resource.id);
    const std::string name = given.empty() ? resource.name : given;
    const std::optional<ScalarKind> scalar = scalarOf(type);
    if (!scalar || type.columns != 1)
      return Error{ErrorKind::kInput, "source.unsupported",
                   "the fragment output \"" + name + "\" is no scalar, vector or array of 16- or 32-bit floats or integers", {}};
    if (compiler.get_decoration(resource.id, spv::DecorationIndex) != 0)
      return Error{ErrorKind::kRefused, "shader.dual_source",
                   "the shader blends from two sources (\"" + name + "\"), which leaves no colour target for a payload", {}};
    output.location = compiler.get_decoration(resource.id, spv::DecorationLocation);
    output.components = static_cast<int>(compiler.get_decoration(resource.id, spv::DecorationComponent) + type.vecsize);
    output.scalar = *scalar;
    const std::uint32_t elements = elementsOf(compiler, type);
    for (std::uint32_t i = 0; i < elements; ++i) {
      output.name = type.array.empty() ? name : name + "[" + std::to_string(i) + "]";
      add(outputs, output);
      ++output.location;
    }
  }
  std::sort(outputs.begin(), outputs.end(), [](const FragmentOutput& a, const FragmentOutput& b) { return a.location < b.location; });
  return outputs;
}

}  // namespace reprise
