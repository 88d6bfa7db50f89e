// The scenario that a model alone gets: with a sun that casts shadows, unless the model brings lights.
#include <gtest/gtest.h>

#include "cli/model_scenario.h"
#include "cli/subject.h"
#include "profiler/scenario/passes.h"
#include "tests/gltf/made_gltf.h"

namespace reprise {
namespace {

using nlohmann::json;

Subject subjectOf(const json& document) {
  const ModelFolder folder;
  const Result<std::string> toml = modelScenario(folder.write("made.gltf", document.dump()));
  REPRISE_CHECK(toml.ok(), formatError(toml.error()));
  Result<Subject> subject = readSubject(folder.write("made.toml", *toml));
  REPRISE_CHECK(subject.ok(), formatError(subject.error()));
  return std::move(*subject);
}

bool samplesShadows(const Subject& subject) {
  for (const Descriptor& descriptor : subject.program.interface.descriptors)
    if (descriptor.name == "shadow_map") return descriptor.compares;
  return false;
}

TEST(ModelScenario, HasASunWithShadowsWhereTheModelHasNoLight) {
  const Subject subject = subjectOf(madeGltf({}));
  EXPECT_TRUE(standardShadow(subject.scenario).has_value());
  EXPECT_TRUE(samplesShadows(subject));
}

TEST(ModelScenario, LeavesTheLightToModelsThatHaveOne) {
  json document = madeGltf({});
  document["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
  document["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  const Subject subject = subjectOf(document);
  EXPECT_FALSE(standardShadow(subject.scenario).has_value());
  EXPECT_FALSE(samplesShadows(subject));
}

}  // namespace
}  // namespace reprise
