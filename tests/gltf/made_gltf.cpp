#include "tests/gltf/made_gltf.h"

#include <stdlib.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "runtime/base/file.h"

namespace reprise {
namespace {

using nlohmann::json;

constexpr int kRows = 9;  // of two vertices each

std::string base64(const std::string& bytes) {
  static const char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t j = 0; j < 3; ++j) word = word << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0u);
    for (std::size_t j = 0; j < 4; ++j) text += i + j > bytes.size() ? '=' : kDigits[word >> (18 - 6 * j) & 63];
  }
  return text;
}

class Writer {
 public:
  template <typename T>
  int add(const std::string& name, const std::vector<T>& values, const std::string& type, int components, int component_type) {
    json& document = json_;
    document["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", values.size() * sizeof(T)}});
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    json accessor = {{"bufferView", document["bufferViews"].size() - 1}, {"componentType", component_type}, {"count", values.size() / static_cast<std::size_t>(components)}, {"type", type}};
    if (name == "POSITION") accessor["min"] = {-10, -10, -10}, accessor["max"] = {10, 10, 10};
    document["accessors"].push_back(accessor);
    document["extras"][name] = document["accessors"].size() - 1;
    return static_cast<int>(document["accessors"].size() - 1);
  }
  int floats(const std::string& name, const std::vector<float>& values, const std::string& type, int components) { return add(name, values, type, components, 5126); }

  json finish() {
    json_["buffers"] = {{{"byteLength", bytes_.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes_)}}};
    return json_;
  }
  json json_ = {{"asset", {{"version", "2.0"}}}};

 private:
  std::string bytes_;
};

struct Bar {
  std::vector<float> positions, normals, uvs, colors, weights;
  std::vector<std::uint8_t> joints;
  std::vector<std::uint16_t> indices;
};

Bar makeBar() {
  Bar bar;
  for (int i = 0; i < 2 * kRows; ++i) {
    const float height = static_cast<float>(i / 2) / (kRows - 1), side = i % 2 == 0 ? -0.2f : 0.2f;
    for (const float value : {side, height, 0.0f}) bar.positions.push_back(value);
    for (const float value : {0.0f, 0.0f, 1.0f}) bar.normals.push_back(value);
    for (const float value : {side + 0.2f, 1 - height}) bar.uvs.push_back(value);
    for (const float value : {static_cast<float>(i), 0.0f, 0.0f, 1.0f}) bar.colors.push_back(value);
    for (const float value : {1 - height, height, 0.0f, 0.0f}) bar.weights.push_back(value);
    for (const int value : {0, 1, 0, 0}) bar.joints.push_back(static_cast<std::uint8_t>(value));
    // Each vertex begins a triangle, so that flat inputs show it.
    if (i + 2 >= 2 * kRows) continue;
    const std::uint16_t a = static_cast<std::uint16_t>(i), b = static_cast<std::uint16_t>(i + 1), c = static_cast<std::uint16_t>(i + 2);
    for (const std::uint16_t index : {a, i % 2 == 0 ? b : c, i % 2 == 0 ? c : b}) bar.indices.push_back(index);
  }
  return bar;
}

std::vector<float> bulge(int target) {
  std::vector<float> deltas;
  for (int i = 0; i < 2 * kRows; ++i)
    for (const float value : {0.05f * static_cast<float>(target + 1) * (i % 2 == 0 ? -1.0f : 1.0f), 0.0f, 0.1f * std::sin(static_cast<float>(i + target))}) deltas.push_back(value);
  return deltas;
}

// Keys of a channel, tripled for cubic splines.
std::vector<float> keys(const std::vector<std::vector<float>>& values, bool cubic) {
  std::vector<float> all;
  for (const std::vector<float>& value : values) {
    for (const float v : value) if (cubic) all.push_back(0.1f * v);
    all.insert(all.end(), value.begin(), value.end());
    for (const float v : value) if (cubic) all.push_back(-0.2f * v);
  }
  return all;
}

void addAnimation(const MadeParts& parts, Writer& writer) {
  const bool cubic = std::string(parts.interpolation) == "CUBICSPLINE";
  const int times = writer.floats("times", {0, 0.3f, 0.7f}, "SCALAR", 1);
  json animation = {{"name", "all"}, {"samplers", json::array()}, {"channels", json::array()}};
  const auto channel = [&](int node, const std::string& path, int output) {
    animation["samplers"].push_back({{"input", times}, {"output", output}, {"interpolation", parts.interpolation}});
    animation["channels"].push_back({{"sampler", animation["samplers"].size() - 1}, {"target", {{"node", node}, {"path", path}}}});
  };
  channel(0, "translation", writer.floats("moves", keys({{0, 0, 0}, {0.2f, 0, 0.1f}, {0, 0.1f, 0}}, cubic), "VEC3", 3));
  channel(3, "rotation", writer.floats("turns", keys({{0, 0, 0, 1}, {0, 0, 0.38268343f, 0.92387953f}, {0.1305262f, 0, 0, 0.9914449f}}, cubic), "VEC4", 4));
  if (parts.morphed) {
    std::vector<std::vector<float>> weights(3);
    for (int key = 0; key < 3; ++key)
      for (int t = 0; t < parts.targets; ++t) weights[static_cast<std::size_t>(key)].push_back(0.3f * static_cast<float>((key + t) % 3));
    channel(1, "weights", writer.floats("weights", keys(weights, cubic), "SCALAR", 1));
  }
  writer.json_["animations"] = {animation};
}

}  // namespace

json madeGltf(const MadeParts& parts) {
  const Bar bar = makeBar();
  Writer writer;
  json attributes = {{"POSITION", writer.floats("POSITION", bar.positions, "VEC3", 3)}};
  if (parts.normals) attributes["NORMAL"] = writer.floats("NORMAL", bar.normals, "VEC3", 3);
  attributes["TEXCOORD_0"] = writer.floats("TEXCOORD_0", bar.uvs, "VEC2", 2);
  attributes["COLOR_0"] = writer.floats("COLOR_0", bar.colors, "VEC4", 4);
  json primitive = {{"indices", writer.add("indices", bar.indices, "SCALAR", 1, 5123)}, {"material", 0}};
  if (parts.skinned) {
    attributes["JOINTS_0"] = writer.add("JOINTS_0", bar.joints, "VEC4", 4, 5121);
    attributes["WEIGHTS_0"] = writer.floats("WEIGHTS_0", bar.weights, "VEC4", 4);
  }
  primitive["attributes"] = attributes;
  for (int target = 0; parts.morphed && target < parts.targets; ++target)
    primitive["targets"].push_back({{"POSITION", writer.floats("target" + std::to_string(target), bulge(target), "VEC3", 3)}});
  json& document = writer.json_;
  document["meshes"] = {{{"primitives", {primitive}}}};
  document["materials"] = {{{"doubleSided", true}, {"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 1, 1}}, {"roughnessFactor", 0.5}}}}};
  json mesh_node = {{"mesh", 0}};
  if (parts.skinned) {
    mesh_node["skin"] = 0;
    // The second joint turns about the middle of the bar.
    document["skins"] = {{{"joints", {2, 3}},
                          {"inverseBindMatrices", writer.floats("inverse_bind", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -0.5f, 0, 1}, "MAT4", 16)}}};
  }
  document["nodes"] = {{{"children", {1, 2}}}, mesh_node, {{"children", {3}}}, {{"translation", {0, 0.5, 0}}}};
  document["scenes"] = {{{"nodes", {0}}}};
  document["scene"] = 0;
  addAnimation(parts, writer);
  return writer.finish();
}

ModelFolder::ModelFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "reprise-model-XXXXXX").string();
  path_ = ::mkdtemp(name.data());
}

ModelFolder::~ModelFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path ModelFolder::write(const std::string& name, const std::string& content) const {
  REPRISE_CHECK(writeFile(path_ / name, content).ok(), name);
  return path_ / name;
}

}  // namespace reprise
