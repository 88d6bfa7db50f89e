// The man page and the completion of shells name what --help names.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/e2e/run_command.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kCommands = {"optimize", "emit", "validate", "analyze", "check", "play", "report", "devices"};

// Options as they are typed: what CLI11 calls --MD is -MD.
std::set<std::string> optionsOf(const std::string& command) {
  const CommandOutcome outcome = command.empty() ? runCommand({REPRISE_EXECUTABLE, "--help"}) : runCommand({REPRISE_EXECUTABLE, command, "--help"});
  EXPECT_EQ(outcome.status, 0) << outcome.all();
  std::set<std::string> options;
  const std::regex line("^  (-[^ ]+)"), option("--?[A-Za-z][A-Za-z-]*");
  std::size_t start = 0;
  for (std::size_t end = outcome.output.find('\n'); end != std::string::npos; start = end + 1, end = outcome.output.find('\n', start)) {
    const std::string text = outcome.output.substr(start, end - start);
    std::smatch head;
    if (!std::regex_search(text, head, line)) continue;
    const std::string names = head[1];
    for (std::sregex_iterator each(names.begin(), names.end(), option), none; each != none; ++each) {
      const std::string name = each->str();
      options.insert(std::regex_match(name, std::regex("--M[A-Z]?")) ? name.substr(1) : name);
    }
  }
  options.erase("-h");
  options.erase("-q");
  EXPECT_FALSE(options.empty()) << command;
  return options;
}

std::string manualText() {
  return std::regex_replace(textOf(fs::path(REPRISE_SOURCE_DIR) / "docs/reprise.1"), std::regex(R"(\\-)"), "-");
}

bool names(const std::string& text, const std::string& option) {
  return std::regex_search(text, std::regex("(^|[^A-Za-z-])" + option + "([^A-Za-z-]|$)"));
}

TEST(Manual, NamesEveryCommandAndOption) {
  const std::string manual = manualText();
  for (const std::string& option : optionsOf("")) EXPECT_TRUE(names(manual, option)) << option;
  for (const std::string& command : kCommands) {
    EXPECT_NE(manual.find(".B " + command + "\n"), std::string::npos) << command;
    for (const std::string& option : optionsOf(command)) EXPECT_TRUE(names(manual, option)) << command << " " << option;
  }
}

TEST(Version, NamesWhatTheToolStandsOn) {
  const std::string text = runCommand({REPRISE_EXECUTABLE, "--version"}).output;
  for (const char* line : {"reprise", "glslang", "SPIRV-Tools v", "SPIRV-Cross C API", "Ceres", "SQLite", "Vulkan headers", "package format"})
    EXPECT_TRUE(std::regex_search(text, std::regex("(^|\n)" + std::string(line) + " ?[0-9]+"))) << line << "\n" << text;
}

TEST(Completion, OffersTheOptionsOfEveryCommand) {
  for (const char* file : {"reprise.bash", "_reprise"}) {
    const std::string text = textOf(fs::path(REPRISE_SOURCE_DIR) / "cli/completion" / file);
    for (const std::string& command : kCommands) {
      if (command == "report") continue;
      std::smatch found;
      std::regex_search(text, found, std::regex("\n *" + command + "\\) options=[\"(](.*)[\")] ;;"));
      ASSERT_FALSE(found.empty()) << file << " " << command;
      const std::string offered = found[1];
      std::set<std::string> options = optionsOf(command);
      options.erase("--help");
      for (const std::string& option : options) EXPECT_TRUE(names(offered, option)) << file << " " << command << " " << option;
    }
  }
}

TEST(Version, NamesWhatItStandsOn) {
  const CommandOutcome outcome = runCommand({REPRISE_EXECUTABLE, "--version"});
  EXPECT_EQ(outcome.status, 0);
  for (const char* part : {"reprise ", "glslang ", "SPIRV-Tools ", "Vulkan headers ", "package format "})
    EXPECT_NE(outcome.output.find(part), std::string::npos) << outcome.output;
}

}  // namespace
}  // namespace reprise
