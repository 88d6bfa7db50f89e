#include "cli/report/text.h"

namespace reprise {
namespace {

std::string payloadNames(const RunChoice& choice) {
  std::string names;
  for (std::size_t i = 0; i < choice.payload.size(); ++i) {
    if (i > 0) names += i + 1 == choice.payload.size() ? " and " : ", ";
    names += printable(choice.payload[i].name);
  }
  return names.empty() ? printable(choice.candidate_id) : names;
}

std::string variantSentence(const RunResult& result) {
  const RunChoice& choice = result.choice;
  std::string text = "Caching " + payloadNames(choice) + " (" + printable(choice.strategy) + ", ";
  text += refreshText(choice.period_frames);
  text += ")";
  if (choice.measured_speedup) {
    text += " makes the shader " + formatNumber(*choice.measured_speedup) + " times as fast";
    if (choice.speedup_ci95) {
      text += " (95% interval " + formatNumber(choice.speedup_ci95->lo) + " to " +
              formatNumber(choice.speedup_ci95->hi) + ")";
    }
  } else {
    text += " was chosen";
  }
  if (choice.measured_error) text += " with a validation error of " + errorText(result, *choice.measured_error);
  return text + "; allowed was " + thresholdsText(result) + ".";
}

}  // namespace

std::string choiceSentence(const RunResult& result) {
  if (result.choice.kind == ChoiceKind::kVariant) return variantSentence(result);
  std::string reason =
      result.choice.reason.empty() ? "no variant qualified" : printable(result.choice.reason);
  if (reason.back() == '.') reason.pop_back();
  if (result.choice.kind == ChoiceKind::kUndecided) return "Undecided, not enough was measured: " + reason + ".";
  return "The original shader is the best answer: " + reason + ".";
}

}  // namespace reprise
