// examples/cmake_project, built against an installed tree by Ninja and by make: nothing runs twice, nothing is missed.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "tests/e2e/run_command.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

const std::string kStepRan = "Reprise: package of ";

class BuildStep : public testing::TestWithParam<std::string> {
 protected:
  static void SetUpTestSuite() {
    installed_ = std::make_unique<TemporaryFolder>();
    const CommandOutcome outcome = runCommand({REPRISE_CMAKE, "--install", REPRISE_BUILD_DIR, "--prefix", installed_->path()});
    ASSERT_EQ(outcome.status, 0) << outcome.all();
  }
  static void TearDownTestSuite() { installed_.reset(); }

  void SetUp() override {
    fs::copy(fs::path(REPRISE_SOURCE_DIR) / "examples/cmake_project", source(), fs::copy_options::recursive);
    const CommandOutcome outcome = runCommand({REPRISE_CMAKE, "-S", source(), "-B", build(), "-G", GetParam(), "-DCMAKE_PREFIX_PATH=" + installed_->path().string(),
                                               std::string("-DCMAKE_CXX_COMPILER=") + REPRISE_COMPILER});
    ASSERT_EQ(outcome.status, 0) << outcome.all();
    expectBuilt(3);
  }

  fs::path source() const { return folder_ / "source"; }
  fs::path build() const { return folder_ / "build"; }
  fs::path shader(const std::string& name) const { return source() / "shaders" / name; }

  CommandOutcome runBuild() const {
    CommandSpec spec;
    spec.words = {REPRISE_CMAKE, "--build", build(), "--parallel", "2"};
    spec.environment = {{"VK_ICD_FILENAMES", "/nonexistent.json"}, {"VK_DRIVER_FILES", "/nonexistent.json"}};
    return runCommand(spec);
  }

  static int stepsIn(const CommandOutcome& outcome) {
    int steps = 0;
    for (std::size_t at = outcome.output.find(kStepRan); at != std::string::npos; at = outcome.output.find(kStepRan, at + 1)) ++steps;
    return steps;
  }

  // This many packages are made, and then none any more.
  void expectBuilt(int packages) const {
    const CommandOutcome first = runBuild();
    ASSERT_EQ(first.status, 0) << first.all();
    EXPECT_EQ(stepsIn(first), packages) << first.all();
    for (int again = 0; again < 2; ++again) {
      const CommandOutcome later = runBuild();
      EXPECT_EQ(later.status, 0) << later.all();
      EXPECT_EQ(stepsIn(later), 0) << later.all();
      EXPECT_EQ(later.output.find("Linking"), std::string::npos) << later.all();
      EXPECT_EQ(later.output.find("Building"), std::string::npos) << later.all();
    }
  }

  // Some file systems and makes tell times apart by a second only.
  static void edit(const fs::path& file, const std::string& from, const std::string& to) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    std::string text = textOf(file);
    ASSERT_NE(text.find(from), std::string::npos) << file;
    writeText(file, text.replace(text.find(from), from.size(), to));
  }

  TemporaryFolder folder_;
  static std::unique_ptr<TemporaryFolder> installed_;
};

std::unique_ptr<TemporaryFolder> BuildStep::installed_;

TEST_P(BuildStep, TheProgramFindsItsPackages) {
  const CommandOutcome outcome = runCommand({build() / "show"});
  EXPECT_EQ(outcome.status, 0) << outcome.all();
  EXPECT_NE(outcome.output.find("granite: "), std::string::npos) << outcome.all();
  EXPECT_NE(outcome.output.find("agate: "), std::string::npos) << outcome.all();
  EXPECT_TRUE(fs::exists(build() / "packages/wood/manifest.json"));
}

TEST_P(BuildStep, RunsAgainWhereAnIncludeATextureOrTheToolChanged) {
  edit(shader("noise.glsl"), "enough work", "enough of work");
  expectBuilt(3);
  edit(shader("granite.toml"), "name = \"granite\"", "name = \"granite\"  # a stone");
  expectBuilt(1);
  edit(shader("dust.png"), "IEND", "IEND");
  expectBuilt(1);
  edit(shader("wood.choice.json"), "\"reason\"", " \"reason\"");
  expectBuilt(1);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  fs::last_write_time(installed_->path() / "bin/reprise", fs::file_time_type::clock::now());
  expectBuilt(3);
}

TEST_P(BuildStep, FailsWithAStaleChoiceAndBuildsOnAfterTheMend) {
  edit(shader("granite.frag"), "object_position * 3.0", "object_position * 3.5");
  for (int again = 0; again < 2; ++again) {
    const CommandOutcome outcome = runBuild();
    EXPECT_NE(outcome.status, 0) << outcome.all();
    EXPECT_NE(outcome.all().find("choice.stale"), std::string::npos) << outcome.all();
    EXPECT_FALSE(fs::exists(build() / "reprise/granite.stamp"));
  }
  edit(shader("granite.frag"), "object_position * 3.5", "object_position * 3.0");
  expectBuilt(1);
}

TEST_P(BuildStep, RunsAgainAndFailsWhereTheBuildAsksForLess) {
  edit(source() / "CMakeLists.txt", "granite.toml MAX_ERROR 0.03", "granite.toml QUALITY draft MAX rms=0.03 flip=0.5 MAX_ERROR 0.02");
  const CommandOutcome outcome = runBuild();
  EXPECT_NE(outcome.status, 0) << outcome.all();
  EXPECT_NE(outcome.all().find("the choice allows rms 0.03, the build asks for at most 0.02 (--max-error)"), std::string::npos) << outcome.all();
  EXPECT_NE(outcome.all().find("the choice does not bind flip (it binds rms 0.03), the build asks for at most 0.5 (--max)"), std::string::npos) << outcome.all();
  EXPECT_NE(outcome.all().find("(--quality draft)"), std::string::npos) << outcome.all();
  edit(source() / "CMakeLists.txt", "QUALITY draft MAX rms=0.03 flip=0.5 MAX_ERROR 0.02", "");
  expectBuilt(1);  // it asks for nothing
}

INSTANTIATE_TEST_SUITE_P(Generators, BuildStep, testing::Values("Ninja", "Unix Makefiles"),
                         [](const auto& each) { return each.param == "Ninja" ? "Ninja" : "Makefiles"; });

// Without CMake: what pkg-config says is enough for a Makefile of one's own.
TEST(PkgConfig, NamesTheToolAndTheLibraries) {
  const TemporaryFolder prefix;
  ASSERT_EQ(runCommand({REPRISE_CMAKE, "--install", REPRISE_BUILD_DIR, "--prefix", prefix.path()}).status, 0);
  fs::path folder;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(prefix.path()))
    if (entry.path().filename() == "reprise.pc") folder = entry.path().parent_path();
  CommandSpec spec;
  spec.words = {"pkg-config", "--define-variable=prefix=" + prefix.path().string(), "--variable=reprise", "reprise"};
  spec.environment = {{"PKG_CONFIG_PATH", folder.string()}};
  const CommandOutcome tool = runCommand(spec);
  ASSERT_EQ(tool.status, 0) << tool.all();
  EXPECT_EQ(tool.output, (prefix / "bin/reprise").string() + "\n");
  writeText(prefix / "use.cpp", "#include \"runtime/package/package.h\"\nint main() { return reprise::readPackage(\"nothing\").ok(); }\n");
  spec.words = {"sh", "-c", std::string(REPRISE_COMPILER) + " -std=c++20 use.cpp -o use $(pkg-config --define-variable=prefix=$PWD --cflags --libs reprise) && ./use"};
  spec.words[2] = "cd '" + prefix.path().string() + "' && " + spec.words[2];
  const CommandOutcome built = runCommand(spec);
  EXPECT_EQ(built.status, 0) << built.all();
}

}  // namespace
}  // namespace reprise
