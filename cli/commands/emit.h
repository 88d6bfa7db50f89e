// `reprise emit`: the package of a choice from the sources, without training, and without a device unless it is to be verified.
#pragma once

#include <functional>
#include <ostream>
#include <string>

#include "cli/demand.h"
#include "runtime/base/result.h"

namespace reprise {

enum class OnStale { kFail, kOriginal };

struct EmitArguments {
  std::string scenario, choice;
  std::string output;            // the package; with `header` it may be empty
  std::string header;            // the package as a C++ header; empty: none
  std::string header_name = "package";  // of the constant in it
  OnStale on_stale = OnStale::kFail;
  DemandWords asked;                    // what the choice has to bind (cli/choice_threshold.h); without a word nothing
  bool list_dependencies = false;       // -M: print the rule and write nothing else
  std::string depfile;                  // -MF; empty: none
  std::string depfile_target;           // -MT; empty: the manifest, else the header
  bool verify = false;                  // hold the package to the original first, on a device (cli/hold_laws.h)
  std::string device, worker_path;      // for `verify`: as in BenchOptions
  std::function<bool()> interrupted;
};

// Notes (a choice of another version of the tool, the original in place of a stale payload) go to `notes`, the rule of -M to `out`.
// Errors: those of readScenario, readChoice, holdThresholds, findPayload and buildPackage; file.unwritable (kMachine); emit.output (kUsage); with `verify`
// law.exact_setting and law.frozen_world (kInput; nothing is written), and those of holdLaws.
Result<void> emitChoice(const EmitArguments& arguments, std::ostream& out, std::ostream& notes);

}  // namespace reprise
