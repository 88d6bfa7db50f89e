#include "bench/timed_variants.h"

#include <algorithm>

namespace reprise {

Result<void> timeVariants(const VariantTiming& plan, const Workspace& workspace, std::vector<TimedVariant>& timed) {
  Job job;
  job.kind = JobKind::kTimes;
  job.scenario_path = workspace.scenarioFile().string();
  job.session = plan.session;
  job.original_dir = timed[0].stored.dir;
  job.rounds = plan.rounds;
  job.device = plan.device;
  for (const TimedVariant& one : timed) job.entries.push_back({one.stored.dir, plan.period_frames});
  SupervisorOptions options;
  options.worker_path = plan.worker_path;
  REPRISE_ASSIGN(const JobResult result, superviseJob(job, options, {}));
  for (std::size_t i = 0; i < timed.size(); ++i)
    for (const TimeRow& row : result.times[i]) timed[i].clock_ms.push_back(result.cpu_device ? row.cpu_ms : row.gpu_ms);
  return {};
}

std::size_t surfacePayload(const Subject& subject) {
  for (std::size_t i = 0; i < subject.candidates.size(); ++i) {
    const Candidate& candidate = subject.candidates[i];
    const bool moves = std::any_of(candidate.inputs.begin(), candidate.inputs.end(), [&](int input) {
      return subject.program.analysis.inputs[static_cast<std::size_t>(input)].kind == InputKind::kUniform;
    });
    if (candidate.kept() && !moves) return i;
  }
  return 0;
}

}  // namespace reprise
