#include "profiler/scenario/read_passes.h"

#include <algorithm>

#include "profiler/scenario/near_names.h"
#include "profiler/scenario/passes.h"
#include "profiler/scenario/read_camera.h"
#include "profiler/scenario/read_motion.h"
#include "profiler/scenario/read_sections.h"

namespace reprise {
namespace {

constexpr std::size_t kMostPasses = 16;
constexpr std::size_t kMostOutputs = 8;

// The nodes of an array; reports what is none.
const std::vector<TomlNode>& elementsOf(TableReader& reader, const TomlNode& node, const std::string& key) {
  if (node.kind != NodeKind::kArray)
    reader.diagnostics().add("type", "'" + key + "' of " + reader.what() + " is " + describeNode(node) + ", expected an array", node.place);
  return node.elements;
}

void readObjectNames(TableReader& reader, const Scenario& scenario, PassSpec& pass) {
  const TomlNode* node = reader.find("objects");
  if (!node) return;
  std::vector<std::string> known;
  for (const Object& object : scenario.objects) known.push_back(object.name);
  for (const ModelSpec& model : scenario.models) known.push_back(model.name);
  for (const TomlNode& element : elementsOf(reader, *node, "objects")) {
    if (element.kind != NodeKind::kText || std::find(known.begin(), known.end(), element.text) == known.end())
      reader.diagnostics().add("value", "an object of " + reader.what() + " is " + describeNode(element) + suggestNames(element.text, known), element.place);
    pass.objects.push_back(element.text);
  }
}

void readShadow(TableReader& reader, const Scenario& scenario, PassSpec& pass) {
  if (const TomlNode* light = reader.find("light", Need::kRequired)) {
    pass.light = readCamera(*light, "'light' of " + reader.what(), std::filesystem::path(scenario.path).parent_path(), reader.diagnostics());
    if (pass.light.reverse_z)
      reader.diagnostics().add("value", "'light' of " + reader.what() + " has reverse_z, which shadow maps do without", light->place);
  }
  reader.readNumbers("color", pass.color, kNotNegative);
  reader.readUnsigned("size", pass.size, {16, kMaxResolution});
  reader.readNumber("slope_bias", pass.slope_bias, kNotNegative);
  readObjectNames(reader, scenario, pass);
}

std::string readExisting(TableReader& reader, const std::string& key, const std::filesystem::path& directory, Need need) {
  const TomlNode* node = reader.find(key, need);
  std::string text;
  reader.readText(key, text);
  return text.empty() ? text : resolvePath(*node, directory, key == "package", reader.diagnostics());
}

void readOutputs(TableReader& reader, PassSpec& pass) {
  const TomlNode* node = reader.find("outputs", Need::kRequired);
  if (!node) return;
  const std::vector<TomlNode>& elements = elementsOf(reader, *node, "outputs");
  if (node->kind == NodeKind::kArray && (elements.empty() || elements.size() > kMostOutputs))
    reader.diagnostics().add("value", "'outputs' of " + reader.what() + " has " + std::to_string(elements.size()) + " tables, expected 1 to " +
                                          std::to_string(kMostOutputs), node->place);
  const std::vector<std::string> formats(std::begin(kColorFormats), std::end(kColorFormats));
  for (const TomlNode& element : elements) {
    PassOutput output;
    TableReader table(element, "an output of " + reader.what(), reader.diagnostics());
    table.readText("texture", output.texture, Need::kRequired);
    table.readText("format", output.format);
    if (std::find(formats.begin(), formats.end(), output.format) == formats.end())
      reader.diagnostics().add("value", "'format' of " + table.what() + " is '" + output.format + "'" + suggestNames(output.format, formats), element.place);
    table.readBoolean("linear", output.linear);
    table.finish();
    pass.outputs.push_back(std::move(output));
  }
}

PassSpec readPass(const TomlNode& node, const std::filesystem::path& directory, const Scenario& scenario, Diagnostics& diagnostics) {
  PassSpec pass;
  TableReader reader(node, "[[pass]] " + std::to_string(scenario.passes.size() + 1), diagnostics);
  readName(reader, pass.name);
  pass.place = node.place;
  const std::size_t errors_before = diagnostics.errors.size();
  if (!reader.has("kind")) reader.find("kind", Need::kRequired);
  reader.readChoice("kind", pass.kind, kScenePassKinds);
  if (diagnostics.errors.size() != errors_before) return pass;
  if (pass.kind == ScenePassKind::kShadow) {
    readShadow(reader, scenario, pass);
  } else {
    pass.fragment_path = readExisting(reader, "fragment", directory, Need::kRequired);
    pass.vertex_path = readExisting(reader, "vertex", directory, Need::kOptional);
    pass.package = readExisting(reader, "package", directory, Need::kOptional);
    reader.readText("depth", pass.depth_texture);
    readOutputs(reader, pass);
  }
  reader.finish();
  return pass;
}

// One name stands for one texture, whoever makes it.
void expectFreshTextures(const Scenario& scenario, const PassSpec& pass, Diagnostics& diagnostics) {
  std::vector<std::string> own;
  for (const std::string& name : texturesOf(pass)) {
    const bool given = std::any_of(scenario.textures.begin(), scenario.textures.end(), [&](const TextureSpec& texture) { return texture.name == name; });
    if (given || findPassTexture(scenario, name) || std::find(own.begin(), own.end(), name) != own.end())
      diagnostics.add("value", "there are two textures named '" + name + "', one of them of pass '" + pass.name + "'; expected distinct names", pass.place);
    own.push_back(name);
  }
}

void checkSources(const Scenario& scenario, Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const PassSpec& pass : scenario.passes) names.push_back(pass.name);
  for (const UniformBinding& binding : scenario.uniforms) {
    const auto* source = std::get_if<PassSource>(&binding.source);
    if (source && !findPass(scenario, source->pass))
      diagnostics.add("value", "uniform '" + binding.member + "' is bound to the pass '" + source->pass + "', which is not there" + suggestNames(source->pass, names),
                      binding.place);
  }
}

}  // namespace

void readPasses(TableReader& root, const std::filesystem::path& directory, Scenario& scenario) {
  const std::vector<const TomlNode*> nodes = root.findTables("pass");
  if (nodes.size() > kMostPasses)
    root.diagnostics().add("value", "there are " + std::to_string(nodes.size()) + " passes, expected at most " + std::to_string(kMostPasses), nodes.back()->place);
  for (const TomlNode* node : nodes) {
    PassSpec pass = readPass(*node, directory, scenario, root.diagnostics());
    if (findPass(scenario, pass.name))
      root.diagnostics().add("value", "there are two passes named '" + pass.name + "', expected distinct names", node->place);
    expectFreshTextures(scenario, pass, root.diagnostics());
    scenario.passes.push_back(std::move(pass));
  }
  checkSources(scenario, root.diagnostics());
}

std::optional<PassSource> readPassSource(const TomlNode& node, const std::string& what, Diagnostics& diagnostics) {
  if (node.kind != NodeKind::kTable) return std::nullopt;
  for (const auto& named : kPassSources) {
    const bool has = std::any_of(node.entries.begin(), node.entries.end(), [&](const Entry& entry) { return entry.key == named.name; });
    if (!has) continue;
    PassSource source{"", named.value};
    TableReader reader(node, what, diagnostics);
    reader.readText(named.name, source.pass, Need::kRequired);
    reader.finish();
    return source;
  }
  return std::nullopt;
}

}  // namespace reprise
