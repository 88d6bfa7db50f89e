#include "bench/probe_ranges.h"

#include "cli/train.h"

namespace reprise {

Result<ValueRanges> probeRanges(const Subject& subject, const Workspace& workspace, std::size_t candidate, const ProbePlan& plan) {
  VariantOptions options = baseOptions(subject, {}, subject.candidates[candidate]);
  options.strategy = "branch";
  options.encoding = Encoding::kRgba32f;
  REPRISE_ASSIGN(const StoredVariant stored, storeVariant(workspace, subject.program, subject.candidates[candidate], options, subject.limits));
  Job job;
  job.kind = JobKind::kProbe;
  job.scenario_path = workspace.scenarioFile().string();
  job.session = plan.session;
  job.original_dir = stored.dir;
  job.entries = {{stored.dir, 1}};
  job.frames = 8;
  job.width = subject.scenario.width / 4;
  job.height = subject.scenario.height / 4;
  job.device = plan.device;
  SupervisorOptions supervisor;
  supervisor.worker_path = plan.worker_path;
  REPRISE_ASSIGN(const JobResult result, superviseJob(job, supervisor, {}));
  const ProbeResult& probe = result.probes[0];
  ValueRanges ranges;
  ranges.depth_near = probe.depth_min * 0.5f;
  ranges.depth_far = probe.depth_max * 1.5f;
  ranges.payload_min = probe.payload_min;
  ranges.payload_max = probe.payload_max;
  return ranges;
}

}  // namespace reprise
