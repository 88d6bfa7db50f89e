#include "profiler/scene/disc_texture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace reprise {
namespace {

Scenario twoObjects() {
  Scenario scenario;
  Object ball, ground;
  ball.name = "ball";
  ball.mesh = {MeshKind::kSphere, 64, 32};
  ball.motion.translate = FixedTrack{{3, 0, 0}};
  ball.motion.scale = FixedTrack{{2, 2, 2}};
  ground.name = "ground";
  ground.mesh = {MeshKind::kPlane, 8, 8};
  scenario.objects = {ball, ground};
  return scenario;
}

TextureSpec discsOf(std::vector<std::string> objects) {
  TextureSpec spec;
  spec.name = "discs";
  spec.kind = TextureKind::kDiscs;
  spec.objects = std::move(objects);
  return spec;
}

struct Pair {
  float x, y, z, area, normal_x, normal_y, normal_z, radius;
};

Pair pairOf(const TextureImage& image, int row, int pair) {
  Pair result;
  std::copy_n(image.rgba.begin() + (row * image.width + 2 * pair) * 4, 8, &result.x);
  return result;
}

TEST(DiscTexture, TheFirstPairIsTheWholeObjectWhereItStands) {
  const TextureImage image = buildDiscTexture(twoObjects(), discsOf({"ground", "ball"})).value();
  EXPECT_EQ(image.width, 34);
  EXPECT_EQ(image.height, 2);
  EXPECT_TRUE(image.high_dynamic_range);
  const Pair ground = pairOf(image, 0, 0), ball = pairOf(image, 1, 0);
  EXPECT_NEAR(ground.area, 4, 1e-5);  // an edge of 2
  EXPECT_NEAR(ground.radius, std::sqrt(2.0), 1e-5);
  EXPECT_NEAR(ball.x, 3, 1e-4);
  EXPECT_NEAR(ball.area, 16 * M_PI, 0.01 * 16 * M_PI);  // radius 2; the mesh lies within the sphere
  EXPECT_NEAR(ball.radius, 2, 1e-3);
}

TEST(DiscTexture, PatchesAddUpToTheirObjectAndFaceOutwards) {
  const TextureImage image = buildDiscTexture(twoObjects(), discsOf({"ball"})).value();
  double area = 0;
  for (int i = 1; i <= 16; ++i) {
    const Pair patch = pairOf(image, 0, i);
    area += patch.area;
    EXPECT_NEAR(std::hypot(patch.normal_x, patch.normal_y, patch.normal_z), 1, 1e-5);
    EXPECT_GT((patch.x - 3) * patch.normal_x + patch.y * patch.normal_y + patch.z * patch.normal_z, 0.5f) << i;
  }
  EXPECT_NEAR(area, pairOf(image, 0, 0).area, 1e-3);
}

TEST(DiscTexture, InObjectSpaceNeitherPlaceNorScaleCounts) {
  TextureSpec spec = discsOf({"ball"});
  spec.object_space = true;
  const TextureImage image = buildDiscTexture(twoObjects(), spec).value();
  const Pair ball = pairOf(image, 0, 0);
  EXPECT_NEAR(ball.x, 0, 1e-4);
  EXPECT_NEAR(ball.radius, 1, 1e-4);
}

TEST(DiscTexture, RefusesAnObjectThatIsNotThere) {
  EXPECT_EQ(buildDiscTexture(twoObjects(), discsOf({"bell"})).error().code, "texture.objects");
}

}  // namespace
}  // namespace reprise
