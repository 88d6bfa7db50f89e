// What a run chose, as a small file to commit beside the shader: DIR/choice.json. `reprise emit` makes the package from it and the
// sources, without a device; `reprise validate --choice` measures it again. docs/build_step.md describes the file.
//
// Keys are sorted, one value stands on a line, floats have the digits that give them back: the file changes where the choice does.
// There is no time, no path of a machine and nothing random in it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compiler/candidates/find_payload.h"
#include "compiler/strategies/build_recipe.h"
#include "profiler/metrics/error_limits.h"
#include "runtime/base/result.h"

namespace reprise {

inline constexpr int kChoiceFormatVersion = 2;

struct ChosenDevice {
  std::string name, driver, clock;  // clock: "process_cpu" or "timestamps"
  bool operator==(const ChosenDevice&) const = default;
};

// What was fitted for the variant, for people and for comparing; emit reads none of it.
struct ChosenModels {
  std::string error_family;                 // "power", ...
  std::map<std::string, double> error_parameters;
  std::optional<double> hit_ns, miss_ns, overhead_ms, hit_rate_mu;
  bool operator==(const ChosenModels&) const = default;
};

struct ChosenMeasures {
  std::optional<double> error, speedup, speedup_low, speedup_high, frame_ms, original_frame_ms;
  bool operator==(const ChosenMeasures&) const = default;
};

struct Choice {
  std::string tool_version;
  bool is_original = true;                  // then payload, candidate_id and variant are empty
  std::string reason;                       // one sentence
  std::string scenario_file, scenario_hash; // the file without folders
  std::string shader_hash;
  std::string quality;                      // the level that bound; "" if none did
  ErrorLimits limits;                       // all thresholds
  double least_gain = 1;
  ChosenDevice device;
  std::string candidate_id;
  std::vector<IdentifiedValue> payload;
  VariantOptions variant;                   // strategy, pattern, block, filter, encoding, period, ranges
  ChosenModels models;
  ChosenMeasures measured;
};

std::string choiceToJson(const Choice& choice);

// Errors (kInput, naming the file): choice.missing, choice.syntax (not JSON), choice.version (of a later Reprise), choice.invalid
// (a key missing or of a wrong type, or a value that this version does not know).
Result<Choice> readChoice(const std::string& file);

}  // namespace reprise
