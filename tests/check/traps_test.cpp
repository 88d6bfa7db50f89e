// Every shader of traps/ gets the verdict that its first line expects: `// expect: verified` or `// expect: refused CODE`.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <thread>

#include "cli/check/run_modules.h"

namespace reprise {
namespace {

const std::filesystem::path kTraps = std::filesystem::path(REPRISE_SOURCE_DIR) / "tests/check/traps";

std::vector<std::string> trapFiles() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(kTraps)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".frag" || extension == ".spvasm") files.push_back(entry.path().filename().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// The rest of the first line.
std::string expectedOf(const std::string& file) {
  std::ifstream stream(kTraps / file);
  std::string line;
  std::getline(stream, line);
  constexpr const char* kMark = "expect: ";
  const std::size_t at = line.find(kMark);
  return at == std::string::npos ? "nothing is expected" : line.substr(at + std::char_traits<char>::length(kMark));
}

class Trap : public testing::TestWithParam<std::string> {
 protected:
  // All are checked at once, as many at a time as there are cores.
  static void SetUpTestSuite() {
    std::vector<CheckRequest> requests;
    for (const std::string& file : trapFiles()) {
      if (!isToRun(file)) continue;
      requests.emplace_back();
      requests.back().path = (kTraps / file).string();
    }
    RunModulesOptions options;
    options.worker_path = REPRISE_EXECUTABLE;
    options.jobs = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
    const auto run = runModules(requests, options, [](const ModuleVerdict&) {});
    ASSERT_TRUE(run.ok()) << run.error().message;
    for (const ModuleVerdict& verdict : *run) verdicts[std::filesystem::path(verdict.path).filename().string()] = verdict;
  }

  // A filtered run is short.
  static bool isToRun(const std::string& file) {
    const testing::TestSuite* suite = testing::UnitTest::GetInstance()->current_test_suite();
    for (int i = 0; i < suite->total_test_count(); ++i) {
      const testing::TestInfo* test = suite->GetTestInfo(i);
      if (test->should_run() && test->value_param() != nullptr && std::string(test->value_param()) == '"' + file + '"') return true;
    }
    return false;
  }

  static std::map<std::string, ModuleVerdict> verdicts;
};

std::map<std::string, ModuleVerdict> Trap::verdicts;

TEST_P(Trap, GetsItsVerdict) {
  ASSERT_TRUE(verdicts.count(GetParam()) != 0);
  const ModuleVerdict& verdict = verdicts.at(GetParam());
  EXPECT_EQ(nameOf(verdict.verdict) + (verdict.code.empty() ? "" : " " + verdict.code), expectedOf(GetParam())) << verdict.reason;
}

INSTANTIATE_TEST_SUITE_P(All, Trap, testing::ValuesIn(trapFiles()), [](const testing::TestParamInfo<std::string>& test) {
  std::string name = test.param;
  std::replace_if(name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
});

}  // namespace
}  // namespace reprise
