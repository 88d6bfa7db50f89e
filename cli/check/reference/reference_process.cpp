#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <memory>

#include "cli/check/reference/child_process.h"
#include "cli/check/reference/reference_messages.h"
#include "cli/check/reference/time_limit.h"

namespace reprise {
namespace {

class ReferenceProcess {
 public:
  ReferenceProcess(ChildProcess child, std::string path, double timeout_s) : child_(child), path_(std::move(path)), timeout_s_(timeout_s) {}
  ReferenceProcess(const ReferenceProcess&) = delete;
  ReferenceProcess& operator=(const ReferenceProcess&) = delete;
  ~ReferenceProcess() { end(); }

  Result<std::vector<HarnessFrame>> answerTo(const ReferenceAsk& ask) {
    if (gone_) return *gone_;
    const TimeLimit limit(child_.process, timeout_s_);
    bool late = false;
    std::optional<PipeMessage> answer;
    if (sendMessage(child_.input, messageOf(ask))) answer = receiveMessage(child_.output, [&] { return late = limit.isOver(); });
    if (answer) return answerFrom(*answer);
    const int status = end(late);
    gone_ = late ? Error{ErrorKind::kMachine, "original.hung", fmt::format("the module alone gave no image in time ({})", path_), {}}
                 : Error{ErrorKind::kMachine, "original.crashed", fmt::format("the module alone {} ({})", howItEnded(status), path_), {}};
    return *gone_;
  }

 private:
  // The status of the process.
  int end(bool kill = true) {
    if (child_.process < 0) return 0;
    if (kill) ::kill(child_.process, SIGKILL);
    int status = 0;
    ::waitpid(child_.process, &status, 0);
    ::close(child_.input), ::close(child_.output);
    child_.process = -1;
    return status;
  }

  ChildProcess child_;
  std::string path_;
  double timeout_s_;
  std::optional<Error> gone_;
};

}  // namespace

Result<Reference> startReferenceProcess(const std::string& executable, const ReferenceModule& module, double timeout_s) {
  ::signal(SIGPIPE, SIG_IGN);  // a reference that dies must not take us with it
  REPRISE_ASSIGN(const ChildProcess child, startChild(executable, "check-reference"));
  const auto process = std::make_shared<ReferenceProcess>(child, module.path, timeout_s);
  sendMessage(child.input, messageOf(module));  // one that is gone already is told at the first question
  return Reference([process](const ReferenceAsk& ask) { return process->answerTo(ask); });
}

}  // namespace reprise
