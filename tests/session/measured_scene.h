// A scenario of shaders/ or of the test's own, with packages of its original and of variants on disk, ready for jobs.
#pragma once

#include <filesystem>
#include <string>

#include "compiler/strategies/build_recipe.h"
#include "profiler/session/job.h"
#include "runtime/package/package.h"
#include "tests/e2e/run_command.h"

namespace reprise {

class MeasuredScene {
 public:
  // `scenario`: a path, from the root of the sources unless absolute.
  explicit MeasuredScene(const std::string& scenario);

  const std::string& scenario() const { return scenario_; }
  const std::string& original() const { return original_; }
  const ShaderProgram& program() const { return program_; }
  // A package of the value `payload`, or of the first candidate that the whole screen computes; the directory. `name` tells
  // variants apart.
  std::string variant(const std::string& name, const VariantOptions& options, const std::string& payload = "") const;
  // A job in the first training session, with one entry.
  Job job(JobKind kind, const JobEntry& entry) const;
  const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
  std::string scenario_, session_, original_;
  ShaderProgram program_;
  std::vector<Candidate> candidates_;
};

// What variants of these tests have in common: two passes, counting, interleaved, bilinear, rgba16f.
VariantOptions countingVariant();

}  // namespace reprise
