// The worker process under its supervisor: answers, deaths, silence, interruption.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <thread>

#include "tests/session/measured_scene.h"

namespace reprise {
namespace {

constexpr const char* kScenario = "shaders/laws/straight_line/straight_line.toml";

SupervisorOptions realWorker() {
  SupervisorOptions options;
  options.worker_path = SESSION_WORKER;
  return options;
}

// A worker that does something else, as a shell script.
class ScriptedWorker {
 public:
  explicit ScriptedWorker(const std::string& script) {
    writeText(folder_ / "worker", "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(folder_ / "worker", std::filesystem::perms::owner_all);
    options_.worker_path = (folder_ / "worker").string();
  }
  SupervisorOptions& options() { return options_; }
  Error failure(const Job& job = {}) const {
    const Result<JobResult> result = superviseJob(job, options_, {});
    EXPECT_FALSE(result.ok());
    return result.ok() ? Error{} : result.error();
  }

 private:
  TemporaryFolder folder_;
  SupervisorOptions options_;
};

std::optional<pid_t> childOf(pid_t process) {
  const std::string id = std::to_string(process);
  for (const auto& thread : std::filesystem::directory_iterator("/proc/" + id + "/task")) {
    std::ifstream children(thread.path() / "children");
    pid_t child = 0;
    if (children >> child) return child;
  }
  return std::nullopt;
}

bool isAlive(pid_t process) {
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string id, name, state;
  return (stat >> id >> name >> state) && state != "Z";
}

TEST(SuperviseJob, AnswersWhatTheJobGivesInThisProcess) {
  const MeasuredScene scene(kScenario);
  Job job = scene.job(JobKind::kErrors, {scene.variant("two_pass", countingVariant()), 4});
  job.frames = 4;
  int steps = 0;
  JobProgress last;
  const Result<JobResult> supervised = superviseJob(job, realWorker(), [&](const JobProgress& progress) { ++steps, last = progress; });
  ASSERT_TRUE(supervised.ok()) << formatError(supervised.error());
  const Result<JobResult> here = runJob(job, {});
  ASSERT_TRUE(here.ok()) << formatError(here.error());
  EXPECT_EQ(supervised->errors, here->errors);
  EXPECT_EQ(supervised->device, here->device);
  EXPECT_EQ(steps, 4);
  EXPECT_EQ(last.done, last.total);
}

TEST(SuperviseJob, HandsOnTheErrorOfTheJob) {
  const MeasuredScene scene(kScenario);
  Job job = scene.job(JobKind::kErrors, {scene.original(), 1});
  job.session = "nowhere";
  const Result<JobResult> result = superviseJob(job, realWorker(), {});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, ErrorKind::kInput);
  EXPECT_EQ(result.error().code, "session.unknown");
  EXPECT_EQ(result.error().place.file, scene.scenario());
}

TEST(SuperviseJob, ReportsACrashWithItsSignalAndLastWords) {
  const Error crash = ScriptedWorker("cat > /dev/null; echo the roof is on fire >&2; kill -SEGV $$").failure();
  EXPECT_EQ(crash.kind, ErrorKind::kMeasurement);
  EXPECT_EQ(crash.code, "worker.crashed");
  EXPECT_NE(crash.message.find(strsignal(SIGSEGV)), std::string::npos) << crash.message;
  EXPECT_NE(crash.message.find("the roof is on fire"), std::string::npos) << crash.message;
}

TEST(SuperviseJob, ReportsAnEndWithoutAnAnswer) {
  const Error end = ScriptedWorker("exit 3").failure();
  EXPECT_EQ(end.code, "worker.crashed");
  EXPECT_NE(end.message.find("status 3"), std::string::npos) << end.message;
}

TEST(SuperviseJob, SaysHowFarTheWorkerHadCome) {
  const Error end = ScriptedWorker("cat > /dev/null; echo '{\"progress\": [3, 8]}'; kill -KILL $$").failure();
  EXPECT_EQ(end.code, "worker.crashed");
  EXPECT_NE(end.message.find("3 of 8"), std::string::npos) << end.message;
}

TEST(SuperviseJob, ReportsAnAnswerThatIsNone) {
  const Error garbled = ScriptedWorker("cat > /dev/null; echo hello").failure();
  EXPECT_EQ(garbled.kind, ErrorKind::kMeasurement);
  EXPECT_EQ(garbled.code, "worker.garbled");
}

TEST(SuperviseJob, EndsAWorkerThatIsSilentForTooLong) {
  ScriptedWorker worker("exec sleep 600");
  worker.options().silence_timeout_s = 0.3;
  const Error hang = worker.failure();
  EXPECT_EQ(hang.kind, ErrorKind::kMeasurement);
  EXPECT_EQ(hang.code, "worker.timeout");
  EXPECT_FALSE(childOf(getpid()).has_value());
}

TEST(SuperviseJob, EndsAWorkerThatNeverReadsALongJob) {
  ScriptedWorker worker("exec sleep 600");
  worker.options().silence_timeout_s = 0.3;
  Job job;
  job.run_id.assign(1 << 20, 'x');  // more than a pipe holds
  EXPECT_EQ(worker.failure(job).code, "worker.timeout");
}

TEST(SuperviseJob, SendsALongJobWhole) {
  Job job;
  job.run_id.assign(1 << 20, 'x');
  const ScriptedWorker worker("bytes=$(wc -c); echo $bytes bytes >&2; exit 3");
  const Error end = worker.failure(job);
  EXPECT_NE(end.message.find(std::to_string(jobToJson(job).size()) + " bytes"), std::string::npos) << end.message;
}

TEST(SuperviseJob, EndsAWorkerThatClosesItsOutputAndGoesOn) {
  ScriptedWorker worker("exec sleep 600 >&-");
  worker.options().silence_timeout_s = 0.3;
  EXPECT_EQ(worker.failure().code, "worker.timeout");
  EXPECT_FALSE(childOf(getpid()).has_value());
}

TEST(SuperviseJob, ProgressIsASignOfLife) {
  ScriptedWorker worker("cat > /dev/null; for i in 1 2 3 4 5 6; do sleep 0.3; echo '{\"progress\": [1, 6]}'; done; exit 4");
  worker.options().silence_timeout_s = 1.5;
  EXPECT_EQ(worker.failure().code, "worker.crashed");
}

TEST(SuperviseJob, StopsWhenInterrupted) {
  ScriptedWorker worker("exec sleep 600");
  worker.options().interrupted = [] { return true; };
  const Error stopped = worker.failure();
  EXPECT_EQ(stopped.kind, ErrorKind::kInterrupted);
  EXPECT_FALSE(childOf(getpid()).has_value());
}

TEST(SuperviseJob, StopsWhenItsTimeIsOver) {
  ScriptedWorker worker("exec sleep 600");
  worker.options().expired = [] { return true; };
  const Error stopped = worker.failure();
  EXPECT_EQ(stopped.kind, ErrorKind::kInterrupted);
  EXPECT_EQ(stopped.code, kBudgetEnded);
  EXPECT_FALSE(childOf(getpid()).has_value());
}

TEST(SuperviseJob, SaysThatThereIsNoWorker) {
  SupervisorOptions options;
  options.worker_path = "/nonexistent/worker";
  const Result<JobResult> result = superviseJob(Job{}, options, {});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, ErrorKind::kMachine);
  EXPECT_EQ(result.error().code, "worker.start");
}

TEST(SuperviseJob, ReportsAWorkerThatIsKilledInTheMiddle) {
  const MeasuredScene scene(kScenario);
  Job job = scene.job(JobKind::kErrors, {scene.original(), 1});
  job.frames = 1000000;
  const Result<JobResult> result = superviseJob(job, realWorker(), [](const JobProgress& progress) {
    if (progress.done == 3) kill(childOf(getpid()).value(), SIGKILL);
  });
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, ErrorKind::kMeasurement);
  EXPECT_EQ(result.error().code, "worker.crashed");
}

TEST(SuperviseJob, WorkerDiesWithItsSupervisor) {
  const ScriptedWorker worker("exec sleep 600");
  const pid_t supervisor = fork();
  ASSERT_GE(supervisor, 0);
  if (supervisor == 0) {
    worker.failure();
    _exit(0);
  }
  std::optional<pid_t> child;
  while (!child) child = childOf(supervisor);
  kill(supervisor, SIGKILL);
  waitpid(supervisor, nullptr, 0);
  for (int i = 0; i < 500 && isAlive(*child); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_FALSE(isAlive(*child));
}

}  // namespace
}  // namespace reprise
