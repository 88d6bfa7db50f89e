#include "cli/model_scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <glm/geometric.hpp>

#include "profiler/gltf/pose.h"
#include "profiler/gltf/read_gltf.h"

namespace reprise {
namespace {

constexpr const char* kScenario = R"(name = "{name}"

[render]
width = 640
height = 360
frames = 48
periods = [1, 2, 4, 8, 16]
cull = "{cull}"
clear = [0.05, 0.06, 0.08, 1]

[[model]]
name = "model"
file = "{file}"
{sun}
[[session]]
name = "orbit"
role = "training"
camera = {{ orbit = {{ target = {center}, radius = {near_distance}, height = {rise}, radians_per_frame = 0.02 }}, near = {near}, far = {far} }}

[[session]]
name = "approach"
role = "training"

[session.camera]
eye = {{ oscillate = {{ base = {base}, amplitude = {amplitude}, period_s = 1.6, phase_rad = 1.5708 }} }}
target = {center}
handheld = {{ move = {shake}, turn_deg = 0.3, seed = 3 }}
near = {near}
far = {far}

[[session]]
name = "other_orbit"
role = "validation"
camera = {{ orbit = {{ target = {center}, radius = {far_distance}, height = {high}, start_rad = 2.0, radians_per_frame = -0.02 }}, near = {near}, far = {far} }}
speed = 1.5

[[session]]
name = "walk"
role = "validation"
speed = 0.75

[session.camera]
eye = {{ random_walk = {{ base = {walk}, extent = {extent}, step_per_s = {step}, seed = 7 }} }}
target = {center}
handheld = {{ move = {shake}, turn_deg = 0.3, seed = 11 }}
near = {near}
far = {far}
)";

// For models without lights of their own: high, to the right and in front.
constexpr const char* kSun = R"(
[[pass]]
name = "shadow_map"
kind = "shadow"
color = [3.0, 2.9, 2.7]
light = {{ eye = {eye}, target = {center}, orthographic = true, ortho_height = {height}, near = {near}, far = {far} }}
)";

std::string vectorText(const glm::vec3& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

std::string escaped(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') out += '\\';
    out += letter;
  }
  return out;
}

std::string sunText(const GltfScene& scene, const glm::vec3& center, float radius) {
  const bool lit = std::any_of(scene.nodes.begin(), scene.nodes.end(), [](const GltfNode& node) { return node.light >= 0; });
  if (lit) return "";
  using namespace fmt::literals;
  return fmt::format(fmt::runtime(kSun), "eye"_a = vectorText(center + 3 * radius * glm::normalize(glm::vec3(0.5f, 1, 0.6f))), "center"_a = vectorText(center),
                     "height"_a = 2.1f * radius, "near"_a = 1.5f * radius, "far"_a = 4.5f * radius);
}

std::string nameFrom(const std::filesystem::path& path) {
  std::string name = path.stem().string();
  for (char& letter : name)
    if (!std::isalnum(static_cast<unsigned char>(letter))) letter = '_';
  return name;
}

}  // namespace

bool isModelFile(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension == ".gltf" || extension == ".glb";
}

Result<std::string> modelScenario(const std::filesystem::path& model) {
  REPRISE_ASSIGN(const GltfScene scene, readGltf(model));
  const GltfBounds bounds = boundsOf(scene, scene.animations.empty() ? nullptr : &scene.animations.front());
  const glm::vec3 center = (bounds.low + bounds.high) * 0.5f;
  const float radius = std::max(glm::length(bounds.high - bounds.low) * 0.5f, 1e-4f);
  const bool double_sided = std::any_of(scene.materials.begin(), scene.materials.end(), [](const GltfMaterial& m) { return m.double_sided; });
  using namespace fmt::literals;
  return fmt::format(
      fmt::runtime(kScenario), "name"_a = nameFrom(model), "cull"_a = double_sided ? "none" : "back", "file"_a = escaped(std::filesystem::absolute(model).string()),
      "sun"_a = sunText(scene, center, radius),
      "center"_a = vectorText(center), "near_distance"_a = 2.1f * radius, "rise"_a = 0.6f * radius, "far_distance"_a = 2.5f * radius,
      "high"_a = 1.1f * radius, "near"_a = 0.05f * radius, "far"_a = 40 * radius, "base"_a = vectorText(center + radius * glm::vec3(0.3f, 0.6f, 3.6f)),
      "amplitude"_a = vectorText(radius * glm::vec3(0.1f, 0.2f, 1.5f)), "walk"_a = vectorText(center + radius * glm::vec3(-0.5f, 0.5f, 2.6f)),
      "extent"_a = vectorText(radius * glm::vec3(1.0f, 0.4f, 0.6f)), "step"_a = 2.5f * radius,
      "shake"_a = 0.005f * radius);
}

}  // namespace reprise
