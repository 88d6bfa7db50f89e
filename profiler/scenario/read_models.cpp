#include "profiler/scenario/read_models.h"

#include <algorithm>

#include "profiler/gltf/figure.h"
#include "profiler/gltf/read_gltf.h"
#include "profiler/scenario/near_names.h"
#include "profiler/scenario/read_motion.h"
#include "profiler/scenario/read_sections.h"

namespace reprise {
namespace {

constexpr int kMostFigureSegments = 128;

void readSource(TableReader& reader, const std::filesystem::path& directory, ModelSpec& model) {
  Diagnostics& diagnostics = reader.diagnostics();
  std::string kind;
  if (const TomlNode* file = reader.find("file")) {
    std::string text;
    reader.readText("file", text);
    if (!text.empty()) model.path = resolvePath(*file, directory, false, diagnostics);
  } else {
    reader.readText("kind", kind, Need::kRequired);
    if (kind != "figure" && reader.has("kind"))
      diagnostics.add("value", "'kind' of " + reader.what() + " is '" + kind + "', expected 'figure' (or 'file' instead)", reader.find("kind")->place);
    reader.readInteger("segments", model.segments, {3, kMostFigureSegments});
  }
}

ModelSpec readModel(const TomlNode& node, const std::string& what, const std::filesystem::path& directory, Diagnostics& diagnostics) {
  ModelSpec model;
  TableReader reader(node, what, diagnostics);
  readName(reader, model.name);
  model.place = node.place;
  readSource(reader, directory, model);
  if (reader.has("animation")) {
    model.animation.emplace();
    reader.readText("animation", *model.animation);
  } else {
    reader.find("animation");
  }
  reader.readNumber("speed", model.speed);
  reader.readNumber("phase_s", model.phase_s);
  reader.readNumbers("color", model.color, kNotNegative);
  if (const TomlNode* motion = reader.find("motion")) model.motion = readMotion(*motion, "'motion' of model '" + model.name + "'", diagnostics);
  reader.finish();
  return model;
}

Result<void> expectAnimation(const ModelSpec& model) {
  if (!model.animation || model.animation->empty() || animationOf(model) != nullptr) return {};
  std::vector<std::string> names;
  for (const GltfAnimation& animation : model.scene->animations) names.push_back(animation.name);
  return Error{ErrorKind::kInput, "scenario.value", "model '" + model.name + "' has no animation '" + *model.animation + "'" + suggestNames(*model.animation, names),
               model.place};
}

}  // namespace

void readModels(TableReader& root, const std::filesystem::path& directory, Scenario& scenario) {
  const std::vector<const TomlNode*> nodes = root.findTables("model");
  for (const TomlNode* node : nodes) {
    ModelSpec model = readModel(*node, "[[model]] " + std::to_string(scenario.models.size() + 1), directory, root.diagnostics());
    const auto bears = [&](const auto& other) { return other.name == model.name; };
    if (std::any_of(scenario.models.begin(), scenario.models.end(), bears) || std::any_of(scenario.objects.begin(), scenario.objects.end(), bears))
      root.diagnostics().add("value", "there are two models or objects named '" + model.name + "', expected distinct names", node->place);
    scenario.models.push_back(std::move(model));
  }
}

Result<void> loadModels(Scenario& scenario) {
  for (std::size_t m = 0; m < scenario.models.size(); ++m) {
    ModelSpec& model = scenario.models[m];
    for (std::size_t before = 0; before < m && !model.scene; ++before)
      if (scenario.models[before].path == model.path && scenario.models[before].segments == model.segments) model.scene = scenario.models[before].scene;
    if (!model.scene) {
      GltfScene read;
      if (model.path.empty()) {
        read = makeFigure(model.segments);
      } else {
        REPRISE_ASSIGN(read, readGltf(model.path));
      }
      model.scene = std::make_shared<const GltfScene>(std::move(read));
    }
    REPRISE_TRY(expectAnimation(model));
    for (std::size_t instance = 0; instance < model.scene->instances.size(); ++instance) {
      Object object;
      object.name = model.name + "." + std::to_string(instance);
      object.part = ModelPart{m, instance};
      scenario.objects.push_back(std::move(object));
    }
  }
  return {};
}

const GltfAnimation* animationOf(const ModelSpec& model) {
  if (model.scene->animations.empty() || (model.animation && model.animation->empty())) return nullptr;
  if (!model.animation) return &model.scene->animations.front();
  for (const GltfAnimation& animation : model.scene->animations)
    if (animation.name == *model.animation) return &animation;
  return nullptr;
}

}  // namespace reprise
