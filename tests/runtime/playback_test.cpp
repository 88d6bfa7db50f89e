// Frames: the original, histories from frame to frame, frames in flight, resizing and invalidation.
#include "tests/runtime/playback_stage.h"

namespace reprise {
namespace {

class Playback : public PlaybackStage {
 protected:
  const std::vector<Quad> full_{Quad{}};
};

TEST_F(Playback, OriginalDrawsInsideItsRectangleAndClearsOutside) {
  Player player = makePlayer(originalPackage());
  EXPECT_TRUE(player.playsOriginal());
  EXPECT_EQ(player.originalReason(), "");
  const std::vector<Quad> quads = {{1, {-1, -1, 0, 1}, 0.5f, 0.25f, 0.75f}};
  FrameInputs frame = inputs(quads);
  frame.colors[0].clear = {.float32 = {9, 8, 7, 6}};
  play(player, quads, frame);
  EXPECT_EQ(colorAt(7, 3), (Pixel{0.25f, 0.75f, 0.5f, 1}));
  EXPECT_EQ(colorAt(8, 3), (Pixel{9, 8, 7, 6}));
}

TEST_F(Playback, NegativeViewportHeightTurnsThePictureUpsideDown) {
  Player player = makePlayer(originalPackage());
  const std::vector<Quad> quads = {{1, {-1, -1, 1, 0}, 0.5f, 1, 0}};
  FrameInputs frame = inputs(quads);
  frame.viewport.y = kSize;
  frame.viewport.height = -static_cast<float>(kSize);
  play(player, quads, frame);
  EXPECT_EQ(colorAt(0, 2)[0], 0);
  EXPECT_EQ(colorAt(0, 13)[0], 1);
}

TEST_F(Playback, HistoryHoldsTheLastFrame) {
  Player player = makePlayer(accumulatingPackage());
  EXPECT_FALSE(player.playsOriginal());
  for (int frame = 1; frame <= 5; ++frame) {
    play(player, full_);
    EXPECT_EQ(colorAt(4, 4)[0], static_cast<float>(frame));
    EXPECT_EQ(resourceAt(player, "cache", 4)[0], static_cast<float>(frame));
  }
}

TEST_F(Playback, FramesInFlightDoNotShareUniformsAndTwoPackagesPlayInOneFrame) {
  PlayerOptions options;
  options.frames_in_flight = 3;
  Player counting = makePlayer(accumulatingPackage(), options), telling = makePlayer(uniformsPackage(), options);
  const std::vector<Quad> left = {{1, {-1, -1, 0, 1}}}, right = {{1, {0, -1, 1, 1}}};
  run([&](VkCommandBuffer commands) -> Result<void> {
    for (int frame = 0; frame < 3; ++frame) {
      separate(commands);
      REPRISE_TRY(counting.record(commands, inputs(left), [&](PassContext& pass) { draw(pass, left); }));
      separate(commands);
      FrameInputs second = inputs(right);
      second.colors[0].load = second.depth.load = true;
      REPRISE_TRY(telling.record(commands, second, [&](PassContext& pass) { draw(pass, right); }));
    }
    return {};
  });
  EXPECT_EQ(colorAt(1, 1)[0], 3);
  EXPECT_EQ(colorAt(14, 1)[0], 2);
}

TEST_F(Playback, UniformsCountFramesAndTellThePeriod) {
  Player player = makePlayer(uniformsPackage());
  FrameInputs frame = inputs(full_);
  frame.period_frames = 8;
  play(player, full_, frame);
  EXPECT_EQ(colorAt(2, 2), (Pixel{0, 8, 0, kSize}));
  frame.period_frames = kNeverRefresh;
  frame.viewport.width = 8;
  play(player, full_, frame);
  EXPECT_EQ(colorAt(2, 2), (Pixel{1, 0, 1, kSize}));
  play(player, full_, frame);
  EXPECT_EQ(colorAt(2, 2), (Pixel{2, 0, 1, 8}));
}

TEST_F(Playback, InvalidateMakesTheNextFrameMissAndOnlyThat) {
  Player player = makePlayer(accumulatingPackage());
  play(player, full_);
  play(player, full_);
  player.invalidate();
  play(player, full_);
  EXPECT_EQ(colorAt(4, 4)[0], 1);
  play(player, full_);
  EXPECT_EQ(colorAt(4, 4)[0], 2);
}

TEST_F(Playback, InvalidateByInputCountsWhereThePayloadDependsOnIt) {
  Player player = makePlayer(accumulatingPackage());
  for (const char* input : {"Scene.light", "Scene", "light", "texture albedo", "albedo"}) {
    play(player, full_);
    play(player, full_);
    player.invalidate(input);
    play(player, full_);
    EXPECT_EQ(colorAt(4, 4)[0], 1) << input;
  }
  for (const char* input : {"Scene.time", "Sce", "ight", "roughness", ""}) {
    player.invalidate();
    play(player, full_);
    player.invalidate(input);
    play(player, full_);
    EXPECT_EQ(colorAt(4, 4)[0], 2) << input;
  }
}

TEST_F(Playback, NewExtentMakesNewHistories) {
  Player player = makePlayer(accumulatingPackage());
  play(player, full_);
  play(player, full_);
  useTargets(2 * kSize, VK_FORMAT_D32_SFLOAT);
  play(player, full_);
  EXPECT_EQ(colorAt(31, 31)[0], 1);
  EXPECT_EQ(player.resource("cache")->extent.width, 2 * kSize);
  play(player, full_);
  EXPECT_EQ(colorAt(31, 31)[0], 2);
}

TEST_F(Playback, ResourcesAreThereOnceAFrameIsRecorded) {
  Player player = makePlayer(accumulatingPackage());
  EXPECT_FALSE(player.resource("cache").has_value());
  play(player, full_);
  EXPECT_TRUE(player.resource("cache").has_value());
  EXPECT_FALSE(player.resource("nonesuch").has_value());
}

TEST_F(Playback, MovedPlayerGoesOn) {
  Player first = makePlayer(accumulatingPackage());
  play(first, full_);
  Player second = std::move(first);
  play(second, full_);
  EXPECT_EQ(colorAt(4, 4)[0], 2);
}

}  // namespace
}  // namespace reprise
