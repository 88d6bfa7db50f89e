// Passes and renderings: depth prepass, images read in the frame that wrote them, adding, stencil, queries.
#include "tests/runtime/playback_stage.h"

namespace reprise {
namespace {

class Passes : public PlaybackStage {
 protected:
  // Far first, so that both are shaded where nothing rejects them; the near one covers the left half.
  const std::vector<Quad> far_then_near_ = {{1, {-1, -1, 1, 1}, 0.75f, 3}, {2, {-1, -1, 0, 1}, 0.25f, 4}};

  Handle<VkQueryPool> makeQueries(VkQueryType type, std::uint32_t count) const {
    const DeviceView& device = context().view();
    VkQueryPoolCreateInfo create{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
    create.queryType = type;
    create.queryCount = count;
    VkQueryPool pool = VK_NULL_HANDLE;
    REPRISE_CHECK(device.fn.vkCreateQueryPool(device.device, &create, nullptr, &pool) == VK_SUCCESS, "vkCreateQueryPool");
    return {device.device, pool, device.fn.vkDestroyQueryPool};
  }
  std::vector<std::uint64_t> resultsOf(const Handle<VkQueryPool>& pool, std::uint32_t first, std::uint32_t count) const {
    const DeviceView& device = context().view();
    std::vector<std::uint64_t> results(count);
    const VkResult read = device.fn.vkGetQueryPoolResults(device.device, pool.get(), first, count, count * 8, results.data(), 8,
                                                          VK_QUERY_RESULT_64_BIT);
    EXPECT_EQ(read, VK_SUCCESS);
    return results;
  }
};

TEST_F(Passes, ForHitsAloneAreLeftOutOfFramesThatAreWhollyDue) {
  Package package = prepassPackage();
  package.variant.pattern = PatternKind::kWhole;
  package.variant.passes[0].frames = PassFrames::kNotWhollyDue;
  Player player = makePlayer(package);
  for (int number = 0; number < 4; ++number) {
    FrameInputs frame = inputs(far_then_near_);
    frame.period_frames = 2;
    std::vector<int> drawn;
    run([&](VkCommandBuffer commands) {
      return player.record(commands, frame, [&](PassContext& pass) { drawn.push_back(pass.pass()); });
    });
    EXPECT_EQ(drawn, number % 2 == 0 ? std::vector<int>{1} : (std::vector<int>{0, 1})) << number;
  }
}

TEST_F(Passes, PrepassShadesEachPixelOnce) {
  const Handle<VkQueryPool> queries = makeQueries(VK_QUERY_TYPE_OCCLUSION, 3);
  FrameInputs frame = inputs(far_then_near_);
  frame.occlusion = queries.get();
  frame.first_occlusion = 1;
  Player prepass = makePlayer(prepassPackage());
  EXPECT_TRUE(prepass.playsOriginal());
  play(prepass, far_then_near_, frame);
  EXPECT_EQ(resultsOf(queries, 1, 2), (std::vector<std::uint64_t>{kSize * kSize * 3 / 2, kSize * kSize}));
  EXPECT_EQ(colorAt(2, 2)[0], 4);
  EXPECT_EQ(colorAt(13, 2)[0], 3);
}

TEST_F(Passes, LaterRenderingsReadWhatEarlierOnesWrote) {
  Player player = makePlayer(twoRenderingsPackage());
  for (int frame = 0; frame < 3; ++frame) {
    play(player, far_then_near_);
    EXPECT_EQ(colorAt(2, 2)[0], 40);
    EXPECT_EQ(colorAt(13, 2)[0], 30);
  }
}

TEST_F(Passes, AddingCountsOverdraw) {
  Player player = makePlayer(countingPackage());
  for (int frame = 0; frame < 2; ++frame) {
    play(player, far_then_near_);
    EXPECT_EQ(resourceAt(player, "counts", 2), (Pixel{2, 4, 0, 0}));
    EXPECT_EQ(resourceAt(player, "counts", 13), (Pixel{1, 2, 0, 0}));
    EXPECT_EQ(colorAt(2, 2)[0], 0.5f);
  }
}

TEST_F(Passes, StencilMarksOncePerFrame) {
  useTargets(kSize, VK_FORMAT_D32_SFLOAT_S8_UINT);
  Player player = makePlayer(stencilPackage());
  EXPECT_EQ(player.originalReason(), "");
  for (int frame = 0; frame < 2; ++frame) {
    std::vector<Quad> quads = far_then_near_;
    quads[0].first = static_cast<float>(5 + frame);
    play(player, quads);
    EXPECT_EQ(colorAt(2, 2)[0], static_cast<float>(5 + frame));  // the far one came first
  }
}

TEST_F(Passes, StencilStartsAtZeroWhereTheApplicationKeepsItsDepth) {
  useTargets(kSize, VK_FORMAT_D32_SFLOAT_S8_UINT);
  Player player = makePlayer(stencilPackage());
  play(player, far_then_near_);
  const std::vector<Quad> nearest = {{1, {-1, -1, 1, 1}, 0.125f, 9}};
  FrameInputs frame = inputs(nearest);
  frame.depth.load = true;
  play(player, nearest, frame);
  EXPECT_EQ(colorAt(13, 2)[0], 9);
}

TEST_F(Passes, LoadedTargetsKeepTheApplicationsContent) {
  Player player = makePlayer(originalPackage());
  play(player, far_then_near_);
  const std::vector<Quad> between = {{1, {-1, -1, 1, 1}, 0.5f, 8}};
  FrameInputs frame = inputs(between);
  frame.colors[0].load = frame.depth.load = true;
  play(player, between, frame);
  EXPECT_EQ(colorAt(2, 2)[0], 4);   // nearer: kept
  EXPECT_EQ(colorAt(13, 2)[0], 8);  // farther: covered
}

TEST_F(Passes, OfFlaggedObjectsLeaveOutTheOthersFrameByFrame) {
  if (!context().has_conditional_rendering()) GTEST_SKIP() << "the device has no VK_EXT_conditional_rendering";
  Player player = makePlayer(flaggedPackage());
  ASSERT_EQ(player.originalReason(), "");
  const auto quads = [](float left, float right) {
    return std::vector<Quad>{{7, {-1, -1, 0, 1}, 0.5f, left}, {3, {0, -1, 1, 1}, 0.5f, right}};
  };
  const std::pair<float, float> frames[] = {{5, 3}, {3, 6}, {3, 3}, {8, 9}};
  for (const auto& [left, right] : frames) {
    play(player, quads(left, right));
    EXPECT_EQ(colorAt(2, 2)[0], left > 4 ? left : 0.5f);
    EXPECT_EQ(colorAt(13, 2)[0], right > 4 ? right : 0.5f);
  }
}

TEST_F(Passes, OfFlaggedObjectsTakeMoreObjectsFromFrameToFrame) {
  if (!context().has_conditional_rendering()) GTEST_SKIP() << "the device has no VK_EXT_conditional_rendering";
  Player player = makePlayer(flaggedPackage());
  play(player, {});
  for (std::uint64_t count = 1; count < 40; count += 13) {
    std::vector<Quad> quads;
    for (std::uint64_t id = 0; id < count; ++id) quads.push_back({id, {-1, -1, 1, 1}, 1 - static_cast<float>(id + 1) / 64, 4 + static_cast<float>(id)});
    play(player, quads);
    EXPECT_EQ(colorAt(2, 2)[0], count == 1 ? 0.5f : static_cast<float>(3 + count));
  }
}

TEST_F(Passes, TimestampsAreWrittenAroundEveryPass) {
  if (!context().has_timestamps()) GTEST_SKIP() << "the device has no timestamps";
  const Handle<VkQueryPool> queries = makeQueries(VK_QUERY_TYPE_TIMESTAMP, 5);
  FrameInputs frame = inputs(far_then_near_);
  frame.timestamps = queries.get();
  frame.first_query = 2;
  Player player = makePlayer(twoRenderingsPackage());
  play(player, far_then_near_, frame);
  const std::vector<std::uint64_t> stamps = resultsOf(queries, 2, 3);
  EXPECT_LE(stamps[0], stamps[1]);
  EXPECT_LE(stamps[1], stamps[2]);
}

}  // namespace
}  // namespace reprise
