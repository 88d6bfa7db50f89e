#include "profiler/scenario/read_scenario.h"

#include <algorithm>

#include "profiler/scenario/model_cameras.h"
#include "profiler/scenario/near_names.h"
#include "profiler/scenario/read_models.h"
#include "profiler/scenario/read_motion.h"
#include "profiler/scenario/read_passes.h"
#include "profiler/scenario/read_sections.h"
#include "profiler/scenario/scenario_hash.h"
#include "runtime/base/file.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

template <typename Named>
void expectDistinct(const std::vector<Named>& named, const std::vector<const TomlNode*>& nodes,
                    const std::string& noun, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < named.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (named[i].name != named[j].name) continue;
      diagnostics.add("value",
                      "there are two " + noun + " named '" + named[i].name + "', the first in line " +
                          std::to_string(nodes[j]->place.line) + "; expected distinct names",
                      nodes[i]->place);
      break;
    }
  }
}

void readObjects(TableReader& root, Scenario& scenario) {
  const std::vector<const TomlNode*> nodes = root.findTables("object");
  for (const TomlNode* node : nodes) {
    Object object;
    TableReader reader(*node, "[[object]] " + std::to_string(scenario.objects.size() + 1),
                       root.diagnostics());
    readName(reader, object.name);
    if (const TomlNode* mesh = reader.find("mesh", Need::kRequired)) {
      object.mesh = readMesh(*mesh, "'mesh' of object '" + object.name + "'", root.diagnostics());
    }
    if (const TomlNode* motion = reader.find("motion")) {
      object.motion = readMotion(*motion, "'motion' of object '" + object.name + "'", root.diagnostics());
    }
    reader.finish();
    scenario.objects.push_back(std::move(object));
  }
  expectDistinct(scenario.objects, nodes, "objects", root.diagnostics());
  if (!root.has("object") && !root.has("model")) {
    root.diagnostics().add("missing_key", "the scenario has no [[object]] and no [[model]], expected at least one",
                           root.table().place);
  }
}

// One slip is caught by the limit of each mesh and texture; these hold many of them together.
void expectModest(const Scenario& scenario, const Place& place, Diagnostics& diagnostics) {
  std::int64_t quads = 0, texels = 0;
  for (const Object& object : scenario.objects) quads += std::int64_t{object.mesh.segments_u} * object.mesh.segments_v;
  for (const TextureSpec& texture : scenario.textures)
    if (texture.kind == TextureKind::kDiscs)
      texels += std::int64_t{2 + 2 * texture.discs_u * texture.discs_v} * static_cast<std::int64_t>(texture.objects.size());
    else if (texture.kind != TextureKind::kFile)
      texels += std::int64_t{texture.size} * texture.size;
  const auto expectAtMost = [&](const std::string& what, std::int64_t found, std::int64_t most) {
    if (found > most)
      diagnostics.add("value", what + std::to_string(found) + " together, expected at most " + std::to_string(most), place);
  };
  expectAtMost("the meshes have segments_u x segments_v = ", quads, kMaxMeshQuads);
  expectAtMost("the textures have size x size = ", texels, kMaxTexels);
}

// Discs are made of the meshes that the scenario itself makes.
void expectOwnMeshes(const Scenario& scenario, const TextureSpec& texture, const TomlNode& node, Diagnostics& diagnostics) {
  std::vector<std::string> known;
  for (const Object& object : scenario.objects)
    if (!object.part) known.push_back(object.name);
  for (const std::string& name : texture.objects)
    if (std::find(known.begin(), known.end(), name) == known.end())
      diagnostics.add("value", "texture '" + texture.name + "' wants discs of the object '" + name + "'" + suggestNames(name, known), node.place);
}

void readTextures(TableReader& root, const fs::path& directory, Scenario& scenario) {
  const std::vector<const TomlNode*> nodes = root.findTables("texture");
  for (const TomlNode* node : nodes) {
    scenario.textures.push_back(readTexture(*node, directory, root.diagnostics()));
    expectOwnMeshes(scenario, scenario.textures.back(), *node, root.diagnostics());
  }
  expectDistinct(scenario.textures, nodes, "textures", root.diagnostics());
}

// Reverse Z and the comparison must agree, else the farthest surface wins.
void checkDepthOrder(const SessionSpec& session, const RenderState& state, const TomlNode& node,
                     Diagnostics& diagnostics) {
  const bool greater =
      state.compare == DepthCompare::kGreater || state.compare == DepthCompare::kGreaterOrEqual;
  if (greater == session.camera.reverse_z) return;
  diagnostics.add("value",
                  "session '" + session.name + "' has a camera with" +
                      (session.camera.reverse_z ? "" : "out") + " reverse_z, but 'depth_compare' is '" +
                      spellingOf(kDepthCompares, state.compare) +
                      "'; expected 'greater' with reverse_z and 'less' without",
                  node.place);
}

void readSessions(TableReader& root, Scenario& scenario) {
  const std::vector<const TomlNode*> nodes = root.findTables("session");
  bool training = false, validation = false;
  for (const TomlNode* node : nodes) {
    SessionSpec session = readSession(*node, scenario, root.diagnostics());
    checkDepthOrder(session, scenario.state, *node, root.diagnostics());
    (session.role == SessionRole::kTraining ? training : validation) = true;
    scenario.sessions.push_back(std::move(session));
  }
  expectDistinct(scenario.sessions, nodes, "sessions", root.diagnostics());
  const Place& place = nodes.empty() ? root.table().place : nodes.front()->place;
  const std::string missing = "expected at least one [[session]] with role = ";
  if (!training)
    root.diagnostics().add("value", "there is no training session, " + missing + "\"training\"", place);
  if (!validation)
    root.diagnostics().add("value", "there is no validation session, " + missing + "\"validation\"", place);
}

void readRoot(const TomlNode& document, const fs::path& directory, Scenario& scenario, Diagnostics& diagnostics) {
  TableReader root(document, "the scenario", diagnostics);
  root.readText("name", scenario.name);
  root.readChoice("motion", scenario.motion, kMotionSources);
  if (const TomlNode* shader = root.find("shader"))
    readShader(*shader, directory, scenario, diagnostics);
  if (const TomlNode* render = root.find("render")) readRender(*render, scenario, diagnostics);
  readObjects(root, scenario);
  readModels(root, directory, scenario);
  scenario.uniforms_place = {scenario.path, 0, 0};
  if (const TomlNode* uniforms = root.find("uniforms")) {
    scenario.uniforms_place = uniforms->place;
    scenario.uniforms = readUniforms(*uniforms, diagnostics);
  }
  readTextures(root, directory, scenario);
  readPasses(root, directory, scenario);
  expectModest(scenario, document.place, diagnostics);
  readSessions(root, scenario);
  root.finish();
}

}  // namespace

Result<Scenario> readScenario(const fs::path& path) {
  REPRISE_ASSIGN(const std::string text, readFile(path));
  REPRISE_ASSIGN(const TomlNode document, parseDocument(text, path.string()));
  Scenario scenario;
  std::error_code status;
  const fs::path absolute = fs::absolute(path, status).lexically_normal();
  scenario.path = absolute.string();
  scenario.name = path.stem().string();
  Diagnostics diagnostics;
  readRoot(document, absolute.parent_path(), scenario, diagnostics);
  sortByPlace(diagnostics);
  if (!diagnostics.errors.empty()) return mergeErrors(std::move(diagnostics.errors));
  REPRISE_TRY(loadModels(scenario));
  REPRISE_TRY(placeModelCameras(scenario));
  REPRISE_ASSIGN(scenario.hash, hashScenario(scenario));
  return scenario;
}

}  // namespace reprise
