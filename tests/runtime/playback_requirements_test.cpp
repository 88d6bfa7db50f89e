// Where requirements are missing, the original is played and the reason told; what nothing can be played on is refused.
#include "tests/runtime/playback_stage.h"

namespace reprise {
namespace {

class Requirement : public PlaybackStage {
 protected:
  // Plays the package's original with a reason in which `expected` occurs.
  void expectOriginal(const Package& package, const std::string& expected) {
    const Player player = makePlayer(package);
    EXPECT_TRUE(player.playsOriginal());
    EXPECT_EQ(player.recipe().strategy, "original");
    EXPECT_NE(player.originalReason().find(expected), std::string::npos) << player.originalReason();
  }
  std::string codeOf(const Package& package, const ApplicationPipeline& application) const {
    const Result<Player> player = Player::create(handles(), package, application);
    return player.ok() ? "" : player.error().code;
  }
};

TEST_F(Requirement, MetOnesPlayTheVariant) {
  const Player player = makePlayer(accumulatingPackage());
  EXPECT_FALSE(player.playsOriginal());
  EXPECT_EQ(player.originalReason(), "");
}

TEST_F(Requirement, TheOriginalIsDrawnWhereOneIsMissing) {
  Player player = makePlayer(stencilPackage());  // the target has no stencil
  EXPECT_TRUE(player.playsOriginal());
  play(player, {{1, {-1, -1, 1, 1}, 0.75f, 3}, {2, {-1, -1, 0, 1}, 0.25f, 4}});
  EXPECT_EQ(colorAt(2, 2)[0], 4);
}

TEST_F(Requirement, StencilOfTheTarget) { expectOriginal(stencilPackage(), "stencil"); }

TEST_F(Requirement, StencilThatTheApplicationLeavesAlone) {
  useTargets(kSize, VK_FORMAT_D32_SFLOAT_S8_UINT);
  state_.depth.stencilTestEnable = VK_TRUE;
  expectOriginal(stencilPackage(), "uses the stencil");
}

TEST_F(Requirement, StrictDepthComparison) {
  Package package = accumulatingPackage();
  package.variant.requirements.depth_less_or_greater = true;
  state_.depth.depthCompareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
  expectOriginal(package, "LESS or GREATER");
  state_.depth.depthCompareOp = VK_COMPARE_OP_GREATER;
  EXPECT_FALSE(makePlayer(package).playsOriginal());
}

TEST_F(Requirement, DepthWrites) {
  state_.depth.depthWriteEnable = VK_FALSE;
  expectOriginal(accumulatingPackage(), "write depth");
}

TEST_F(Requirement, NoBlending) {
  state_.blend_attachment.blendEnable = VK_TRUE;
  expectOriginal(accumulatingPackage(), "blends");
}

TEST_F(Requirement, NoMultisampling) {
  state_.samples.rasterizationSamples = VK_SAMPLE_COUNT_4_BIT;
  expectOriginal(accumulatingPackage(), "multisampled");
}

TEST_F(Requirement, FreeDescriptorSet) {
  uses_block_ = true;  // set 0, where the package has its own
  expectOriginal(accumulatingPackage(), "descriptor set 0");
}

TEST_F(Requirement, TheApplicationsWordThatDrawsShareTheirInputs) {
  Package package = accumulatingPackage();
  package.variant.requirements.shared_inputs = true;
  expectOriginal(package, "share what the fragment shader reads");
}

TEST_F(Requirement, TheApplicationsWordThatRejectedLanesLoad) {
  Package package = accumulatingPackage();
  package.variant.requirements.rejected_lanes_load = true;
  expectOriginal(package, "ApplicationPipeline::rejected_lanes_load");
  ApplicationPipeline promising = pipeline();
  promising.rejected_lanes_load = true;
  const Result<Player> player = Player::create(handles(), package, promising, {});
  ASSERT_TRUE(player.ok()) << formatError(player.error());
  EXPECT_FALSE(player->playsOriginal()) << player->originalReason();
}

TEST_F(Requirement, TheApplicationsWordThatConditionalRenderingIsEnabled) {
  ApplicationPipeline silent = pipeline();
  silent.conditional_rendering = false;
  const Result<Player> player = Player::create(handles(), flaggedPackage(), silent, {});
  ASSERT_TRUE(player.ok()) << formatError(player.error());
  EXPECT_TRUE(player->playsOriginal());
  EXPECT_NE(player->originalReason().find("VK_EXT_conditional_rendering"), std::string::npos) << player->originalReason();
}

TEST_F(Requirement, AttachmentsOfTheDevice) {
  Package package = accumulatingPackage();
  package.variant.requirements.color_attachments = 1000;
  expectOriginal(package, "colour attachments");
}

TEST_F(Requirement, OriginalOnDemand) {
  PlayerOptions options;
  options.force_original = true;
  const Player player = makePlayer(accumulatingPackage(), options);
  EXPECT_TRUE(player.playsOriginal());
  EXPECT_EQ(player.originalReason(), "");
}

TEST_F(Requirement, PipelinesWithoutStateAreRefused) {
  ApplicationPipeline application = pipeline();
  EXPECT_EQ(codeOf(originalPackage(), application), "");
  application.color_formats.clear();
  EXPECT_EQ(codeOf(originalPackage(), application), "player.pipeline");
  application = pipeline();
  application.create_info = nullptr;
  EXPECT_EQ(codeOf(originalPackage(), application), "player.pipeline");
  state_.create_info.pMultisampleState = nullptr;
  EXPECT_EQ(codeOf(originalPackage(), pipeline()), "player.pipeline");
}

TEST_F(Requirement, PackagesThatContradictThemselvesAreRefused) {
  Package package = accumulatingPackage();
  package.variant.passes[0].reads[0].resource = "nonesuch";
  EXPECT_EQ(codeOf(package, pipeline()), "package.inconsistent");
}

TEST_F(Requirement, HandlesThatAreMissingAreRefused) {
  DeviceHandles none = handles();
  none.get_device_proc_addr = nullptr;
  const Result<Player> player = Player::create(none, originalPackage(), pipeline());
  ASSERT_FALSE(player.ok());
  EXPECT_EQ(player.error().code, "device.function");
}

}  // namespace
}  // namespace reprise
