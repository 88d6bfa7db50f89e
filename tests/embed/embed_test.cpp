// examples/embed, built from an installed tree, against `reprise play`: the same packages, the same scene,
// the same pixels.
#include <gtest/gtest.h>
#include <stb/stb_image.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/candidates/enumerate.h"
#include "compiler/emit/emit.h"
#include "compiler/source/compile.h"
#include "compiler/strategies/build_package.h"
#include "compiler/strategies/shader_program.h"
#include "tests/e2e/run_command.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

constexpr int kFrames = 12;
const fs::path kExample = fs::path(REPRISE_SOURCE_DIR) / "examples/embed";

struct Frames {
  std::vector<std::vector<unsigned char>> rgb;  // by frame
};

// Frames that a program wrote, by name; each must be there and be of one size.
Frames readFrames(const fs::path& folder) {
  Frames frames;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".png") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    int width = 0, height = 0, channels = 0;
    unsigned char* pixels = stbi_load(file.c_str(), &width, &height, &channels, 3);
    if (!pixels) {
      ADD_FAILURE() << "cannot read " << file;
      continue;
    }
    EXPECT_EQ(width, 320);
    EXPECT_EQ(height, 180);
    frames.rgb.emplace_back(pixels, pixels + static_cast<std::size_t>(width) * height * 3);
    stbi_image_free(pixels);
  }
  EXPECT_EQ(frames.rgb.size(), static_cast<std::size_t>(kFrames)) << folder;
  return frames;
}

int differingPixels(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b) {
  EXPECT_EQ(a.size(), b.size());
  int count = 0;
  for (std::size_t i = 0; i + 2 < std::min(a.size(), b.size()); i += 3) {
    count += a[i] != b[i] || a[i + 1] != b[i + 1] || a[i + 2] != b[i + 2];
  }
  return count;
}

// The example's shaders with their veins of stone cached, by one strategy.
std::optional<Package> makePackage(const std::string& strategy) {
  const Result<CompiledShader> vertex = compile(kExample / "embed.vert", {});
  const Result<CompiledShader> fragment = compile(kExample / "embed.frag", {});
  if (!vertex.ok() || !fragment.ok()) return std::nullopt;
  const Result<ShaderProgram> program = readProgram(*vertex, *fragment);
  if (!program.ok()) {
    ADD_FAILURE() << formatError(program.error());
    return std::nullopt;
  }
  const std::vector<Candidate> candidates =
      enumerateCandidates(*program->fragment, program->analysis, program->sources, {});
  const auto stone = std::find_if(candidates.begin(), candidates.end(), [](const Candidate& candidate) {
    return candidate.name == "stone" && candidate.kept();
  });
  if (stone == candidates.end()) return std::nullopt;
  VariantOptions options;
  options.strategy = strategy;
  options.period_frames = 8;
  Result<Package> package = buildPackage(*program, *stone, options, {});
  if (!package.ok()) {
    ADD_FAILURE() << formatError(package.error());
    return std::nullopt;
  }
  return std::move(package).value();
}

class Embed : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const std::optional<Package> package = makePackage(GetParam());
    ASSERT_TRUE(package.has_value());
    const Result<void> written = writePackage(*package, run() / "package");
    ASSERT_TRUE(written.ok()) << formatError(written.error());
  }

  fs::path run() const { return folder_ / "run"; }

  Frames playedByExample(const std::string& name, std::vector<std::string> more) const {
    CommandSpec spec;
    spec.words = {REPRISE_EXAMPLE,         run() / "package", "--frames",
                  std::to_string(kFrames), "--png",           folder_ / name};
    spec.words.insert(spec.words.end(), more.begin(), more.end());
    // Law 5 holds inside an application, too: the layer reports on standard output.
    spec.environment = {{"VK_INSTANCE_LAYERS", "VK_LAYER_KHRONOS_validation"},
                        {"VK_LAYER_ENABLES", "VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT"}};
    const CommandOutcome outcome = runCommand(spec);
    EXPECT_EQ(outcome.status, 0) << outcome.all();
    EXPECT_EQ(outcome.all().find("Validation"), std::string::npos) << outcome.all();
    EXPECT_EQ(outcome.output.find("the original is played"), std::string::npos) << outcome.output;
    return readFrames(folder_ / name);
  }

  Frames playedByReprise(const std::string& name, std::vector<std::string> more) const {
    CommandSpec spec;
    spec.words = {REPRISE_EXECUTABLE,      "play",      run(),         "--scenario",
                  kExample / "embed.toml", "--session", "orbit",       "--frames",
                  std::to_string(kFrames), "--png",     folder_ / name};
    spec.words.insert(spec.words.end(), more.begin(), more.end());
    const CommandOutcome outcome = runCommand(spec);
    EXPECT_EQ(outcome.status, 0) << outcome.all();
    return readFrames(folder_ / name);
  }

 private:
  TemporaryFolder folder_;
};

TEST_P(Embed, CachedFramesEqualThoseOfPlay) {
  const Frames example = playedByExample("example", {});
  const Frames play = playedByReprise("play", {});
  ASSERT_EQ(example.rgb.size(), play.rgb.size());
  for (std::size_t i = 0; i < example.rgb.size(); ++i) {
    EXPECT_EQ(differingPixels(example.rgb[i], play.rgb[i]), 0) << "frame " << i;
  }
}

TEST_P(Embed, OriginalFramesEqualThoseOfPlay) {
  const Frames example = playedByExample("example", {"--original"});
  const Frames play = playedByReprise("play", {"--original"});
  ASSERT_EQ(example.rgb.size(), play.rgb.size());
  for (std::size_t i = 0; i < example.rgb.size(); ++i) {
    EXPECT_EQ(differingPixels(example.rgb[i], play.rgb[i]), 0) << "frame " << i;
  }
}

// The comparison above would be empty if the switch did nothing, or if nothing moved.
TEST_P(Embed, SwitchChangesFramesAfterTheFirst) {
  const Frames cached = playedByExample("cached", {});
  const Frames original = playedByExample("original", {"--original"});
  ASSERT_EQ(cached.rgb.size(), static_cast<std::size_t>(kFrames));
  EXPECT_EQ(differingPixels(cached.rgb[0], original.rgb[0]), 0);
  EXPECT_GT(differingPixels(cached.rgb[kFrames - 1], original.rgb[kFrames - 1]), 0);
  EXPECT_GT(differingPixels(original.rgb[0], original.rgb[kFrames - 1]), 320 * 180 / 10);
}

INSTANTIATE_TEST_SUITE_P(Strategies, Embed, testing::Values("branch", "two_pass"),
                         [](const auto& each) { return each.param; });

}  // namespace
}  // namespace reprise
