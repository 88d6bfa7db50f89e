// The supervisor's side: a worker process for each job, so that a crash, a hang or a lost device ends the job and not the run.
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>

#include "profiler/session/job_json.h"

namespace reprise {
namespace {

constexpr int kPollMs = 100;
constexpr std::size_t kStderrTail = 600;

struct Pipe {
  int read = -1, write = -1;
  ~Pipe() { closeBoth(); }
  bool open() {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) return false;
    read = ends[0];
    write = ends[1];
    return true;
  }
  void closeRead() {
    if (read >= 0) ::close(read);
    read = -1;
  }
  void closeWrite() {
    if (write >= 0) ::close(write);
    write = -1;
  }
  void closeBoth() {
    closeRead();
    closeWrite();
  }
};

class Worker {
 public:
  ~Worker() { kill(); }

  Result<void> start(const std::string& path, const std::string& job) {
    if (::access(path.c_str(), X_OK) != 0) return systemError("'" + path + "'");
    if (!input_.open() || !output_.open() || !errors_.open()) return systemError("pipe");
    const pid_t parent = ::getpid();
    pid_ = ::fork();
    if (pid_ < 0) return systemError("fork");
    if (pid_ == 0) becomeWorker(path, parent);
    input_.closeRead();
    output_.closeWrite();
    errors_.closeWrite();
    ::fcntl(output_.read, F_SETFL, O_NONBLOCK);
    ::fcntl(errors_.read, F_SETFL, O_NONBLOCK);
    ::fcntl(input_.write, F_SETFL, O_NONBLOCK);
    unsent_ = job;
    return {};
  }

  // Reads until a line answers the job, the worker dies, or it is silent for too long.
  Result<JobResult> listen(const SupervisorOptions& options, const std::function<void(const JobProgress&)>& progress) {
    auto heard = std::chrono::steady_clock::now();
    while (true) {
      std::array<pollfd, 3> ends{{{output_.read, POLLIN, 0}, {errors_.read, POLLIN, 0}, {input_.write, POLLOUT, 0}}};
      ::poll(ends.data(), ends.size(), kPollMs);
      send();
      if (!drain(errors_.read, stderr_tail_)) errors_.closeRead();
      if (stderr_tail_.size() > 4 * kStderrTail) stderr_tail_.erase(0, stderr_tail_.size() - kStderrTail);
      const bool open = drain(output_.read, buffer_);
      for (std::size_t end = buffer_.find('\n'); end != std::string::npos; end = buffer_.find('\n')) {
        const std::string line = buffer_.substr(0, end);
        buffer_.erase(0, end + 1);
        heard = std::chrono::steady_clock::now();
        if (auto answer = understand(line, progress)) return std::move(*answer);
      }
      if (!open) return death(options.silence_timeout_s);
      if (options.interrupted && options.interrupted()) {
        kill();
        return Error{ErrorKind::kInterrupted, "run.interrupted", "interrupted; run the same command again to go on from here", {}};
      }
      if (options.expired && options.expired()) {
        kill();
        return Error{ErrorKind::kInterrupted, kBudgetEnded, "the budget ended", {}};
      }
      if (std::chrono::duration<double>(std::chrono::steady_clock::now() - heard).count() > options.silence_timeout_s) {
        kill();
        return Error{ErrorKind::kMeasurement, "worker.timeout",
                     "the measuring process was silent for " + std::to_string(static_cast<int>(options.silence_timeout_s)) +
                         " s and was ended" + whereabouts() + tail(), {}};
      }
    }
  }

 private:
  static Error systemError(const std::string& call) {
    return {ErrorKind::kMachine, "worker.start", "cannot start the measuring process: " + call + ": " + std::strerror(errno), {}};
  }

  [[noreturn]] void becomeWorker(const std::string& path, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(1);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) ::signal(number, SIG_IGN);  // the supervisor decides what an interrupt means
    ::dup2(input_.read, STDIN_FILENO);
    ::dup2(output_.write, STDOUT_FILENO);
    ::dup2(errors_.write, STDERR_FILENO);
    ::execl(path.c_str(), path.c_str(), "worker", static_cast<char*>(nullptr));
    ::_exit(127);
  }

  // As much of the job as the pipe takes now: a worker that never reads it must not hold up the supervisor.
  void send() {
    if (input_.write < 0) return;
    // Nor must a worker that died at once take the supervisor with it.
    struct sigaction ignore {}, before {};
    ignore.sa_handler = SIG_IGN;
    ::sigaction(SIGPIPE, &ignore, &before);
    while (!unsent_.empty()) {
      const ssize_t written = ::write(input_.write, unsent_.data(), unsent_.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0 && errno == EAGAIN) break;
      if (written <= 0) {
        unsent_.clear();
      } else {
        unsent_.erase(0, static_cast<std::size_t>(written));
      }
    }
    ::sigaction(SIGPIPE, &before, nullptr);
    if (unsent_.empty()) input_.closeWrite();
  }

  // False at the end of the stream.
  static bool drain(int descriptor, std::string& into) {
    std::array<char, 65536> chunk;
    while (descriptor >= 0) {
      const ssize_t count = ::read(descriptor, chunk.data(), chunk.size());
      if (count == 0) return false;
      if (count < 0) return errno == EAGAIN || errno == EINTR;
      into.append(chunk.data(), static_cast<std::size_t>(count));
    }
    return false;
  }

  std::optional<Result<JobResult>> understand(const std::string& line, const std::function<void(const JobProgress&)>& progress) {
    try {
      const nlohmann::json message = nlohmann::json::parse(line);
      if (message.contains("progress")) {
        last_ = {message.at("progress").at(0), message.at("progress").at(1)};
        if (progress) progress(last_);
        return std::nullopt;
      }
      if (message.contains("result")) return Result<JobResult>(resultFrom(message.at("result")));
      return Result<JobResult>(errorFrom(message.at("error")));
    } catch (const std::exception& failure) {
      return Result<JobResult>(Error{ErrorKind::kMeasurement, "worker.garbled", std::string("the measuring process said something that is no answer: ") + failure.what(), {}});
    }
  }

  // Of a worker that has closed its output; one that goes on without it is ended.
  Error death(double timeout_s) {
    int status = 0;
    const auto closed = std::chrono::steady_clock::now();
    while (::waitpid(pid_, &status, WNOHANG) == 0) {
      if (std::chrono::duration<double>(std::chrono::steady_clock::now() - closed).count() > timeout_s) {
        kill();
        return {ErrorKind::kMeasurement, "worker.timeout",
                "the measuring process closed its output without an answer, went on and was ended" + whereabouts() + tail(), {}};
      }
      ::poll(nullptr, 0, 1);
    }
    pid_ = -1;
    drain(errors_.read, stderr_tail_);
    const std::string how = WIFSIGNALED(status) ? std::string("was ended by ") + ::strsignal(WTERMSIG(status))
                                                : "ended with status " + std::to_string(WEXITSTATUS(status)) + " and no answer";
    return {ErrorKind::kMeasurement, "worker.crashed", "the measuring process " + how + whereabouts() + tail(), {}};
  }

  // What it was doing.
  std::string whereabouts() const {
    if (last_.total == 0) return ", before it had measured anything";
    return ", after " + std::to_string(last_.done) + " of " + std::to_string(last_.total) + " frames";
  }

  std::string tail() const {
    if (stderr_tail_.empty()) return "";
    const std::size_t start = stderr_tail_.size() > kStderrTail ? stderr_tail_.size() - kStderrTail : 0;
    return "; it last said: " + stderr_tail_.substr(start);
  }

  void kill() {
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
    pid_ = -1;
  }

  pid_t pid_ = -1;
  Pipe input_, output_, errors_;
  std::string unsent_, buffer_, stderr_tail_;
  JobProgress last_;
};

}  // namespace

Result<JobResult> superviseJob(const Job& job, const SupervisorOptions& options, const std::function<void(const JobProgress&)>& progress) {
  Worker worker;
  REPRISE_TRY(worker.start(options.worker_path, jobToJson(job)));
  return worker.listen(options, progress);
}

}  // namespace reprise
