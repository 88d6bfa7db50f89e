#include "profiler/scene/disc_texture.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include "profiler/scene/frame_state.h"
#include "profiler/scene/mesh.h"

namespace reprise {
namespace {

struct Patch {
  glm::dvec3 center{0}, normal{0};  // sums, weighted by area
  double area = 0;
};

// The texel pairs of one object.
class ObjectDiscs {
 public:
  ObjectDiscs(const TextureSpec& spec, const Mesh& mesh, const glm::dmat4& placement)
      : spec_(spec), mesh_(mesh), placement_(placement), patches_(static_cast<std::size_t>(spec.discs_u) * spec.discs_v) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) addTriangle(i);
  }

  void append(std::vector<float>& rgba) const {
    Patch whole;
    for (const Patch& patch : patches_) whole.center += patch.center, whole.area += patch.area;
    const glm::dvec3 center = whole.area > 0 ? whole.center / whole.area : whole.center;
    double radius = 0;
    for (const Vertex& vertex : mesh_.vertices) radius = std::max(radius, glm::distance(center, placed(vertex)));
    appendPair(rgba, whole, {0, 0, 0}, radius);
    for (const Patch& patch : patches_)
      appendPair(rgba, patch, glm::length(patch.normal) > 0 ? glm::normalize(patch.normal) : glm::dvec3(0), 0);
  }

 private:
  glm::dvec3 placed(const Vertex& vertex) const {
    return glm::dvec3(placement_ * glm::dvec4(vertex.position[0], vertex.position[1], vertex.position[2], 1));
  }

  void addTriangle(std::size_t first) {
    const Vertex& a = mesh_.vertices[mesh_.indices[first]];
    const Vertex& b = mesh_.vertices[mesh_.indices[first + 1]];
    const Vertex& c = mesh_.vertices[mesh_.indices[first + 2]];
    const auto cell = [](float sum, int count) { return std::clamp(static_cast<int>(sum / 3 * static_cast<float>(count)), 0, count - 1); };
    const int u = cell(a.uv[0] + b.uv[0] + c.uv[0], spec_.discs_u), v = cell(a.uv[1] + b.uv[1] + c.uv[1], spec_.discs_v);
    Patch& patch = patches_[static_cast<std::size_t>(v * spec_.discs_u + u)];
    const glm::dvec3 normal = glm::cross(placed(b) - placed(a), placed(c) - placed(a)) * 0.5;  // as long as the area
    const double area = glm::length(normal);
    patch.center += area / 3 * (placed(a) + placed(b) + placed(c));
    patch.normal += normal;
    patch.area += area;
  }

  static void appendPair(std::vector<float>& rgba, const Patch& patch, const glm::dvec3& normal, double last) {
    const glm::dvec3 center = patch.area > 0 ? patch.center / patch.area : glm::dvec3(0);
    for (const double value : {center.x, center.y, center.z, patch.area, normal.x, normal.y, normal.z, last})
      rgba.push_back(static_cast<float>(value));
  }

  const TextureSpec& spec_;
  const Mesh& mesh_;
  glm::dmat4 placement_;
  std::vector<Patch> patches_;
};

}  // namespace

Result<TextureImage> buildDiscTexture(const Scenario& scenario, const TextureSpec& spec) {
  const FrameState start = evaluateFrame(scenario, SessionSpec{}, 0);
  TextureImage image;
  image.width = 2 + 2 * spec.discs_u * spec.discs_v;
  image.height = static_cast<int>(spec.objects.size());
  image.high_dynamic_range = true;
  for (const std::string& name : spec.objects) {
    const auto object = std::find_if(scenario.objects.begin(), scenario.objects.end(), [&](const Object& one) { return one.name == name && !one.part; });
    if (object == scenario.objects.end())
      return Error{ErrorKind::kInput, "texture.objects",
                   "texture '" + spec.name + "' wants discs of '" + name + "', expected an [[object]] of the scenario", spec.place};
    const auto index = static_cast<std::size_t>(object - scenario.objects.begin());
    const Mesh mesh = buildMesh(object->mesh);
    ObjectDiscs(spec, mesh, spec.object_space ? glm::dmat4(1) : glm::dmat4(start.models[index])).append(image.rgba);
  }
  return image;
}

}  // namespace reprise
