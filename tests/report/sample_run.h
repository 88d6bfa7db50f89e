// Made-up runs of a believable shape for the tests of the report: a long marble shader, seventeen candidates,
// eight of them trained in several configurations, errors and times from the models plus a repeatable
// disturbance.
#pragma once

#include "cli/report/result.h"
#include "cli/report/write_report.h"

namespace reprise::sample {

RunResult variantRun();   // a variant was chosen
RunResult originalRun();  // nothing qualified
RunResult emptyRun();     // stopped before anything was found: every list empty
// variantRun with markup, script ends, quotes, control characters and bytes that are not UTF-8 in every text
// from a file.
RunResult hostileRun();

// Forty candidates, each trained in one configuration, with a front over several of them.
RunResult manyCandidatesRun();

// Source, cuts, cost samples and pictures that go with a run.
ReportEvidence evidenceOf(const RunResult& run);

// Small pictures of a marbled ball.
ReportImages pictures();

}  // namespace reprise::sample
