#include "cli/smear_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace reprise {
namespace {

bool isSample(spv::Op opcode) {
  return opcode >= spv::Op::OpImageSampleImplicitLod && opcode <= spv::Op::OpImageDrefGather;
}

bool changes(const Track& track) {
  if (std::holds_alternative<FixedTrack>(track)) return false;
  const auto* keys = std::get_if<KeyFramesTrack>(&track);
  return keys == nullptr || std::adjacent_find(keys->values.begin(), keys->values.end(), std::not_equal_to<>()) != keys->values.end();
}

// Uniform members that change from frame to frame by the scenario, the camera's and the objects' own matrices aside.
std::set<std::string> varyingUniforms(const Scenario& scenario) {
  std::set<std::string> names;
  for (const UniformBinding& binding : scenario.uniforms) {
    const auto* semantic = std::get_if<Semantic>(&binding.source);
    const auto* track = std::get_if<Track>(&binding.source);
    if (semantic != nullptr && (*semantic == Semantic::kTime || *semantic == Semantic::kFrame)) names.insert(binding.member);
    if (track != nullptr && changes(*track)) names.insert(binding.member);
  }
  for (const SessionSpec& session : scenario.sessions)
    for (const auto& [member, track] : session.uniforms)
      if (changes(track)) names.insert(member);
  return names;
}

std::vector<std::string> varyingInputs(const std::vector<int>& inputs, const ShaderAnalysis& analysis, const std::set<std::string>& varying) {
  std::vector<std::string> names;
  for (const int input : inputs) {
    const InputSource& source = analysis.inputs[static_cast<std::size_t>(input)];
    if (source.kind == InputKind::kUniform && varying.contains(source.name)) names.push_back(source.name);
  }
  return names;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// Lines of the slice that sample at coordinates which change with a varying uniform.
std::set<std::string> scrollingPlaces(const Subject& subject, const Candidate& candidate, const std::set<std::string>& varying) {
  const ShaderAnalysis& analysis = subject.program.analysis;
  std::vector<int> from;
  for (const CandidateValue& value : candidate.values) from.push_back(value.node);
  const std::vector<bool> slice = neededNodes(analysis.graph, from);
  std::set<std::string> places;
  for (std::size_t node = 0; node < slice.size(); ++node) {
    const Instruction& instruction = *analysis.graph.nodes[node].instruction;
    if (!slice[node] || !isSample(instruction.opcode)) continue;
    const auto coordinate = analysis.graph.node_of.find(instruction.operands[1].words[0]);
    if (coordinate == analysis.graph.node_of.end()) continue;
    if (varyingInputs(analysis.inputs_of[static_cast<std::size_t>(coordinate->second)], analysis, varying).empty()) continue;
    const Place place = placeOf(*subject.program.fragment, instruction, subject.program.sources);
    places.insert(fmt::format("{}:{}", std::filesystem::path(place.file).filename().string(), place.line));
  }
  return places;
}

}  // namespace

std::vector<std::string> smearWarnings(const Subject& subject, const std::vector<std::string>& candidate_ids) {
  std::vector<std::string> warnings;
  const std::set<std::string> varying = varyingUniforms(subject.scenario);
  if (varying.empty()) return warnings;
  for (const Candidate& candidate : subject.candidates) {
    if (std::find(candidate_ids.begin(), candidate_ids.end(), candidate.id) == candidate_ids.end()) continue;
    const std::string name = candidate.name.empty() ? candidate.id : candidate.name;
    const std::vector<std::string> inputs = varyingInputs(candidate.inputs, subject.program.analysis, varying);
    if (inputs.empty()) continue;
    const std::set<std::string> places = scrollingPlaces(subject, candidate, varying);
    if (!places.empty())
      warnings.push_back(fmt::format("{}: texture coordinates at {} move with {}; between refreshes the kept texture stands still and smears",
                                     name, joined({places.begin(), places.end()}), joined(inputs)));
    else
      warnings.push_back(fmt::format("{}: the payload changes over time with {}; a hit shows it as it was up to a period ago", name, joined(inputs)));
  }
  return warnings;
}

}  // namespace reprise
