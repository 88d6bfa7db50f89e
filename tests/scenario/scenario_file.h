// A scenario as a file in a folder of the test's own, beside shaders and a texture that it may name.
#pragma once

#include <filesystem>
#include <string>

#include "profiler/scenario/scenario.h"

namespace reprise {

// A small valid scenario in TOML, for tests to change.
std::string validScenario();

// `text` with the one place of `wanted` replaced; the test fails if there is none or are several.
std::string changed(const std::string& text, const std::string& wanted, const std::string& replacement);

class ScenarioFolder {
 public:
  ScenarioFolder();  // holds a.frag, a.vert, common/, wood.png
  ~ScenarioFolder();
  ScenarioFolder(const ScenarioFolder&) = delete;
  ScenarioFolder& operator=(const ScenarioFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& name, const std::string& content) const;

  // Writes scene.toml and reads it.
  Result<Scenario> read(const std::string& toml) const;

 private:
  std::filesystem::path path_;
};

// The scenario without what says where it came from: its path, the places.
Scenario withoutPlaces(Scenario scenario);

}  // namespace reprise
