// Law 5: several frames in one command buffer, where the layer sees what lies between them, are silent; a missing barrier is
// not.
#include "tests/runtime/playback_stage.h"

namespace reprise {
namespace {

class Synchronization : public PlaybackStage {
 protected:
  void playFrames(const Package& package, bool omit_barrier) {
    PlayerOptions options;
    options.frames_in_flight = 4;
    options.omit_barrier_for_test = omit_barrier;
    Player player = makePlayer(package, options);
    ASSERT_EQ(player.originalReason(), "");
    const std::vector<Quad> quads = {{1, {-1, -1, 1, 1}, 0.75f, 3}, {2, {-1, -1, 0, 1}, 0.25f, 4}};
    run([&](VkCommandBuffer commands) -> Result<void> {
      for (int frame = 0; frame < 4; ++frame) {
        separate(commands);
        REPRISE_TRY(player.record(commands, inputs(quads), [&](PassContext& pass) { draw(pass, quads); }));
      }
      return {};
    });
  }
};

TEST_F(Synchronization, FramesOfEveryKindAreSilent) {
  useTargets(kSize, VK_FORMAT_D32_SFLOAT_S8_UINT);
  for (const Package& package : {originalPackage(), prepassPackage(), accumulatingPackage(), uniformsPackage(),
                                 twoRenderingsPackage(), countingPackage(), stencilPackage()})
    playFrames(package, false);
  if (context().has_conditional_rendering()) playFrames(flaggedPackage(), false);
  EXPECT_TRUE(messages().empty());
}

TEST_F(Synchronization, AMissingBarrierIsReported) {
  expects_messages_ = true;
  playFrames(twoRenderingsPackage(), true);
  bool hazard = false;
  for (const std::string& message : messages()) hazard = hazard || message.find("SYNC-HAZARD") != std::string::npos;
  EXPECT_TRUE(hazard) << messages().size() << " messages, none of a hazard";
}

}  // namespace
}  // namespace reprise
