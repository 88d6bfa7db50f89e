#include "cli/check/run_modules.h"

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <deque>
#include <iostream>
#include <iterator>

#include "cli/check/check_module.h"
#include "cli/check/reference/child_process.h"
#include "cli/check/reference/pipe_messages.h"
#include "cli/check/reference/time_limit.h"

namespace reprise {
namespace {

constexpr int kPollMilliseconds = 50;

struct Worker {
  std::size_t request = 0;
  pid_t process = -1;
  int output = -1;
  std::string text;
  TimeLimit limit{-1, 0};
  bool timed_out = false;
};

// What a worker tells of itself as it goes on; the last one tells whose fault its end is.
constexpr std::array<const char*, 4> kStages = {"compiles", "prepares", "plays the original", "plays variants"};
std::string stageLine(CheckStage stage) { return std::string("stage: ") + kStages[static_cast<std::size_t>(stage)] + "\n"; }

CheckStage lastStage(const std::string& text) {
  CheckStage last = CheckStage::kCompile;
  std::size_t place = 0;
  for (std::size_t i = 0; i < kStages.size(); ++i) {
    const std::size_t at = text.rfind(stageLine(static_cast<CheckStage>(i)));
    if (at != std::string::npos && at >= place) place = at, last = static_cast<CheckStage>(i);
  }
  return last;
}

Result<Worker> startWorker(const RunModulesOptions& options, CheckRequest request) {
  request.timeout_s = options.module_timeout_s;
  REPRISE_ASSIGN(const ChildProcess child, startChild(options.worker_path, "check-worker"));
  const std::string text = requestToJson(request);
  writeAll(child.input, text.data(), text.size());
  ::close(child.input);
  Worker worker;
  worker.process = child.process;
  worker.output = child.output;
  worker.limit = TimeLimit(child.process, options.module_timeout_s);
  return worker;
}

void stop(Worker& worker) {
  ::kill(worker.process, SIGKILL);
  ::waitpid(worker.process, nullptr, 0);
  ::close(worker.output);
}

// Of a worker that ended without a verdict.
ModuleVerdict verdictOfEnd(const Worker& worker, int status) {
  ModuleVerdict verdict;
  verdict.seconds = worker.limit.elapsedSeconds();
  const std::string how = worker.timed_out ? "gave no answer in time" : howItEnded(status);
  const std::string ending = worker.timed_out ? "hung" : "crashed";
  verdict.verdict = worker.timed_out ? Verdict::kHung : Verdict::kCrashed;
  switch (lastStage(worker.text)) {
    case CheckStage::kCompile:
      verdict.verdict = Verdict::kUntestable;
      verdict.code = "source." + ending;
      verdict.reason = "the process " + how + " while it compiled the shader, before any rewrite";
      break;
    case CheckStage::kPrepare:
      verdict.code = "prepare." + ending;
      verdict.reason = "the process that prepares and rewrites the module " + how;
      break;
    case CheckStage::kOriginal:
      // The process waits for the reference, which has a limit of its own: it is late only where the machine is.
      if (worker.timed_out) verdict.verdict = Verdict::kUntestable;
      verdict.code = worker.timed_out ? "original.hung" : "prepare.crashed";
      verdict.reason = "the process that waits for the image of the module alone " + how;
      break;
    case CheckStage::kVariants:
      verdict.code = "variant." + ending;
      verdict.reason = "the original runs, but the process of its variants " + how;
      break;
  }
  return verdict;
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
  ModuleVerdict verdict = verdictOfEnd(worker, status);
  verdict.path = path;
  return verdict;
}

// A device that one process loses or fills is lost to its neighbours, too, and a busy one lets them run out of time: only alone
// does such an end say something about the module.
bool wantsASecondRun(const ModuleVerdict& verdict) {
  for (const char* code : {"device.lost", "device.timeout", "device.memory"})
    if (verdict.code == code) return true;
  return verdict.code.ends_with(".crashed") || verdict.code.ends_with(".hung");
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
        Result<Worker> worker = startWorker(options_, requests_[waiting_.front()]);
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
      if (!worker.timed_out && worker.limit.isOver()) {
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

int runCheckWorker(const std::string& executable) {
  belongToParent();
  // Drivers that print to standard output must not garble the answer.
  const int answers = ::dup(STDOUT_FILENO);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
  const auto tell = [&](const std::string& text) { return writeAll(answers, text.data(), text.size()); };
  const CheckRequest request = requestFromJson(std::string((std::istreambuf_iterator<char>(std::cin)), std::istreambuf_iterator<char>()));
  CheckHooks hooks;
  hooks.enters = [&](CheckStage stage) { tell(stageLine(stage)); };
  hooks.start_reference = [&](const ReferenceModule& module) { return startReferenceProcess(executable, module, request.timeout_s / 2); };
  return tell(verdictToJson(checkModule(request, hooks)) + "\n") ? 0 : 1;
}

}  // namespace reprise
