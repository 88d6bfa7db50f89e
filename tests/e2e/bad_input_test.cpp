// Bad shaders and bad command lines.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/e2e/refusal.h"
#include "tests/e2e/run_command.h"
#include "tests/e2e/small_scenario.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

CommandOutcome analyze(const fs::path& shader) {
  return runCommand({REPRISE_EXECUTABLE, "analyze", shader});
}

// SPIR-V of a shader of the small scenario, by the reference compiler.
std::string spirvOf(const SmallScenario& scenario, const fs::path& shader) {
  const fs::path binary = scenario.file("reference.spv");
  const CommandOutcome outcome =
      runCommand({"glslangValidator", "-V", "--target-env", "vulkan1.3", shader, "-o", binary});
  EXPECT_EQ(outcome.status, 0) << outcome.all();
  return textOf(binary);
}

TEST(BadSource, SmallScenarioIsFineAsItIs) {
  const SmallScenario scenario;
  const CommandOutcome outcome = analyze(scenario.fragment());
  EXPECT_EQ(outcome.status, kExitDone) << outcome.all();
  EXPECT_NE(outcome.output.find("small.frag:"), std::string::npos) << outcome.all();
}

TEST(BadSource, SyntaxErrorIsReportedWithFileAndLine) {
  const SmallScenario scenario;
  scenario.replace(scenario.fragment(), "vec3 point =", "vec3 point ==");
  const int line = SmallScenario::lineOf(scenario.fragment(), "vec3 point ==");
  expectRefusal(analyze(scenario.fragment()), kExitBadInput,
                {"small.frag:" + std::to_string(line) + ":", "error: "});
}

TEST(BadSource, UndeclaredNameIsReportedWithItsName) {
  const SmallScenario scenario;
  scenario.replace(scenario.fragment(), "0.4 * waves", "0.4 * wave");
  const int line = SmallScenario::lineOf(scenario.fragment(), "0.4 * wave;");
  expectRefusal(analyze(scenario.fragment()), kExitBadInput,
                {"small.frag:" + std::to_string(line) + ":", "error: ", "'wave'"});
}

TEST(BadSource, ErrorsAsJsonAreJson) {
  const SmallScenario scenario;
  scenario.replace(scenario.fragment(), "0.4 * waves", "0.4 * wave");
  const CommandOutcome outcome =
      runCommand({REPRISE_EXECUTABLE, "analyze", scenario.fragment(), "--error-format=json"});
  expectRefusal(outcome, kExitBadInput, {"\"code\"", "\"message\"", "\"line\"", "small.frag"});
  EXPECT_TRUE(outcome.errors.starts_with("{") || outcome.errors.starts_with("[")) << outcome.errors;
}

TEST(BadSource, SyntaxErrorStopsOptimizeBeforeItWritesAnything) {
  const SmallScenario scenario;
  scenario.replace(scenario.fragment(), "vec3 point =", "vec3 point ==");
  expectRefusal(runCommand(optimizeSmall(scenario)), kExitBadInput, {"small.frag:", "error: "});
  EXPECT_EQ(leftovers(scenario.output()), "");
}

TEST(BadSource, EmptyFile) {
  const SmallScenario scenario;
  for (const std::string name : {"empty.frag", "empty.spv"}) {
    writeText(scenario.file(name), "");
    expectRefusal(analyze(scenario.file(name)), kExitBadInput, {name, "error: "});
  }
}

TEST(BadSource, MissingFile) {
  const SmallScenario scenario;
  expectRefusal(analyze(scenario.file("nonesuch.frag")), kExitBadInput, {"nonesuch.frag"});
}

TEST(BadSource, SpirvThatIsWholeIsTaken) {
  const SmallScenario scenario;
  writeText(scenario.file("whole.spv"), spirvOf(scenario, scenario.fragment()));
  const CommandOutcome outcome = analyze(scenario.file("whole.spv"));
  EXPECT_EQ(outcome.status, kExitDone) << outcome.all();
}

TEST(BadSource, TruncatedSpirvIsRefusedWhereverItIsCut) {
  const SmallScenario scenario;
  const std::string spirv = spirvOf(scenario, scenario.fragment());
  ASSERT_GT(spirv.size(), 400u);
  for (const std::size_t size : {std::size_t{3}, std::size_t{4}, std::size_t{20}, spirv.size() / 2 / 4 * 4,
                                 spirv.size() / 2 / 4 * 4 + 1, spirv.size() - 4}) {
    SCOPED_TRACE(size);
    writeText(scenario.file("cut.spv"), spirv.substr(0, size));
    expectRefusal(analyze(scenario.file("cut.spv")), kExitBadInput, {"cut.spv", "error: "});
  }
}

TEST(BadSource, BinaryThatIsNoSpirvIsRefused) {
  const SmallScenario scenario;
  std::string bytes;
  for (int i = 0; i < 1024; ++i) bytes.push_back(static_cast<char>(i * 151 + i / 7));
  writeText(scenario.file("noise.spv"), bytes);
  expectRefusal(analyze(scenario.file("noise.spv")), kExitBadInput, {"noise.spv", "error: "});
}

TEST(BadSource, DamagedSpirvNeverCrashes) {
  const SmallScenario scenario;
  const std::string spirv = spirvOf(scenario, scenario.fragment());
  for (std::size_t place = 20; place < spirv.size(); place += spirv.size() / 24) {
    SCOPED_TRACE(place);
    std::string damaged = spirv;
    damaged[place] = static_cast<char>(damaged[place] ^ 0x5a);
    writeText(scenario.file("damaged.spv"), damaged);
    const CommandOutcome outcome = analyze(scenario.file("damaged.spv"));
    // Some damage leaves a valid module, a changed constant for instance.
    EXPECT_TRUE(outcome.status == kExitDone || outcome.status == kExitBadInput)
        << outcome.status << outcome.all();
  }
}

TEST(BadSource, VertexShaderIsNoFragmentShader) {
  const SmallScenario scenario;
  writeText(scenario.file("vertex.spv"), spirvOf(scenario, scenario.vertex()));
  expectRefusal(analyze(scenario.file("vertex.spv")), kExitBadInput, {"vertex.spv", "vertex", "fragment"});
  expectRefusal(analyze(scenario.vertex()), kExitBadInput, {"small.vert", "fragment"});

  scenario.replace(scenario.toml(), "fragment = \"small.frag\"", "fragment = \"vertex.spv\"");
  expectRefusal(runCommand(optimizeSmall(scenario)), kExitBadInput, {"vertex.spv", "fragment"});
  EXPECT_EQ(leftovers(scenario.output()), "");
}

TEST(CommandLine, MistakesEndWithStatusTwo) {
  const SmallScenario scenario;
  const std::string toml = scenario.toml(), out = scenario.output();
  const std::vector<std::vector<std::string>> mistakes = {
      {"optimise", toml},
      {"optimize"},
      {"optimize", toml, "--max-error", "much", "-o", out},
      {"optimize", toml, "--max-error", "-0.02", "-o", out},
      {"optimize", toml, "--max-error", "nan", "-o", out},
      {"optimize", toml, "--max-error", "0.02", "--metric", "psnr", "-o", out},
      {"optimize", toml, "--max-error", "0.02", "--budget", "-5s", "-o", out},
      {"optimize", toml, "--max-error", "0.02", "--budget", "5 bananas", "-o", out},
      {"optimize", toml, "--max-error", "0.02", "--no-such-flag", "-o", out},
      {"analyze"},
      {"analyze", scenario.fragment(), "--error-format=xml"},
  };
  for (std::vector<std::string> words : mistakes) {
    std::string line;
    for (const std::string& word : words) line += " " + word;
    SCOPED_TRACE(line);
    words.insert(words.begin(), REPRISE_EXECUTABLE);
    const CommandOutcome outcome = runCommand(words);
    EXPECT_EQ(outcome.status, kExitBadCommandLine) << outcome.all();
    EXPECT_NE(outcome.errors, "");
    EXPECT_FALSE(fs::exists(scenario.output()));
  }
}

TEST(CommandLine, MistakenMetricIsAnsweredWithTheKnownOnes) {
  const SmallScenario scenario;
  expectRefusal(runCommand(optimizeSmall(scenario, {"--metric", "rsm"})), kExitBadCommandLine,
                {"rsm", "rms", "flip"});
}

TEST(CommandLine, HelpAndVersionAreNoMistakes) {
  for (const std::string flag : {"--help", "--version"}) {
    const CommandOutcome outcome = runCommand({REPRISE_EXECUTABLE, flag});
    EXPECT_EQ(outcome.status, kExitDone);
    EXPECT_NE(outcome.output, "");
    EXPECT_EQ(outcome.errors, "");
  }
}

}  // namespace
}  // namespace reprise
