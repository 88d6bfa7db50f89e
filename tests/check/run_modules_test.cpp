// Workers that crash, hang or talk nonsense, played by shell scripts.
#include "cli/check/run_modules.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/e2e/run_command.h"

namespace reprise {
namespace {

class RunModules : public testing::Test {
 protected:
  // What comes of one module whose worker does this after it has read its request.
  ModuleVerdict verdictOf(const std::string& script) {
    writeText(folder_ / "worker", "#!/bin/sh\ncat > /dev/null\n" + script + "\n");
    std::filesystem::permissions(folder_ / "worker", std::filesystem::perms::owner_all);
    RunModulesOptions options;
    options.worker_path = (folder_ / "worker").string();
    options.module_timeout_s = 1;
    CheckRequest request;
    request.path = "some.frag";
    const auto verdicts = runModules({request}, options, [](const ModuleVerdict&) {});
    return verdicts.ok() ? verdicts->front() : ModuleVerdict{};
  }

  TemporaryFolder folder_;
};

TEST_F(RunModules, ACrashOfVariantsIsOurs) {
  const ModuleVerdict verdict = verdictOf("echo stage: compiles\necho stage: plays variants\nkill -SEGV $$");
  EXPECT_EQ(verdict.verdict, Verdict::kCrashed);
  EXPECT_EQ(verdict.code, "variant.crashed");
  EXPECT_NE(verdict.reason.find("signal 11"), std::string::npos) << verdict.reason;
}

// The reference has a process of its own, so nothing else than our passes runs then.
TEST_F(RunModules, ACrashWhilePreparingIsOurs) {
  const ModuleVerdict verdict = verdictOf("echo stage: compiles\necho stage: prepares\nexit 70");
  EXPECT_EQ(verdict.verdict, Verdict::kCrashed);
  EXPECT_EQ(verdict.code, "prepare.crashed");
  EXPECT_NE(verdict.reason.find("status 70"), std::string::npos) << verdict.reason;
}

TEST_F(RunModules, ACrashOfTheCompilerIsNot) {
  const ModuleVerdict verdict = verdictOf("echo stage: compiles\nkill -SEGV $$");
  EXPECT_EQ(verdict.verdict, Verdict::kUntestable);
  EXPECT_EQ(verdict.code, "source.crashed");
}

TEST_F(RunModules, AHangIsEnded) {
  EXPECT_EQ(verdictOf("echo stage: plays variants\nexec sleep 60").code, "variant.hung");
  EXPECT_EQ(verdictOf("echo stage: plays variants\necho stage: plays the original\nexec sleep 60").code, "original.hung");
}

TEST_F(RunModules, HalfAVerdictIsACrash) {
  EXPECT_EQ(verdictOf("echo stage: plays variants\nprintf '{\"path\": \"some.frag\", \"verd'").verdict, Verdict::kCrashed);
}

TEST_F(RunModules, VerdictsKeepTheOrderOfTheirModules) {
  // The first worker is the slowest.
  writeText(folder_ / "worker", R"sh(#!/bin/sh
request=$(cat)
path=$(printf '%s' "$request" | sed 's/.*"path":"\([^"]*\)".*/\1/')
[ "$path" = 0.frag ] && sleep 0.4
echo "stage: plays variants"
echo "{\"path\":\"$path\",\"verdict\":\"verified\",\"code\":\"\",\"reason\":\"\",\"candidates\":1,\"variants\":4,\"refused_strategies\":[],\"seconds\":0.1}"
)sh");
  std::filesystem::permissions(folder_ / "worker", std::filesystem::perms::owner_all);
  std::vector<CheckRequest> requests(5);
  for (std::size_t i = 0; i < requests.size(); ++i) requests[i].path = std::to_string(i) + ".frag";
  RunModulesOptions options;
  options.worker_path = (folder_ / "worker").string();
  options.jobs = 3;
  int done = 0;
  const auto verdicts = runModules(requests, options, [&](const ModuleVerdict&) { ++done; });
  ASSERT_TRUE(verdicts.ok());
  EXPECT_EQ(done, 5);
  for (std::size_t i = 0; i < requests.size(); ++i) {
    EXPECT_EQ((*verdicts)[i].path, requests[i].path);
    EXPECT_EQ((*verdicts)[i].verdict, Verdict::kVerified);
  }
}

TEST_F(RunModules, ADeviceLostBesideOthersIsLookedAtAgainAlone) {
  // Whoever is not alone loses the device; the first one is there long enough for the second to come.
  writeText(folder_ / "worker", R"sh(#!/bin/sh
request=$(cat)
path=$(printf '%s' "$request" | sed 's/.*"path":"\([^"]*\)".*/\1/')
answer() { echo "{\"path\":\"$path\",\"verdict\":\"$1\",\"code\":\"$2\",\"reason\":\"\",\"candidates\":1,\"variants\":4,\"refused_strategies\":[],\"seconds\":0.1}"; }
if mkdir "$(dirname "$0")/device" 2> /dev/null; then
  sleep 0.4
  rmdir "$(dirname "$0")/device"
  answer verified ""
else
  answer untestable device.lost
fi
)sh");
  std::filesystem::permissions(folder_ / "worker", std::filesystem::perms::owner_all);
  std::vector<CheckRequest> requests(3);
  for (std::size_t i = 0; i < requests.size(); ++i) requests[i].path = std::to_string(i) + ".frag";
  RunModulesOptions options;
  options.worker_path = (folder_ / "worker").string();
  options.jobs = 2;
  int done = 0;
  const auto verdicts = runModules(requests, options, [&](const ModuleVerdict&) { ++done; });
  ASSERT_TRUE(verdicts.ok());
  EXPECT_EQ(done, 3);
  for (const ModuleVerdict& verdict : *verdicts) EXPECT_EQ(verdict.verdict, Verdict::kVerified) << verdict.path;
}

TEST_F(RunModules, AnInterruptStopsEveryWorker) {
  writeText(folder_ / "worker", "#!/bin/sh\nexec sleep 60\n");
  std::filesystem::permissions(folder_ / "worker", std::filesystem::perms::owner_all);
  RunModulesOptions options;
  options.worker_path = (folder_ / "worker").string();
  options.jobs = 2;
  options.interrupted = [] { return true; };
  const auto verdicts = runModules(std::vector<CheckRequest>(4), options, [](const ModuleVerdict&) {});
  ASSERT_FALSE(verdicts.ok());
  EXPECT_EQ(verdicts.error().kind, ErrorKind::kInterrupted);
}

TEST(RepeatCommand, HasAllThatTheInputsDependOn) {
  CheckRequest request;
  request.path = "a.frag";
  EXPECT_EQ(repeatCommand(request, 2, "branch"), "reprise check a.frag --seed 2 --strategy branch");
  request.path = "it's.frag";
  request.include_dirs = {"my includes"};
  request.defines = {"SIZE=4", "FAST"};
  request.entry_point = "shade";
  request.candidates = 3;
  EXPECT_EQ(repeatCommand(request, 1, "two_pass"),
            "reprise check 'it'\\''s.frag' -I 'my includes' -D SIZE=4 -D FAST --entry-point shade --candidates 3 --seed 1 --strategy two_pass");
  EXPECT_EQ(repeatCommand({"b.frag"}, 3, ""), "reprise check b.frag --seed 3");
}

TEST(VerdictJson, ComesBackAsItWas) {
  ModuleVerdict verdict{"a \"b\".frag", Verdict::kFailed, "law.misses_exact", "x", 2, 3, 1, {"two_pass: state.depth_compare"}, 1.5};
  const ModuleVerdict back = verdictFromJson(verdictToJson(verdict));
  EXPECT_EQ(verdictToJson(back), verdictToJson(verdict));
  EXPECT_EQ(back.path, verdict.path);
  EXPECT_EQ(back.verdict, verdict.verdict);
}

}  // namespace
}  // namespace reprise
