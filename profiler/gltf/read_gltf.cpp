#include "profiler/gltf/read_gltf.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <glm/matrix.hpp>

#include "profiler/gltf/gltf_parts.h"
#include "profiler/gltf/pose.h"
#include "runtime/base/file.h"
#include "runtime/base/hash.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

constexpr int kMostNesting = 64;

// What the reader's call-backs share: where files may lie, which were read, and why one was not.
struct Folder {
  fs::path root;
  std::vector<std::string> files;
  std::vector<std::string> hashes;
  std::string refusal;
};

bool liesWithin(const fs::path& relative) {
  return !relative.empty() && relative.is_relative() && *relative.begin() != "..";
}

bool readWithin(std::vector<unsigned char>* out, std::string* message, const std::string& name, void* user) {
  auto& folder = *static_cast<Folder*>(user);
  const fs::path relative = fs::path(name).lexically_normal();
  const auto refuse = [&](const std::string& reason) {
    folder.refusal = "'" + name + "' " + reason;
    if (message) *message += folder.refusal;
    return false;
  };
  if (!liesWithin(relative)) return refuse("lies outside the model's folder");
  const Result<std::string> bytes = readFile(folder.root / relative, kMostGltfBytes);
  if (!bytes.ok()) return refuse("cannot be read: " + bytes.error().message);
  out->assign(bytes->begin(), bytes->end());
  if (std::find(folder.files.begin(), folder.files.end(), relative.generic_string()) == folder.files.end()) {
    folder.files.push_back(relative.generic_string());
    folder.hashes.push_back(contentHash(*bytes));
  }
  return true;
}

bool isWithin(const std::string& name, void* user) {
  auto& folder = *static_cast<Folder*>(user);
  std::error_code status;
  if (!liesWithin(fs::path(name).lexically_normal())) {
    folder.refusal = "'" + name + "' lies outside the model's folder";
    return false;
  }
  if (fs::exists(folder.root / name, status)) return true;
  folder.refusal = "there is no file '" + name + "'";
  return false;
}

// Images stay encoded. Those in buffer views are fetched later, when their ranges have been checked.
bool keepEncoded(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes, int size, void*) {
  if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
  image->as_is = true;
  return true;
}

std::string_view jsonOf(const std::string& bytes, bool binary) {
  if (!binary) return bytes;
  if (bytes.size() < 20) return {};
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, 4);
  return std::string_view(bytes).substr(20, length);
}

// tinygltf reads by recursion.
bool nestsTooDeeply(std::string_view json) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char letter = json[i];
    if (quoted && letter == '\\') {
      ++i;
    } else if (letter == '"') {
      quoted = !quoted;
    } else if (!quoted && (letter == '{' || letter == '[')) {
      if (++depth > kMostNesting) return true;
    } else if (!quoted && (letter == '}' || letter == ']')) {
      --depth;
    }
  }
  return false;
}

std::string oneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

Result<tinygltf::Model> load(const std::string& bytes, Folder& folder) {
  const bool binary = bytes.starts_with("glTF");
  if (nestsTooDeeply(jsonOf(bytes, binary))) return gltfError("limit", "the file", "its JSON is nested more than " + std::to_string(kMostNesting) + " deep");
  tinygltf::TinyGLTF reader;
  reader.SetImageLoader(keepEncoded, nullptr);
  reader.SetFsCallbacks({isWithin, [](const std::string& name, void*) { return name; }, readWithin, nullptr, &folder});
  tinygltf::Model model;
  std::string errors, warnings;
  const auto size = static_cast<unsigned int>(bytes.size());
  const bool loaded = binary ? reader.LoadBinaryFromMemory(&model, &errors, &warnings, reinterpret_cast<const unsigned char*>(bytes.data()), size)
                             : reader.LoadASCIIFromString(&model, &errors, &warnings, bytes.data(), size, "");
  if (!folder.refusal.empty()) return gltfError("uri", "the file", folder.refusal);
  if (!loaded) return gltfError("syntax", "the file", errors.empty() ? "it is no glTF 2.0" : oneLine(errors));
  for (const std::string& extension : model.extensionsRequired)
    if (extension != "KHR_lights_punctual" && extension != "KHR_mesh_quantization")
      return gltfError("extension", "extensionsRequired", "'" + extension + "' is not known here");
  return model;
}

void markMirrored(GltfScene& scene) {
  const GltfPose rest = poseAt(scene, nullptr, 0);
  for (GltfInstance& instance : scene.instances)
    instance.mirrored = instance.skin < 0 && glm::determinant(rest.nodes[static_cast<std::size_t>(instance.node)]) < 0;
}

Result<GltfScene> sceneOf(const std::string& bytes, Folder& folder) {
  REPRISE_ASSIGN(const tinygltf::Model model, load(bytes, folder));
  GltfScene scene;
  REPRISE_TRY(readMaterials(model, scene));
  REPRISE_TRY(readMeshes(model, scene));
  REPRISE_TRY(readNodes(model, scene));
  REPRISE_TRY(readAnimations(model, scene));
  markMirrored(scene);
  scene.files = folder.files;
  std::string all = contentHash(bytes);
  for (const std::string& hash : folder.hashes) all += hash;
  scene.hash = contentHash(all);
  return scene;
}

}  // namespace

Result<GltfScene> readGltf(const fs::path& path) {
  const auto placed = [&](Error error) {
    error.place.file = path.string();
    return error;
  };
  REPRISE_ASSIGN(const std::string bytes, readFile(path, kMostGltfBytes));
  Folder folder{path.parent_path(), {}, {}, {}};
  Result<GltfScene> scene = sceneOf(bytes, folder);
  if (!scene.ok()) return placed(scene.error());
  return scene;
}

}  // namespace reprise
