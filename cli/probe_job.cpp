#include "cli/probe_job.h"

#include <algorithm>

namespace reprise {
namespace {

constexpr std::uint32_t kProbeScale = 4;

}  // namespace

Job probeJob(const Measuring& measuring, JobKind kind, int frames) {
  Job job;
  job.kind = kind;
  job.scenario_path = measuring.scenario_path;
  job.original_dir = measuring.original_dir;
  job.device = measuring.device;
  job.frames = frames;
  job.width = std::max(64u, measuring.base.width / kProbeScale);
  job.height = std::max(36u, measuring.base.height / kProbeScale);
  return job;
}

}  // namespace reprise
