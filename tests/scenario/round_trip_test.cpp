// Law 6 for scenarios: reading what was written gives the same scenario, the shipped ones and made-up ones.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <filesystem>

#include "profiler/scenario/names.h"
#include "profiler/scenario/read_scenario.h"
#include "runtime/base/file.h"
#include "tests/scenario/scenario_file.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> shippedScenarios() {
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(REPRISE_SOURCE_DIR) / "shaders")) {
    if (entry.path().extension() == ".toml") paths.push_back(entry.path().string());
  }
  return paths;
}

class ShippedScenario : public testing::TestWithParam<std::string> {};

TEST_P(ShippedScenario, SurvivesWritingAndReading) {
  const Result<Scenario> first = readScenario(GetParam());
  ASSERT_TRUE(first.ok()) << formatError(first.error());
  const ScenarioFolder folder;
  // Written for another folder: its files are named by absolute paths there.
  const Result<Scenario> again = folder.read(writeScenario(*first, folder.path()));
  ASSERT_TRUE(again.ok()) << formatError(again.error());
  EXPECT_EQ(withoutPlaces(*again), withoutPlaces(*first));
  EXPECT_EQ(writeScenario(*again, folder.path()), writeScenario(*first, folder.path()));
}

INSTANTIATE_TEST_SUITE_P(Scenarios, ShippedScenario, testing::ValuesIn(shippedScenarios()),
                         [](const auto& each) { return fs::path(each.param).stem().string(); });

TEST(WrittenScenario, NamesFilesBelowItsFolderByRelativePaths) {
  const ScenarioFolder folder;
  const Result<Scenario> read = folder.read(validScenario());
  ASSERT_TRUE(read.ok()) << formatError(read.error());
  const std::string text = writeScenario(*read, folder.path());
  EXPECT_NE(text.find("fragment = \"a.frag\""), std::string::npos) << text;
  EXPECT_NE(text.find("include_dirs = [\"common\"]"), std::string::npos) << text;
  EXPECT_EQ(text.find(folder.path().string()), std::string::npos) << text;
}

TEST(WrittenScenario, DocumentationExampleIsAScenario) {
  const Result<std::string> page = readFile(fs::path(REPRISE_SOURCE_DIR) / "docs/scenario.md");
  ASSERT_TRUE(page.ok());
  const std::string fence = "```toml\n";
  const std::size_t start = page->find(fence) + fence.size();
  const ScenarioFolder folder;
  folder.write("brick.frag", "");
  folder.write("brick.vert", "");
  folder.write("brick.png", "");
  const Result<Scenario> read = folder.read(page->substr(start, page->find("```", start) - start));
  ASSERT_TRUE(read.ok()) << formatError(read.error());
  EXPECT_EQ(read->objects.size(), 2u);
}

float anyFloat(float low, float high) {
  const int steps = *rc::gen::inRange(0, 1 << 24);
  return low + (high - low) * static_cast<float>(steps) / static_cast<float>(1 << 24);
}

std::vector<float> anyFloats(std::size_t count) {
  std::vector<float> values(count);
  for (float& value : values) value = anyFloat(-1000, 1000);
  return values;
}

std::array<float, 3> anyDirection() {
  return {anyFloat(-1, 1), anyFloat(0.1f, 1), anyFloat(-1, 1)};
}

Track anyTrack(std::size_t size) {
  switch (*rc::gen::inRange(0, 5)) {
    case 4:
      return FlickerTrack{anyFloats(size), anyFloats(size), anyFloat(0.1f, 60), *rc::gen::arbitrary<std::uint32_t>()};
    case 0:
      return FixedTrack{anyFloats(size)};
    case 1: {
      KeyFramesTrack track;
      float at_s = 0;
      for (int i = *rc::gen::inRange(1, 5); i > 0; --i) {
        track.times_s.push_back(at_s);
        track.values.push_back(anyFloats(size));
        at_s += anyFloat(0.01f, 3);
      }
      return track;
    }
    case 2:
      return OscillationTrack{anyFloats(size), anyFloats(size), anyFloat(0.1f, 9), anyFloat(-4, 4)};
    default: {
      RandomWalkTrack track{anyFloats(size), anyFloats(size), anyFloat(0, 5),
                            *rc::gen::arbitrary<std::uint32_t>()};
      for (float& extent : track.extent) extent = std::abs(extent);
      return track;
    }
  }
}

Motion anyMotion() {
  return {anyTrack(3), anyTrack(3), anyTrack(3), anyDirection(), anyFloat(-1, 1)};
}

// Only the fields that the kind has: the others are not written.
MeshSpec anyMesh() {
  MeshSpec mesh;
  mesh.kind = static_cast<MeshKind>(*rc::gen::inRange(0, 6));
  mesh.segments_u = *rc::gen::inRange(3, 2049);
  mesh.segments_v = *rc::gen::inRange(3, 2049);
  if (mesh.kind == MeshKind::kSphere || mesh.kind == MeshKind::kTorusKnot || mesh.kind == MeshKind::kDisplacedSphere) mesh.radius = anyFloat(0.01f, 10);
  if (mesh.kind == MeshKind::kTorusKnot) {
    mesh.tube_radius = anyFloat(0.01f, 1);
    mesh.p = *rc::gen::inRange(1, 8);
    mesh.q = mesh.p + 1;
  }
  if (mesh.kind == MeshKind::kPlane || mesh.kind == MeshKind::kTerrain) mesh.size = anyFloat(0.1f, 100);
  if (mesh.kind == MeshKind::kTerrain) {
    mesh.height = anyFloat(0, 3);
    mesh.seed = *rc::gen::arbitrary<std::uint32_t>();
  }
  if (mesh.kind == MeshKind::kDisplacedSphere) {
    mesh.height = anyFloat(0, 1);
    mesh.cells = *rc::gen::inRange(1, 40);
    mesh.seed = *rc::gen::arbitrary<std::uint32_t>();
  }
  if (mesh.kind == MeshKind::kRevolution)
    for (int i = 0; i < 4; ++i) mesh.profile.push_back({anyFloat(0, 2), static_cast<float>(i)});
  return mesh;
}

RecordedPath anyRecording() {
  RecordedPath path;
  const bool zooms = *rc::gen::arbitrary<bool>();
  float at_s = 0;
  for (int i = *rc::gen::inRange(1, 5); i > 0; --i) {
    const float half_rad = anyFloat(-3, 3);
    path.keys.push_back({at_s, anyDirection(), {std::sin(half_rad), 0, 0, std::cos(half_rad)}, zooms ? anyFloat(1, 170) : 0});
    at_s += anyFloat(0.01f, 3);
  }
  return path;
}

void addShakeAndCuts(Camera& camera) {
  if (*rc::gen::arbitrary<bool>())
    camera.handheld = Handheld{anyFloat(0, 1), anyFloat(0, 9), anyFloat(0.1f, 9), *rc::gen::arbitrary<std::uint32_t>()};
  float at_s = 0;
  for (int i = *rc::gen::inRange(0, 3); i > 0; --i) {
    camera.cuts.push_back({at_s, anyFloat(-180, 180), anyDirection()});
    at_s += anyFloat(0.01f, 3);
  }
}

Camera anyCamera(bool reverse_z) {
  Camera camera;
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      camera.path = OrbitPath{anyDirection(), anyFloat(0.1f, 9), anyFloat(-3, 3), anyFloat(-7, 7), anyFloat(-1, 1)};
      break;
    case 1:
      camera.path = TrackPath{anyTrack(3), anyTrack(3)};
      break;
    default:
      camera.path = anyRecording();
  }
  addShakeAndCuts(camera);
  camera.up = anyDirection();
  camera.orthographic = *rc::gen::arbitrary<bool>();
  if (camera.orthographic)
    camera.ortho_height = anyFloat(0.1f, 20);
  else
    camera.fov_y_deg = anyFloat(1, 170);
  camera.near_plane = anyFloat(0.001f, 1);
  const bool infinite = !camera.orthographic && *rc::gen::arbitrary<bool>();
  camera.far_plane = infinite ? std::numeric_limits<float>::infinity() : anyFloat(2, 1000);
  camera.reverse_z = reverse_z;
  return camera;
}

std::string anyText() {
  return *rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::inRange<char>(1, 127)));
}

TextureSpec anyTexture(const std::string& name, const std::string& file) {
  TextureSpec texture;
  texture.name = name;
  texture.kind = static_cast<TextureKind>(*rc::gen::inRange(0, 7));
  if (texture.kind == TextureKind::kFile) {
    texture.path = file;
  } else if (texture.kind == TextureKind::kDiscs) {
    texture.objects = {"object.1"};
    texture.discs_u = *rc::gen::inRange(1, 9);
    texture.discs_v = *rc::gen::inRange(1, 9);
    texture.object_space = *rc::gen::arbitrary<bool>();
  } else {
    texture.size = *rc::gen::inRange(1, 4096);
    if (texture.kind == TextureKind::kBumps) texture.height = anyFloat(0, 2);
    else for (float& value : texture.color_a) value = anyFloat(0, 20);
  }
  if (hasCells(texture.kind)) texture.cells = *rc::gen::inRange(1, 99);
  if (hasSeed(texture.kind)) texture.seed = *rc::gen::arbitrary<std::uint32_t>();
  texture.linear = *rc::gen::arbitrary<bool>();
  texture.repeat = *rc::gen::arbitrary<bool>();
  texture.mipmaps = *rc::gen::arbitrary<bool>();
  texture.srgb = *rc::gen::arbitrary<bool>();
  return texture;
}

PassSpec anyPass(const Scenario& scenario, const std::string& name, const std::string& shader) {
  PassSpec pass;
  pass.name = name;
  pass.kind = static_cast<ScenePassKind>(*rc::gen::inRange(0, 2));
  if (pass.kind == ScenePassKind::kShadow) {
    pass.light = anyCamera(false);
    pass.size = *rc::gen::inRange(16u, 4096u);
    pass.slope_bias = anyFloat(0, 9);
    for (float& value : pass.color) value = anyFloat(0, 20);
    if (*rc::gen::arbitrary<bool>()) pass.objects = {scenario.objects[0].name};
  } else {
    pass.fragment_path = shader;
    if (*rc::gen::arbitrary<bool>()) pass.vertex_path = shader;
    if (*rc::gen::arbitrary<bool>()) pass.depth_texture = name + "_depth";
    for (int i = *rc::gen::inRange(1, 4); i > 0; --i)
      pass.outputs.push_back({name + std::to_string(i), kColorFormats[*rc::gen::inRange(0, 3)], *rc::gen::arbitrary<bool>()});
  }
  return pass;
}

RenderState anyState(bool reverse_z) {
  RenderState state;
  state.cull = static_cast<CullMode>(*rc::gen::inRange(0, 3));
  state.compare = static_cast<DepthCompare>(*rc::gen::inRange(0, 2) + (reverse_z ? 2 : 0));
  state.depth_stencil = *rc::gen::arbitrary<bool>();
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i) state.color_formats.emplace_back("rgba16_sfloat");
  for (float& value : state.clear) value = anyFloat(-1, 2);
  return state;
}

SessionSpec anySession(const Scenario& scenario, int number, bool reverse_z) {
  SessionSpec session;
  session.name = "session" + std::to_string(number);
  session.role = number == 0 ? SessionRole::kTraining : SessionRole::kValidation;
  session.camera = anyCamera(reverse_z);
  session.frames = *rc::gen::inRange(0, 500);
  session.speed = anyFloat(0, 3);
  if (*rc::gen::arbitrary<bool>()) session.motions[scenario.objects[0].name] = anyMotion();
  if (*rc::gen::arbitrary<bool>()) session.uniforms["Scene.tint"] = anyTrack(3);
  return session;
}

Scenario anyScenario(const fs::path& folder) {
  Scenario scenario;
  scenario.name = anyText();
  scenario.motion = static_cast<MotionSource>(*rc::gen::inRange(0, 2));
  scenario.fragment_path = (folder / "a.frag").string();
  scenario.vertex_path = (folder / "a.vert").string();
  if (*rc::gen::arbitrary<bool>()) scenario.vertex_inputs = {{"input_0", "position"}, {"in.var.\"x\"", "uv"}};
  if (*rc::gen::arbitrary<bool>()) scenario.fragment_entry_point = "PSMain", scenario.vertex_entry_point = "VSMain";
  if (*rc::gen::arbitrary<bool>()) scenario.include_dirs = {(folder / "common").string()};
  if (*rc::gen::arbitrary<bool>()) scenario.defines = {{"B", anyText()}, {"A", ""}, {"C", "1"}};
  scenario.width = *rc::gen::inRange(1u, 8193u);
  scenario.height = *rc::gen::inRange(1u, 8193u);
  scenario.frames = *rc::gen::inRange(1, 1000);
  scenario.frame_time_s = anyFloat(0.001f, 1);
  if (*rc::gen::arbitrary<bool>()) scenario.periods = {1, 0, 64};
  if (*rc::gen::arbitrary<bool>()) scenario.stereo = Stereo{anyFloat(0.001f, 2)}, scenario.periods = {1, 2};
  scenario.seed = *rc::gen::arbitrary<std::uint32_t>();
  scenario.tone_map = static_cast<ToneMap>(*rc::gen::inRange(0, 3));
  scenario.exposure = anyFloat(0.1f, 8);
  const bool reverse_z = *rc::gen::arbitrary<bool>();
  scenario.state = anyState(reverse_z);
  for (int i = *rc::gen::inRange(1, 4); i > 0; --i)
    scenario.objects.push_back({"object." + std::to_string(i), anyMesh(), anyMotion()});
  scenario.uniforms.push_back({"Scene.tint", anyTrack(3), {}});
  scenario.uniforms.push_back({"Scene.view.sun", static_cast<Semantic>(*rc::gen::inRange(0, 9)), {}});
  for (int i = *rc::gen::inRange(0, 3); i > 0; --i)
    scenario.textures.push_back(anyTexture("texture" + std::to_string(i), (folder / "wood.png").string()));
  for (int i = *rc::gen::inRange(0, 3); i > 0; --i) {
    scenario.passes.push_back(anyPass(scenario, "pass" + std::to_string(i), scenario.fragment_path));
    scenario.uniforms.push_back({"Scene.pass" + std::to_string(i), PassSource{"pass" + std::to_string(i), kPassSources[*rc::gen::inRange(0, 4)].value}, {}});
  }
  for (int i = 0; i < 2; ++i) scenario.sessions.push_back(anySession(scenario, i, reverse_z));
  return scenario;
}

RC_GTEST_PROP(WrittenScenario, ReadsBackTheSame, ()) {
  static const ScenarioFolder folder;
  Scenario scenario = anyScenario(folder.path());
  const Result<Scenario> read = folder.read(writeScenario(scenario, folder.path()));
  if (!read.ok()) RC_FAIL(formatError(read.error()));
  scenario.hash = read->hash;
  RC_ASSERT(withoutPlaces(*read) == withoutPlaces(scenario));
}

}  // namespace
}  // namespace reprise
