#include "cli/commands/annotate.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "compiler/analysis/line_costs.h"

namespace reprise {
namespace {

constexpr double kLeastShown = 0.0005;  // of the cost: what would print as 0.0%

std::string letterOf(std::size_t index) { return index < 26 ? std::string(1, static_cast<char>('A' + index)) : std::to_string(index + 1); }

std::string ordinal(std::size_t number) {
  const std::size_t last = number % 10, tens = number % 100;
  const char* suffix = tens >= 11 && tens <= 13 ? "th" : last == 1 ? "st" : last == 2 ? "nd" : last == 3 ? "rd" : "th";
  return std::to_string(number) + suffix;
}

}  // namespace

std::string rankText(const Candidate& candidate, std::size_t rank, std::size_t count, const ShaderAnalysis& analysis) {
  std::string inputs;
  for (const std::string& input : inputNames(candidate, analysis)) inputs += (inputs.empty() ? "" : ", ") + input;
  return fmt::format("{} of {}: a hit saves {:.1f}% of the cost; {} channel{}; changes with {}{}", ordinal(rank), count, candidate.share * 100,
                     candidate.channels, candidate.channels == 1 ? "" : "s", inputs,
                     candidate.conditional ? "; computed on some paths only, and guarded" : "");
}

void printAnnotated(const AnnotatedShader& annotated, std::ostream& out) {
  const auto shares = lineCosts(annotated.shader, annotated.analysis);
  std::vector<const Candidate*> kept;
  for (const Candidate& candidate : annotated.candidates)
    if (candidate.kept()) kept.push_back(&candidate);
  for (const SourceFile& source : annotated.sources) {
    const auto mentions = [&](const auto& share) { return share.first.first == source.path; };
    const bool marked = std::any_of(kept.begin(), kept.end(), [&](const Candidate* candidate) { return candidate->place.file == source.path; });
    if (!marked && std::none_of(shares.begin(), shares.end(), mentions)) continue;
    out << source.path << '\n';
    std::istringstream lines(source.text);
    std::string text;
    for (int line = 1; std::getline(lines, text); ++line) {
      const auto share = shares.find({source.path, line});
      std::string letters;
      for (std::size_t i = 0; i < kept.size(); ++i)
        if (kept[i]->place.file == source.path && kept[i]->place.line == line) letters += letterOf(i);
      const bool shown = share != shares.end() && share->second >= kLeastShown;
      out << fmt::format("{:>6} {:<3} {:>5} | {}\n", shown ? fmt::format("{:.1f}%", share->second * 100) : "", letters, line, text);
    }
    out << '\n';
  }
  const auto unplaced = shares.find({"", 0});
  if (unplaced != shares.end()) out << fmt::format("{:.1f}% of the cost has no line\n", unplaced->second * 100);
  for (std::size_t i = 0; i < kept.size(); ++i)
    out << fmt::format("{} {} {}: {}\n", letterOf(i), kept[i]->type, kept[i]->name.empty() ? kept[i]->operation : kept[i]->name,
                       rankText(*kept[i], i + 1, kept.size(), annotated.analysis));
}

}  // namespace reprise
