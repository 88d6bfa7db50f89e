#include "cli/check/check_subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "compiler/ir/reproducible.h"
#include "compiler/source/validate.h"
#include "runtime/vulkan/lane_probe.h"

namespace reprise {
namespace {

// The reason that most values have for being no candidates.
std::string whyNone(const std::vector<Candidate>& values) {
  std::map<std::string, int> counts;
  const Candidate* most = nullptr;
  int best = 0;
  for (const Candidate& value : values)
    if (++counts[value.dropped.code] > best) best = counts[value.dropped.code], most = &value;
  if (most == nullptr) return "the shader computes nothing";
  return fmt::format("none of {} values can be kept; most often: {} [{}]", values.size(), most->dropped.message, most->dropped.code);
}

}  // namespace

CompileOptions compileOptionsOf(const CheckRequest& request) {
  CompileOptions options;
  options.stage = ShaderStage::kFragment;
  options.entry_point = request.entry_point;
  for (const std::string& directory : request.include_dirs) options.include_dirs.emplace_back(directory);
  for (const std::string& define : request.defines) {
    const std::size_t equals = define.find('=');
    options.defines.emplace_back(define.substr(0, equals), equals == std::string::npos ? "" : define.substr(equals + 1));
  }
  return options;
}

Result<std::vector<Candidate>> candidatesOf(const ShaderProgram& program) {
  CandidateOptions enumeration;
  enumeration.least_share = 0;
  const std::vector<Candidate> values = enumerateCandidates(*program.fragment, program.analysis, program.sources, enumeration);
  std::vector<Candidate> kept;
  std::copy_if(values.begin(), values.end(), std::back_inserter(kept), [](const Candidate& value) { return value.kept(); });
  std::stable_partition(kept.begin(), kept.end(), [](const Candidate& one) { return !isRegrouped(one); });
  if (kept.empty()) return Error{ErrorKind::kRefused, "candidate.none", whyNone(values), {}};
  return kept;
}

Result<StateLimits> limitsFor(const ShaderProgram& program, const Context& context) {
  StateLimits limits{true, true, true};
  if (!program.analysis.derivatives_read_buffers) return limits;
  REPRISE_ASSIGN(const LaneLoads lanes, probeLanes(context));
  limits.rejected_lanes_load = lanes.rejected;
  limits.device = context.summary().name;
  return limits;
}

Result<CompiledShader> withZeros(const CompiledShader& shader) {
  REPRISE_ASSIGN(const Module module, readModule(shader.words));
  CompiledShader result = shader;
  result.words = writeModule(withDefinedValues(module));
  REPRISE_TRY(validateModule(result.words));
  return result;
}

}  // namespace reprise
