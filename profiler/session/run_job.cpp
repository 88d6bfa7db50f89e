#include "profiler/session/stage.h"

namespace reprise {

Result<JobResult> runJob(const Job& job, const std::function<void(const JobProgress&)>& progress) {
  switch (job.kind) {
    case JobKind::kErrors: return runErrors(job, progress);
    case JobKind::kTimes: return runTimes(job, progress);
    case JobKind::kProbe: return runProbe(job, progress);
    case JobKind::kObjects: return runObjects(job, progress);
    case JobKind::kImages: return runImages(job, progress);
    case JobKind::kReference: return runReference(job, progress);
    case JobKind::kLaws: return runLaws(job, progress);
  }
  return Error{ErrorKind::kInput, "job.kind", "an unknown kind of job", {}};
}

}  // namespace reprise
