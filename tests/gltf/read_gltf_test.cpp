// What comes out of glTF files, and what is refused.
#include "profiler/gltf/read_gltf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "profiler/gltf/figure.h"
#include "profiler/gltf/pose.h"
#include "runtime/base/file.h"
#include "tests/gltf/made_gltf.h"

namespace reprise {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

Result<GltfScene> readMade(const json& document) {
  const ModelFolder folder;
  return readGltf(folder.write("made.gltf", document.dump()));
}

struct Break {
  const char* name;
  std::function<void(json&)> change;
  const char* code;
  const char* path;  // that the message tells
};

const Break kBreaks[] = {
    {"IndexBeyondTheVertices", [](json& d) { d["accessors"][d["extras"]["indices"].get<int>()]["bufferView"] = 0; d["accessors"][d["extras"]["indices"].get<int>()]["count"] = 12; },
     "gltf.index", "meshes[0].primitives[0].indices"},
    {"MissingBuffer", [](json& d) { d["buffers"][0]["uri"] = "gone.bin"; }, "gltf.uri", "gone.bin"},
    {"BufferOutsideTheFolder", [](json& d) { d["buffers"][0]["uri"] = "../gone.bin"; }, "gltf.uri", "gone.bin"},
    {"AccessorThatIsNotThere", [](json& d) { d["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 99; }, "gltf.index", "meshes[0].primitives[0].attributes.POSITION"},
    {"AccessorBeyondItsView", [](json& d) { d["accessors"][0]["count"] = 1000; }, "gltf.accessor", "meshes[0].primitives[0].attributes.POSITION"},
    {"ViewBeyondItsBuffer", [](json& d) { d["bufferViews"][0]["byteOffset"] = 1 << 20; }, "gltf.accessor", "bufferViews[0]"},
    {"AbsurdCount", [](json& d) { d["accessors"][0]["count"] = 4000000000u; }, "gltf.limit", "meshes[0].primitives[0].attributes.POSITION"},
    {"CircleOfNodes", [](json& d) { d["nodes"][3]["children"] = {2}; d["nodes"][0]["children"] = {1}; }, "gltf.nodes", "nodes["},
    {"TwoParents", [](json& d) { d["nodes"][3]["children"] = {1}; }, "gltf.nodes", "nodes["},
    {"ChildThatIsNotThere", [](json& d) { d["nodes"][3]["children"] = {77}; }, "gltf.index", "nodes[3].children[0]"},
    {"JointThatIsNotThere", [](json& d) { d["skins"][0]["joints"] = {2, 44}; }, "gltf.index", "skins[0].joints[1]"},
    {"JointBeyondTheSkin", [](json& d) { d["skins"][0]["joints"] = {2}; }, "gltf.index", "JOINTS_0"},
    {"MaterialThatIsNotThere", [](json& d) { d["meshes"][0]["primitives"][0]["material"] = 5; }, "gltf.index", "meshes[0].primitives[0].material"},
    {"ExtensionThatIsRequired", [](json& d) { d["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }, "gltf.extension", "KHR_draco_mesh_compression"},
    {"KeysThatDoNotFit", [](json& d) { d["animations"][0]["samplers"][0]["output"] = d["extras"]["turns"]; }, "gltf.accessor", "animations[0].samplers[0].output"},
    {"NothingToDraw", [](json& d) { d["nodes"][1].erase("mesh"); d["animations"] = json::array(); }, "gltf.empty", "scene"},
};

class BrokenGltf : public testing::TestWithParam<Break> {};

TEST_P(BrokenGltf, IsRefusedWithItsPlace) {
  json document = madeGltf({});
  GetParam().change(document);
  const Result<GltfScene> read = readMade(document);
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().code, GetParam().code) << read.error().message;
  EXPECT_NE(read.error().message.find(GetParam().path), std::string::npos) << read.error().message;
  EXPECT_FALSE(read.error().place.file.empty());
}

INSTANTIATE_TEST_SUITE_P(Kinds, BrokenGltf, testing::ValuesIn(kBreaks), [](const auto& each) { return std::string(each.param.name); });

TEST(ReadGltf, RefusesPositionsThatAreNotFinite) {
  json document = madeGltf({});
  const std::string uri = document["buffers"][0]["uri"];
  const std::size_t data = uri.find(',') + 1;
  // The first sixteen digits hold the first three floats.
  document["buffers"][0]["uri"] = uri.substr(0, data) + "AADAfwAAwH8AAMB/" + uri.substr(data + 16);
  const Result<GltfScene> read = readMade(document);
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().code, "gltf.value");
  EXPECT_NE(read.error().message.find("meshes[0].primitives[0].attributes.POSITION"), std::string::npos) << read.error().message;
}

TEST(ReadGltf, RefusesWhatIsNoGltf) {
  const ModelFolder folder;
  for (const std::string text : {"", "{", "glTF", "glTF\2\0\0\0\xff\xff\xff\xff", "not at all"}) {
    const Result<GltfScene> read = readGltf(folder.write("a.glb", text));
    EXPECT_FALSE(read.ok()) << text;
  }
  const Result<GltfScene> deep = readGltf(folder.write("deep.gltf", std::string(100000, '[')));
  ASSERT_FALSE(deep.ok());
  EXPECT_EQ(deep.error().code, "gltf.limit");
}

TEST(ReadGltf, FindsFilesBesideItWhoseNamesArePercentEncoded) {
  const ModelFolder folder;
  json document = madeGltf({});
  // All positions in one place, all indices 0: what matters is that the file is found. Times of keys must not be all the same.
  document["animations"] = json::array();
  folder.write("two words.bin", std::string(document["buffers"][0]["byteLength"].get<std::size_t>(), '\0'));
  document["buffers"][0]["uri"] = "two%20words.bin";
  const Result<GltfScene> beside = readGltf(folder.write("beside.gltf", document.dump()));
  ASSERT_TRUE(beside.ok()) << beside.error().message;
  EXPECT_EQ(beside->files, std::vector<std::string>{"two words.bin"});
}

TEST(ReadGltf, SurvivesEveryTruncation) {
  const ModelFolder folder;
  const std::string text = madeGltf({}).dump();
  for (std::size_t length = 0; length < text.size(); length += 37) (void)readGltf(folder.write("cut.gltf", text.substr(0, length)));
}

TEST(ReadGltf, KeepsTheFourTargetsThatMoveTheMost) {
  MadeParts parts;
  parts.targets = 6;
  const Result<GltfScene> read = readMade(madeGltf(parts));
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->meshes[0].primitives[0].targets, (std::vector<std::size_t>{2, 3, 4, 5}));
  ASSERT_EQ(read->warnings.size(), 1u);
  EXPECT_NE(read->warnings[0].find("meshes[0].primitives[0].targets"), std::string::npos);
}

TEST(ReadGltf, WarnsOfExtensionsThatAreNotDrawnByTheNameOfTheMaterial) {
  json document = madeGltf({});
  json& material = document["materials"][0];
  material["name"] = "Glass";
  material["extensions"] = {{"KHR_materials_transmission", {{"transmissionFactor", 0.9}}}, {"KHR_materials_sheen", json::object()},
                            {"KHR_materials_clearcoat", {{"clearcoatFactor", 0}}}, {"KHR_materials_ior", json::object()}};
  document["textures"] = {json::object()};  // without a source, which is warned of, too
  material["normalTexture"] = {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {2, 2}}}}}}};
  const std::vector<std::string> before = readMade(madeGltf({}))->warnings;
  const Result<GltfScene> read = readMade(document);
  ASSERT_TRUE(read.ok()) << read.error().message;
  const auto warned = [&](const std::string& text) { return std::find(read->warnings.begin(), read->warnings.end(), text) != read->warnings.end(); };
  EXPECT_TRUE(warned("materials[0] 'Glass': KHR_materials_transmission is not drawn"));
  EXPECT_TRUE(warned("materials[0] 'Glass': KHR_materials_sheen is not drawn"));
  EXPECT_TRUE(warned("materials[0] 'Glass'.normalTexture: KHR_texture_transform is not drawn"));
  EXPECT_EQ(read->warnings.size(), before.size() + 4);
}

TEST(ReadGltf, MakesNormalsOfTrianglesAndTangentsAlongU) {
  MadeParts parts;
  parts.normals = false;
  const Result<GltfScene> read = readMade(madeGltf(parts));
  ASSERT_TRUE(read.ok()) << read.error().message;
  for (const Vertex& vertex : read->meshes[0].primitives[0].vertices) {
    EXPECT_NEAR(vertex.normal[2], 1, 1e-6);
    EXPECT_NEAR(vertex.tangent[0], 1, 1e-6);  // u grows with x, v falls with y
    EXPECT_EQ(vertex.tangent[3], 1);
  }
}

TEST(PoseAt, HitsTheKeysInEveryInterpolation) {
  for (const char* interpolation : {"STEP", "LINEAR", "CUBICSPLINE"}) {
    MadeParts parts;
    parts.interpolation = interpolation;
    const Result<GltfScene> read = readMade(madeGltf(parts));
    ASSERT_TRUE(read.ok()) << read.error().message;
    const GltfPose pose = poseAt(*read, &read->animations[0], 0.3f);
    EXPECT_NEAR(pose.nodes[0][3].x, 0.2f, 1e-6) << interpolation;
    EXPECT_NEAR(pose.weights[1][0], 0.3f, 1e-6) << interpolation;
    const float between = poseAt(*read, &read->animations[0], 0.15f).nodes[0][3].x;
    // Halfway the spline of the keys 0 and 0.2 with tangents 0 and 0.02 over 0.3 s lies at 0.1 - 0.3 * 0.02 / 8.
    EXPECT_NEAR(between, interpolation[0] == 'S' ? 0.0f : interpolation[0] == 'L' ? 0.1f : 0.09925f, 1e-5) << interpolation;
  }
}

TEST(PoseAt, RunsInACircle) {
  const GltfScene figure = makeFigure(6);
  const GltfPose early = poseAt(figure, &figure.animations[0], 0.25), late = poseAt(figure, &figure.animations[0], 5.25);
  for (std::size_t joint = 0; joint < early.joints[0].size(); ++joint)
    for (int column = 0; column < 4; ++column) EXPECT_LT(glm::distance(early.joints[0][joint][column], late.joints[0][joint][column]), 1e-4f);
}

TEST(Figure, StandsOnTheGroundAndWalks) {
  const GltfScene figure = makeFigure(8);
  const GltfBounds bounds = boundsOf(figure, &figure.animations[0]);
  EXPECT_NEAR(bounds.low.y, 0, 0.2);
  EXPECT_NEAR(bounds.high.y, 1.8, 0.15);
  const GltfPose one = poseAt(figure, &figure.animations[0], 0.25), other = poseAt(figure, &figure.animations[0], 0.75);
  float moved = 0;
  for (std::size_t v = 0; v < figure.meshes[0].primitives[0].vertices.size(); ++v)
    moved = std::max(moved, glm::distance(positionAt(figure, one, figure.instances[0], v), positionAt(figure, other, figure.instances[0], v)));
  EXPECT_GT(moved, 0.5f);
}

TEST(ReadGltf, ReadsRealFiles) {
  const fs::path folder = fs::path(REPRISE_SOURCE_DIR) / ".." / "shared" / "gltf";
  if (!fs::is_directory(folder)) GTEST_SKIP() << "the sample models are not there: " << folder;
  int read_files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".glb" && entry.path().extension() != ".gltf") continue;
    const Result<GltfScene> read = readGltf(entry.path());
    EXPECT_TRUE(read.ok()) << entry.path() << ": " << (read.ok() ? "" : read.error().message);
    ++read_files;
  }
  EXPECT_GT(read_files, 0);
}

}  // namespace
}  // namespace reprise
