#include <algorithm>
#include <cmath>

#include "tests/report/sample_run.h"

namespace reprise::sample {
namespace {

constexpr int kCandidates = 40, kLines = 60;

RunVariant variantOf(const RunCandidate& candidate, const RunConfiguration& one, std::uint32_t period) {
  return {candidate.id, one.strategy, one.pattern, one.filter, one.encoding, one.block_pixels, period};
}

}  // namespace

RunResult manyCandidatesRun() {
  RunResult run = variantRun();
  const RunCandidate base = *std::find_if(run.candidates.begin(), run.candidates.end(),
                                          [&](const RunCandidate& one) { return one.id == run.choice.candidate_id; });
  run.candidates.clear();
  run.front.clear();
  run.threshold.margin = 0.1;
  for (int i = 0; i < kCandidates; ++i) {
    RunCandidate candidate = base;
    if (i > 0) candidate.id = "many" + std::to_string(i), candidate.name = "value_" + std::to_string(i), candidate.line = 1 + i;
    if (i > 0) candidate.configurations.resize(1);
    for (RunConfiguration& one : candidate.configurations) {
      one.cache_bytes_per_pixel = 8 + i % 3 * 8;
      for (RunPoint& point : one.points) {
        if (!point.predicted_error) continue;
        *point.predicted_error *= 1 + 0.05 * i;
        *point.predicted_frame_ms *= 1 - 0.004 * i;
        if (point.measured_frame_ms) point.measured_frame_ms_ci95 = RunInterval{*point.measured_frame_ms * 0.98, *point.measured_frame_ms * 1.02};
      }
    }
    run.candidates.push_back(candidate);
  }
  for (const int i : {0, 5, 20, 39}) {
    const RunConfiguration& one = run.candidates[static_cast<std::size_t>(i)].configurations.front();
    for (const RunPoint& point : one.points)
      if (point.period_frames == (i == 0 ? 2u : 8u)) run.front.push_back(variantOf(run.candidates[static_cast<std::size_t>(i)], one, point.period_frames));
  }
  return run;
}

ReportEvidence evidenceOf(const RunResult& run) {
  ReportEvidence made;
  RunEvidence& evidence = made.evidence;
  EvidenceSource source{run.candidates.empty() ? "a.frag" : run.candidates.front().file, "", {}};
  for (int line = 1; line <= kLines; ++line) {
    source.text += "float v" + std::to_string(line) + " = a < b ? 1.0 : 0.0;  // </script><b>\n";
    source.line_shares.push_back(1.0 / kLines);
  }
  evidence.sources.push_back(source);
  for (const RunCandidate& candidate : run.candidates) {
    if (candidate.configurations.empty()) continue;
    evidence.slices.push_back({candidate.id, {{0, 1}, {0, 2}}, {{0, 4}}, {{0, 3}}});
    const RunConfiguration& one = candidate.configurations.front();
    EvidenceCost cost{variantOf(candidate, one, 1), {}};
    for (int i = 1; i <= 12; ++i)
      cost.samples.push_back({i % 2 ? 2u : 16u, 1000.0 * i, 300.0 * (13 - i),
                              *one.overhead_ms + (1000.0 * i * *one.hit_ns + 300.0 * (13 - i) * *one.miss_ns) * 1e-6});
    evidence.costs.push_back(cost);
  }
  evidence.session = "orbit_fast", evidence.frame = 64, evidence.original = "original.png";
  const RunChoice& choice = run.choice;
  evidence.pictures.push_back({{choice.candidate_id, choice.strategy, choice.pattern, choice.filter, choice.encoding, choice.block_pixels, choice.period_frames},
                               "cached_0.png", "error_0.png", "hit_miss_0.png", "payload_0.png"});
  for (const RunVariant& variant : run.front) evidence.pictures.push_back({variant, "cached_1.png", "error_0.png", "hit_miss_0.png", ""});
  for (const int frame : {0, 16, 32}) evidence.strip.push_back({frame, "original.png", "cached_0.png"});
  const ReportImages images = pictures();
  made.files = {{"original.png", images.original}, {"cached_0.png", images.cached}, {"cached_1.png", images.cached}, {"error_0.png", images.error},
                {"hit_miss_0.png", images.hit_miss}, {"payload_0.png", images.cached}};
  return made;
}

}  // namespace reprise::sample
