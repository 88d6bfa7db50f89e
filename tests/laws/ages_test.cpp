// The ages that the counting copy writes: every strategy, pattern, filter and encoding, on every scenario of shaders/laws. A new entry of
// the registry is tested here without further work.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "compiler/strategies/refuse_variant.h"
#include "tests/laws/law_scene.h"

namespace reprise {
namespace {

constexpr Encoding kEncodings[] = {Encoding::kRgba8, Encoding::kRgba16, Encoding::kRgba16f, Encoding::kRgba32f};
constexpr std::uint32_t kPeriod = 4;
constexpr std::uint32_t kFrames = 7;  // more than a period, so that each block has been due again
constexpr int kMostOfAByte = 255;

class Ages : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { scene_ = LawScene::open(GetParam()); }

  std::vector<Filter> filters() const {
    if (isInteger(scene_->candidate().scalar)) return {Filter::kNearest};
    return {Filter::kBilinear, Filter::kNearest};
  }

  VariantOptions options(const Strategy& strategy, PatternKind pattern, Filter filter, Encoding encoding) const {
    VariantOptions options = lawOptions(*scene_, strategy.name, pattern, filter, encoding);
    options.aged = true;
    return options;
  }

  VariantOptions pairOptions(const Strategy& strategy) const {
    VariantOptions pairs = options(strategy, PatternKind::kWhole, filters().front(), Encoding::kRgba16f);
    pairs.previous = PreviousImage::kOtherEye;
    pairs.period_frames = 2;
    return pairs;
  }

  // Nothing where the strategy is not for this shader or device, or its counting copy needs more targets than there are.
  std::unique_ptr<Player> playerOf(const Strategy& strategy, const VariantOptions& options) const {
    const StateLimits& limits = scene_->subject().limits;
    if (!strategy.selectable || (flagsDraws(strategy) && !scene_->context().has_conditional_rendering())) return nullptr;
    if (refuseVariant(scene_->subject().program, scene_->candidate(), options, limits)) return nullptr;
    const auto built = buildRecipe(scene_->subject().program, scene_->candidate(), options, limits);
    EXPECT_TRUE(built.ok() || (repairs(strategy) && built.error().code == "state.targets")) << formatError(built.error());
    return built.ok() ? scene_->player(options) : nullptr;
  }

  // Where a pass runs the one body or the other, quads of a shader that takes derivatives hit or miss as a whole.
  bool decidesByQuad(const Strategy& strategy) const {
    return scene_->subject().program.analysis.takes_derivatives &&
           std::any_of(strategy.passes.begin(), strategy.passes.end(), [](const PassPlan& pass) { return pass.bodies.hit && pass.bodies.miss; });
  }

  // Frames since the pixel's block was due; at most those since the first.
  int framesSinceDue(const VariantOptions& options, std::size_t pixel, std::uint32_t frame) const {
    const std::uint32_t width = scene_->subject().scenario.width, height = scene_->subject().scenario.height;
    const std::uint32_t x = static_cast<std::uint32_t>(pixel) % width, y = static_cast<std::uint32_t>(pixel) / width;
    const std::uint32_t group = refreshGroup(options.pattern, x, y, kPeriod, options.block_pixels, width, height);
    return static_cast<int>(std::min((frame + kPeriod - group) % kPeriod, frame));
  }

  void expectFramesSinceDue(Player& player, const Strategy& strategy, const VariantOptions& options) {
    std::vector<int> since_miss;
    std::size_t covered = 0, older = 0;
    for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
      const PlayedFrame played = scene_->play(player, 0, kPeriod, true);
      since_miss.resize(played.kind.size());
      ASSERT_EQ(played.age.size(), played.kind.size());
      for (std::size_t pixel = 0; pixel < played.kind.size(); ++pixel) {
        if (played.kind[pixel] == 0) continue;
        ++covered;
        older += played.age[pixel] > 1;
        since_miss[pixel] = played.kind[pixel] == 2 ? 0 : since_miss[pixel] + 1;
        ASSERT_EQ(played.age[pixel], since_miss[pixel]) << "frame " << frame << " pixel " << pixel;
        // Quads at depth edges miss out of turn (law 3).
        const int since_due = framesSinceDue(options, pixel, frame);
        if (decidesByQuad(strategy)) {
          ASSERT_LE(played.age[pixel], since_due) << "frame " << frame << " pixel " << pixel;
        } else {
          ASSERT_EQ(played.age[pixel], since_due) << "frame " << frame << " pixel " << pixel;
        }
      }
    }
    EXPECT_GT(covered, 0u);
    EXPECT_GT(older, 0u);
  }

  // What one frame's ages can be after another's. `frames`: since the history became invalid.
  void expectNextAges(const PlayedFrame& last, const PlayedFrame& next, int frames) {
    std::array<bool, kMostOfAByte + 1> seen = {};
    for (std::size_t pixel = 0; pixel < last.kind.size(); ++pixel)
      if (last.kind[pixel] != 0) seen[last.age[pixel]] = true;
    for (std::size_t pixel = 0; pixel < next.kind.size(); ++pixel) {
      if (next.kind[pixel] == 0) continue;
      ASSERT_EQ(next.age[pixel] == 0, next.kind[pixel] == 2) << "pixel " << pixel;
      ASSERT_LE(next.age[pixel], frames) << "pixel " << pixel;
      ASSERT_TRUE(next.age[pixel] == 0 || seen[next.age[pixel] - 1u]) << "pixel " << pixel << ": no pixel was of age " << next.age[pixel] - 1;
    }
  }

  // A cut in the middle.
  void expectAgesOfAMovingWorld(Player& player) {
    PlayedFrame last;
    int since_cut = 0;
    std::size_t hits = 0;
    for (int frame = 0; frame < 8; ++frame) {
      if (frame == 4) {
        player.invalidate();
        since_cut = 0;
      }
      PlayedFrame played = scene_->play(player, frame, kPeriod);
      SCOPED_TRACE("frame " + std::to_string(frame));
      expectNextAges(last, played, since_cut++);
      if (HasFatalFailure()) return;
      hits += static_cast<std::size_t>(std::count(played.kind.begin(), played.kind.end(), 1));
      last = std::move(played);
    }
    EXPECT_GT(hits, 0u);
  }

  std::unique_ptr<LawScene> scene_;
};

TEST_P(Ages, AreFramesSinceTheBlockWasDueInAFrozenWorld) {
  std::size_t turn = 0;
  for (const Strategy& strategy : strategies())
    for (const PatternKind pattern : kPatternKinds)
      for (const Filter filter : filters()) {
        // Encodings change places and bindings, not ages; each meets each strategy.
        const Encoding encoding = kEncodings[turn++ % std::size(kEncodings)];
        SCOPED_TRACE(strategy.name + " " + nameOf(pattern) + " " + nameOf(filter) + " " + nameOf(encoding));
        const VariantOptions aged = options(strategy, pattern, filter, encoding);
        const auto player = playerOf(strategy, aged);
        if (player == nullptr) continue;
        expectFramesSinceDue(*player, strategy, aged);
        if (HasFatalFailure()) return;
      }
}

TEST_P(Ages, AreZeroAtMissesAndGrowByOneAtHitsUnderMotion) {
  std::size_t turn = 0;
  for (const Strategy& strategy : strategies())
    for (const Filter filter : filters()) {
      const Encoding encoding = kEncodings[turn++ % std::size(kEncodings)];
      SCOPED_TRACE(strategy.name + " " + nameOf(filter) + " " + nameOf(encoding));
      const auto player = playerOf(strategy, options(strategy, PatternKind::kInterleaved, filter, encoding));
      if (player == nullptr) continue;
      expectAgesOfAMovingWorld(*player);
      if (HasFatalFailure()) return;
    }
}

TEST_P(Ages, AreOneWhereTheOtherEyeIsTakenFrom) {
  for (const Strategy& strategy : strategies()) {
    SCOPED_TRACE(strategy.name);
    const auto player = playerOf(strategy, pairOptions(strategy));
    if (player == nullptr) continue;
    for (int frame = 0; frame < 4; ++frame) {
      const PlayedFrame played = scene_->play(*player, frame, 2);
      for (std::size_t pixel = 0; pixel < played.kind.size(); ++pixel) {
        if (played.kind[pixel] != 0) {
          ASSERT_EQ(played.age[pixel], played.kind[pixel] == 1 ? 1 : 0) << "frame " << frame << " pixel " << pixel;
        }
      }
    }
  }
}

std::string scenarioTestName(const testing::TestParamInfo<std::string>& parameter) {
  const std::size_t slash = parameter.param.find_last_of('/');
  return parameter.param.substr(slash + 1, parameter.param.size() - slash - 6);
}

INSTANTIATE_TEST_SUITE_P(Shaders, Ages, testing::ValuesIn(lawScenarios()), scenarioTestName);

class AgesOfAStraightLine : public testing::Test {
 protected:
  static std::string file() { return std::string(REPRISE_SOURCE_DIR) + "/shaders/laws/straight_line/straight_line.toml"; }

  static VariantOptions aged(const LawScene& scene, const std::string& strategy, PatternKind pattern) {
    VariantOptions options = lawOptions(scene, strategy, pattern, Filter::kBilinear, Encoding::kRgba8);
    options.aged = true;
    return options;
  }
};

TEST_F(AgesOfAStraightLine, EndAtWhatAByteHolds) {
  const auto scene = LawScene::open(file());
  const auto player = scene->player(aged(*scene, "branch", PatternKind::kInterleaved));
  for (int frame = 0; frame < kMostOfAByte + 4; ++frame) {
    const PlayedFrame played = scene->play(*player, 0, kNeverRefresh, true);
    for (std::size_t pixel = 0; pixel < played.kind.size(); ++pixel) {
      if (played.kind[pixel] != 0) {
        ASSERT_EQ(played.age[pixel], std::min(frame, kMostOfAByte)) << "pixel " << pixel;
      }
    }
  }
}

TEST_F(AgesOfAStraightLine, ChangeNothingElseAndLeaveValidationSilent) {
  const auto scene = LawScene::open(file(), true);
  for (const Strategy& strategy : strategies()) {
    if (!strategy.selectable || (strategy.needs_stencil && !scene->subject().limits.stencil) ||
        (flagsDraws(strategy) && !scene->context().has_conditional_rendering()))
      continue;
    for (const PreviousImage previous : {PreviousImage::kLastFrame, PreviousImage::kOtherEye}) {
      SCOPED_TRACE(strategy.name + " " + nameOf(previous));
      const bool pairs = previous == PreviousImage::kOtherEye;
      VariantOptions with = aged(*scene, strategy.name, pairs ? PatternKind::kWhole : PatternKind::kTiled);
      with.previous = previous;
      with.period_frames = 2;
      VariantOptions without = with;
      without.aged = false;
      const auto aged = scene->player(with), counting = scene->player(without);
      for (int frame = 0; frame < 4; ++frame) {
        const PlayedFrame a = scene->play(*aged, frame, 2), b = scene->play(*counting, frame, 2);
        ASSERT_EQ(a.raw, b.raw);
        ASSERT_EQ(a.kind, b.kind);
        EXPECT_EQ(a.shaded_hits, b.shaded_hits);
        EXPECT_EQ(a.shaded_misses, b.shaded_misses);
        EXPECT_FALSE(a.age.empty());
        EXPECT_TRUE(b.age.empty());
      }
    }
  }
  std::string said;
  for (const std::string& message : scene->context().validation_messages()) said += message + "\n";
  EXPECT_EQ(said, "");
}

}  // namespace
}  // namespace reprise
