// `reprise emit` on the committed choices of examples/cmake_project: the same bytes anywhere, no device, and what it says of bad input.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <map>
#include <string>

#include "tests/e2e/run_command.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

const fs::path kShaders = fs::path(REPRISE_SOURCE_DIR) / "examples/cmake_project/shaders";

std::map<std::string, std::string> filesOf(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[entry.path().lexically_relative(folder).string()] = textOf(entry.path());
  return files;
}

class Emit : public testing::Test {
 protected:
  void SetUp() override { fs::copy(kShaders, shaders()); }

  fs::path shaders() const { return folder_ / "shaders"; }
  fs::path output() const { return folder_ / "package"; }
  fs::path choice() const { return shaders() / "granite.choice.json"; }

  CommandOutcome emit(std::vector<std::string> more = {}, const std::string& scenario = "granite") const {
    CommandSpec spec;
    spec.words = {REPRISE_EXECUTABLE, "emit", shaders() / (scenario + ".toml"), "--choice", shaders() / (scenario + ".choice.json"), "-o", output()};
    spec.words.insert(spec.words.end(), more.begin(), more.end());
    // No Vulkan device can be found: none is needed.
    spec.environment = {{"VK_ICD_FILENAMES", "/nonexistent.json"}, {"VK_DRIVER_FILES", "/nonexistent.json"}};
    return runCommand(spec);
  }

  void replace(const fs::path& file, const std::string& from, const std::string& to) const {
    std::string text = textOf(file);
    ASSERT_NE(text.find(from), std::string::npos) << file << " does not hold " << from;
    writeText(file, text.replace(text.find(from), from.size(), to));
  }

  void expectRefused(const CommandOutcome& outcome, int status, const std::string& said) const {
    EXPECT_EQ(outcome.status, status) << outcome.all();
    EXPECT_NE(outcome.errors.find(said), std::string::npos) << outcome.errors;
  }

  TemporaryFolder folder_;
};

TEST_F(Emit, GivesTheSameBytesWhereverTheSourcesLie) {
  ASSERT_EQ(emit().status, 0);
  const auto first = filesOf(output());
  EXPECT_TRUE(first.contains("manifest.json"));
  const fs::path moved = folder_ / "somewhere" / "else";
  fs::create_directories(moved.parent_path());
  fs::rename(shaders(), moved);
  const CommandOutcome outcome = runCommand({REPRISE_EXECUTABLE, "emit", moved / "granite.toml", "--choice", moved / "granite.choice.json", "-o",
                                             folder_ / "second"});
  ASSERT_EQ(outcome.status, 0) << outcome.all();
  const auto second = filesOf(folder_ / "second");
  ASSERT_EQ(first.size(), second.size());
  for (const auto& [name, bytes] : first) EXPECT_TRUE(second.contains(name) && second.at(name) == bytes) << name << " differs";
}

TEST_F(Emit, VerifiesOnADevice) {
  expectRefused(emit({"--verify"}), 3, "device.none");
  EXPECT_FALSE(fs::exists(output()));
  ASSERT_EQ(emit().status, 0);
  const CommandOutcome outcome = runCommand({REPRISE_EXECUTABLE, "emit", shaders() / "granite.toml", "--choice", choice(), "-o", folder_ / "verified", "--verify"});
  ASSERT_EQ(outcome.status, 0) << outcome.all();
  EXPECT_TRUE(filesOf(folder_ / "verified") == filesOf(output()));
}

TEST_F(Emit, WritesNothingWhereNothingDiffers) {
  ASSERT_EQ(emit({"--header", folder_ / "granite.h"}).status, 0);
  std::map<fs::path, fs::file_time_type> times;
  for (const fs::directory_entry& entry : fs::directory_iterator(output())) times[entry.path()] = entry.last_write_time();
  times[folder_ / "granite.h"] = fs::last_write_time(folder_ / "granite.h");
  ASSERT_EQ(emit({"--header", folder_ / "granite.h"}).status, 0);
  for (const auto& [file, time] : times) EXPECT_EQ(fs::last_write_time(file), time) << file;
}

TEST_F(Emit, SurvivesAnEditOfTheTail) {
  replace(shaders() / "granite.frag", "(0.2 + 0.8 * facing)", "(0.3 + 0.6 * facing * facing)");
  const CommandOutcome outcome = emit();
  EXPECT_EQ(outcome.status, 0) << outcome.all();
  EXPECT_TRUE(filesOf(output()).contains("fragment_hits.spv"));
}

TEST_F(Emit, SaysWhatOfTheSliceChangedAndLeavesTheOldPackage) {
  ASSERT_EQ(emit().status, 0);
  const auto before = filesOf(output());
  replace(shaders() / "noise.glsl", "1.37", "1.41");
  expectRefused(emit(), 1, "choice.stale");
  expectRefused(emit(), 1, "constant");
  EXPECT_TRUE(filesOf(output()) == before);
}

TEST_F(Emit, ShipsTheOriginalOfAStaleChoiceWhereAllowed) {
  ASSERT_EQ(emit().status, 0);
  replace(shaders() / "noise.glsl", "sin(point.z)", "cos(point.z)");
  const CommandOutcome outcome = emit({"--on-stale", "original"});
  EXPECT_EQ(outcome.status, 0) << outcome.all();
  EXPECT_NE(outcome.errors.find("the original is shipped"), std::string::npos) << outcome.errors;
  // The modules of the variant are gone, those of the original are there.
  for (const auto& [name, bytes] : filesOf(output()))
    EXPECT_TRUE(name == "manifest.json" || name.starts_with("fragment.") || name.starts_with("original_vertex.")) << name;
}

// The motion that the choice was trained with is gone.
TEST_F(Emit, ShipsNoVariantOfAPositionThatReadsNothing) {
  replace(shaders() / "common.vert", "gl_Position = frame.view_projection * world", "gl_Position = vec4(position.xy, 0.5, 1.0)");
  expectRefused(emit(), 1, "motion.none");
  EXPECT_FALSE(fs::exists(output()));
  const CommandOutcome original = emit({"--on-stale", "original"});
  EXPECT_EQ(original.status, 0) << original.all();
  EXPECT_NE(original.errors.find("the original is shipped"), std::string::npos) << original.errors;
  writeText(shaders() / "granite.toml", "motion = \"none\"\n" + textOf(shaders() / "granite.toml"));
  const CommandOutcome said = emit();
  EXPECT_EQ(said.status, 0) << said.all();
  EXPECT_TRUE(filesOf(output()).contains("fragment_hits.spv"));
}

TEST_F(Emit, ListsEverythingThatThePackageDependsOn) {
  const CommandOutcome outcome = emit({"-M"}, "agate");
  ASSERT_EQ(outcome.status, 0) << outcome.all();
  for (const char* name : {"agate.toml", "agate.frag", "common.vert", "noise.glsl", "dust.png", "agate.choice.json"})
    EXPECT_NE(outcome.output.find((shaders() / name).string()), std::string::npos) << name << " is missing in\n" << outcome.output;
  EXPECT_FALSE(fs::exists(output()));
  ASSERT_EQ(emit({"-MD", "-MF", folder_ / "agate.d", "-MT", "wanted"}, "agate").status, 0);
  EXPECT_TRUE(textOf(folder_ / "agate.d").starts_with("wanted:"));
}

TEST_F(Emit, RefusesBadChoices) {
  fs::remove(choice());
  expectRefused(emit(), 1, "choice.missing");
  writeText(choice(), "<<<<<<< ours\n{}\n");
  expectRefused(emit(), 1, "choice.syntax");
  writeText(choice(), "{\"format_version\": 999, \"tool_version\": \"9.0\"}");
  expectRefused(emit(), 1, "choice.version");
  writeText(choice(), "{\"format_version\": 1}");
  expectRefused(emit(), 1, "choice.invalid");
  EXPECT_FALSE(fs::exists(output()));
}

TEST_F(Emit, NotesAChoiceOfAnotherVersion) {
  std::string text = textOf(choice());
  const std::size_t at = text.find("\"tool_version\": \"") + 17;
  text.replace(at, text.find('"', at) - at, "0.0.1");
  writeText(choice(), text);
  const CommandOutcome outcome = emit();
  EXPECT_EQ(outcome.status, 0) << outcome.all();
  EXPECT_NE(outcome.errors.find("was made by reprise 0.0.1"), std::string::npos) << outcome.errors;
}

TEST_F(Emit, RefusesAMissingTexture) {
  fs::remove(shaders() / "dust.png");
  expectRefused(emit({}, "agate"), 1, "dust.png");
  EXPECT_FALSE(fs::exists(output()));
}

TEST_F(Emit, SaysThatItCannotWrite) {
  const CommandOutcome outcome =
      runCommand({REPRISE_EXECUTABLE, "emit", shaders() / "granite.toml", "--choice", choice(), "-o", "/proc/reprise"});
  expectRefused(outcome, 3, "file.unwritable");
}

TEST_F(Emit, SweepsAwayWhatKilledProcessesLeftAside) {
  const fs::path dead = output() / ".new-2147483647", living = output() / (".new-" + std::to_string(::getpid())), other = output() / ".new-thing";
  for (const fs::path& folder : {dead, living, other}) {
    fs::create_directories(folder);
    writeText(folder / "manifest.json", "half");
  }
  const CommandOutcome outcome = emit();
  EXPECT_EQ(outcome.status, 0) << outcome.all();
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(living) && fs::exists(other)) << "of a process that may still be writing, and of somebody else";
}

// A run's own package and the one made of its choice, whatever was chosen.
// The marble's choice lies beside it for builds and benchmarks; it must hold as long as the marble and the analysis do.
TEST_F(Emit, FindsTheCommittedMarblesPayload) {
  const std::string marble = std::string(REPRISE_SOURCE_DIR) + "/shaders/marble/marble20";
  const CommandOutcome outcome = runCommand({REPRISE_EXECUTABLE, "emit", marble + ".toml", "--choice", marble + ".choice.json", "-o", output()});
  EXPECT_EQ(outcome.status, 0) << outcome.all();
  EXPECT_NE(textOf(output() / "manifest.json").find("\"vein\""), std::string::npos);
}

TEST_F(Emit, EqualsWhatOptimizeWrote) {
  const fs::path run = folder_ / "run";
  const CommandOutcome optimized = runCommand({REPRISE_EXECUTABLE, "optimize", shaders() / "granite.toml", "--max-error", "0.03", "--budget", "60s",
                                               "-o", run, "--quiet"});
  ASSERT_EQ(optimized.status, 0) << optimized.all();
  const CommandOutcome emitted = runCommand({REPRISE_EXECUTABLE, "emit", shaders() / "granite.toml", "--choice", run / "choice.json", "-o", output()});
  ASSERT_EQ(emitted.status, 0) << emitted.all();
  const auto made = filesOf(run / "package"), again = filesOf(output());
  ASSERT_EQ(made.size(), again.size());
  for (const auto& [name, bytes] : made) EXPECT_TRUE(again.contains(name) && again.at(name) == bytes) << name << " differs";
}

}  // namespace
}  // namespace reprise
