#include "cli/check/reference/time_limit.h"

#include <unistd.h>

#include <fstream>
#include <sstream>
#include <string>

namespace reprise {
namespace {

constexpr double kIdleFactor = 4;
constexpr int kFieldsBeforeTimes = 11;  // of /proc/PID/stat, after the name

}  // namespace

bool isOverTime(double elapsed_seconds, double worked_seconds, double limit_seconds) {
  return elapsed_seconds > kIdleFactor * limit_seconds || (elapsed_seconds > limit_seconds && worked_seconds > limit_seconds);
}

double workedSeconds(pid_t process) {
  std::ifstream stream("/proc/" + std::to_string(process) + "/stat");
  std::string line;
  std::getline(stream, line);
  // The name, in brackets, may hold anything.
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return 0;
  std::istringstream fields(line.substr(name_end + 1));
  std::string skipped;
  for (int i = 0; i < kFieldsBeforeTimes; ++i) fields >> skipped;
  double user = 0, system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

double TimeLimit::elapsedSeconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

bool TimeLimit::isOver() const {
  const double elapsed = elapsedSeconds();
  return elapsed > seconds_ && isOverTime(elapsed, workedSeconds(process_), seconds_);
}

}  // namespace reprise
