#include "tests/scenario/scenario_file.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include "profiler/scenario/read_scenario.h"
#include "runtime/base/file.h"

namespace reprise {

namespace fs = std::filesystem;

std::string validScenario() {
  return R"([shader]
fragment = "a.frag"
vertex = "a.vert"
include_dirs = ["common"]
defines = { LAYERS = 4 }

[render]
width = 64
height = 48
frames = 8
periods = [1, 2, "never"]

[[object]]
name = "ball"
mesh = { kind = "sphere", radius = 1.5 }

[[object]]
name = "floor"
mesh = { kind = "plane", size = 4 }

[uniforms]
"Scene.view_projection" = "view_projection"
"Scene.gain" = 0.5

[[texture]]
name = "wood"
file = "wood.png"

[[session]]
name = "train"
role = "training"
camera = { orbit = { radius = 3 } }

[[session]]
name = "check"
role = "validation"
camera = { eye = [0, 1, 4], target = [0, 0, 0] }
)";
}

std::string changed(const std::string& text, const std::string& wanted, const std::string& replacement) {
  const std::size_t place = text.find(wanted);
  EXPECT_NE(place, std::string::npos) << "nothing like " << wanted;
  if (place == std::string::npos) return text;
  EXPECT_EQ(text.find(wanted, place + 1), std::string::npos) << "several of " << wanted;
  return std::string(text).replace(place, wanted.size(), replacement);
}

ScenarioFolder::ScenarioFolder() {
  std::string name = (fs::temp_directory_path() / "reprise-scenario-XXXXXX").string();
  path_ = ::mkdtemp(name.data());
  write("a.frag", "#version 450\n");
  write("a.vert", "#version 450\n");
  write("common/shared.glsl", "");
  write("wood.png", "not decoded by the reader");
}

ScenarioFolder::~ScenarioFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void ScenarioFolder::write(const std::string& name, const std::string& content) const {
  ASSERT_TRUE(writeFile(path_ / name, content).ok());
}

Result<Scenario> ScenarioFolder::read(const std::string& toml) const {
  write("scene.toml", toml);
  return readScenario(path_ / "scene.toml");
}

Scenario withoutPlaces(Scenario scenario) {
  scenario.path.clear();
  scenario.uniforms_place = {};
  for (UniformBinding& binding : scenario.uniforms) binding.place = {};
  for (ModelSpec& model : scenario.models) model.place = {};
  for (TextureSpec& texture : scenario.textures) texture.place = texture.file_place = {};
  for (PassSpec& pass : scenario.passes) pass.place = {};
  return scenario;
}

}  // namespace reprise
