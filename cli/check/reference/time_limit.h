// How long a process may take on a machine that others use, too.
#pragma once

#include <sys/types.h>

#include <chrono>

namespace reprise {

// Over once the limit has passed and the process has worked for as long itself, or once four times the limit has passed: a process
// that waits for a core has not hung, one that waits for nothing has.
class TimeLimit {
 public:
  TimeLimit(pid_t process, double seconds) : process_(process), seconds_(seconds) {}
  bool isOver() const;
  double elapsedSeconds() const;

 private:
  pid_t process_;
  double seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// The rule itself.
bool isOverTime(double elapsed_seconds, double worked_seconds, double limit_seconds);

// CPU time of a running process and its threads, 0 if there is none.
double workedSeconds(pid_t process);

}  // namespace reprise
