// libFuzzer target: any bytes as a glTF file. What is read can be posed in the middle of each animation, and every index holds.
#include "profiler/gltf/pose.h"
#include "profiler/gltf/read_gltf.h"
#include "runtime/base/check.h"
#include "tests/fuzz/fuzz_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const reprise::FuzzFolder folder;
  const std::filesystem::path file = folder.write("given.gltf", {reinterpret_cast<const char*>(data), size});
  const reprise::Result<reprise::GltfScene> scene = reprise::readGltf(file);
  if (!scene.ok()) {
    REPRISE_CHECK(!scene.error().code.empty() && !scene.error().message.empty(), scene.error().code);
    return 0;
  }
  for (const reprise::GltfMesh& mesh : scene->meshes)
    for (const reprise::GltfPrimitive& primitive : mesh.primitives) {
      for (const std::uint32_t index : primitive.indices) REPRISE_CHECK(index < primitive.vertices.size(), index);
      REPRISE_CHECK(primitive.material < static_cast<int>(scene->materials.size()), primitive.material);
      REPRISE_CHECK(primitive.deform.empty() || primitive.deform.size() == primitive.vertices.size(), primitive.deform.size());
    }
  const reprise::GltfPose rest = reprise::poseAt(*scene, nullptr, 0);
  REPRISE_CHECK(rest.nodes.size() == scene->nodes.size(), rest.nodes.size());
  for (const reprise::GltfAnimation& animation : scene->animations) (void)reprise::poseAt(*scene, &animation, 0.5f);
  return 0;
}
