// What a run is about: the scenario and its shaders, read, compiled and analysed (stages 1 to 4).
#pragma once

#include <filesystem>
#include <vector>

#include "compiler/candidates/enumerate.h"
#include "compiler/strategies/build_recipe.h"
#include "compiler/strategies/shader_program.h"
#include "profiler/scenario/scenario.h"
#include "runtime/package/package.h"

namespace reprise {

struct Subject {
  Scenario scenario;
  ShaderProgram program;
  std::vector<Candidate> candidates;  // kept ones first, ranked
  std::vector<Package> passes;        // by pass of the scenario: the shaders of G-buffer passes
  StateLimits limits;
  bool orthographic = false;
  std::vector<std::string> included;  // by the shaders, each file once
};

// Errors: those of readScenario, compile, readProgram, checkBindings and expectMotion (motion.h); scenario.mixed_projection (kInput), where sessions differ
// in perspective and orthographic cameras, which one recipe cannot serve.
Result<Subject> readSubject(const std::filesystem::path& scenario_file);

// The same without candidates, which take most of the time and which a choice that was made does not need, and without expectMotion, for
// the original may be shipped all the same.
Result<Subject> readSubjectUnranked(const std::filesystem::path& scenario_file);

// Copies of the inputs that `play` and `validate` need, with compiled shaders in place of sources.
Result<void> copyInputs(const Subject& subject, const std::filesystem::path& scenario_file);

}  // namespace reprise
