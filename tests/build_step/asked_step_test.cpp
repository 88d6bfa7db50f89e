// What a build step allows is held against the committed choice, and a run that is undecided keeps it. The tool's optimize is played by a
// script, so that nothing is measured.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/e2e/run_command.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = REPRISE_SOURCE_DIR;

// Writes down the words of optimize, then does what `optimize` says; everything else is the tool's.
const std::string kTool = R"sh(#!/bin/sh
if [ "$1" != optimize ]; then exec "TOOL" "$@"; fi
echo "$@" >> "FOLDER/optimized"
while [ "$1" != -o ]; do shift; done
mkdir -p "$2"
OPTIMIZE
)sh";

const std::string kUndecided = R"sh(echo '{"choice": {"kind": "undecided", "reason": "the budget ended; too soon"}}' > "$2/result.json"; exit 4)sh";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
  return text;
}

class AskedStep : public testing::Test {
 protected:
  void SetUp() override {
    fs::copy(kSource / "examples/cmake_project/shaders", shaders());
    fs::create_directories(folder_ / "build");
    optimizeIs(kUndecided);
  }

  fs::path shaders() const { return folder_ / "shaders"; }
  fs::path choice() const { return shaders() / "granite.choice.json"; }
  fs::path package() const { return folder_ / "build/granite/manifest.json"; }
  fs::path stamp() const { return folder_ / "build/granite.stamp"; }

  void optimizeIs(const std::string& script) const {
    const std::string text = replaced(replaced(replaced(kTool, "TOOL", REPRISE_EXECUTABLE), "FOLDER", folder_.path().string()), "OPTIMIZE", script);
    writeText(folder_ / "tool", text);
    fs::permissions(folder_ / "tool", fs::perms::owner_all);
  }

  CommandOutcome step(const std::string& asked, const std::string& train = "NEVER") const {
    const auto given = [](const std::string& name, const std::string& value) { return "-D" + name + "=" + value; };
    return runCommand({REPRISE_CMAKE, given("REPRISE", folder_ / "tool"), given("SCENARIO", shaders() / "granite.toml"), given("ASKED", asked),
                       given("CHOICE", choice()), given("OUTPUT", folder_ / "build/granite"), given("TRAIN", train), given("STAMP", stamp()),
                       given("HEADER", ""), given("NAME", ""), given("BESIDE", ""), "-P", kSource / "cmake/reprise_build_step.cmake"});
  }

  std::string optimizedWith() const { return fs::exists(folder_ / "optimized") ? textOf(folder_ / "optimized") : ""; }

  TemporaryFolder folder_;
};

std::string joined(const CommandOutcome& outcome) {  // CMake breaks the lines of its messages
  std::string text;
  for (const char c : outcome.all())
    if (!std::isspace(static_cast<unsigned char>(c)) || (!text.empty() && text.back() != ' ')) text += std::isspace(static_cast<unsigned char>(c)) ? ' ' : c;
  return text;
}

TEST_F(AskedStep, FailsWithBothNumbersWhereTheChoiceAllowsMore) {
  const CommandOutcome outcome = step("--max-error 0.02");
  EXPECT_NE(outcome.status, 0);
  EXPECT_NE(joined(outcome).find("the choice allows rms 0.03, the build asks for at most 0.02"), std::string::npos) << outcome.all();
  EXPECT_FALSE(fs::exists(stamp()));
  EXPECT_EQ(optimizedWith(), "");
}

TEST_F(AskedStep, TakesAChoiceThatIsAsStrict) {
  EXPECT_EQ(step("--max-error 0.03").status, 0);
  EXPECT_EQ(step("").status, 0);
  EXPECT_TRUE(fs::exists(package()));
}

TEST_F(AskedStep, TrainsAnewWithTheSameWordsWhereTheChoiceAllowsMore) {
  const std::string stricter = replaced(textOf(choice()), "\"value\": 0.03", "\"value\": 0.02");
  writeText(folder_ / "stricter.json", stricter);
  optimizeIs("cp '" + (folder_ / "stricter.json").string() + "' \"$2/choice.json\"");
  const CommandOutcome outcome = step("--max-error 0.02 --metric rms", "IF_STALE");
  EXPECT_EQ(outcome.status, 0) << outcome.all();
  EXPECT_NE(optimizedWith().find("--max-error 0.02 --metric rms"), std::string::npos) << optimizedWith();
  EXPECT_EQ(textOf(choice()), stricter);
}

TEST_F(AskedStep, KeepsTheCommittedChoiceWhereARunIsUndecided) {
  const std::string before = textOf(choice());
  const CommandOutcome outcome = step("--max-error 0.03", "ALWAYS");
  EXPECT_EQ(outcome.status, 0) << outcome.all();
  EXPECT_NE(joined(outcome).find("the budget ended; too soon"), std::string::npos) << outcome.all();
  EXPECT_NE(outcome.all().find("Warning"), std::string::npos) << outcome.all();
  EXPECT_EQ(textOf(choice()), before);
  EXPECT_TRUE(fs::exists(package()));
}

TEST_F(AskedStep, FailsWhereARunIsUndecidedAndNothingIsCommitted) {
  fs::remove(choice());
  const CommandOutcome outcome = step("--max-error 0.03", "IF_STALE");
  EXPECT_NE(outcome.status, 0);
  EXPECT_NE(joined(outcome).find("no committed choice to keep"), std::string::npos) << outcome.all();
  EXPECT_FALSE(fs::exists(choice()));
  EXPECT_FALSE(fs::exists(stamp()));
}

// The committed choice is kept as a file, but it allows too much, so that nothing can be made of it.
TEST_F(AskedStep, FailsWhereARunIsUndecidedAndTheCommittedChoiceDoesNotHold) {
  const std::string before = textOf(choice());
  const CommandOutcome outcome = step("--max-error 0.02", "IF_STALE");
  EXPECT_NE(outcome.status, 0);
  EXPECT_NE(joined(outcome).find("too soon"), std::string::npos) << outcome.all();
  EXPECT_NE(joined(outcome).find("the choice allows rms 0.03"), std::string::npos) << outcome.all();
  EXPECT_EQ(textOf(choice()), before);
}

}  // namespace
}  // namespace reprise
