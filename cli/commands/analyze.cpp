#include "cli/commands/analyze.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "cli/commands/annotate.h"
#include "cli/divergence_warnings.h"
#include "compiler/ir/prepare.h"
#include "compiler/source/depfile.h"

namespace reprise {
namespace {

struct Listing {
  const PreparedShader& shader;
  const ShaderAnalysis& analysis;
  const std::vector<Candidate>& candidates;
  const std::vector<DivergenceWarning> warnings;
};

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

std::string titleOf(const Candidate& candidate) {
  return candidate.name.empty() ? "(" + candidate.operation + ")" : candidate.name;
}

std::string placeText(const Place& place) {
  return fmt::format("{}:{}:{}", place.file, place.line, place.column);
}

nlohmann::json valuesJson(const Candidate& candidate) {
  nlohmann::json values = nlohmann::json::array();
  for (const CandidateValue& value : candidate.values)
    values.push_back({{"name", value.name}, {"operation", value.operation}, {"type", value.type}, {"file", value.place.file},
                      {"line", value.place.line}, {"column", value.place.column}});
  return values;
}

nlohmann::json toJson(const Listing& listing) {
  nlohmann::json values = nlohmann::json::array();
  const auto kept = static_cast<std::size_t>(
      std::count_if(listing.candidates.begin(), listing.candidates.end(), [](const Candidate& candidate) { return candidate.kept(); }));
  std::size_t rank = 0;
  for (const Candidate& candidate : listing.candidates) {
    nlohmann::json value = {{"id", candidate.id}, {"name", candidate.name}, {"operation", candidate.operation},
                            {"type", candidate.type}, {"file", candidate.place.file}, {"line", candidate.place.line},
                            {"column", candidate.place.column}, {"channels", candidate.channels}, {"saved_cost", candidate.saved_cost},
                            {"cost_share", candidate.share}, {"slice_cost", candidate.slice_cost},
                            {"inputs", inputNames(candidate, listing.analysis)}, {"conditional", candidate.conditional},
                            {"candidate", candidate.kept()}};
    if (candidate.values.size() > 1) value["values"] = valuesJson(candidate);
    if (candidate.kept()) {
      value["rank"] = ++rank;
      value["ranked"] = rankText(candidate, rank, kept, listing.analysis);
    }
    if (!candidate.kept()) value["reason"] = {{"code", candidate.dropped.code}, {"message", candidate.dropped.message}};
    values.push_back(std::move(value));
  }
  nlohmann::json document = {{"shader_cost", listing.analysis.total_cost}, {"values", std::move(values)}};
  document["warnings"] = nlohmann::json::array();
  for (const DivergenceWarning& warning : listing.warnings)
    document["warnings"].push_back({{"code", kDivergentDerivative}, {"message", warning.message}, {"file", warning.place.file},
                                    {"line", warning.place.line}, {"column", warning.place.column}});
  if (listing.analysis.refusal)
    document["refusal"] = {{"code", listing.analysis.refusal->code}, {"message", listing.analysis.refusal->message}};
  return document;
}

void printCandidates(const Listing& listing, std::ostream& out) {
  out << fmt::format("{:<24} {:<12} {:>8} {:>7}  {}\n", "candidate", "type", "saves", "share", "place");
  for (const Candidate& candidate : listing.candidates) {
    if (!candidate.kept()) continue;
    out << fmt::format("{:<24} {:<12} {:>8.0f} {:>6.1f}%  {}\n", titleOf(candidate), candidate.type, candidate.saved_cost,
                       candidate.share * 100, placeText(candidate.place));
    out << fmt::format("    depends on {}{}\n", joined(inputNames(candidate, listing.analysis)),
                       candidate.conditional ? "; computed on some paths only, and guarded" : "");
  }
}

void printDropped(const Listing& listing, bool all, std::ostream& out) {
  std::map<std::string, std::pair<int, std::string>> reasons;
  for (const Candidate& candidate : listing.candidates)
    if (!candidate.kept()) {
      auto& [count, example] = reasons[candidate.dropped.code];
      if (count++ == 0) example = candidate.dropped.message;
    }
  out << "\nno candidates:\n";
  for (const auto& [code, reason] : reasons) out << fmt::format("{:>6}  {:<18} {}\n", reason.first, code, reason.second);
  if (!all) {
    out << "(--all lists them one by one)\n";
    return;
  }
  out << '\n';
  for (const Candidate& candidate : listing.candidates)
    if (!candidate.kept())
      out << fmt::format("{}: {} {}, saves {:.0f}: {} [{}]\n", placeText(candidate.place), candidate.type, titleOf(candidate),
                         candidate.saved_cost, candidate.dropped.message, candidate.dropped.code);
}

}  // namespace

Result<void> analyzeShader(const AnalyzeArguments& arguments, std::ostream& out) {
  CompileOptions options = arguments.compile;
  options.stage = ShaderStage::kFragment;
  REPRISE_ASSIGN(const CompiledShader compiled, compile(arguments.shader, options));
  if (!arguments.depfile.empty()) {
    std::vector<std::string> dependencies{arguments.shader};
    dependencies.insert(dependencies.end(), compiled.dependencies.begin(), compiled.dependencies.end());
    REPRISE_TRY(writeDepfile(arguments.depfile, arguments.shader, dependencies));
  }
  REPRISE_ASSIGN(const Module module, readModule(compiled.words));
  REPRISE_ASSIGN(const PreparedShader shader, prepareForCaching(module, ""));
  const ShaderAnalysis analysis = analyse(shader);
  const std::vector<Candidate> candidates = enumerateCandidates(shader, analysis, compiled.sources, {});
  const Listing listing{shader, analysis, candidates, divergenceWarnings(shader, analysis, compiled.sources)};
  if (arguments.json) {
    out << toJson(listing).dump(2) << '\n';
    return {};
  }
  out << fmt::format("{}: cost {:.0f} (in scalar additions)\n", arguments.shader, analysis.total_cost);
  if (analysis.refusal) out << "no variant can be made: " << analysis.refusal->message << " [" << analysis.refusal->code << "]\n";
  for (const DivergenceWarning& warning : listing.warnings)
    out << fmt::format("{}: warning: {} [{}]\n", placeText(warning.place), warning.message, kDivergentDerivative);
  out << '\n';
  if (arguments.annotate) {
    printAnnotated({shader, analysis, candidates, compiled.sources}, out);
    return {};
  }
  printCandidates(listing, out);
  printDropped(listing, arguments.all, out);
  return {};
}

}  // namespace reprise
