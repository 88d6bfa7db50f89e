// The laws that every strategy, pattern, filter and encoding is held to, on every scenario of shaders/laws. A new entry of the
// registry is tested here without further work.
#include <gtest/gtest.h>

#include <cmath>
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <map>

#include "compiler/strategies/refuse_variant.h"
#include "tests/laws/law_scene.h"

namespace reprise {
namespace {

constexpr Encoding kEncodings[] = {Encoding::kRgba8, Encoding::kRgba16, Encoding::kRgba16f, Encoding::kRgba32f};
constexpr std::uint32_t kPeriod = 4;
constexpr int kFrames = 6;

// Of pairs of eyes every second frame is stored.
std::uint32_t periodOf(const VariantOptions& options) { return options.previous == PreviousImage::kOtherEye ? 2 : kPeriod; }

// What an encoding may cost in the final colour: half a step of the format over the range of the payload (2.6 with margins for
// rgba8; values below 2 for rgba16f), times the shaders' gain from payload to colour, plus the step of an 8-bit target.
double toleranceOf(Encoding encoding) {
  switch (encoding) {
    case Encoding::kRgba8: return 2.6 / 255 * 4 + 1.0 / 255;
    case Encoding::kRgba16: return 1.0 / 65535 * 4 * 4 + 1.0 / 255;
    case Encoding::kRgba16f: return 2.0 / 1024 * 4 + 1.0 / 255;
    case Encoding::kRgba32f: return 0;
  }
  return 0;
}

double largestDifference(const PlayedFrame& a, const PlayedFrame& b, std::size_t pixel) {
  double largest = 0;
  for (std::size_t output = 0; output < a.colors.size(); ++output)
    for (std::size_t channel = 0; channel < 4; ++channel)
      largest = std::max(largest, static_cast<double>(std::abs(a.colors[output][pixel * 4 + channel] - b.colors[output][pixel * 4 + channel])));
  return largest;
}

bool sameBits(const PlayedFrame& a, const PlayedFrame& b, std::size_t pixel) {
  for (std::size_t output = 0; output < a.raw.size(); ++output) {
    const std::size_t bytes = a.raw[output].size() / (a.colors[output].size() / 4);
    if (std::memcmp(&a.raw[output][pixel * bytes], &b.raw[output][pixel * bytes], bytes) != 0) return false;
  }
  return true;
}

// Says so where the device cannot play a strategy.
bool isPlayable(const LawScene& scene, const Strategy& strategy) {
  const bool playable = !flagsDraws(strategy) || scene.context().has_conditional_rendering();
  if (!playable) std::cout << "Left out, as the device has no VK_EXT_conditional_rendering: " << strategy.name << '\n';
  return playable;
}

class Laws : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { scene_ = LawScene::open(GetParam()); }

  bool allowed(const Strategy& strategy) const {
    if (!isPlayable(*scene_, strategy)) return false;
    VariantOptions options;
    options.strategy = strategy.name;
    options.filter = Filter::kNearest;
    return strategy.selectable && !refuseVariant(scene_->subject().program, scene_->candidate(), options, scene_->subject().limits);
  }

  // The counting copy may need more targets than there are.
  bool hasTargetsFor(const VariantOptions& options) const {
    const auto built = buildRecipe(scene_->subject().program, scene_->candidate(), options, scene_->subject().limits);
    const bool has = built.ok() || built.error().code != "state.targets";
    EXPECT_TRUE(has || options.strategy == "repair") << options.strategy << " is held to no law";
    return has;
  }

  // Where a pass runs the one body or the other, quads of a shader that takes derivatives hit or miss as a whole.
  bool decidesByQuad(const std::string& strategy) const {
    const std::vector<PassPlan>& passes = findStrategy(strategy)->passes;
    return scene_->subject().program.analysis.takes_derivatives &&
           std::any_of(passes.begin(), passes.end(), [](const PassPlan& pass) { return pass.bodies.hit && pass.bodies.miss; });
  }

  // They differ at depth edges, in few places.
  void expectHitsByQuadAmongHitsByPixel(const std::vector<PlayedFrame>& by_quad, const std::vector<PlayedFrame>& by_pixel) {
    for (std::size_t frame = 0; frame < by_quad.size(); ++frame) {
      std::size_t differ = 0, covered = 0, only_by_quad = 0;
      for (std::size_t pixel = 0; pixel < pixels(); ++pixel) {
        const auto quad = by_quad[frame].kind[pixel], alone = by_pixel[frame].kind[pixel];
        covered += quad != 0;
        differ += quad != alone;
        only_by_quad += quad == 1 && alone != 1;
      }
      ASSERT_EQ(only_by_quad, 0u) << "frame " << frame;
      ASSERT_LE(differ, covered / 10) << "frame " << frame;
    }
  }

  bool integerPayload() const { return isInteger(scene_->candidate().scalar); }

  // Integers cannot be interpolated: a bilinear fetch of them is refused (filter.integer).
  std::vector<Filter> filters() const {
    if (integerPayload()) return {Filter::kNearest};
    return {Filter::kBilinear, Filter::kNearest};
  }

  // Integers are kept bit by bit in every encoding. A regrouped sum of values around 1 is off by some units in the last place of
  // the floats, and the colours by a step of their 16 bits.
  double tolerance(Encoding encoding) const {
    return (integerPayload() ? 0 : toleranceOf(encoding)) + (isRegrouped(scene_->candidate()) ? 2e-3 : 0);
  }

  std::size_t pixels() const { return static_cast<std::size_t>(scene_->subject().scenario.width) * scene_->subject().scenario.height; }

  std::vector<PlayedFrame> originals(bool frozen) {
    VariantOptions options = baseOptions(scene_->subject(), scene_->ranges());
    options.strategy = "original";
    const auto player = scene_->player(options);
    std::vector<PlayedFrame> frames;
    for (int frame = 0; frame < kFrames; ++frame) frames.push_back(scene_->play(*player, frame, 1, frozen));
    return frames;
  }

  // Law 1 where the tail reads the payload back: within the encoding's tolerance, exact at rgba32f.
  void expectEqual(const PlayedFrame& expected, const PlayedFrame& played, std::size_t pixel, double tolerance) {
    if (tolerance == 0) {
      ASSERT_TRUE(sameBits(expected, played, pixel)) << "pixel " << pixel << " differs by " << largestDifference(expected, played, pixel);
    } else {
      ASSERT_LE(largestDifference(expected, played, pixel), tolerance) << "pixel " << pixel;
    }
  }

  void checkAlwaysRefresh(const VariantOptions& options, bool raw_tail, const std::vector<PlayedFrame>& originals) {
    const auto player = scene_->player(options);
    for (int frame = 0; frame < 3; ++frame) {
      const PlayedFrame played = scene_->play(*player, frame, 1);
      for (std::size_t pixel = 0; pixel < pixels(); ++pixel) {
        expectEqual(originals[static_cast<std::size_t>(frame)], played, pixel, raw_tail ? tolerance(options.encoding) : 0);
        if (HasFatalFailure()) return;
        ASSERT_NE(played.kind[pixel], 1) << "a hit at period 1, pixel " << pixel;
      }
    }
  }

  std::vector<PlayedFrame> checkMovingWorld(const VariantOptions& options, bool raw_tail, const std::vector<PlayedFrame>& originals) {
    const auto player = scene_->player(options);
    std::vector<PlayedFrame> frames;
    std::size_t hits = 0;
    for (int frame = 0; frame < kFrames; ++frame) {
      frames.push_back(scene_->play(*player, frame, periodOf(options)));
      const PlayedFrame& played = frames.back();
      const PlayedFrame& original = originals[static_cast<std::size_t>(frame)];
      const float clear_depth = scene_->subject().scenario.state.compare == DepthCompare::kGreater ? 0.0f : 1.0f;
      std::size_t misses = 0, covered = 0;
      for (std::size_t pixel = 0; pixel < pixels(); ++pixel) {
        covered += played.kind[pixel] != 0;
        hits += played.kind[pixel] == 1;
        misses += played.kind[pixel] == 2;
        // Books balance: exactly the pixels that the original covers.
        if (!original.depth.empty()) {
          EXPECT_EQ(played.kind[pixel] != 0, original.depth[pixel] != clear_depth) << "frame " << frame << " pixel " << pixel;
          EXPECT_EQ(played.depth[pixel], original.depth[pixel]) << "depth, frame " << frame << " pixel " << pixel;
        }
        // Misses are exact.
        if (played.kind[pixel] == 2) expectEqual(original, played, pixel, raw_tail ? tolerance(options.encoding) : 0);
        if (HasFatalFailure() || HasNonfatalFailure()) return frames;
      }
      if (frame == 0) {
        EXPECT_EQ(misses, covered) << "frame 0 is all misses";
      }
      EXPECT_GE(played.shaded_hits + played.shaded_misses, static_cast<double>(covered));
    }
    EXPECT_GT(hits, 0u) << "nothing ever hit, so the laws hold for nothing";
    return frames;
  }

  void checkFrozenWorld(const VariantOptions& options, const std::vector<PlayedFrame>& frozen) {
    const auto player = scene_->player(options);
    const Scenario& scenario = scene_->subject().scenario;
    const std::uint32_t period = periodOf(options);
    // Where hits are decided per quad, a fragment that is hidden behind a depth edge makes its quad miss with it: exact, but
    // no hit. Such misses must stay few.
    const bool by_quad = decidesByQuad(options.strategy);
    std::size_t expected_hits = 0, hits = 0;
    for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
      const PlayedFrame played = scene_->play(*player, 0, period, true);
      for (std::uint32_t y = 0; y < scenario.height; ++y)
        for (std::uint32_t x = 0; x < scenario.width; ++x) {
          const std::size_t pixel = static_cast<std::size_t>(y) * scenario.width + x;
          if (played.kind[pixel] == 0) continue;
          const bool due = refreshGroup(options.pattern, x, y, period, options.block_pixels, scenario.width, scenario.height) == frame % period;
          const int expected = frame == 0 || due ? 2 : 1;
          expected_hits += expected == 1;
          hits += played.kind[pixel] == 1;
          if (!by_quad || expected == 2) {
            ASSERT_EQ(played.kind[pixel], expected) << "frame " << frame << " pixel " << x << "," << y;
          }
          expectEqual(frozen[frame], played, pixel, tolerance(options.encoding));
          if (HasFatalFailure()) return;
        }
    }
    EXPECT_GE(static_cast<double>(hits), 0.9 * static_cast<double>(expected_hits));
  }

  std::unique_ptr<LawScene> scene_;
};

TEST_P(Laws, HoldForEveryStrategyPatternFilterAndEncoding) {
  const std::vector<PlayedFrame> moving = originals(false), frozen = originals(true);
  for (const PatternKind pattern : kPatternKinds)
    for (const Filter filter : filters())
      for (const Encoding encoding : kEncodings) {
        std::vector<PlayedFrame> by_pixel, by_quad;  // of the first strategy that decides hits so
        for (const Strategy& strategy : strategies()) {
          if (!allowed(strategy)) continue;
          SCOPED_TRACE(strategy.name + " " + nameOf(pattern) + " " + nameOf(filter) + " " + nameOf(encoding) + " " + scene_->candidate().id);
          const VariantOptions options = lawOptions(*scene_, strategy.name, pattern, filter, encoding);
          if (!hasTargetsFor(options)) continue;
          checkAlwaysRefresh(options, strategy.keeps_raw_payload, moving);
          if (HasFatalFailure()) return;
          const std::vector<PlayedFrame> frames = checkMovingWorld(options, strategy.keeps_raw_payload, moving);
          if (HasFatalFailure() || HasNonfatalFailure()) return;
          checkFrozenWorld(options, frozen);
          if (HasFatalFailure()) return;
          // Strategies agree: the same image and the same hits.
          std::vector<PlayedFrame>& first = decidesByQuad(strategy.name) ? by_quad : by_pixel;
          if (first.empty()) {
            first = frames;
            continue;
          }
          for (std::size_t frame = 0; frame < frames.size(); ++frame) {
            ASSERT_EQ(frames[frame].kind, first[frame].kind) << "hits differ in frame " << frame;
            for (std::size_t pixel = 0; pixel < pixels(); ++pixel)
              expectEqual(first[frame], frames[frame], pixel, strategy.keeps_raw_payload ? tolerance(encoding) : 0);
            if (HasFatalFailure()) return;
          }
        }
        if (!by_quad.empty() && !by_pixel.empty()) expectHitsByQuadAmongHitsByPixel(by_quad, by_pixel);
        if (HasFatalFailure()) return;
      }
}

TEST_P(Laws, HoldForPairsOfEyes) {
  const std::vector<PlayedFrame> moving = originals(false), frozen = originals(true);
  for (const Strategy& strategy : strategies()) {
    if (!allowed(strategy)) continue;
    SCOPED_TRACE(strategy.name + " " + scene_->candidate().id);
    VariantOptions options = lawOptions(*scene_, strategy.name, PatternKind::kWhole, filters().front(), Encoding::kRgba32f);
    options.previous = PreviousImage::kOtherEye;
    options.period_frames = 2;
    if (!hasTargetsFor(options)) continue;
    checkAlwaysRefresh(options, strategy.keeps_raw_payload, moving);
    if (HasFatalFailure()) return;
    checkMovingWorld(options, strategy.keeps_raw_payload, moving);
    if (HasFatalFailure() || HasNonfatalFailure()) return;
    checkFrozenWorld(options, frozen);
    if (HasFatalFailure()) return;
  }
}

// Only a frame that follows a stored one has a history.
TEST(PairsOfEyes, PlayedAtAnotherPeriodHitAfterStoredFramesAlone) {
  const auto scene = LawScene::open(std::string(REPRISE_SOURCE_DIR) + "/shaders/laws/straight_line/straight_line.toml");
  for (const char* strategy : {"branch", "two_pass"}) {
    VariantOptions options = lawOptions(*scene, strategy, PatternKind::kWhole, Filter::kNearest, Encoding::kRgba32f);
    options.previous = PreviousImage::kOtherEye;
    options.period_frames = 2;
    const auto player = scene->player(options);
    for (int frame = 0; frame < 8; ++frame) {
      const PlayedFrame played = scene->play(*player, 0, 4, true);
      const auto hits = std::count(played.kind.begin(), played.kind.end(), 1), misses = std::count(played.kind.begin(), played.kind.end(), 2);
      EXPECT_EQ(hits > 0, frame % 4 == 1) << strategy << " frame " << frame;
      EXPECT_GT(hits + misses, 0) << strategy << " frame " << frame;
    }
  }
}

TEST_P(Laws, InvalidateMakesTheNextFrameAllMisses) {
  const auto player = scene_->player(lawOptions(*scene_, "branch", PatternKind::kInterleaved, filters().front(), Encoding::kRgba16f));
  for (int frame = 0; frame < 3; ++frame) scene_->play(*player, frame, kPeriod);
  player->invalidate();
  const PlayedFrame cut = scene_->play(*player, 3, kPeriod);
  EXPECT_EQ(std::count(cut.kind.begin(), cut.kind.end(), 1), 0);
  const PlayedFrame after = scene_->play(*player, 4, kPeriod);
  EXPECT_GT(std::count(after.kind.begin(), after.kind.end(), 1), 0);
}

TEST_P(Laws, ErrorsHitsAndMissesRepeatFromRunToRun) {
  const VariantOptions options = lawOptions(*scene_, "branch", PatternKind::kRandom, filters().front(), Encoding::kRgba8);
  const auto one = scene_->player(options), two = scene_->player(options);
  for (int frame = 0; frame < kFrames; ++frame) {
    const PlayedFrame a = scene_->play(*one, frame, kPeriod), b = scene_->play(*two, frame, kPeriod);
    ASSERT_EQ(a.raw, b.raw);
    ASSERT_EQ(a.kind, b.kind);
    ASSERT_EQ(a.shaded_hits, b.shaded_hits);
  }
}

std::string scenarioTestName(const testing::TestParamInfo<std::string>& parameter) {
  const std::size_t slash = parameter.param.find_last_of('/');
  return parameter.param.substr(slash + 1, parameter.param.size() - slash - 6);
}

INSTANTIATE_TEST_SUITE_P(Shaders, Laws, testing::ValuesIn(lawScenarios()), scenarioTestName);

TEST(Scenarios, HoldEveryKindOfPayload) {
  const auto candidateOf = [](const std::string& name) {
    return LawScene::open(std::string(REPRISE_SOURCE_DIR) + "/shaders/laws/" + name + "/" + name + ".toml")->candidate();
  };
  EXPECT_GT(candidateOf("several_values").values.size(), 1u);
  EXPECT_GT(candidateOf("several_values").channels, 4);
  EXPECT_NE(candidateOf("guarded").values.front().guard_channel, kNoGuard);
  EXPECT_TRUE(isRegrouped(candidateOf("regrouped")));
  EXPECT_EQ(candidateOf("loop_result").values.front().operation, "Phi");
}

TEST(Scenarios, AreRepairedButForThoseThatDiscardTakeDerivativesOrLabelObjects) {
  VariantOptions repair;
  repair.strategy = "repair";
  repair.filter = Filter::kNearest;
  std::map<std::string, std::string> refused;
  for (const std::string& file : lawScenarios()) {
    const auto scene = LawScene::open(file);
    const auto refusal = refuseVariant(scene->subject().program, scene->candidate(), repair, scene->subject().limits);
    if (refusal) refused[std::filesystem::path(file).stem()] = refusal->code;
  }
  EXPECT_EQ(refused, (std::map<std::string, std::string>{{"discard", "repair.discards"},
                                                          {"edges", "repair.derivatives"},
                                                          {"labels", "state.shared_inputs"},
                                                          {"textures", "repair.derivatives"}}));
}

TEST(Scenarios, OneHasAnIntegerPayloadThatThePlayedVariantsKeep) {
  const auto scene = LawScene::open(std::string(REPRISE_SOURCE_DIR) + "/shaders/laws/integer/integer.toml", true);
  EXPECT_EQ(scene->candidate().name, "key");
  EXPECT_EQ(scene->candidate().type, "ivec2");
  for (const char* strategy : {"branch", "three_pass"}) {
    const auto player = scene->player(lawOptions(*scene, strategy, PatternKind::kTiled, Filter::kNearest, Encoding::kRgba8));
    for (int frame = 0; frame < 3; ++frame) scene->play(*player, frame, 2);
    EXPECT_EQ(player->resource("cache")->format, VK_FORMAT_R32G32_UINT);
  }
  for (const std::string& message : scene->context().validation_messages()) ADD_FAILURE() << message;
}

TEST(Validation, IsSilentForEveryStrategy) {
  const auto scene = LawScene::open(std::string(REPRISE_SOURCE_DIR) + "/shaders/laws/straight_line/straight_line.toml", true);
  for (const Strategy& strategy : strategies()) {
    if (!strategy.selectable || (strategy.needs_stencil && !scene->subject().limits.stencil) || !isPlayable(*scene, strategy)) continue;
    const auto player = scene->player(lawOptions(*scene, strategy.name, PatternKind::kTiled, Filter::kBilinear, Encoding::kRgba8));
    for (int frame = 0; frame < 3; ++frame) scene->play(*player, frame, 2);
    VariantOptions pairs = lawOptions(*scene, strategy.name, PatternKind::kWhole, Filter::kBilinear, Encoding::kRgba8);
    pairs.previous = PreviousImage::kOtherEye;
    pairs.period_frames = 2;
    const auto eyes = scene->player(pairs);
    for (int frame = 0; frame < 4; ++frame) scene->play(*eyes, frame, 2);
  }
  std::string said;
  for (const std::string& message : scene->context().validation_messages()) said += message + "\n";
  ASSERT_EQ(said, "");
}

TEST(Validation, NoticesAMissingBarrier) {
  for (const char* strategy : {"three_pass", "repair"}) {
    const auto scene = LawScene::open(std::string(REPRISE_SOURCE_DIR) + "/shaders/laws/straight_line/straight_line.toml", true);
    PlayerOptions careless;
    careless.omit_barrier_for_test = true;
    const auto player = scene->player(lawOptions(*scene, strategy, PatternKind::kTiled, Filter::kBilinear, Encoding::kRgba16f), careless);
    scene->play(*player, 0, 2);
    EXPECT_FALSE(scene->context().validation_messages().empty()) << strategy << ": synchronization validation would not notice a missing barrier";
  }
}

}  // namespace
}  // namespace reprise
