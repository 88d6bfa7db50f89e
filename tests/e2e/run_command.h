// Runs programs from tests: the built `reprise`, example programs, compilers.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace reprise {

struct CommandSpec {
  std::vector<std::string> words;  // the program's path first, or its name in PATH
  std::vector<std::pair<std::string, std::string>> environment;  // on top of the test's own
  std::string input;                                             // standard input
  std::optional<std::uint64_t> file_size_limit_bytes;  // no file may grow beyond it, as on a full disk
  std::chrono::seconds time_limit{300};                // then the whole process group is killed
};

struct CommandOutcome {
  int status = -1;  // exit status; 128 + signal number if a signal ended it
  bool timed_out = false;
  std::string output, errors;  // standard output and standard error
  std::string all() const { return output + errors; }
};

// A program that runs beside the test, in a process group of its own; killed with it if still there at the
// end.
class Command {
 public:
  explicit Command(CommandSpec spec);
  ~Command();
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  pid_t process() const { return process_; }
  bool running();
  void signal(int signal_number);       // to the program alone, as a supervisor would
  void signalGroup(int signal_number);  // to it and its children, as a terminal does with Ctrl-C
  CommandOutcome wait();

 private:
  CommandSpec spec_;
  std::filesystem::path streams_;  // folder of the files that hold input, output and errors
  pid_t process_ = -1;
  std::optional<int> wait_status_;
  std::chrono::steady_clock::time_point deadline_;
};

CommandOutcome runCommand(CommandSpec spec);
CommandOutcome runCommand(std::vector<std::string> words);

// A folder that is made for the test and removed with it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

std::string textOf(const std::filesystem::path& file);
void writeText(const std::filesystem::path& file, const std::string& text);

}  // namespace reprise
