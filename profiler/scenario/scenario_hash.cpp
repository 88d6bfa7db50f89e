#include "profiler/scenario/scenario_hash.h"

#include "profiler/scenario/read_scenario.h"
#include "profiler/scenario/texture_file.h"
#include "runtime/base/hash.h"

namespace reprise {

Result<std::string> hashScenario(const Scenario& scenario) {
  Scenario bare = scenario;
  bare.name = "scenario";
  bare.fragment_path = bare.vertex_path = "shader";
  bare.fragment_entry_point = bare.vertex_entry_point = "main";
  bare.include_dirs.clear();
  for (TextureSpec& texture : bare.textures) {
    if (texture.kind != TextureKind::kFile) continue;
    REPRISE_ASSIGN(const std::string bytes, readTextureFile(texture));
    texture.path = contentHash(bytes);
  }
  for (PassSpec& pass : bare.passes) {
    pass.fragment_path = pass.kind == ScenePassKind::kGBuffer ? "shader" : "";
    pass.vertex_path = pass.package = "";
  }
  // The figure's shape is told by the scenario itself.
  for (ModelSpec& model : bare.models)
    if (!model.path.empty() && model.scene) model.path = model.scene->hash;
  return contentHash(writeScenario(bare, {}));
}

}  // namespace reprise
