#include "cli/probe_candidates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/probe_job.h"
#include "cli/train.h"

namespace reprise {
namespace {

constexpr int kProbeFrames = 12;
constexpr float kPayloadMargin = 0.05f;
// Stands for a far plane at infinity, in distances of the near plane: floats still tell depths apart by a hundredth of that distance.
constexpr float kInfinityInNears = 1e6f;

void merge(ProbeResult& all, const ProbeResult& probe) {
  for (std::size_t channel = 0; channel < kMostPayloadChannels; ++channel) {
    all.payload_min[channel] = std::min(all.payload_min[channel], probe.payload_min[channel]);
    all.payload_max[channel] = std::max(all.payload_max[channel], probe.payload_max[channel]);
    all.payload_change[channel] = std::max(all.payload_change[channel], probe.payload_change[channel]);
  }
  all.depth_min = std::min(all.depth_min, probe.depth_min);
  all.depth_max = std::max(all.depth_max, probe.depth_max);
  all.nonfinite_payload += probe.nonfinite_payload;
  all.nonfinite_color += probe.nonfinite_color;
  all.covered += probe.covered;
}

ValueRanges widened(const ProbeResult& probe, ValueRanges ranges) {
  if (probe.covered > 0 && probe.depth_max > probe.depth_min) {
    ranges.depth_near = std::max(ranges.depth_near, probe.depth_min * 0.5f);
    ranges.depth_far = std::min(ranges.depth_far, probe.depth_max * 1.5f);
  }
  for (std::size_t channel = 0; channel < kMostPayloadChannels; ++channel) {
    const float margin = (probe.payload_max[channel] - probe.payload_min[channel]) * kPayloadMargin;
    ranges.payload_min[channel] = probe.payload_min[channel] - margin;
    ranges.payload_max[channel] = probe.payload_max[channel] + margin;
  }
  return ranges;
}

// What each candidate's probe saw, over all training sessions.
void conclude(const Subject& subject, const std::map<std::size_t, ProbeResult>& seen, ProbedRanges& probed) {
  bool told_of_color = false;
  for (const auto& [candidate, probe] : seen) {
    probed.ranges[candidate] = widened(probe, unprobedRanges(subject));
    probed.changes[candidate] = probe.payload_change;
    if (probe.nonfinite_payload > 0)
      probed.warnings.push_back(fmt::format("{}: {} pixels had a payload that is not finite or was not computed; such pixels always miss",
                                            subject.candidates[candidate].id, probe.nonfinite_payload));
    if (probe.nonfinite_color > 0 && !told_of_color) {
      told_of_color = true;
      probed.warnings.push_back(fmt::format("the original shader itself gives NaN or infinity in {} pixels of the probe; they are left out of errors",
                                            probe.nonfinite_color));
    }
  }
}

}  // namespace

ValueRanges unprobedRanges(const Subject& subject) {
  ValueRanges ranges;
  ranges.depth_near = 1e9f;
  ranges.depth_far = 0;
  for (const SessionSpec& session : subject.scenario.sessions) {
    const Camera& camera = session.camera;
    ranges.depth_near = std::min(ranges.depth_near, camera.near_plane);
    ranges.depth_far = std::max(ranges.depth_far, std::isinf(camera.far_plane) ? kInfinityInNears * camera.near_plane : camera.far_plane);
  }
  // Orthographic history depth is clip z.
  if (subject.orthographic) ranges.depth_near = 0, ranges.depth_far = 1;
  return ranges;
}

Result<ProbedRanges> probeCandidates(const Subject& subject, const Workspace& workspace, const Measuring& measuring, Progress& progress) {
  ProbedRanges probed;
  Job job = probeJob(measuring, JobKind::kProbe, kProbeFrames);
  std::vector<std::size_t> entries;  // candidate of each
  for (std::size_t candidate = 0; candidate < subject.candidates.size(); ++candidate) {
    if (!subject.candidates[candidate].kept()) continue;
    VariantOptions options = baseOptions(subject, unprobedRanges(subject), subject.candidates[candidate]);
    options.strategy = "branch";
    options.encoding = Encoding::kRgba32f;
    const Result<StoredVariant> variant = storeVariant(workspace, subject.program, subject.candidates[candidate], options, subject.limits);
    if (!variant.ok()) {
      if (variant.error().kind != ErrorKind::kRefused) return variant.error();
      probed.failed[candidate] = variant.error().message;
      continue;
    }
    job.entries.push_back({variant->dir, 1});
    entries.push_back(candidate);
  }
  if (entries.empty()) return probed;
  progress.begin("probe payload ranges");
  std::map<std::size_t, ProbeResult> seen;
  for (const SessionSpec& session : subject.scenario.sessions) {
    if (session.role != SessionRole::kTraining) continue;
    job.session = session.name;
    const Result<JobResult> result = superviseJob(job, measuring.supervisor, measuring.progress);
    if (!result.ok()) {
      if (result.error().kind != ErrorKind::kMeasurement) return result.error();
      for (const std::size_t candidate : entries) probed.failed[candidate] = result.error().message;
      return probed;
    }
    for (std::size_t i = 0; i < entries.size(); ++i)
      if (const auto [entry, first] = seen.emplace(entries[i], result->probes[i]); !first) merge(entry->second, result->probes[i]);
  }
  conclude(subject, seen, probed);
  return probed;
}

}  // namespace reprise
