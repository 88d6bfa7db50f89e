#include "cli/probe_objects.h"

#include <fmt/format.h>

#include "cli/probe_job.h"
#include "cli/train.h"

namespace reprise {
namespace {

constexpr int kProbeFrames = 16;

}  // namespace

Result<std::map<std::string, std::string>> strategiesWithoutIdleObjects(const Subject& subject, const Workspace& workspace, const Measuring& measuring,
                                                                        const ObjectProbe& probe, Progress& progress) {
  std::map<std::string, std::string> reasons;
  Job job = probeJob(measuring, JobKind::kObjects, kProbeFrames);
  for (const Strategy& strategy : strategies()) {
    if (!strategy.selectable || !flagsDraws(strategy)) continue;
    VariantOptions options = baseOptions(subject, probe.ranges, subject.candidates[probe.candidate]);
    options.strategy = strategy.name;
    const Result<StoredVariant> variant = storeVariant(workspace, subject.program, subject.candidates[probe.candidate], options, subject.limits);
    if (!variant.ok() && variant.error().kind == ErrorKind::kRefused) continue;
    if (!variant.ok()) return variant.error();
    job.entries = {{variant->dir, subject.scenario.stereo ? 2 : kNeverRefresh}};
    progress.begin("probe objects");
    ObjectCounts counts;
    for (const SessionSpec& session : subject.scenario.sessions) {
      if (session.role != SessionRole::kTraining) continue;
      job.session = session.name;
      const Result<JobResult> result = superviseJob(job, measuring.supervisor, measuring.progress);
      if (!result.ok() && result.error().kind != ErrorKind::kMeasurement) return result.error();
      if (!result.ok()) {
        if (result.error().code == "player.requirement") reasons[strategy.name] = result.error().message;
        break;
      }
      counts.drawn += result->objects.at(0).drawn;
      counts.flagged += result->objects.at(0).flagged;
    }
    const double share = counts.drawn > 0 ? static_cast<double>(counts.flagged) / static_cast<double>(counts.drawn) : 0;
    if (share > kMostObjectsWithMisses)
      reasons[strategy.name] = fmt::format("it leaves out objects without misses, but {:.0f}% of the objects of a frame have some, even if nothing is ever refreshed", 100 * share);
  }
  return reasons;
}

}  // namespace reprise
