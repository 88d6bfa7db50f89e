// Shaders whose derivatives depend on storage buffers, on a device whose rejected lanes do not read them: branch holds, all else is refused.
#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/vulkan/context.h"
#include "runtime/vulkan/lane_probe.h"
#include "tests/check/check_in_place.h"

namespace reprise {
namespace {

using Texts = std::vector<std::string>;

ModuleVerdict checkTrap(const std::string& name, std::uint32_t seed) {
  CheckRequest request;
  request.path = std::string(REPRISE_SOURCE_DIR) + "/tests/check/traps/" + name;
  request.seed = seed;
  return checkInPlace(request, REPRISE_EXECUTABLE);
}

Texts expectedRefusals() {
  if (probeLanes(Context::create({}).value()).value().rejected) return {"repair: repair.derivatives"};
  return {"repair: repair.derivatives", "three_pass: device.rejected_lanes", "two_pass: device.rejected_lanes", "two_pass_objects: device.rejected_lanes",
          "two_pass_stencil: device.rejected_lanes"};
}

Texts sorted(Texts texts) {
  std::sort(texts.begin(), texts.end());
  return texts;
}

TEST(RejectedLanes, LeaveBranchToAnOrdinaryMaterial) {
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    const ModuleVerdict verdict = checkTrap("material_in_storage_buffer.frag", seed);
    EXPECT_EQ(verdict.verdict, Verdict::kVerified) << "seed " << seed << ": " << verdict.code << ' ' << verdict.reason;
    EXPECT_EQ(sorted(verdict.refused_strategies), expectedRefusals()) << "seed " << seed;
  }
}

TEST(RejectedLanes, LeaveEveryStrategyToTheSameInAUniformBlock) {
  const ModuleVerdict verdict = checkTrap("material_in_uniform_block.frag", 1);
  EXPECT_EQ(verdict.verdict, Verdict::kVerified) << verdict.code << ' ' << verdict.reason;
  EXPECT_EQ(verdict.refused_strategies, (Texts{"repair: repair.derivatives"}));
}

}  // namespace
}  // namespace reprise
