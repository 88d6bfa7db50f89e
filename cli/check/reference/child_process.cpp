#include "cli/check/reference/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace reprise {

Result<ChildProcess> startChild(const std::string& executable, const std::string& verb) {
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
  std::string name = executable, word = verb;
  char* arguments[] = {name.data(), word.data(), nullptr};
  ChildProcess child;
  const int status = ::posix_spawn(&child.process, executable.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(input[0]), ::close(output[1]);
  if (status != 0) {
    ::close(input[1]), ::close(output[0]);
    return Error{ErrorKind::kMachine, "check.process", "no process could be started from " + executable, {}};
  }
  child.input = input[1];
  child.output = output[0];
  return child;
}

void belongToParent() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) ::signal(number, SIG_IGN);
}

std::string howItEnded(int status) {
  if (WIFSIGNALED(status)) return fmt::format("ended by signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)));
  return fmt::format("ended with status {}", WEXITSTATUS(status));
}

}  // namespace reprise
