// Parts of glTF files beyond plain indexed triangles: lights, mirrored nodes, sparse accessors, strips and fans, textures, binary files.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "profiler/gltf/read_gltf.h"
#include "tests/gltf/made_gltf.h"

namespace reprise {
namespace {

using nlohmann::json;

json plain() {
  MadeParts parts;
  parts.skinned = parts.morphed = false;
  return madeGltf(parts);
}

GltfScene readWith(const ModelFolder& folder, const json& document) {
  const Result<GltfScene> read = readGltf(folder.write("made.gltf", document.dump()));
  REPRISE_CHECK(read.ok(), formatError(read.error()));
  return *read;
}

const GltfPrimitive& firstOf(const GltfScene& scene) { return primitiveOf(scene, scene.instances.at(0)); }

TEST(GltfLights, KeepKindColorAndCone) {
  json document = plain();
  document["extensionsUsed"] = {"KHR_lights_punctual"};
  document["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"}, {"color", {1, 0.5, 0.25}}, {"intensity", 8}, {"range", 12}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.5}}}},
      {{"type", "directional"}}};
  document["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  const ModelFolder folder;
  const GltfScene scene = readWith(folder, document);
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_EQ(scene.nodes[1].light, 0);
  EXPECT_EQ(scene.nodes[0].light, -1);
  EXPECT_EQ(scene.lights[0].kind, GltfLightKind::kSpot);
  EXPECT_EQ(scene.lights[0].color, (std::array<float, 3>{8, 4, 2}));
  EXPECT_EQ(scene.lights[0].range, 12);
  EXPECT_FLOAT_EQ(scene.lights[0].outer_cone_rad, 0.5f);
  EXPECT_EQ(scene.lights[1].kind, GltfLightKind::kDirectional);
  EXPECT_EQ(scene.lights[1].color, (std::array<float, 3>{1, 1, 1}));
}

TEST(GltfLights, ThatAreNotThereAreRefused) {
  json document = plain();
  document["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 3;
  const ModelFolder folder;
  const Result<GltfScene> read = readGltf(folder.write("made.gltf", document.dump()));
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().code, "gltf.index");
  EXPECT_NE(read.error().message.find("nodes[1].extensions.KHR_lights_punctual.light"), std::string::npos) << read.error().message;
}

TEST(GltfNodes, ThatMirrorTurnTheWindingAround) {
  const ModelFolder folder;
  json document = plain();
  EXPECT_FALSE(readWith(folder, document).instances[0].mirrored);
  document["nodes"][1]["scale"] = {-1, 1, 1};
  EXPECT_TRUE(readWith(folder, document).instances[0].mirrored);
  document["nodes"][0]["scale"] = {1, 1, -2};
  EXPECT_FALSE(readWith(folder, document).instances[0].mirrored) << "two mirrors are none";
}

TEST(GltfAccessors, ThatAreSparseReplaceWhatTheyName) {
  const ModelFolder folder;
  json document = plain();
  const GltfScene before = readWith(folder, document);
  // Vertices 1 and 4 move; two indices of two bytes, then six floats.
  const std::uint16_t indices[] = {1, 4};
  const float moved[] = {9, 8, 7, 6, 5, 4};
  std::string bytes(sizeof indices + sizeof moved, '\0');
  std::memcpy(bytes.data(), indices, sizeof indices);
  std::memcpy(bytes.data() + sizeof indices, moved, sizeof moved);
  folder.write("sparse.bin", bytes);
  document["buffers"].push_back({{"uri", "sparse.bin"}, {"byteLength", bytes.size()}});
  const std::size_t view = document["bufferViews"].size(), buffer = document["buffers"].size() - 1;
  document["bufferViews"].push_back({{"buffer", buffer}, {"byteLength", sizeof indices}});
  document["bufferViews"].push_back({{"buffer", buffer}, {"byteOffset", sizeof indices}, {"byteLength", sizeof moved}});
  document["accessors"][document["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<int>()]["sparse"] = {
      {"count", 2}, {"indices", {{"bufferView", view}, {"componentType", 5123}}}, {"values", {{"bufferView", view + 1}}}};
  const GltfScene after = readWith(folder, document);
  for (std::size_t vertex = 0; vertex < firstOf(before).vertices.size(); ++vertex)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float expected = vertex == 1 ? moved[axis] : vertex == 4 ? moved[3 + axis] : firstOf(before).vertices[vertex].position[axis];
      EXPECT_EQ(firstOf(after).vertices[vertex].position[axis], expected) << vertex;
    }
}

using Triangle = std::array<std::uint32_t, 3>;

// Beginning with the least index, the winding kept.
std::vector<Triangle> trianglesOf(const GltfPrimitive& primitive) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    Triangle triangle = {primitive.indices[i], primitive.indices[i + 1], primitive.indices[i + 2]};
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    triangles.push_back(triangle);
  }
  return triangles;
}

TEST(GltfPrimitives, StripsAndFansAreTriangles) {
  const ModelFolder folder;
  json document = plain();
  const std::vector<Triangle> listed = trianglesOf(firstOf(readWith(folder, document)));
  document["meshes"][0]["primitives"][0].erase("indices");
  document["meshes"][0]["primitives"][0]["mode"] = 5;
  EXPECT_EQ(trianglesOf(firstOf(readWith(folder, document))), listed) << "the bar's vertices are in the order of a strip";
  document["meshes"][0]["primitives"][0]["mode"] = 6;
  // By places: vertices that triangles with different tangents share are written twice.
  const GltfScene read = readWith(folder, document);
  const GltfPrimitive& fan = firstOf(read);
  ASSERT_EQ(fan.indices.size(), 3 * listed.size());
  for (std::uint32_t i = 0; i < listed.size(); ++i)
    for (const auto& [index, expected] : {std::pair{fan.indices[3 * i], i + 1}, {fan.indices[3 * i + 1], i + 2}, {fan.indices[3 * i + 2], 0u}})
      for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_EQ(fan.vertices[index].position[axis], fan.vertices[expected].position[axis]) << "triangle " << i;
}

TEST(GltfMaterials, NameTheirImagesAndSamplers) {
  const ModelFolder folder;
  folder.write("wood.png", "bytes that nobody decodes yet");
  json document = plain();
  document["images"] = {{{"uri", "wood.png"}}};
  document["samplers"] = {{{"magFilter", 9728}, {"wrapS", 33071}}};
  document["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 0}}};
  document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 0;
  document["materials"][0]["occlusionTexture"] = {{"index", 1}, {"strength", 0.5}};
  document["materials"][0]["alphaMode"] = "MASK";
  const GltfScene scene = readWith(folder, document);
  const GltfMaterial& material = scene.materials.at(0);
  ASSERT_EQ(material.base_color_map.image, 0);
  EXPECT_EQ(scene.images.at(0).bytes, "bytes that nobody decodes yet");
  EXPECT_FALSE(material.base_color_map.linear);
  EXPECT_FALSE(material.base_color_map.repeat);
  EXPECT_EQ(material.occlusion_map.image, 0);
  EXPECT_TRUE(material.occlusion_map.linear);
  EXPECT_EQ(material.occlusion_strength, 0.5f);
  EXPECT_EQ(material.normal_map.image, -1);
  EXPECT_EQ(material.alpha_cutoff, 0.5f) << "the default of masks";
  EXPECT_EQ(scene.files, std::vector<std::string>{"wood.png"});
}

std::string decoded(const std::string& base64) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char digit : base64) {
    if (digit == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(digits.find(digit));
    if ((count += 6) < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255);
  }
  return bytes;
}

std::string word(std::size_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> 8 * i & 255);
  return bytes;
}

std::string chunk(const std::string& kind, std::string content, char padding) {
  content.resize((content.size() + 3) / 4 * 4, padding);
  return word(content.size()) + kind + content;
}

TEST(GltfBinaries, HoldWhatTheirTextFormHolds) {
  const ModelFolder folder;
  json document = madeGltf({});
  const GltfScene text = readWith(folder, document);
  const std::string uri = document["buffers"][0]["uri"];
  document["buffers"][0].erase("uri");
  const std::string body = chunk("JSON", document.dump(), ' ') + chunk(std::string("BIN\0", 4), decoded(uri.substr(uri.find(',') + 1)), '\0');
  const Result<GltfScene> binary = readGltf(folder.write("made.glb", "glTF" + word(2) + word(12 + body.size()) + body));
  ASSERT_TRUE(binary.ok()) << formatError(binary.error());
  const GltfPrimitive &one = firstOf(text), &other = firstOf(*binary);
  EXPECT_EQ(one.indices, other.indices);
  ASSERT_EQ(one.vertices.size(), other.vertices.size());
  EXPECT_EQ(std::memcmp(one.vertices.data(), other.vertices.data(), one.vertices.size() * sizeof(Vertex)), 0);
  ASSERT_EQ(one.deform.size(), other.deform.size());
  EXPECT_EQ(std::memcmp(one.deform.data(), other.deform.data(), one.deform.size() * sizeof(DeformVertex)), 0);
  EXPECT_EQ(text.animations.size(), binary->animations.size());
}

}  // namespace
}  // namespace reprise
