// The tests' own way of running programs does what the tests rely on.
#include "tests/e2e/run_command.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>

namespace reprise {
namespace {

CommandSpec shell(const std::string& script) {
  CommandSpec spec;
  spec.words = {"sh", "-c", script};
  return spec;
}

TEST(RunCommand, ReportsStatusAndBothStreams) {
  const CommandOutcome outcome = runCommand(shell("echo out; echo err >&2; exit 7"));
  EXPECT_EQ(outcome.status, 7);
  EXPECT_EQ(outcome.output, "out\n");
  EXPECT_EQ(outcome.errors, "err\n");
  EXPECT_FALSE(outcome.timed_out);
}

TEST(RunCommand, ReportsAProgramThatIsNotThere) {
  EXPECT_EQ(runCommand({"nonesuch-program"}).status, 127);
}

TEST(RunCommand, PassesInputAndEnvironment) {
  CommandSpec spec = shell("cat; echo $COLOR");
  spec.input = "in ";
  spec.environment = {{"COLOR", "green"}};
  EXPECT_EQ(runCommand(spec).output, "in green\n");
}

TEST(RunCommand, KillsTheWholeGroupAfterItsTimeLimit) {
  CommandSpec spec = shell("sleep 60 & sleep 60");
  spec.time_limit = std::chrono::seconds(0);
  const CommandOutcome outcome = runCommand(spec);
  EXPECT_TRUE(outcome.timed_out);
  EXPECT_EQ(outcome.status, 128 + SIGKILL);
}

TEST(RunCommand, FileSizeLimitFailsWritesAndNotTheProgram) {
  const TemporaryFolder folder;
  const std::string file = (folder / "big").string();
  CommandSpec spec = shell("dd if=/dev/zero of='" + file + "' bs=1k count=64 2> /dev/null || exit 9");
  spec.file_size_limit_bytes = 2048;
  EXPECT_EQ(runCommand(spec).status, 9);
  EXPECT_EQ(std::filesystem::file_size(file), 2048u);
}

TEST(RunCommand, SignalsReachTheProgram) {
  Command command(shell("trap 'exit 5' INT; while :; do sleep 0.01; done"));
  EXPECT_TRUE(command.running());
  // The trap may not be set yet at the first signal.
  command.signalGroup(SIGINT);
  const int status = command.wait().status;
  EXPECT_TRUE(status == 5 || status == 128 + SIGINT) << status;
}

TEST(TemporaryFolder, IsRemovedWithWhatItHolds) {
  std::filesystem::path path;
  {
    const TemporaryFolder folder;
    path = folder.path();
    writeText(folder / "a/b.txt", "text");
    EXPECT_EQ(textOf(path / "a/b.txt"), "text");
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace reprise
