// glTF 2.0 files (.gltf, .glb; buffers and images in the file, beside it, or as data URIs) as GltfScene.
//
// Normals that are absent are those of the triangles; tangents that are absent and wanted by a normal map are MikkTSpace's
// (tangents.h). Triangle strips and fans become triangles. Left out with a warning: points and lines, texture coordinates beyond the first,
// morph targets beyond the kMorphTargets that move the most, joints beyond four a vertex,
// extensions of materials (undrawn_extensions.h). Files that belong to the model must lie in its folder or below.
#pragma once

#include <filesystem>

#include "profiler/gltf/gltf_scene.h"
#include "runtime/base/result.h"

namespace reprise {

inline constexpr std::size_t kMostGltfBytes = std::size_t{1} << 30;      // of one file
inline constexpr std::size_t kMostGltfVertices = std::size_t{1} << 23;   // of all primitives together
inline constexpr std::size_t kMostGltfNodes = 1 << 16;
inline constexpr std::size_t kMostGltfInstances = 1024;
inline constexpr std::size_t kMostJoints = 256;

// Errors (kInput), the message beginning with the JSON path where there is one ("meshes[0].primitives[1].attributes.POSITION"):
//   those of readFile, of kMostGltfBytes
//   gltf.syntax     no glTF 2.0, or one that its reader refuses
//   gltf.limit      larger than the limits above, or nested too deeply
//   gltf.uri        a file outside the model's folder, or one that is not there or cannot be read
//   gltf.index      an index that names nothing
//   gltf.accessor   an accessor of the wrong kind or beyond its buffer view
//   gltf.nodes      nodes that are their own ancestors or have two parents
//   gltf.value      a number that is not finite or out of its range
//   gltf.extension  an extension that the file requires and that is not known here (KHR_lights_punctual, KHR_mesh_quantization are)
//   gltf.empty      no triangles
Result<GltfScene> readGltf(const std::filesystem::path& path);

}  // namespace reprise
