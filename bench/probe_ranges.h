// The ranges of payload and depth that a variant is built for, seen in 8 frames of one session at a quarter of the resolution, with margins.
#pragma once

#include "cli/subject.h"
#include "cli/workspace.h"
#include "profiler/session/job.h"

namespace reprise {

struct ProbePlan {
  std::string session, device, worker_path;
};

// `candidate` is an index into subject.candidates. The workspace holds the scenario. Errors: of buildPackage and of the worker.
Result<ValueRanges> probeRanges(const Subject& subject, const Workspace& workspace, std::size_t candidate, const ProbePlan& plan);

}  // namespace reprise
