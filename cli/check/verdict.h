// What `reprise check` says of one module.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace reprise {

enum class Verdict {
  kVerified,    // every law held in every strategy that could be built, and the inputs made that mean something
  kUnshown,     // every law held, but nothing of the cache could show in the image
  kRefused,     // Reprise says that it cannot cache this shader, and why
  kUntestable,  // no inputs could be made up that show a defined image, or the original alone does not run
  kFailed,      // a law was broken: a bug in Reprise
  kCrashed,     // a rewrite or a variant took the process down, or the time limit, though the original alone runs
  kHung
};
inline constexpr Verdict kVerdicts[] = {Verdict::kVerified, Verdict::kUnshown, Verdict::kRefused, Verdict::kUntestable,
                                        Verdict::kFailed, Verdict::kCrashed, Verdict::kHung};
const char* nameOf(Verdict verdict);  // "verified", "unshown", ...
bool isOurFault(Verdict verdict);     // failed, crashed, hung

struct ModuleVerdict {
  std::string path;
  Verdict verdict = Verdict::kUntestable;
  std::string code;    // "candidate.none", "law.misses_exact", "prepare", ...; empty if verified
  std::string reason;  // one sentence; for a broken law the smallest case and the command that repeats it
  int candidates = 0;  // tried
  int variants = 0;    // that held all laws
  std::uint32_t seed = 0;  // of the inputs that decided
  std::vector<std::string> refused_strategies;  // "two_pass: state.depth_compare"
  double seconds = 0;
};

struct CheckRequest {
  std::string path;
  std::string device;
  std::string entry_point = "main";
  std::vector<std::string> include_dirs;
  std::vector<std::string> defines;  // NAME or NAME=VALUE
  std::uint32_t seed = 1;
  int candidates = 1;                // how many of the best ones
  std::string strategy;              // empty: all
  double timeout_s = 60;             // for the module; the reference has half of it for an answer
};

// The words for a shell that check the same module with the same inputs, in one strategy, or all if it is empty.
std::string repeatCommand(const CheckRequest& request, std::uint32_t seed, const std::string& strategy);

// One line of JSON each; the worker's side of the pipe and --json alike.
std::string verdictToJson(const ModuleVerdict& verdict);
ModuleVerdict verdictFromJson(const std::string& text);
std::string requestToJson(const CheckRequest& request);
CheckRequest requestFromJson(const std::string& text);

}  // namespace reprise
