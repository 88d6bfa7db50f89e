// Models in scenarios: the objects that come of them, and that nothing of them is lost.
#include <gtest/gtest.h>

#include "profiler/scenario/read_scenario.h"
#include "tests/scenario/scenario_file.h"

namespace reprise {
namespace {

std::string withFigures(const std::string& more = "") {
  return changed(validScenario(), "[uniforms]",
                 "[[model]]\nname = \"ann\"\nkind = \"figure\"\n[[model]]\nname = \"bob\"\nkind = \"figure\"\nphase_s = 0.5\nspeed = 2\ncolor = [1, 0, 0, 1]\n" +
                     more + "\n[uniforms]");
}

TEST(Models, BecomeObjectsAfterTheOthers) {
  const ScenarioFolder folder;
  const Result<Scenario> read = folder.read(withFigures());
  ASSERT_TRUE(read.ok()) << formatError(read.error());
  ASSERT_EQ(read->objects.size(), 4u);
  EXPECT_EQ(read->objects[2].name, "ann.0");
  EXPECT_EQ(read->objects[3].part, (ModelPart{1, 0}));
  EXPECT_EQ(read->models[0].scene, read->models[1].scene);
}

TEST(Models, SurviveWritingAndReading) {
  const ScenarioFolder folder;
  const Result<Scenario> read = folder.read(withFigures("animation = \"walk\""));
  ASSERT_TRUE(read.ok()) << formatError(read.error());
  const Result<Scenario> again = folder.read(writeScenario(*read, folder.path()));
  ASSERT_TRUE(again.ok()) << formatError(again.error());
  EXPECT_EQ(withoutPlaces(*again), withoutPlaces(*read));
  EXPECT_EQ(again->hash, read->hash);
}

TEST(Models, CountForTheHash) {
  const ScenarioFolder folder;
  const Result<Scenario> one = folder.read(withFigures()), other = folder.read(withFigures("segments = 9"));
  ASSERT_TRUE(one.ok() && other.ok());
  EXPECT_NE(one->hash, other->hash);
}

TEST(Models, RefuseAnimationsThatAreNotThere) {
  const ScenarioFolder folder;
  const Result<Scenario> read = folder.read(withFigures("animation = \"wlak\""));
  ASSERT_FALSE(read.ok());
  EXPECT_NE(read.error().message.find("walk"), std::string::npos) << read.error().message;
}

TEST(Models, RefuseFilesThatAreNoGltf) {
  const ScenarioFolder folder;
  folder.write("a.glb", "no model");
  const Result<Scenario> read = folder.read(changed(validScenario(), "[uniforms]", "[[model]]\nname = \"a\"\nfile = \"a.glb\"\n[uniforms]"));
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().code, "gltf.syntax");
}

// One triangle, and a camera that a node named "Eye" holds.
const char* const kModelWithCamera = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],
"nodes":[{"mesh":0},{"name":"Eye","camera":0,"translation":[0,1,4]}],
"cameras":[{"name":"Front","type":"perspective","perspective":{"yfov":1,"znear":0.2,"zfar":50}}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}]})";

Result<Scenario> readWithModelCamera(const ScenarioFolder& folder, const std::string& camera) {
  folder.write("a.gltf", kModelWithCamera);
  const std::string text = changed(validScenario(), "[uniforms]", "[[model]]\nname = \"a\"\nfile = \"a.gltf\"\n[uniforms]");
  return folder.read(changed(text, "camera = { orbit = { radius = 3 } }", "camera = { gltf = " + camera + " }"));
}

TEST(ModelCameras, AreFoundByNameNodeAndIndexAndBringTheirLens) {
  const ScenarioFolder folder;
  for (const char* camera : {"\"a\"", "{ model = \"a\", camera = 0 }", "{ model = \"a\", camera = \"Front\" }", "{ model = \"a\", camera = \"Eye\" }"}) {
    const Result<Scenario> read = readWithModelCamera(folder, camera);
    ASSERT_TRUE(read.ok()) << formatError(read.error());
    const Camera& found = read->sessions[0].camera;
    EXPECT_EQ(std::get<ModelCameraPath>(found.path).node_index, 1u);
    EXPECT_NEAR(found.fov_y_deg, 57.29578f, 1e-4);
    EXPECT_EQ(found.near_plane, 0.2f);
    EXPECT_EQ(found.far_plane, 50);
    const Result<Scenario> again = folder.read(writeScenario(*read, folder.path()));
    ASSERT_TRUE(again.ok()) << formatError(again.error());
    EXPECT_EQ(again->sessions, read->sessions);
  }
}

TEST(ModelCameras, WithoutAFarPlaneSeeToInfinity) {
  const ScenarioFolder folder;
  folder.write("endless.gltf", changed(kModelWithCamera, ",\"zfar\":50", ""));
  const std::string text = changed(validScenario(), "[uniforms]", "[[model]]\nname = \"a\"\nfile = \"endless.gltf\"\n[uniforms]");
  const Result<Scenario> read = folder.read(changed(text, "camera = { orbit = { radius = 3 } }", "camera = { gltf = \"a\" }"));
  ASSERT_TRUE(read.ok()) << formatError(read.error());
  EXPECT_EQ(read->sessions[0].camera.far_plane, std::numeric_limits<float>::infinity());
}

TEST(ModelCameras, ThatAreNotThereAreRefusedWithNearNames) {
  const ScenarioFolder folder;
  const Result<Scenario> read = readWithModelCamera(folder, "{ model = \"a\", camera = \"Frnt\" }");
  ASSERT_FALSE(read.ok());
  EXPECT_NE(read.error().message.find("'Front'"), std::string::npos) << read.error().message;
  EXPECT_FALSE(readWithModelCamera(folder, "{ model = \"a\", camera = 1 }").ok());
}

TEST(ModelCameras, TakeNoLensOfTheirOwn) {
  const ScenarioFolder folder;
  EXPECT_FALSE(readWithModelCamera(folder, "\"a\", fov_y_deg = 40").ok());
}

}  // namespace
}  // namespace reprise
