#include "cli/check/run_modules.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <iostream>
#include <iterator>

#include "cli/check/check_module.h"

extern char** environ;

namespace reprise {
namespace {

using Clock = std::chrono::steady_clock;
constexpr const char* kOriginalRuns = "original runs";
constexpr int kPollMilliseconds = 50;

struct Worker {
  std::size_t request = 0;
  pid_t process = -1;
  int output = -1;
  std::string text;
  Clock::time_point start;
  bool timed_out = false;
};

bool writeAll(int descriptor, const std::string& text) {
  std::size_t sent = 0;
  while (sent < text.size()) {
    const ssize_t written = ::write(descriptor, text.data() + sent, text.size() - sent);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    sent += static_cast<std::size_t>(written);
  }
  return true;
}

// Standard error goes nowhere: drivers and assertions of crashing shaders would drown the verdicts.
Result<Worker> startWorker(const std::string& executable, const CheckRequest& request) {
  int input[2], output[2];
  if (::pipe2(input, O_CLOEXEC) != 0) return Error{ErrorKind::kMachine, "check.process", "no pipe to a checking process", {}};
  if (::pipe2(output, O_CLOEXEC) != 0) {
    ::close(input[0]), ::close(input[1]);
    return Error{ErrorKind::kMachine, "check.process", "no pipe from a checking process", {}};
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output[1], STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::string name = executable, verb = "check-worker";
  char* arguments[] = {name.data(), verb.data(), nullptr};
  Worker worker;
  const int status = ::posix_spawn(&worker.process, executable.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(input[0]), ::close(output[1]);
  if (status == 0) writeAll(input[1], requestToJson(request));
  ::close(input[1]);
  if (status != 0) {
    ::close(output[0]);
    return Error{ErrorKind::kMachine, "check.process", "no process could be started from " + executable, {}};
  }
  worker.output = output[0];
  worker.start = Clock::now();
  return worker;
}

void stop(Worker& worker) {
  ::kill(worker.process, SIGKILL);
  ::waitpid(worker.process, nullptr, 0);
  ::close(worker.output);
}

// Of a worker that has closed its output.
ModuleVerdict verdictOf(const Worker& worker, const std::string& path, int status) {
  const std::size_t brace = worker.text.find('{');
  if (brace != std::string::npos && worker.text.back() == '\n' && !worker.timed_out) {
    try {
      return verdictFromJson(worker.text.substr(brace));
    } catch (const std::exception&) {
      // Half a verdict: the process ended while it wrote.
    }
  }
  ModuleVerdict verdict;
  verdict.path = path;
  verdict.seconds = std::chrono::duration<double>(Clock::now() - worker.start).count();
  const bool ours = worker.text.find(kOriginalRuns) != std::string::npos;
  const std::string how = worker.timed_out ? "gave no answer in time"
                          : WIFSIGNALED(status) ? fmt::format("ended by signal {}", WTERMSIG(status))
                                                : fmt::format("ended with status {}", WEXITSTATUS(status));
  verdict.verdict = !ours ? Verdict::kUntestable : worker.timed_out ? Verdict::kHung : Verdict::kCrashed;
  verdict.code = (ours ? "variant." : "original.") + std::string(worker.timed_out ? "hung" : "crashed");
  verdict.reason = std::string(ours ? "the original runs, but the process of its variants " : "before the original had been played, the process ") + how;
  return verdict;
}

// A device that one process loses or fills is lost to its neighbours, too, and a busy one lets them run out of time: only alone
// does such an end say something about the module.
bool wantsASecondRun(const ModuleVerdict& verdict) {
  for (const char* code : {"device.lost", "device.timeout", "device.memory", "original.crashed", "original.hung", "variant.crashed", "variant.hung"})
    if (verdict.code == code) return true;
  return false;
}

class ModuleRun {
 public:
  ModuleRun(const std::vector<CheckRequest>& requests, const RunModulesOptions& options, const std::function<void(const ModuleVerdict&)>& done)
      : requests_(requests), options_(options), done_(done), verdicts_(requests.size()) {}

  Result<std::vector<ModuleVerdict>> run() {
    jobs_ = static_cast<std::size_t>(std::max(options_.jobs, 1));
    for (std::size_t request = 0; request < requests_.size(); ++request) waiting_.push_back(request);
    REPRISE_TRY(runWaiting());
    jobs_ = 1;
    waiting_ = std::move(again_);
    REPRISE_TRY(runWaiting());
    return std::move(verdicts_);
  }

 private:
  Result<void> runWaiting() {
    while (!waiting_.empty() || !workers_.empty()) {
      while (!waiting_.empty() && workers_.size() < jobs_) {
        Result<Worker> worker = startWorker(options_.worker_path, requests_[waiting_.front()]);
        if (!worker.ok()) return ended(worker.error());
        worker->request = waiting_.front();
        waiting_.pop_front();
        workers_.push_back(std::move(*worker));
      }
      if (options_.interrupted && options_.interrupted()) return ended({ErrorKind::kInterrupted, "check.interrupted", "interrupted", {}});
      readAll();
    }
    return {};
  }

  Error ended(Error error) {
    for (Worker& worker : workers_) stop(worker);
    return error;
  }

  void readAll() {
    std::vector<pollfd> polled;
    for (const Worker& worker : workers_) polled.push_back({worker.output, POLLIN, 0});
    ::poll(polled.data(), polled.size(), kPollMilliseconds);
    for (std::size_t i = workers_.size(); i-- > 0;) {
      Worker& worker = workers_[i];
      if (std::chrono::duration<double>(Clock::now() - worker.start).count() > options_.module_timeout_s && !worker.timed_out) {
        worker.timed_out = true;
        ::kill(worker.process, SIGKILL);
      }
      if ((polled[i].revents & (POLLIN | POLLHUP)) == 0) continue;
      char buffer[4096];
      const ssize_t count = ::read(worker.output, buffer, sizeof buffer);
      if (count > 0) worker.text.append(buffer, static_cast<std::size_t>(count));
      if (count > 0 || (count < 0 && errno == EINTR)) continue;
      finish(i);
    }
  }

  void finish(std::size_t index) {
    const Worker worker = workers_[index];
    workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(index));
    int status = 0;
    ::waitpid(worker.process, &status, 0);
    ::close(worker.output);
    const ModuleVerdict verdict = verdictOf(worker, requests_[worker.request].path, status);
    if (jobs_ > 1 && wantsASecondRun(verdict)) {
      again_.push_back(worker.request);
      return;
    }
    verdicts_[worker.request] = verdict;
    done_(verdict);
  }

  const std::vector<CheckRequest>& requests_;
  const RunModulesOptions& options_;
  const std::function<void(const ModuleVerdict&)>& done_;
  std::vector<ModuleVerdict> verdicts_;
  std::vector<Worker> workers_;
  std::deque<std::size_t> waiting_, again_;  // requests: to be started; to be run alone at the end
  std::size_t jobs_ = 1;
};

}  // namespace

Result<std::vector<ModuleVerdict>> runModules(const std::vector<CheckRequest>& requests, const RunModulesOptions& options,
                                              const std::function<void(const ModuleVerdict&)>& done) {
  ::signal(SIGPIPE, SIG_IGN);  // a worker that dies early must not take the run with it
  return ModuleRun(requests, options, done).run();
}

int runCheckWorker() {
  // Drivers that print to standard output must not garble the answer.
  const int answers = ::dup(STDOUT_FILENO);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
  const std::string text((std::istreambuf_iterator<char>(std::cin)), std::istreambuf_iterator<char>());
  const ModuleVerdict verdict = checkModule(requestFromJson(text), [&] { writeAll(answers, std::string(kOriginalRuns) + "\n"); });
  return writeAll(answers, verdictToJson(verdict) + "\n") ? 0 : 1;
}

}  // namespace reprise
