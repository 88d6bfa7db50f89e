// Motion that is not there: a full-screen pass over a G-buffer is refused, and where its user says that nothing moves, the result begins
// with the warning that something seems to.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/e2e/refusal.h"
#include "tests/e2e/run_command.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

class FullScreenPass : public testing::Test {
 protected:
  void SetUp() override { fs::copy(fs::path(REPRISE_SOURCE_DIR) / "tests/e2e/full_screen", folder_.path(), fs::copy_options::recursive); }

  void sayThatNothingMoves() const { writeText(toml(), "motion = \"none\"\n" + textOf(toml())); }

  CommandOutcome optimize() const {
    return runCommand({REPRISE_EXECUTABLE, "optimize", toml().string(), "--max-error", "0.2", "--budget", "120s", "-o", output().string()});
  }

  fs::path toml() const { return folder_ / "full_screen.toml"; }
  fs::path output() const { return folder_ / "out"; }

 private:
  TemporaryFolder folder_;
};

TEST_F(FullScreenPass, IsRefused) {
  const CommandOutcome outcome = optimize();
  expectRefusal(outcome, kExitBadInput, {"motion.none", "screen.vert", "gl_Position reads no uniform", "motion = \"none\""});
  EXPECT_TRUE(outcome.output.empty()) << outcome.output;
  EXPECT_FALSE(fs::exists(output() / "result.json"));
}

TEST_F(FullScreenPass, IsSuspectedWhereTheScenarioSaysThatNothingMoves) {
  sayThatNothingMoves();
  const CommandOutcome outcome = optimize();
  ASSERT_EQ(outcome.status, kExitDone) << outcome.all();
  EXPECT_TRUE(outcome.output.starts_with("motion.suspect: ")) << outcome.output;
  const nlohmann::json result = nlohmann::json::parse(textOf(output() / "result.json"));
  const std::string warning = result.at("warnings").at(0);
  EXPECT_TRUE(warning.starts_with("motion.suspect: ")) << warning;
  EXPECT_NE(warning.find("may be right"), std::string::npos);
  EXPECT_NE(textOf(output() / "report.html").find("\"leading\":\"motion.suspect: "), std::string::npos);
}

}  // namespace
}  // namespace reprise
