// The small scenario as files in a folder of the test's own, whole or with one thing wrong.
#pragma once

#include <filesystem>
#include <string>

#include "tests/e2e/run_command.h"

namespace reprise {

class SmallScenario {
 public:
  SmallScenario();  // copies tests/e2e/small

  std::filesystem::path toml() const { return folder_ / "small.toml"; }
  std::filesystem::path fragment() const { return folder_ / "small.frag"; }
  std::filesystem::path vertex() const { return folder_ / "small.vert"; }
  std::filesystem::path output() const { return folder_ / "out"; }
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }

  // Replaces the one place where `wanted` stands in the file. The test fails if there is none or are several.
  void replace(const std::filesystem::path& file, const std::string& wanted,
               const std::string& replacement) const;

  // The line, from 1, on which `wanted` stands first; 0 if it does not.
  static int lineOf(const std::filesystem::path& file, const std::string& wanted);

 private:
  TemporaryFolder folder_;
};

// `reprise optimize` of the scenario with a threshold that a variant can keep, and further words.
CommandSpec optimizeSmall(const SmallScenario& scenario, std::vector<std::string> more = {});

// What a run that failed must not leave: a result or a package, or files under temporary names.
std::string leftovers(const std::filesystem::path& output);

// Returns true when a run has begun to write its measurements and still runs, so that it can be disturbed in
// the middle; false if it ended before.
bool waitForMeasurements(Command& run, const std::filesystem::path& output);

}  // namespace reprise
