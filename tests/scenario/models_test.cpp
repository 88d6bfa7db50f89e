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

}  // namespace
}  // namespace reprise
