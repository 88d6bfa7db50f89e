// Build steps that measure: where a choice is missing or stale (TRAIN IF_STALE), or whenever a package has to be made (TRAIN ALWAYS).
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include "tests/e2e/run_command.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProject = R"cmake(
cmake_minimum_required(VERSION 3.22)
project(trained CXX)
find_package(Reprise REQUIRED)
add_executable(show main.cpp)
reprise_optimize_shader(show SCENARIO first/small.toml MAX_ERROR 0.05 CHOICE first.choice.json OUTPUT made/first TRAIN IF_STALE)
reprise_optimize_shader(show SCENARIO second/small.toml MAX_ERROR 0.05 CHOICE second.choice.json OUTPUT made/second TRAIN ALWAYS)
)cmake";

std::size_t countOf(const std::string& text, const std::string& words) {
  std::size_t count = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
  return count;
}

class TrainStep : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(runCommand({REPRISE_CMAKE, "--install", REPRISE_BUILD_DIR, "--prefix", folder_ / "installed"}).status, 0);
    fs::create_directories(source());
    for (const char* name : {"first", "second"}) fs::copy(fs::path(REPRISE_SOURCE_DIR) / "tests/e2e/small", source() / name, fs::copy_options::recursive);
    writeText(source() / "CMakeLists.txt", kProject);
    writeText(source() / "main.cpp", "int main() {}\n");
  }

  fs::path source() const { return folder_ / "source"; }
  fs::path build() const { return folder_ / "build"; }

  void configure() const {
    const CommandOutcome outcome =
        runCommand({REPRISE_CMAKE, "-S", source(), "-B", build(), "-G", "Ninja", "-DCMAKE_PREFIX_PATH=" + (folder_ / "installed").string(),
                    std::string("-DCMAKE_CXX_COMPILER=") + REPRISE_COMPILER});
    ASSERT_EQ(outcome.status, 0) << outcome.all();
  }

  // How many scenarios were measured. Then nothing is left to do, twice.
  std::size_t measuredIn(const std::string& expected_words = "") const {
    const CommandOutcome outcome = runCommand({REPRISE_CMAKE, "--build", build(), "--parallel", "2"});
    EXPECT_EQ(outcome.status, 0) << outcome.all();
    EXPECT_NE(outcome.all().find(expected_words), std::string::npos) << outcome.all();
    for (int again = 0; again < 2; ++again) {
      const CommandOutcome later = runCommand({REPRISE_CMAKE, "--build", build(), "--parallel", "2"});
      EXPECT_EQ(later.status, 0) << later.all();
      EXPECT_NE(later.output.find("no work to do"), std::string::npos) << later.all();
    }
    return countOf(outcome.all(), "probe payload ranges");
  }

  static void append(const fs::path& file, const std::string& text) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // some file systems tell times apart by a second only
    writeText(file, textOf(file) + text);
  }

  TemporaryFolder folder_;
};

TEST_F(TrainStep, MeasuresWhatIsMissingOneAfterTheOther) {
  configure();
  EXPECT_EQ(measuredIn("which another run measures on"), 2u);
  EXPECT_TRUE(fs::exists(source() / "first.choice.json"));
  EXPECT_TRUE(fs::exists(source() / "second.choice.json"));
  EXPECT_TRUE(fs::exists(build() / "made/second/manifest.json"));

  append(source() / "first/small.frag", "// the first\n");
  EXPECT_EQ(measuredIn(), 0u);  // its choice still holds
  append(source() / "second/small.frag", "// the second\n");
  EXPECT_EQ(measuredIn(), 1u);
}

TEST_F(TrainStep, MeasuresAnewWhereTheChoiceIsStale) {
  const std::string of_another_shader = textOf(fs::path(REPRISE_SOURCE_DIR) / "examples/cmake_project/shaders/granite.choice.json");
  writeText(source() / "first.choice.json", of_another_shader);
  configure();
  EXPECT_EQ(measuredIn("first.choice.json has to be made anew"), 2u);
  EXPECT_NE(textOf(source() / "first.choice.json"), of_another_shader);
}

}  // namespace
}  // namespace reprise
