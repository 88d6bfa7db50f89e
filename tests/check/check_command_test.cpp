// `reprise check` as its users call it.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/e2e/run_command.h"

namespace reprise {
namespace {

const std::string kShaders = std::string(REPRISE_SOURCE_DIR) + "/shaders/laws";

TEST(CheckCommand, PrintsALineForEachModuleAndASummary) {
  const CommandOutcome outcome = runCommand({REPRISE_EXECUTABLE, "check", kShaders + "/straight_line", kShaders + "/discard/discard.frag"});
  EXPECT_EQ(outcome.status, 0) << outcome.all();
  EXPECT_NE(outcome.output.find("straight_line.frag: verified (6 variants"), std::string::npos) << outcome.all();
  EXPECT_NE(outcome.output.find("2 modules: 2 verified, 0 unshown, 0 refused, 0 untestable, 0 failed, 0 crashed, 0 hung"), std::string::npos) << outcome.all();
  EXPECT_NE(outcome.output.find("\nmotion was not judged"), std::string::npos) << outcome.all();
}

TEST(CheckCommand, JsonHasEveryModule) {
  TemporaryFolder folder;
  writeText(folder / "constant.frag", "#version 450\nlayout(location = 0) out vec4 color;\nvoid main() { color = vec4(1.0); }\n");
  const CommandOutcome outcome = runCommand({REPRISE_EXECUTABLE, "check", "--json", kShaders + "/loop/loop.frag", (folder / "constant.frag").string()});
  EXPECT_EQ(outcome.status, 0) << outcome.all();
  const nlohmann::json document = nlohmann::json::parse(outcome.output), modules = document.at("modules");
  EXPECT_EQ(document.at("motion"), "not judged");
  ASSERT_EQ(modules.size(), 2u);
  EXPECT_EQ(modules[0].at("verdict"), "verified");
  EXPECT_EQ(modules[0].at("variants"), 6);
  EXPECT_EQ(modules[1].at("verdict"), "refused");
  EXPECT_EQ(modules[1].at("code"), "candidate.none");
  for (const char* key : {"path", "reason", "candidates", "seconds"}) EXPECT_TRUE(modules[0].contains(key)) << key;
}

TEST(CheckCommand, WhatNothingCanShowIsNoFailure) {
  TemporaryFolder folder;
  const std::string shader = (folder / "dark.frag").string();
  writeText(shader, "#version 450\nlayout(location = 0) in vec3 place;\nlayout(location = 0) out vec4 color;\n"
                    "void main() { color = vec4(max(sin(place.x) - 5.0, 0.0)); }\n");
  const CommandOutcome outcome = runCommand({REPRISE_EXECUTABLE, "check", shader, shader});
  EXPECT_EQ(outcome.status, 0) << outcome.all();
  EXPECT_NE(outcome.output.find("dark.frag: unshown image.constant (6 variants"), std::string::npos) << outcome.all();
  EXPECT_NE(outcome.output.find("2 modules: 0 verified, 2 unshown"), std::string::npos) << outcome.all();
}

TEST(CheckCommand, JsonGoesWithProgressOnStandardError) {
  TemporaryFolder folder;
  const std::string shader = (folder / "constant.frag").string();
  writeText(shader, "#version 450\nlayout(location = 0) out vec4 color;\nvoid main() { color = vec4(1.0); }\n");
  const CommandOutcome told = runCommand({REPRISE_EXECUTABLE, "check", "--json", shader});
  EXPECT_NE(told.errors.find("constant.frag: refused candidate.none"), std::string::npos) << told.all();
  EXPECT_TRUE(nlohmann::json::accept(told.output));
  const CommandOutcome quiet = runCommand({REPRISE_EXECUTABLE, "check", "--json", "--quiet", shader});
  EXPECT_TRUE(quiet.errors.empty()) << quiet.all();
}

TEST(CheckCommand, TakesSpirvAssembly) {
  TemporaryFolder folder;
  const std::string binary = (folder / "loop.spv").string(), text = (folder / "loop.spvasm").string();
  ASSERT_EQ(runCommand({"glslangValidator", "-V", "--target-env", "vulkan1.1", "-o", binary, kShaders + "/loop/loop.frag"}).status, 0);
  ASSERT_EQ(runCommand({"spirv-dis", "-o", text, binary}).status, 0);
  const CommandOutcome outcome = runCommand({REPRISE_EXECUTABLE, "check", binary, text});
  EXPECT_EQ(outcome.status, 0) << outcome.all();
  EXPECT_NE(outcome.output.find("2 verified"), std::string::npos) << outcome.all();
}

TEST(CheckCommand, WhatIsNotThereIsRefused) {
  TemporaryFolder folder;
  const CommandOutcome missing = runCommand({REPRISE_EXECUTABLE, "check", (folder / "none.frag").string()});
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(missing.errors.find("no such file"), std::string::npos) << missing.all();
  const CommandOutcome empty = runCommand({REPRISE_EXECUTABLE, "check", folder.path().string()});
  EXPECT_EQ(empty.status, 1);
  EXPECT_EQ(runCommand({REPRISE_EXECUTABLE, "check"}).status, 2);
  const CommandOutcome strategy = runCommand({REPRISE_EXECUTABLE, "check", kShaders, "--strategy", "four_pass"});
  EXPECT_EQ(strategy.status, 2);
  EXPECT_NE(strategy.errors.find("two_pass_stencil"), std::string::npos) << strategy.all();
}

TEST(CheckCommand, NoDeviceIsSaidOnce) {
  CommandSpec spec;
  spec.words = {REPRISE_EXECUTABLE, "check", kShaders};
  spec.environment = {{"VK_ICD_FILENAMES", "/nonexistent.json"}, {"VK_DRIVER_FILES", "/nonexistent.json"}};
  const CommandOutcome outcome = runCommand(spec);
  EXPECT_EQ(outcome.status, 3) << outcome.all();
  EXPECT_TRUE(outcome.output.empty()) << outcome.all();
}

}  // namespace
}  // namespace reprise
