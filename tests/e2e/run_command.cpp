#include "tests/e2e/run_command.h"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace reprise {

namespace fs = std::filesystem;

namespace {

fs::path makeFolder() {
  std::string name = (fs::temp_directory_path() / "reprise_test_XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("cannot make a temporary folder " + name);
  return name;
}

void redirect(const fs::path& file, int flags, int descriptor) {
  const int opened = open(file.c_str(), flags, 0600);
  if (opened < 0 || dup2(opened, descriptor) < 0) _exit(127);
  close(opened);
}

// In the child, after fork: never returns.
[[noreturn]] void become(const CommandSpec& spec, const fs::path& streams) {
  setpgid(0, 0);
  redirect(streams / "input", O_RDONLY, STDIN_FILENO);
  redirect(streams / "output", O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
  redirect(streams / "errors", O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
  for (const auto& [name, value] : spec.environment) setenv(name.c_str(), value.c_str(), 1);
  if (spec.file_size_limit_bytes) {
    ::signal(SIGXFSZ, SIG_IGN);  // writes fail with an error instead of ending the program
    const rlimit limit{*spec.file_size_limit_bytes, *spec.file_size_limit_bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  std::vector<char*> words;
  for (const std::string& word : spec.words) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execvp(words[0], words.data());
  _exit(127);
}

}  // namespace

Command::Command(CommandSpec spec)
    : spec_(std::move(spec)),
      streams_(makeFolder()),
      deadline_(std::chrono::steady_clock::now() + spec_.time_limit) {
  writeText(streams_ / "input", spec_.input);
  process_ = fork();
  if (process_ < 0) throw std::runtime_error("cannot fork");
  if (process_ == 0) become(spec_, streams_);
  setpgid(process_, process_);  // in both processes, so that neither has to wait for the other
}

Command::~Command() {
  if (running()) {
    signalGroup(SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  std::error_code ignored;
  fs::remove_all(streams_, ignored);
}

bool Command::running() {
  if (wait_status_) return false;
  int status = 0;
  if (waitpid(process_, &status, WNOHANG) == process_) wait_status_ = status;
  return !wait_status_;
}

void Command::signal(int signal_number) {
  if (running()) kill(process_, signal_number);
}

void Command::signalGroup(int signal_number) {
  if (running()) kill(-process_, signal_number);
}

CommandOutcome Command::wait() {
  CommandOutcome outcome;
  while (running()) {
    if (std::chrono::steady_clock::now() > deadline_) {
      outcome.timed_out = true;
      signalGroup(SIGKILL);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const int status = *wait_status_;
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.output = textOf(streams_ / "output");
  outcome.errors = textOf(streams_ / "errors");
  return outcome;
}

CommandOutcome runCommand(CommandSpec spec) {
  return Command(std::move(spec)).wait();
}

CommandOutcome runCommand(std::vector<std::string> words) {
  CommandSpec spec;
  spec.words = std::move(words);
  return runCommand(std::move(spec));
}

TemporaryFolder::TemporaryFolder() : path_(makeFolder()) {}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string textOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void writeText(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace reprise
