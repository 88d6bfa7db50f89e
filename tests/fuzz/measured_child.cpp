#include "tests/fuzz/measured_child.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "runtime/base/check.h"

namespace reprise {

ChildOutcome runInChild(const std::function<std::string()>& work, int most_cpu_s) {
  int ends[2] = {};
  REPRISE_CHECK(::pipe(ends) == 0, "no pipe");
  const pid_t child = ::fork();
  REPRISE_CHECK(child >= 0, "no process");
  if (child == 0) {
    const rlimit limit{static_cast<rlim_t>(most_cpu_s), static_cast<rlim_t>(most_cpu_s)};
    ::setrlimit(RLIMIT_CPU, &limit);
    const std::string answer = work();
    const bool told = ::write(ends[1], answer.data(), answer.size()) == static_cast<ssize_t>(answer.size());
    ::_exit(told ? 0 : 1);
  }
  ::close(ends[1]);
  ChildOutcome outcome;
  char buffer[4096];
  for (ssize_t count; (count = ::read(ends[0], buffer, sizeof buffer)) > 0;) outcome.answer.append(buffer, static_cast<std::size_t>(count));
  ::close(ends[0]);
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  outcome.ended = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  const auto seconds = [](const timeval& time) { return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6; };
  outcome.cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  outcome.peak_mib = static_cast<double>(usage.ru_maxrss) / 1024;
  return outcome;
}

}  // namespace reprise
