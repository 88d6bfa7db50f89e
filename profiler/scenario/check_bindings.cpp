#include <algorithm>

#include "profiler/scenario/check_passes.h"
#include "profiler/scenario/diagnostics.h"
#include "profiler/scenario/names.h"
#include "profiler/scenario/near_names.h"
#include "profiler/scenario/passes.h"
#include "profiler/scenario/read_scenario.h"
#include "profiler/scenario/standard_names.h"
#include "profiler/scenario/track_size.h"

namespace reprise {
namespace {

struct Member {
  std::string name;  // "Block.member"
  BlockMember shape;
};

std::vector<Member> membersOf(const ShaderInterface& interface) {
  std::vector<Member> members;
  for (const Descriptor& descriptor : interface.descriptors) {
    if (descriptor.kind != DescriptorKind::kUniformBlock) continue;
    for (const BlockMember& member : descriptor.members)
      members.push_back({descriptor.name + "." + member.name, member});
  }
  for (const BlockMember& member : interface.push_constant_members)
    members.push_back({interface.push_constant_name + "." + member.name, member});
  return members;
}

std::string shapeText(const BlockMember& member) {
  const std::string scalar = member.scalar == ScalarKind::kFloat ? "float"
                             : member.scalar == ScalarKind::kInt ? "int"
                                                                 : "uint";
  const std::string prefix = member.scalar == ScalarKind::kFloat ? ""
                             : member.scalar == ScalarKind::kInt ? "i"
                                                                 : "u";
  std::string text = scalar;
  if (member.columns > 1)
    text = "mat" + std::to_string(member.columns) + "x" + std::to_string(member.rows);
  else if (member.rows > 1)
    text = prefix + "vec" + std::to_string(member.rows);
  return member.array_length > 0 ? text + "[" + std::to_string(member.array_length) + "]" : text;
}

std::size_t floatsOf(const BlockMember& member) {
  return static_cast<std::size_t>(member.rows) * static_cast<std::size_t>(member.columns) *
         std::max(1u, member.array_length);
}

// Which members a semantic source can fill, in words; empty if this one can be.
std::string semanticMismatch(Semantic semantic, const BlockMember& member) {
  const bool is_float = member.scalar == ScalarKind::kFloat, single = member.array_length == 0;
  const bool vector = is_float && single && member.columns == 1,
             matrix = is_float && single && member.columns > 1;
  switch (semantic) {
    case Semantic::kView:
    case Semantic::kProjection:
    case Semantic::kViewProjection:
    case Semantic::kShadowViewProjection:
      return matrix && member.rows == 4 && member.columns == 4 ? "" : "a mat4";
    case Semantic::kModel:
      return matrix && member.rows >= 3 && member.columns == 4 ? "" : "a mat4 or mat4x3";
    case Semantic::kNormalMatrix:
      return matrix && member.rows >= 3 && member.columns >= 3 ? "" : "a mat3, mat3x4 or mat4";
    case Semantic::kCameraPosition:
      return vector && member.rows >= 3 ? "" : "a vec3 or vec4";
    case Semantic::kTime:
      return vector && member.rows == 1 ? "" : "a float";
    case Semantic::kFrame:
      return single && member.columns == 1 && member.rows == 1 ? "" : "an int, uint or float";
    case Semantic::kResolution:
      return single && member.columns == 1 && (member.rows == 2 || member.rows == 4)
                 ? ""
                 : "a vec2, or a vec4 that takes the inverse, too";
    default:
      return modelSemanticMismatch(semantic, member);
  }
  return "";
}

void checkTrack(const Track& track, const Member& member, const std::string& what, Diagnostics& diagnostics,
                const Place& place) {
  if (trackSize(track) == floatsOf(member.shape)) return;
  diagnostics.add("value",
                  what + " yields " + std::to_string(trackSize(track)) + " numbers, expected " +
                      std::to_string(floatsOf(member.shape)) + " for " + shapeText(member.shape),
                  place);
}

using Interfaces = std::vector<const ShaderInterface*>;

// Blocks that passes have in common with the shader are bound once.
std::vector<Member> membersOfAll(const Interfaces& interfaces) {
  std::vector<Member> members;
  for (const ShaderInterface* interface : interfaces)
    for (Member& member : membersOf(*interface)) {
      const bool known = std::any_of(members.begin(), members.end(), [&](const Member& other) { return other.name == member.name && other.shape == member.shape; });
      if (!known) members.push_back(std::move(member));
    }
  return members;
}

Semantic semanticOf(const UniformBinding& binding) {
  const auto* of_pass = std::get_if<PassSource>(&binding.source);
  return of_pass ? of_pass->semantic : std::get<Semantic>(binding.source);
}

std::string sourceText(const UniformBinding& binding) {
  const auto* of_pass = std::get_if<PassSource>(&binding.source);
  return of_pass ? spellingOf(kPassSources, of_pass->semantic) : spellingOf(kSemantics, std::get<Semantic>(binding.source));
}

void checkUniforms(const Scenario& scenario, const Interfaces& interfaces, Diagnostics& diagnostics) {
  const std::vector<Member> members = membersOfAll(interfaces);
  std::vector<std::string> names;
  for (const Member& member : members) names.push_back(member.name);
  for (const UniformBinding& binding : scenario.uniforms) {
    bool found = false;
    for (const Member& member : members) {
      if (member.name != binding.member) continue;
      found = true;
      const std::string what = "uniform '" + binding.member + "'";
      if (const auto* track = std::get_if<Track>(&binding.source)) {
        checkTrack(*track, member, what, diagnostics, binding.place);
      } else if (const std::string wanted =
                     semanticMismatch(semanticOf(binding), member.shape);
                 !wanted.empty()) {
        diagnostics.add("value",
                        what + " is " + shapeText(member.shape) + ", but '" +
                            sourceText(binding) + "' fills " + wanted,
                        binding.place);
      }
      for (const SessionSpec& session : scenario.sessions) {
        const auto track = session.uniforms.find(binding.member);
        if (track != session.uniforms.end())
          checkTrack(track->second, member, what + " in session '" + session.name + "'", diagnostics,
                     binding.place);
      }
    }
    if (!found && !diagnostics.full()) {
      diagnostics.add(
          "unknown_uniform",
          "the shaders have no uniform '" + binding.member + "'" + suggestNames(binding.member, names),
          binding.place);
    }
  }
  for (const Member& member : members) {
    const std::string& name = member.name;
    if (const auto semantic = standardSemantic(name)) {
      const std::string wanted = semanticMismatch(*semantic, member.shape);
      if (!wanted.empty())
        diagnostics.add("value", "uniform '" + name + "' is " + shapeText(member.shape) + ", expected " + wanted, {scenario.vertex_path, 0, 0});
      continue;
    }
    const bool bound = std::any_of(scenario.uniforms.begin(), scenario.uniforms.end(),
                                   [&](const UniformBinding& binding) { return binding.member == name; });
    if (!bound) {
      diagnostics.add(
          "unbound",
          "nobody binds the uniform '" + name + "' (" + shapeText(member.shape) + " at byte " + std::to_string(member.shape.offset) + "), expected a line \"" + name + "\" = ... in [uniforms]",
          scenario.uniforms_place);
    }
  }
}

const char* unsupportedReason(const Descriptor& descriptor) {
  switch (descriptor.kind) {
    case DescriptorKind::kStorageBlock:
      return "is a storage buffer";
    case DescriptorKind::kStorageImage:
    case DescriptorKind::kUniformTexelBuffer:
    case DescriptorKind::kStorageTexelBuffer:
      return "is a storage image";
    case DescriptorKind::kSampledImage:
    case DescriptorKind::kSampler:
      return "is an image or sampler of its own, expected a combined sampler2D";
    case DescriptorKind::kUniformBlock:
      return descriptor.count == 1 ? nullptr : "is an array of uniform blocks";
    case DescriptorKind::kCombinedImageSampler:
      if (descriptor.dimension != ImageDimension::k2D) return "is not a sampler2D";
      return descriptor.count == 1 ? nullptr : "is an array of samplers";
  }
  return nullptr;
}

void checkDescriptors(const Scenario& scenario, const ShaderInterface& interface, std::vector<std::string>& names, Diagnostics& diagnostics) {
  for (const Descriptor& descriptor : interface.descriptors) {
    const auto of_pass = findPassTexture(scenario, descriptor.name);
    if (descriptor.kind == DescriptorKind::kCombinedImageSampler && descriptor.compares && !(of_pass && of_pass->depth))
      diagnostics.add("unsupported", "'" + descriptor.name + "' is a sampler2DShadow, expected a [[pass]] whose depth has that name", {scenario.fragment_path, 0, 0});
    if (const char* reason = unsupportedReason(descriptor)) {
      diagnostics.add("unsupported",
                      "'" + descriptor.name + "' " + reason + ", which a scenario cannot fill yet",
                      {scenario.fragment_path, 0, 0});
    } else if (descriptor.kind == DescriptorKind::kCombinedImageSampler) {
      names.push_back(descriptor.name);
    }
  }
}

void checkTextures(const Scenario& scenario, const Interfaces& interfaces, Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const ShaderInterface* interface : interfaces) checkDescriptors(scenario, *interface, names, diagnostics);
  for (const TextureSpec& texture : scenario.textures) {
    if (diagnostics.full() || std::find(names.begin(), names.end(), texture.name) != names.end()) continue;
    diagnostics.add("unknown_texture",
                    "the shaders have no texture '" + texture.name + "'" + suggestNames(texture.name, names),
                    texture.place);
  }
  for (const std::string& name : names) {
    if (isStandardTexture(name) || findPassTexture(scenario, name)) continue;
    const bool given = std::any_of(scenario.textures.begin(), scenario.textures.end(),
                                   [&](const TextureSpec& texture) { return texture.name == name; });
    if (!given) {
      diagnostics.add("unbound",
                      "nobody gives the texture '" + name + "', expected a [[texture]] with that name",
                      {scenario.path, 0, 0});
    }
  }
}

void checkVertexInputs(const Scenario& scenario, const ShaderInterface& interface, Diagnostics& diagnostics) {
  std::vector<std::string> known = {"position", "normal", "tangent", "uv", "color"};
  for (const std::string& name : deformInputs()) known.push_back(name);
  for (const VertexInput& input : interface.vertex_inputs) {
    const Place place = {scenario.vertex_path, 0, 0};
    if (std::find(known.begin(), known.end(), input.name) == known.end()) {
      diagnostics.add(
          "vertex_input",
          "the meshes have no vertex input '" + input.name + "'" + suggestNames(input.name, known) +
              (nearNames(input.name, known).empty() ? ""
                                                    : " (there are position, normal, tangent, uv, color)") +
              "; or say in [shader] what it takes (it is at location " + std::to_string(input.location) + "): vertex_inputs = { \"" + input.name +
              "\" = \"position\" }",
          place);
    } else if (input.scalar != ScalarKind::kFloat) {
      diagnostics.add("vertex_input",
                      "the vertex input '" + input.name + "' has integers, but the meshes have floats",
                      place);
    }
  }
}

// A name of 'vertex_inputs' that no shader has is still there: nothing was renamed by it.
void checkNamedInputs(const Scenario& scenario, const Interfaces& interfaces, Diagnostics& diagnostics) {
  for (const auto& [name, taken] : scenario.vertex_inputs) {
    const bool used = std::any_of(interfaces.begin(), interfaces.end(), [&, &taken = taken](const ShaderInterface* interface) {
      const auto& inputs = interface->vertex_inputs;
      return std::any_of(inputs.begin(), inputs.end(), [&](const VertexInput& input) { return input.name == taken; });
    });
    if (!used)
      diagnostics.add("vertex_input", "'vertex_inputs' of [shader] calls '" + name + "' '" + taken + "', but the vertex shader reads no '" + name + "'",
                      {scenario.path, 0, 0});
  }
}

void checkOutputs(const Scenario& scenario, const ShaderInterface& interface, Diagnostics& diagnostics) {
  const Place place = {scenario.fragment_path, 0, 0};
  const std::size_t formats = scenario.state.color_formats.size();
  if (formats != 0 && formats != interface.outputs.size()) {
    diagnostics.add("outputs",
                    "the fragment shader has " + std::to_string(interface.outputs.size()) +
                        " colour outputs, but 'formats' in [render] has " + std::to_string(formats),
                    {scenario.path, 0, 0});
  }
  if (interface.outputs.empty())
    diagnostics.add("outputs", "the fragment shader has no colour output, expected one", place);
  for (std::size_t i = 0; i < interface.outputs.size(); ++i) {
    const FragmentOutput& output = interface.outputs[i];
    if (output.location != i) {
      diagnostics.add("unsupported",
                      "the output '" + output.name + "' has location " + std::to_string(output.location) +
                          ", expected locations from 0 without a gap",
                      place);
    } else if (output.scalar != ScalarKind::kFloat) {
      diagnostics.add("unsupported", "the output '" + output.name + "' has integers, expected floats", place);
    }
  }
}

}  // namespace

void nameVertexInputs(const Scenario& scenario, ShaderInterface& interface) {
  for (VertexInput& input : interface.vertex_inputs) {
    const auto named = std::find_if(scenario.vertex_inputs.begin(), scenario.vertex_inputs.end(), [&](const auto& one) { return one.first == input.name; });
    if (named != scenario.vertex_inputs.end()) input.name = named->second;
  }
}

Result<void> checkBindings(const Scenario& scenario, const ShaderInterface& interface, std::span<const ShaderInterface> passes) {
  Diagnostics diagnostics;
  Interfaces interfaces = {&interface};
  for (const ShaderInterface& pass : passes) interfaces.push_back(&pass);
  // In this order: what is misspelled in the scenario comes before what is missing for that reason.
  checkUniforms(scenario, interfaces, diagnostics);
  checkPasses(scenario, interface, passes, diagnostics);
  checkTextures(scenario, interfaces, diagnostics);
  for (const ShaderInterface* each : interfaces) checkVertexInputs(scenario, *each, diagnostics);
  checkNamedInputs(scenario, interfaces, diagnostics);
  checkOutputs(scenario, interface, diagnostics);
  if (diagnostics.errors.empty()) return {};
  return mergeErrors(std::move(diagnostics.errors));
}

}  // namespace reprise
