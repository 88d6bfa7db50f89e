// Jobs on the first device: what they measure, and that they measure the same again (laws 1, 4, 8 and 9).
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "profiler/metrics/metrics.h"
#include "tests/session/measured_scene.h"

namespace reprise {
namespace {

Result<JobResult> run(const Job& job) { return runJob(job, {}); }

void expectNoError(const ErrorRow& row) {
  ASSERT_FALSE(row.errors.empty()) << "frame " << row.frame;
  for (const auto& [metric, value] : row.errors) EXPECT_EQ(value, 0) << metric << ", frame " << row.frame;
}

class EveryOutput : public testing::TestWithParam<const char*> {};

TEST_P(EveryOutput, OriginalAgainstItselfHasNoError) {
  const MeasuredScene scene(GetParam());
  Job job = scene.job(JobKind::kErrors, {scene.original(), 1});
  job.metrics = {"ssim", "flip", "tile_flip"};
  job.frames = 4;
  job.width = 160;
  job.height = 90;
  const Result<JobResult> result = run(job);
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  ASSERT_EQ(result->errors.size(), 1u);
  ASSERT_EQ(result->errors[0].size(), 4u);
  for (int frame = 0; frame < 4; ++frame) {
    const ErrorRow& row = result->errors[0][static_cast<std::size_t>(frame)];
    EXPECT_EQ(row.frame, frame);
    EXPECT_GT(row.covered, 160u * 90 / 20);
    EXPECT_LE(row.covered, 160u * 90);
    EXPECT_EQ(row.misses, row.covered);
    EXPECT_EQ(row.nonfinite, 0u);
    EXPECT_EQ(row.errors.size(), metrics().size());
    expectNoError(row);
  }
}

INSTANTIATE_TEST_SUITE_P(Shaders, EveryOutput,
                         testing::Values("shaders/marble/marble.toml", "shaders/laws/textures/textures.toml",
                                         "shaders/laws/several_outputs/several_outputs.toml"));

TEST(DepthWithStencil, CoversTheSamePixels) {
  const std::filesystem::path shaders = std::filesystem::path(REPRISE_SOURCE_DIR) / "shaders" / "laws";
  std::string text = textOf(shaders / "straight_line" / "straight_line.toml");
  const auto replace = [&](const std::string& from, const std::string& to) { text.replace(text.find(from), from.size(), to); };
  replace("\"straight_line.frag\"", "\"" + (shaders / "straight_line" / "straight_line.frag").string() + "\"");
  replace("\"../law.vert\"", "\"" + (shaders / "law.vert").string() + "\"");
  replace("[render]", "[render]\ndepth_stencil = true");
  const TemporaryFolder folder;
  writeText(folder / "stencil.toml", text);
  const MeasuredScene plain("shaders/laws/straight_line/straight_line.toml"), stencil((folder / "stencil.toml").string());
  const Result<JobResult> expected = run(plain.job(JobKind::kErrors, {plain.original(), 1}));
  const Result<JobResult> result = run(stencil.job(JobKind::kErrors, {stencil.original(), 1}));
  ASSERT_TRUE(expected.ok()) << formatError(expected.error());
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  EXPECT_EQ(result->errors, expected->errors);
}

class MeasuredVariant : public testing::Test {
 protected:
  Job errors(std::uint32_t period_frames) const {
    Job job = scene_.job(JobKind::kErrors, {variant_, period_frames});
    job.frames = 6;
    return job;
  }

  MeasuredScene scene_{"shaders/laws/straight_line/straight_line.toml"};
  std::string variant_ = scene_.variant("two_pass", countingVariant());
};

TEST_F(MeasuredVariant, BooksBalanceAndTheFirstFrameIsAllMisses) {
  const Result<JobResult> result = run(errors(4));
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  std::uint64_t hits = 0;
  double largest = 0;
  for (const ErrorRow& row : result->errors.at(0)) {
    EXPECT_EQ(row.covered, row.hits + row.misses);
    EXPECT_GE(row.shaded_hits, row.hits);
    EXPECT_GE(row.shaded_misses, row.misses);
    hits += row.hits;
    largest = std::max(largest, row.errors.at("rms"));
  }
  EXPECT_EQ(result->errors[0][0].hits, 0u);
  expectNoError(result->errors[0][0]);
  EXPECT_GT(hits, 0u);
  EXPECT_GT(largest, 0) << "a variant that reuses values under motion differs from the original";
}

TEST_F(MeasuredVariant, AlwaysRefreshHasNoErrorAndNoHit) {
  const Result<JobResult> result = run(errors(1));
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  for (const ErrorRow& row : result->errors.at(0)) {
    EXPECT_EQ(row.hits, 0u);
    expectNoError(row);
  }
}

TEST_F(MeasuredVariant, RowsAreTheSameFromRunToRunAndAShorterRunIsAPrefix) {
  const Result<JobResult> once = run(errors(4)), again = run(errors(4));
  Job shorter = errors(4);
  shorter.frames = 3;
  const Result<JobResult> prefix = run(shorter);
  ASSERT_TRUE(once.ok() && again.ok() && prefix.ok());
  EXPECT_EQ(once->errors, again->errors);
  const std::vector<ErrorRow> expected(once->errors[0].begin(), once->errors[0].begin() + 3);
  EXPECT_EQ(prefix->errors[0], expected);
}

TEST_F(MeasuredVariant, EntriesDoNotDisturbOneAnother) {
  Job together = errors(4);
  together.entries = {{variant_, 2}, {scene_.original(), 1}, {variant_, 4}, {variant_, 2}};
  const Result<JobResult> all = run(together), alone = run(errors(4));
  ASSERT_TRUE(all.ok() && alone.ok());
  EXPECT_EQ(all->errors.at(2), alone->errors.at(0));
  EXPECT_EQ(all->errors.at(0), all->errors.at(3));
  EXPECT_NE(all->errors.at(0), all->errors.at(2));
}

// Entries that do not fit into memory at once are played in batches; 64 MB of histories each, and more than one batch.
TEST_F(MeasuredVariant, BatchesChangeNoRow) {
  Job job = errors(4);
  job.frames = 2;
  job.width = 1280;
  job.height = 720;
  const Result<JobResult> alone = run(job);
  job.entries.assign(12, {variant_, 4});
  int last_total = 0;
  const Result<JobResult> many = runJob(job, [&](const JobProgress& progress) { last_total = progress.total; });
  ASSERT_TRUE(alone.ok() && many.ok());
  EXPECT_GT(last_total, 2) << "all entries went into one batch, so this test says nothing";
  for (const std::vector<ErrorRow>& rows : many->errors) EXPECT_EQ(rows, alone->errors.at(0));
}

TEST_F(MeasuredVariant, TellingAgesChangesNoRowButForTheMetricOfAges) {
  VariantOptions options = countingVariant();
  options.aged = true;
  Job job = errors(4);
  job.entries.push_back({scene_.variant("aged", options), 4});
  Result<JobResult> result = run(job);
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  EXPECT_GT(result->errors.at(1).back().hits, 0u);
  EXPECT_GT(result->errors.at(1).back().errors.at("flicker"), 0);
  EXPECT_GT(result->errors.at(1).back().errors.at("blocks"), 0);
  for (std::vector<ErrorRow>& rows : result->errors)
    for (ErrorRow& row : rows) row.errors.erase("blocks"), row.tiles.erase("blocks");
  EXPECT_EQ(result->errors.at(1), result->errors.at(0));
}

TEST_F(MeasuredVariant, TellingAgesChangesNoPicture) {
  VariantOptions options = countingVariant();
  options.aged = true;
  const auto pictureOf = [&](const std::string& variant, const std::string& name) {
    Job job = scene_.job(JobKind::kImages, {variant, 4});
    job.image_frame = 5;
    job.image_dir = (scene_.folder() / name).string();
    std::filesystem::create_directories(job.image_dir);
    EXPECT_TRUE(run(job).ok());
    return textOf(std::filesystem::path(job.image_dir) / "hit_miss.png");
  };
  EXPECT_EQ(pictureOf(scene_.variant("aged", options), "aged_pictures"), pictureOf(variant_, "pictures"));
}

TEST_F(MeasuredVariant, TimesHaveARowForEveryEntryAndRound) {
  VariantOptions options = countingVariant();
  options.instrumented = false;
  Job job = scene_.job(JobKind::kTimes, {scene_.original(), 1});
  job.entries.push_back({scene_.variant("timed", options), 4});
  job.rounds = 5;
  job.warmup_frames = 2;
  job.run_id = "this run";
  const Result<JobResult> result = run(job);
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  EXPECT_FALSE(result->device.empty());
  EXPECT_FALSE(result->driver.empty());
  ASSERT_EQ(result->times.size(), 2u);
  for (const std::vector<TimeRow>& rows : result->times) {
    ASSERT_EQ(rows.size(), 5u);
    for (int round = 0; round < 5; ++round) {
      const TimeRow& row = rows[static_cast<std::size_t>(round)];
      EXPECT_EQ(row.run_id, "this run");
      EXPECT_EQ(row.pair, round);
      EXPECT_EQ(row.frame, round + 2);
      EXPECT_GT(row.wall_ms, 0);
      EXPECT_GT(row.cpu_ms, 0);
      EXPECT_LE(row.gpu_ms, row.wall_ms);
    }
  }
}

TEST_F(MeasuredVariant, ProbeFindsTheRangesOfPayloadAndDepth) {
  VariantOptions options = countingVariant();
  options.strategy = "branch";
  options.encoding = Encoding::kRgba32f;
  options.instrumented = false;
  const Job job = scene_.job(JobKind::kProbe, {scene_.variant("probed", options, "base"), 1});
  const Result<JobResult> result = run(job);
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  ASSERT_EQ(result->probes.size(), 1u);
  const ProbeResult& probe = result->probes[0];
  EXPECT_GT(probe.covered, 0u);
  EXPECT_EQ(probe.nonfinite_payload, 0u);
  EXPECT_EQ(probe.nonfinite_color, 0u);
  // base = 0.5 + 0.35 * sin(...), and the camera is 3.4 away from objects with a radius of about one.
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_GE(probe.payload_min[channel], 0.15f - 1e-5f);
    EXPECT_LT(probe.payload_min[channel], 0.3f);
    EXPECT_LE(probe.payload_max[channel], 0.85f + 1e-5f);
    EXPECT_GT(probe.payload_max[channel], 0.7f);
  }
  EXPECT_GT(probe.depth_min, 1.0f);
  EXPECT_LT(probe.depth_min, 3.4f);
  EXPECT_GT(probe.depth_max, 3.4f);
  EXPECT_LT(probe.depth_max, 6.0f);
}

// Before a camera that stands still; the payload follows a light that does or does not change its place.
TEST(MeasuredPayloads, AreProbedForTheirChangeFromFrameToFrame) {
  const auto changeOf = [](const std::string& light) {
    const TemporaryFolder folder;
    writeText(folder / "lit.frag", R"(#version 450
layout(set = 0, binding = 1) uniform Light { float turn; } light;
layout(location = 0) in vec3 object_position;
layout(location = 0) out vec4 color;
void main() {
  float lit = 0.5;
  for (int i = 0; i < 24; ++i) lit += 0.01 * sin(object_position.x * float(i) + light.turn);
  color = vec4(lit, lit * lit, 1.0 - lit, 1.0);
}
)");
    const std::filesystem::path laws = std::filesystem::path(REPRISE_SOURCE_DIR) / "shaders" / "laws";
    writeText(folder / "lit.toml", "[shader]\nfragment = \"lit.frag\"\nvertex = \"" + (laws / "law.vert").string() + R"("
[render]
width = 64
height = 64
frames = 12
[[object]]
name = "ball"
mesh = { kind = "sphere" }
[uniforms]
"Scene.view_projection" = "view_projection"
"Scene.camera_position" = "camera_position"
"Scene.shininess" = 24
"Scene.light_position" = [2.5, 3.0, 4.0]
"Scene.time_s" = "time"
"Object.model" = "model"
"Object.normal_matrix" = "normal_matrix"
"Light.turn" = )" + light + R"(
[[session]]
name = "train"
role = "training"
camera = { eye = [0, 0, 4], target = [0, 0, 0] }
[[session]]
name = "check"
role = "validation"
camera = { eye = [0, 0, 4], target = [0, 0, 0] }
)");
    const MeasuredScene scene((folder / "lit.toml").string());
    VariantOptions options = countingVariant();
    options.strategy = "branch";
    options.encoding = Encoding::kRgba32f;
    options.instrumented = false;
    const Result<JobResult> result = run(scene.job(JobKind::kProbe, {scene.variant("probed", options, "lit"), 1}));
    EXPECT_TRUE(result.ok()) << formatError(result.error());
    return result.ok() ? result->probes.at(0).payload_change : ChannelFloats{};
  };
  EXPECT_EQ(changeOf("0.3"), ChannelFloats{});
  const ChannelFloats change = changeOf("\"time\"");
  EXPECT_GT(change[0], 1e-4f);
  EXPECT_LT(change[0], 0.24f);
  for (std::size_t channel = 1; channel < change.size(); ++channel) EXPECT_EQ(change[channel], 0) << channel;
}

// Two spheres side by side before a camera that stands still: the first does not move, the second does in the other scene.
std::string sideBySide(const std::string& motion) {
  const std::filesystem::path shaders = std::filesystem::path(REPRISE_SOURCE_DIR) / "shaders" / "laws";
  std::string text = textOf(shaders / "straight_line" / "straight_line.toml");
  const auto replace = [&](const std::string& from, const std::string& to) { text.replace(text.find(from), from.size(), to); };
  const auto replaceBetween = [&](const std::string& from, const std::string& until, const std::string& to) {
    const std::size_t start = text.find(from);
    text.replace(start, text.find(until, start) - start, to);
  };
  replace("\"straight_line.frag\"", "\"" + (shaders / "straight_line" / "straight_line.frag").string() + "\"");
  replace("\"../law.vert\"", "\"" + (shaders / "law.vert").string() + "\"");
  replaceBetween("[[object]]", "[uniforms]",
                 "[[object]]\nname = \"left\"\nmesh = { kind = \"sphere\", radius = 0.5 }\nmotion = { translate = [-0.8, 0, 0] }\n"
                 "[[object]]\nname = \"right\"\nmesh = { kind = \"sphere\", radius = 0.5 }\nmotion = { " + motion + " }\n");
  replace("camera = { orbit = { radius = 3.4, height = 0.6, radians_per_frame = 0.02 } }", "camera = { eye = [0, 0, 4], target = [0, 0, 0] }");
  return text;
}

ObjectCounts countedObjects(const std::string& motion, const JobEntry& period, bool stereo = false) {
  const TemporaryFolder folder;
  writeText(folder / "spheres.toml", sideBySide(motion));
  const MeasuredScene scene((folder / "spheres.toml").string());
  VariantOptions options = countingVariant();
  options.strategy = "two_pass_objects";
  options.instrumented = false;
  if (stereo) {
    options.pattern = PatternKind::kWhole;
    options.previous = PreviousImage::kOtherEye;
    options.period_frames = 2;
  }
  const Result<JobResult> result = run(scene.job(JobKind::kObjects, {scene.variant("flagging", options), period.period_frames}));
  EXPECT_TRUE(result.ok()) << formatError(result.error());
  return result.ok() ? result->objects.at(0) : ObjectCounts{};
}

TEST(MeasuredObjects, HaveMissesWhereTheyMoveOrAreRefreshed) {
  const std::string still = "translate = [0.8, 0, 0]", turns = still + ", spin_rad_per_frame = 0.05";
  const JobEntry never{"", kNeverRefresh}, every{"", 1}, second{"", 2};
  // 12 frames, of which the first does not count.
  EXPECT_EQ(countedObjects(still, never), (ObjectCounts{22, 0}));
  EXPECT_EQ(countedObjects(turns, never), (ObjectCounts{22, 11}));
  EXPECT_EQ(countedObjects(still, every), (ObjectCounts{22, 22}));
  // Six pairs of eyes: left ones are stored as a whole, right ones flag.
  EXPECT_EQ(countedObjects(turns, second, true), (ObjectCounts{12, 6}));
}

TEST_F(MeasuredVariant, CountsNoObjectsOfVariantsThatDoNotFlagThem) {
  const Result<JobResult> result = run(scene_.job(JobKind::kObjects, {variant_, 4}));
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  EXPECT_EQ(result->objects.at(0), (ObjectCounts{0, 0}));
}

TEST(MeasuredIntegers, AreProbedWithTheirSignsAndPictured) {
  const MeasuredScene scene("shaders/laws/integer/integer.toml");
  VariantOptions options = countingVariant();
  options.strategy = "branch";
  options.filter = Filter::kNearest;
  options.instrumented = false;
  const std::string variant = scene.variant("probed", options, "key");
  const Result<JobResult> probed = run(scene.job(JobKind::kProbe, {variant, 1}));
  ASSERT_TRUE(probed.ok()) << formatError(probed.error());
  const ProbeResult& probe = probed->probes.at(0);
  EXPECT_EQ(probe.nonfinite_payload, 0u);
  for (int channel = 0; channel < 2; ++channel) {
    EXPECT_LT(probe.payload_min[channel], -1e9f);
    EXPECT_GT(probe.payload_max[channel], 1e9f);
  }
  EXPECT_EQ(probe.payload_max[2], 0);
  Job pictures = scene.job(JobKind::kImages, {variant, 4});
  pictures.image_frame = 1;
  pictures.image_dir = (scene.folder() / "images").string();
  const Result<JobResult> drawn = run(pictures);
  ASSERT_TRUE(drawn.ok()) << formatError(drawn.error());
  EXPECT_TRUE(std::filesystem::exists(scene.folder() / "images" / "payload.png"));
}

TEST_F(MeasuredVariant, ImagesAreWritten) {
  Job job = scene_.job(JobKind::kImages, {variant_, 4});
  job.image_frame = 3;
  job.image_dir = (scene_.folder() / "images").string();
  const Result<JobResult> result = run(job);
  ASSERT_TRUE(result.ok()) << formatError(result.error());
  std::vector<std::string> names;
  for (const std::string& file : result->images) {
    EXPECT_GT(std::filesystem::file_size(file), 100u);
    names.push_back(std::filesystem::path(file).filename().string());
  }
  EXPECT_EQ(names, (std::vector<std::string>{"original.png", "cached.png", "error.png", "hit_miss.png", "payload.png"}));
  EXPECT_NE(textOf(result->images[0]), textOf(result->images[1]));
}

}  // namespace
}  // namespace reprise
