// Law 10: hits are honest. Objects that hide one another move under a moving camera; the original tells which
// place of which object every pixel showed a frame ago, and a hit's payload tells what it fetched.
//
// Every step is looked at alone: a frame of misses only, then the measured one. So all that a hit can fetch
// was computed in the frame before, and no fault of an earlier frame is counted again.
//
// The objects come near one another but never pierce: along a line where surfaces meet, their depths are the
// same, and a footprint across it fetches both, however depth is tested.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <limits>

#include "tests/laws/law_scene.h"

namespace reprise {
namespace {

constexpr Filter kFilters[] = {Filter::kNearest, Filter::kBilinear};
constexpr Encoding kEncodings[] = {Encoding::kRgba8, Encoding::kRgba16, Encoding::kRgba16f,
                                   Encoding::kRgba32f};
constexpr int kStarts[] = {0, 7, 14, 25};
constexpr std::uint32_t kPeriod = 4;
// A filtered lookup misses along outlines, and the smaller the image, the more of it is outline: at the
// scenario's own size that alone would be the 5%.
constexpr std::uint32_t kMagnified = 3;
constexpr double kMostStrangers = 0.001, kLeastHits = 0.95;

// shaders/laws/labels/labels.frag.
constexpr float kLabelPerUnit = 0.25f;

// Two places of one object within this many pixel footprints lie on one surface. A footprint grows with the
// slant of the surface, but only so far: where it is seen edge-on, another part of the object may lie as
// near.
constexpr float kFootprints = 2;
constexpr float kLeastCosine = 0.25f;
constexpr float kLabelMargin = 0.05f;

struct Surface {
  int object = -1;  // none
  glm::vec3 place{0}, label{0};
  float reach = 0;  // world units: as far as the same surface goes
};

// What the original drew in a frame.
struct Reference {
  FrameState state;
  std::vector<Surface> surfaces;  // by pixel
};

// Two frames in a row, and which pixels of the second showed what had been visible in the first.
struct Step {
  int frame = 0;
  Reference before, now;
  std::vector<bool> visible;
};

struct Tally {
  std::size_t hits = 0, strangers = 0, visible = 0, visible_hits = 0;
  double strangersShare() const { return static_cast<double>(strangers) / static_cast<double>(hits); }
  double hitsShare() const { return static_cast<double>(visible_hits) / static_cast<double>(visible); }
};

glm::vec4 texelOf(const PlayedFrame& played, std::size_t output, std::size_t pixel) {
  const float* texel = &played.colors[output][pixel * 4];
  return {texel[0], texel[1], texel[2], texel[3]};
}

glm::vec3 worldOf(const FrameState& state, const Surface& surface) {
  return state.models[static_cast<std::size_t>(surface.object)] * glm::vec4(surface.place, 1);
}

glm::vec4 clipOf(const FrameState& state, const glm::vec3& world) {
  return state.projection * state.view * glm::vec4(world, 1);
}

// Edge of a pixel's footprint on a surface at `world` with this normal, in world units.
float footprintOf(const FrameState& state, const glm::vec3& world, const glm::vec3& normal) {
  const glm::vec4 clip = clipOf(state, world);
  const float across = 2 * clip.w / (std::abs(state.projection[1][1]) * static_cast<float>(state.height));
  const glm::vec3 back = {state.view[0][2], state.view[1][2], state.view[2][2]};
  const bool orthographic = state.projection[3][3] == 1;
  const glm::vec3 to_camera = orthographic ? back : glm::normalize(state.camera_position - world);
  return across / std::max(std::abs(glm::dot(normal, to_camera)), kLeastCosine);
}

Reference referenceOf(const FrameState& state, const PlayedFrame& original) {
  Reference reference{state, std::vector<Surface>(static_cast<std::size_t>(state.width) * state.height)};
  for (std::size_t pixel = 0; pixel < reference.surfaces.size(); ++pixel) {
    const glm::vec4 place = texelOf(original, 1, pixel), facing = texelOf(original, 2, pixel);
    if (facing.w == 0) continue;
    Surface& surface = reference.surfaces[pixel];
    surface.object = static_cast<int>(place.w);
    surface.place = place;
    surface.label = texelOf(original, 0, pixel);
    surface.reach = kFootprints * footprintOf(state, worldOf(state, surface), facing);
  }
  return reference;
}

// Where a surface point of now was in the frame before: the texel that it fell into, or the size of the image
// for none.
std::size_t texelBefore(const FrameState& before, const Surface& surface) {
  const glm::vec4 clip = clipOf(before, worldOf(before, surface));
  const glm::vec2 size(before.width, before.height);
  const glm::vec2 at = glm::floor((glm::vec2(clip) / clip.w * 0.5f + 0.5f) * size);
  const bool inside = clip.w > 0 && at.x >= 0 && at.y >= 0 && at.x < size.x && at.y < size.y;
  if (!inside) return static_cast<std::size_t>(before.width) * before.height;
  return static_cast<std::size_t>(at.y) * before.width + static_cast<std::size_t>(at.x);
}

bool wasVisible(const Reference& before, const Surface& surface) {
  const std::size_t texel = texelBefore(before.state, surface);
  if (texel >= before.surfaces.size()) return false;
  const Surface& seen = before.surfaces[texel];
  if (seen.object != surface.object) return false;
  return glm::distance(worldOf(before.state, seen), worldOf(before.state, surface)) <= surface.reach;
}

class HonestHits : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    scene_ = LawScene::open(std::string(REPRISE_SOURCE_DIR) + "/shaders/laws/labels/labels.toml", false,
                            kMagnified);
    if (GetParam()) useOrthographicCamera();
    ASSERT_EQ(scene_->candidate().name, "label");
    VariantOptions original = baseOptions(scene_->subject(), scene_->ranges());
    original.strategy = "original";
    const auto player = scene_->player(original);
    for (const int start : kStarts) steps_.push_back(stepFrom(*player, start));
    measureRanges();
    expectSomethingToDo();
  }

  void useOrthographicCamera() {
    scene_->subject().orthographic = true;
    Camera& camera = scene_->subject().scenario.sessions.front().camera;
    camera.orthographic = true;
    camera.ortho_height = 3.2f;
    camera.far_plane = 10;
  }

  Reference reference(Player& original, int frame) {
    const Scenario& scenario = scene_->subject().scenario;
    return referenceOf(evaluateFrame(scenario, scenario.sessions.front(), frame),
                       scene_->play(original, frame, 1));
  }

  Step stepFrom(Player& original, int start) {
    Step step{start, reference(original, start), reference(original, start + 1), {}};
    for (const Surface& surface : step.now.surfaces)
      step.visible.push_back(surface.object >= 0 && wasVisible(step.before, surface));
    return step;
  }

  // Both kinds of pixels must be there, or the law would hold for nothing.
  void expectSomethingToDo() {
    for (const Step& step : steps_) {
      const auto visible = std::count(step.visible.begin(), step.visible.end(), true);
      const auto covered = std::count_if(step.now.surfaces.begin(), step.now.surfaces.end(),
                                         [](const Surface& surface) { return surface.object >= 0; });
      EXPECT_GT(visible, covered / 2) << "frame " << step.frame;
      EXPECT_GT(covered - visible, covered / 100) << "frame " << step.frame;
    }
  }

  // As training hands them on: a margin each way, and what no frame has shown would be stored invalid.
  void measureRanges() {
    ranges_.payload_min.fill(std::numeric_limits<float>::max());
    ranges_.payload_max.fill(std::numeric_limits<float>::lowest());
    float nearest = std::numeric_limits<float>::max(), farthest = 0;
    for (const Step& step : steps_)
      for (const Reference* reference : {&step.before, &step.now})
        for (const Surface& surface : reference->surfaces) {
          if (surface.object < 0) continue;
          for (int channel = 0; channel < 3; ++channel) {
            const auto at = static_cast<std::size_t>(channel);
            ranges_.payload_min[at] =
                std::min(ranges_.payload_min[at], surface.label[channel] - kLabelMargin);
            ranges_.payload_max[at] =
                std::max(ranges_.payload_max[at], surface.label[channel] + kLabelMargin);
          }
          const glm::vec4 clip = clipOf(reference->state, worldOf(reference->state, surface));
          nearest = std::min(nearest, GetParam() ? clip.z : clip.w);
          farthest = std::max(farthest, GetParam() ? clip.z : clip.w);
        }
    ranges_.depth_near = nearest / 2;
    ranges_.depth_far = GetParam() ? std::min(farthest * 1.5f, 1.0f) : farthest * 1.5f;
  }

  // How far encoding alone may move a label: half a step of the format in each of three channels (the labels
  // span 2.3 with the margins), and what is lost in arithmetic.
  static float encodingError(Encoding encoding) {
    switch (encoding) {
      case Encoding::kRgba8:
        return 2.1f / 255;
      case Encoding::kRgba16:
        return 2.1f / 65535;
      case Encoding::kRgba16f:
        return 1.0f / 1024;
      case Encoding::kRgba32f:
        return 1e-5f;
    }
    return 0;
  }

  // `turn`: of the player's frame, which group of pixels was due.
  void addStep(const Step& step, const PlayedFrame& played, const VariantOptions& options, std::uint32_t turn,
               Tally& tally) const {
    const std::uint32_t width = scene_->subject().scenario.width, height = scene_->subject().scenario.height;
    for (std::size_t pixel = 0; pixel < step.visible.size(); ++pixel) {
      const bool hit = played.kind[pixel] == 1;
      const Surface& surface = step.now.surfaces[pixel];
      if (hit) {
        const float off = glm::distance(glm::vec3(texelOf(played, 0, pixel)), surface.label);
        const bool same = off <= surface.reach * kLabelPerUnit + encodingError(options.encoding);
        ++tally.hits;
        tally.strangers += !same;
      }
      const auto x = static_cast<std::uint32_t>(pixel % width), y = static_cast<std::uint32_t>(pixel / width);
      const bool due =
          refreshGroup(options.pattern, x, y, kPeriod, options.block_pixels, width, height) == turn;
      if (!step.visible[pixel] || due) continue;
      ++tally.visible;
      tally.visible_hits += hit;
    }
  }

  void check(const std::string& strategy, PatternKind pattern, Filter filter, Encoding encoding) {
    VariantOptions options = lawOptions(*scene_, strategy, pattern, filter, encoding);
    options.ranges = ranges_;
    const auto player = scene_->player(options);
    Tally tally;
    std::uint32_t player_frame = 0;
    for (const Step& step : steps_) {
      player->invalidate();
      scene_->play(*player, step.frame, kPeriod);
      const PlayedFrame played = scene_->play(*player, step.frame + 1, kPeriod);
      addStep(step, played, options, (player_frame + 1) % kPeriod, tally);
      player_frame += 2;
    }
    SCOPED_TRACE(strategy + " " + nameOf(pattern) + " " + nameOf(filter) + " " + nameOf(encoding));
    ASSERT_GT(tally.hits, 0u);
    EXPECT_LE(tally.strangersShare(), kMostStrangers) << tally.strangers << " of " << tally.hits << " hits";
    EXPECT_GE(tally.hitsShare(), kLeastHits)
        << tally.visible_hits << " of " << tally.visible << " visible pixels";
  }

  std::unique_ptr<LawScene> scene_;
  std::vector<Step> steps_;
  ValueRanges ranges_;
};

TEST_P(HonestHits, FetchTheSameSurfaceAndMissLittleThatWasVisible) {
  for (const Strategy& strategy : strategies())
    for (const Filter filter : kFilters)
      for (const Encoding encoding : kEncodings) {
        // A repair is refused, as objects have labels of their own; its hits are those of the others (law 11, laws_test.cpp).
        if (!strategy.selectable || repairs(strategy)) continue;
        check(strategy.name, PatternKind::kInterleaved, filter, encoding);
      }
}

TEST_P(HonestHits, AreAsHonestInEveryPattern) {
  for (const PatternKind pattern : kPatternKinds) check("branch", pattern, Filter::kBilinear, Encoding::kRgba16f);
}

INSTANTIATE_TEST_SUITE_P(Cameras, HonestHits, testing::Bool(), [](const auto& orthographic) {
  return orthographic.param ? std::string("orthographic") : std::string("perspective");
});

}  // namespace
}  // namespace reprise
