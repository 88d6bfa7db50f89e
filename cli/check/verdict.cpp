#include "cli/check/verdict.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

namespace reprise {
namespace {

constexpr std::array<const char*, 7> kNames = {"verified", "unshown", "refused", "untestable", "failed", "crashed", "hung"};

std::string textOf(const nlohmann::json& json) { return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace); }

std::string quoted(const std::string& word) {
  if (word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%") == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace

const char* nameOf(Verdict verdict) { return kNames[static_cast<std::size_t>(verdict)]; }

bool isOurFault(Verdict verdict) { return verdict == Verdict::kFailed || verdict == Verdict::kCrashed || verdict == Verdict::kHung; }

std::string verdictToJson(const ModuleVerdict& verdict) {
  return textOf({{"path", verdict.path}, {"verdict", nameOf(verdict.verdict)}, {"code", verdict.code}, {"reason", verdict.reason},
                 {"candidates", verdict.candidates}, {"variants", verdict.variants}, {"refused_strategies", verdict.refused_strategies},
                 {"seconds", verdict.seconds}});
}

ModuleVerdict verdictFromJson(const std::string& text) {
  const nlohmann::json json = nlohmann::json::parse(text);
  ModuleVerdict verdict;
  const std::string name = json.at("verdict");
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (name == kNames[i]) verdict.verdict = static_cast<Verdict>(i);
  verdict.path = json.at("path");
  verdict.code = json.at("code");
  verdict.reason = json.at("reason");
  verdict.candidates = json.at("candidates");
  verdict.variants = json.at("variants");
  verdict.refused_strategies = json.at("refused_strategies").get<std::vector<std::string>>();
  verdict.seconds = json.at("seconds");
  return verdict;
}

std::string requestToJson(const CheckRequest& request) {
  return textOf({{"path", request.path}, {"device", request.device}, {"entry_point", request.entry_point},
                 {"include_dirs", request.include_dirs}, {"defines", request.defines}, {"seed", request.seed},
                 {"candidates", request.candidates}, {"strategy", request.strategy}, {"timeout_s", request.timeout_s}});
}

CheckRequest requestFromJson(const std::string& text) {
  const nlohmann::json json = nlohmann::json::parse(text);
  CheckRequest request;
  request.path = json.at("path");
  request.device = json.at("device");
  request.entry_point = json.at("entry_point");
  request.include_dirs = json.at("include_dirs").get<std::vector<std::string>>();
  request.defines = json.at("defines").get<std::vector<std::string>>();
  request.seed = json.at("seed");
  request.candidates = json.at("candidates");
  request.strategy = json.at("strategy");
  request.timeout_s = json.at("timeout_s");
  return request;
}

std::string repeatCommand(const CheckRequest& request, std::uint32_t seed, const std::string& strategy) {
  const CheckRequest defaults;
  std::string command = "reprise check " + quoted(request.path);
  for (const std::string& directory : request.include_dirs) command += " -I " + quoted(directory);
  for (const std::string& define : request.defines) command += " -D " + quoted(define);
  if (request.entry_point != defaults.entry_point) command += " --entry-point " + quoted(request.entry_point);
  if (!request.device.empty()) command += " --device " + quoted(request.device);
  if (request.candidates != defaults.candidates) command += fmt::format(" --candidates {}", request.candidates);
  command += fmt::format(" --seed {}", seed);
  return strategy.empty() ? command : command + " --strategy " + strategy;
}

}  // namespace reprise
