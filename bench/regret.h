// How much slower a run's choice is than the best that a search of everything would have found (DESIGN of selection: regret).
//
//   regret = t(choice) / t(best) - 1
// over the top four candidates x all strategies x four periods, with the pattern, filter and encoding of the choice, measured on the
// validation sessions: t is the median of the binding clock, all variants of a candidate and the choice alternating in one run, so
// times of different candidates are compared by their ratios to the choice. Best: the least t among those whose worst session keeps the
// threshold, the choice and the original among them.
#pragma once

#include <filesystem>
#include <string>

#include "cli/report/result.h"
#include "runtime/base/result.h"

namespace reprise {

struct RegretPlan {
  std::filesystem::path directory;  // of a finished run (`optimize`); what was measured is kept in DIR/regret
  std::string device, worker_path;
  int rounds = 10;                  // per session
};

struct Regret {
  double value = 0;                 // 0: nothing measured is faster
  std::string best;                 // which variant is the fastest
  double best_error = 0;            // worst validation session
  std::size_t variants = 0, within_threshold = 0;
};

// Resumable: each candidate's rows are a file in DIR/regret, read back where it is there. Errors: of the stages and of the worker.
Result<Regret> measureRegret(const RegretPlan& plan);

}  // namespace reprise
