// A small glTF document as JSON, for tests to change and write: a bar of vertices that is skinned to two joints and morphed, on a node that
// moves, with an animation of all of it. Vertex i has COLOR_0 (i, 0, 0, 1), so that a shader can tell which it is.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace reprise {

struct MadeParts {
  bool skinned = true, morphed = true;
  bool normals = true;
  const char* interpolation = "LINEAR";
  int targets = 2;
};

// meshes[0].primitives[0]; nodes: 0 holder, 1 mesh, 2 and 3 joints. accessors are listed by name under "extras".
nlohmann::json madeGltf(const MadeParts& parts);

// A folder of its own that is removed with it.
class ModelFolder {
 public:
  ModelFolder();
  ~ModelFolder();
  ModelFolder(const ModelFolder&) = delete;
  ModelFolder& operator=(const ModelFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path path_;
};

}  // namespace reprise
