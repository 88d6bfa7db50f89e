// Last frame's push constants and uniform blocks, by draw id.
#include "tests/runtime/playback_stage.h"

namespace reprise {
namespace {

class PreviousInputs : public PlaybackStage {
 protected:
  void SetUp() override {
    PlaybackStage::SetUp();
    uses_block_ = true;
  }
  void playWith(Player& player, const std::vector<Quad>& quads, float block) {
    block_[0] = block;
    play(player, quads);
  }
  static Quad left(std::uint64_t id, float first) { return {id, {-1, -1, 0, 1}, 0.5f, first}; }
  static Quad right(std::uint64_t id, float first) { return {id, {0, -1, 1, 1}, 0.5f, first}; }
};

TEST_F(PreviousInputs, AreThoseOfTheLastFrame) {
  Player player = makePlayer(previousPackage());
  playWith(player, {left(1, 10)}, 100);
  EXPECT_EQ(colorAt(2, 2), (Pixel{0, 10, 10, 100}));  // nothing before: its own values, not valid
  playWith(player, {left(1, 11)}, 101);
  EXPECT_EQ(colorAt(2, 2), (Pixel{1, 10, 11, 100}));
  playWith(player, {left(1, 12)}, 102);
  EXPECT_EQ(colorAt(2, 2), (Pixel{1, 11, 12, 101}));
}

TEST_F(PreviousInputs, FollowTheDrawIdAndNotTheOrder) {
  Player player = makePlayer(previousPackage());
  playWith(player, {left(7, 10), right(3, 20)}, 0);
  playWith(player, {right(3, 21), left(7, 11)}, 0);
  EXPECT_EQ(colorAt(2, 2), (Pixel{1, 10, 11, 0}));
  EXPECT_EQ(colorAt(13, 2), (Pixel{1, 20, 21, 0}));
}

TEST_F(PreviousInputs, AnIdThatWasAbsentLastFrameIsNotValid) {
  Player player = makePlayer(previousPackage());
  playWith(player, {left(1, 10), right(2, 20)}, 0);
  playWith(player, {left(1, 11)}, 0);
  playWith(player, {left(1, 12), right(2, 22)}, 0);
  EXPECT_EQ(colorAt(2, 2), (Pixel{1, 11, 12, 0}));
  EXPECT_EQ(colorAt(13, 2), (Pixel{0, 22, 22, 0}));
}

TEST_F(PreviousInputs, ManyDrawsGrowTheMemory) {
  Player player = makePlayer(previousPackage());
  std::vector<Quad> quads;
  for (std::uint64_t id = 0; id < 100; ++id) {
    quads.push_back(left(id, static_cast<float>(id)));
    quads.back().depth = 1 - static_cast<float>(id + 1) / 128;  // each nearer than those before
    playWith(player, quads, 0);
    ASSERT_EQ(colorAt(2, 2), (Pixel{0, static_cast<float>(id), static_cast<float>(id), 0}));
  }
  playWith(player, quads, 0);
  EXPECT_EQ(colorAt(2, 2), (Pixel{1, 99, 99, 0}));
}

class BadInputs : public PreviousInputs {
 protected:
  std::string codeOf(const std::function<void(FrameInputs&)>& spoil) {
    const std::vector<Quad> quads = {left(1, 10), right(2, 20)};
    FrameInputs frame = inputs(quads);
    spoil(frame);
    Player player = makePlayer(previousPackage());
    Result<void> recorded;
    run([&](VkCommandBuffer commands) -> Result<void> {
      recorded = player.record(commands, frame, [&](PassContext& pass) { draw(pass, quads); });
      return {};
    });
    return recorded.ok() ? "" : recorded.error().code;
  }
};

TEST_F(BadInputs, AreRefusedByCode) {
  EXPECT_EQ(codeOf([](FrameInputs&) {}), "");
  EXPECT_EQ(codeOf([](FrameInputs& frame) { frame.draws[1].blocks.clear(); }), "player.input_missing");
  EXPECT_EQ(codeOf([](FrameInputs& frame) { frame.draws[1].blocks[0].binding = 5; }), "player.input_missing");
  EXPECT_EQ(codeOf([](FrameInputs& frame) { frame.draws[0].blocks[0].bytes = {}; }), "player.input_missing");
  EXPECT_EQ(codeOf([](FrameInputs& frame) { frame.draws[0].push_constants = frame.draws[0].push_constants.first(16); }),
            "player.input_missing");
  EXPECT_EQ(codeOf([](FrameInputs& frame) { frame.draws[1].id = frame.draws[0].id; }), "player.draw_id");
  EXPECT_EQ(codeOf([](FrameInputs& frame) { frame.colors.clear(); }), "player.target_missing");
  EXPECT_EQ(codeOf([](FrameInputs& frame) { frame.depth.view = VK_NULL_HANDLE; }), "player.target_missing");
  EXPECT_EQ(codeOf([](FrameInputs& frame) { frame.extent.height = 0; }), "player.extent");
}

}  // namespace
}  // namespace reprise
