#include "cli/training_laws.h"

#include <fmt/format.h>

#include <algorithm>

namespace reprise {

// Those whose candidate has not been held to the laws in this strategy; that then counts as done.
std::vector<StudyAndStrategy> TrainingLaws::unheld(const std::vector<StudyAndStrategy>& wanted, const Training& training) {
  std::vector<StudyAndStrategy> found;
  for (const auto& [study, strategy] : wanted)
    if (held_.insert({training.errors[study].candidate, strategy}).second) found.emplace_back(study, strategy);
  return found;
}

Result<std::map<StudyAndStrategy, FailureRow>> TrainingLaws::convict(const std::vector<StudyAndStrategy>& wanted, Training& training) {
  const std::vector<StudyAndStrategy> fresh = unheld(wanted, training);
  std::vector<VariantToHold> variants;
  for (const auto& [study, strategy] : fresh) {
    variants.push_back({subject_.candidates[training.errors[study].candidate], training.errors[study].options, {}});
    variants.back().options.strategy = strategy;
  }
  REPRISE_ASSIGN(const std::vector<LawVerdict> verdicts, holdLaws(subject_, workspace_, measuring_, variants, progress_, HeldSessions::kTraining));
  std::map<StudyAndStrategy, FailureRow> convictions;
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    const std::string& id = variants[i].candidate.id;
    if (verdicts[i].conviction) {
      convictions[fresh[i]] = *verdicts[i].conviction;
      training.warnings.push_back(fmt::format("{} in {} was left out: {}", id, fresh[i].second, verdicts[i].conviction->message));
    } else if (!verdicts[i].refused && verdicts[i].frozen_hits == 0) {
      training.warnings.push_back(fmt::format("{} in {}: no hit was seen with the scene frozen, so none was compared with the original", id, fresh[i].second));
    }
  }
  return convictions;
}

Result<std::set<std::size_t>> TrainingLaws::holdErrors(const std::set<std::size_t>& studies, Training& training) {
  std::vector<StudyAndStrategy> wanted;
  for (const std::size_t study : studies) wanted.emplace_back(study, training.errors[study].options.strategy);
  REPRISE_ASSIGN(const auto convictions, convict(wanted, training));
  std::set<std::size_t> convicted;
  for (const auto& [which, why] : convictions) {
    ErrorStudy& study = training.errors[which.first];
    study.failure = why.message;
    if (isLawBroken(why)) training.convicted[study.candidate] = why;
    convicted.insert(which.first);
  }
  const bool none_left = std::all_of(training.errors.begin(), training.errors.end(), [](const ErrorStudy& study) { return !study.failure.empty(); });
  if (convicted.empty() || training.convicted.empty() || !none_left) return convicted;
  const auto& [candidate, why] = *training.convicted.begin();
  return Error{ErrorKind::kInput, why.code, fmt::format("no candidate is left, as none equals the original; {}: {}", subject_.candidates[candidate].id, why.message), {}};
}

}  // namespace reprise
