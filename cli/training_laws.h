// Before training measures a candidate, it is held to the laws (cli/hold_laws.h), once, in the strategy that its errors are rendered with.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/hold_laws.h"
#include "cli/trained.h"

namespace reprise {

using StudyAndStrategy = std::pair<std::size_t, std::string>;  // index into Training::errors

class TrainingLaws {
 public:
  // All must outlive it.
  TrainingLaws(const Subject& subject, const Workspace& workspace, const Measuring& measuring, Progress& progress)
      : subject_(subject), workspace_(workspace), measuring_(measuring), progress_(progress) {}

  // Of studies whose errors are about to be measured, in the strategy that they are rendered with: those that differ from the original, or cannot
  // be compared with it. `training` is told why. Errors: those of holdLaws; kInput with the broken law where no study is left of the whole run.
  Result<std::set<std::size_t>> holdErrors(const std::set<std::size_t>& studies, Training& training);

 private:
  // Why each of them must not be measured; nothing of the others, nor of a candidate that was held in this strategy before. Warnings go to
  // `training`. Errors: those of holdLaws.
  Result<std::map<StudyAndStrategy, FailureRow>> convict(const std::vector<StudyAndStrategy>& wanted, Training& training);
  std::vector<StudyAndStrategy> unheld(const std::vector<StudyAndStrategy>& wanted, const Training& training);

  const Subject& subject_;
  const Workspace& workspace_;
  const Measuring& measuring_;
  Progress& progress_;
  std::set<std::pair<std::size_t, std::string>> held_;  // candidate and strategy
};

}  // namespace reprise
