// Whole runs of shaders that are easily rewritten wrongly: what ships shows at period 1 what the original shows, and no candidate had to
// be left out for showing something else.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "cli/report/result.h"
#include "tests/e2e/refusal.h"
#include "tests/e2e/run_command.h"
#include "tests/e2e/small_scenario.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

// Hashes of all frames.
std::string playedHashes(const fs::path& output, const std::vector<std::string>& more) {
  CommandSpec spec;
  spec.words = {REPRISE_EXECUTABLE, "play", output, "--hashes"};
  spec.words.insert(spec.words.end(), more.begin(), more.end());
  const CommandOutcome outcome = runCommand(spec);
  EXPECT_EQ(outcome.status, kExitDone) << outcome.all();
  const std::size_t first = outcome.output.find("frame  ");
  EXPECT_NE(first, std::string::npos) << outcome.output;
  return first == std::string::npos ? "" : outcome.output.substr(first);
}

TEST(EqualsOriginal, NestedLoopsThatLeaveByContinueAndBreak) {
  const TemporaryFolder folder;
  fs::copy(fs::path(REPRISE_SOURCE_DIR) / "tests/e2e/loop", folder.path(), fs::copy_options::recursive);
  const CommandOutcome outcome = runCommand({REPRISE_EXECUTABLE, "optimize", folder / "loop.toml", "--max-error", "0.05", "-o", folder / "out"});
  ASSERT_EQ(outcome.status, kExitDone) << outcome.all();
  const Result<RunResult> result = resultFromJson(textOf(folder / "out" / "result.json"));
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  EXPECT_TRUE(std::any_of(result->candidates.begin(), result->candidates.end(), [](const RunCandidate& one) { return one.status == CandidateStatus::kTrained; }));
  for (const RunCandidate& candidate : result->candidates)
    EXPECT_FALSE(candidate.reason.code.starts_with("law.")) << candidate.id << ": " << candidate.reason.message;
  EXPECT_EQ(playedHashes(folder / "out", {"--period", "1"}), playedHashes(folder / "out", {"--original"}));
}

}  // namespace
}  // namespace reprise
