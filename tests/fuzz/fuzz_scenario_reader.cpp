// libFuzzer target: any text as a scenario. What is read must come back from writing and reading again, and can be held
// against a pair of shaders.
#include <string>

#include "profiler/scenario/read_scenario.h"
#include "tests/fuzz/fuzz_folder.h"

namespace {

using reprise::Result;
using reprise::Scenario;

Scenario withoutPlaces(Scenario scenario) {
  scenario.path.clear();
  scenario.uniforms_place = {};
  for (auto& binding : scenario.uniforms) binding.place = {};
  for (auto& texture : scenario.textures) texture.place = {};
  return scenario;
}

// The shaders that the seeds name, as one interface.
reprise::ShaderInterface sampleInterface() {
  reprise::ShaderInterface interface;
  interface.vertex_inputs = {{"position", 0, reprise::ScalarKind::kFloat, 3}};
  interface.outputs = {{"color", 0, reprise::ScalarKind::kFloat, 4}};
  reprise::Descriptor scene;
  scene.name = "Scene";
  scene.members = {{"view_projection", reprise::ScalarKind::kFloat, 4, 4, 0, 16, false, 0, 0},
                   {"gain", reprise::ScalarKind::kFloat, 1, 1, 64, 0, false, 0, 0}};
  interface.descriptors = {scene};
  return interface;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const reprise::FuzzFolder folder;
  static const reprise::ShaderInterface interface = sampleInterface();
  static const bool prepared = [] {
    for (const char* name : {"a.frag", "a.vert", "wood.png"}) folder.write(name, "any");
    std::filesystem::create_directories(folder.path() / "common");
    return true;
  }();
  (void)prepared;
  const std::filesystem::path file = folder.write("given.toml", {reinterpret_cast<const char*>(data), size});
  const Result<Scenario> scenario = reprise::readScenario(file);
  if (!scenario.ok()) {
    REPRISE_CHECK(!scenario.error().code.empty() && !scenario.error().message.empty(), scenario.error().code);
    return 0;
  }
  (void)reprise::checkBindings(*scenario, interface);
  const std::string written = reprise::writeScenario(*scenario, folder.path());
  const Result<Scenario> again = reprise::readScenario(folder.write("written.toml", written));
  REPRISE_CHECK(again.ok(), again.error().message, written);
  REPRISE_CHECK(withoutPlaces(*again) == withoutPlaces(*scenario), written);
  return 0;
}
