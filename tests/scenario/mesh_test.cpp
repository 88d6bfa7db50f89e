// Meshes: closed ones are watertight, normals and tangents are unit vectors, and all wind counter-clockwise
// from outside, in space as on the screen.
#include "profiler/scene/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <string>

#include "profiler/scene/frame_state.h"

namespace reprise {
namespace {

struct MeshCase {
  std::string name;
  MeshSpec spec;
  bool closed;
};

MeshSpec ofKind(MeshKind kind, int segments_u, int segments_v) {
  MeshSpec spec;
  spec.kind = kind;
  spec.segments_u = segments_u;
  spec.segments_v = segments_v;
  return spec;
}

MeshSpec vase(std::vector<std::array<float, 2>> profile) {
  MeshSpec spec = ofKind(MeshKind::kRevolution, 24, 30);
  spec.profile = std::move(profile);
  return spec;
}

MeshSpec knot(int p, int q) {
  MeshSpec spec = ofKind(MeshKind::kTorusKnot, 120, 9);
  spec.p = p;
  spec.q = q;
  spec.tube_radius = 0.1f;
  return spec;
}

const std::vector<MeshCase> kMeshes = {
    {"Sphere", ofKind(MeshKind::kSphere, 17, 9), true},
    {"CoarsestSphere", ofKind(MeshKind::kSphere, 3, 2), true},
    {"TorusKnot", ofKind(MeshKind::kTorusKnot, 96, 8), true},
    {"CinquefoilKnot", knot(2, 5), true},
    {"PlainTorus", knot(1, 1), true},
    {"ClosedRevolution", vase({{0, 0}, {0.6f, 0.1f}, {0.5f, 1}, {0.2f, 1.5f}, {0, 1.6f}}), true},
    {"OpenRevolution", vase({{0.3f, 0}, {0.6f, 0.5f}, {0.4f, 1}}), false},
    {"Plane", ofKind(MeshKind::kPlane, 5, 7), false},
    {"DisplacedSphere", ofKind(MeshKind::kDisplacedSphere, 48, 24), true},
    {"Terrain", ofKind(MeshKind::kTerrain, 40, 30), false},
};

class MeshOf : public testing::TestWithParam<MeshCase> {
 protected:
  Mesh mesh_ = buildMesh(GetParam().spec);
};

glm::vec3 positionOf(const Vertex& vertex) {
  return {vertex.position[0], vertex.position[1], vertex.position[2]};
}
glm::vec3 normalOf(const Vertex& vertex) {
  return {vertex.normal[0], vertex.normal[1], vertex.normal[2]};
}
glm::vec3 tangentOf(const Vertex& vertex) {
  return {vertex.tangent[0], vertex.tangent[1], vertex.tangent[2]};
}

std::array<const Vertex*, 3> cornersOf(const Mesh& mesh, std::size_t first_index) {
  return {&mesh.vertices[mesh.indices[first_index]], &mesh.vertices[mesh.indices[first_index + 1]],
          &mesh.vertices[mesh.indices[first_index + 2]]};
}

using Spot = std::array<float, 3>;

Spot spotOf(const Vertex& vertex) {
  // -0 and 0 are one place.
  return {vertex.position[0] + 0.0f, vertex.position[1] + 0.0f, vertex.position[2] + 0.0f};
}

TEST_P(MeshOf, HasWholeTrianglesOfExistingVertices) {
  ASSERT_FALSE(mesh_.indices.empty());
  ASSERT_EQ(mesh_.indices.size() % 3, 0u);
  for (const std::uint32_t index : mesh_.indices) ASSERT_LT(index, mesh_.vertices.size());
}

TEST_P(MeshOf, HasUnitNormalsAndTangentsAtRightAngles) {
  for (const Vertex& vertex : mesh_.vertices) {
    ASSERT_NEAR(glm::length(normalOf(vertex)), 1, 1e-5);
    ASSERT_NEAR(glm::length(tangentOf(vertex)), 1, 1e-5);
    ASSERT_NEAR(glm::dot(normalOf(vertex), tangentOf(vertex)), 0, 1e-5);
    ASSERT_EQ(std::abs(vertex.tangent[3]), 1);
    for (const float value : vertex.uv) ASSERT_TRUE(value >= 0 && value <= 1);
  }
}

TEST_P(MeshOf, WindsCounterClockwiseAboutItsNormals) {
  for (std::size_t i = 0; i < mesh_.indices.size(); i += 3) {
    const auto [a, b, c] = cornersOf(mesh_, i);
    const glm::vec3 face = glm::cross(positionOf(*b) - positionOf(*a), positionOf(*c) - positionOf(*a));
    ASSERT_GT(glm::dot(face, normalOf(*a) + normalOf(*b) + normalOf(*c)), 0) << "triangle " << i / 3;
  }
}

TEST_P(MeshOf, IsWatertightIfClosed) {
  std::map<std::pair<Spot, Spot>, int> edges;
  for (std::size_t i = 0; i < mesh_.indices.size(); i += 3) {
    const auto corners = cornersOf(mesh_, i);
    for (std::size_t k = 0; k < 3; ++k) ++edges[{spotOf(*corners[k]), spotOf(*corners[(k + 1) % 3])}];
  }
  int open_edges = 0;
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    open_edges += edges.count({edge.second, edge.first}) == 0 ? 1 : 0;
  }
  EXPECT_EQ(open_edges == 0, GetParam().closed) << open_edges << " open edges";
}

TEST_P(MeshOf, EnclosesAPositiveVolumeIfClosed) {
  if (!GetParam().closed) return;
  double volume = 0;
  for (std::size_t i = 0; i < mesh_.indices.size(); i += 3) {
    const auto [a, b, c] = cornersOf(mesh_, i);
    volume += glm::dot(positionOf(*a), glm::cross(positionOf(*b), positionOf(*c))) / 6;
  }
  EXPECT_GT(volume, 0);
}

TEST_P(MeshOf, HasTextureCoordinatesOfTheStatedHandedness) {
  int agreeing = 0, counted = 0;
  for (std::size_t i = 0; i < mesh_.indices.size(); i += 3) {
    const auto [a, b, c] = cornersOf(mesh_, i);
    const glm::vec3 e1 = positionOf(*b) - positionOf(*a), e2 = positionOf(*c) - positionOf(*a);
    const float du1 = b->uv[0] - a->uv[0], dv1 = b->uv[1] - a->uv[1], du2 = c->uv[0] - a->uv[0],
                dv2 = c->uv[1] - a->uv[1];
    const float determinant = du1 * dv2 - du2 * dv1;
    if (std::abs(determinant) < 1e-9f) continue;
    const glm::vec3 along_v = (e2 * du1 - e1 * du2) / determinant;
    const glm::vec3 bitangent = glm::cross(normalOf(*a), tangentOf(*a)) * a->tangent[3];
    agreeing += glm::dot(along_v, bitangent) > 0 ? 1 : 0;
    ++counted;
  }
  EXPECT_GT(counted, 0);
  EXPECT_GE(agreeing, counted * 95 / 100);
}

// The Vulkan specification's area of a polygon, in framebuffer coordinates: positive is counter-clockwise.
float vulkanArea(const std::array<glm::vec3, 3>& corners) {
  float sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::vec3 &a = corners[i], &b = corners[(i + 1) % 3];
    sum += a.x * b.y - b.x * a.y;
  }
  return -0.5f * sum;
}

TEST_P(MeshOf, FacesTheCameraCounterClockwiseOnTheScreen) {
  for (const bool orthographic : {false, true}) {
    for (const bool reverse_z : {false, true}) {
      Scenario scenario;
      scenario.objects.resize(1);
      SessionSpec session;
      session.camera.path = TrackPath{FixedTrack{{1.1f, 5.3f, 4.2f}}, FixedTrack{{0, 0, 0}}};
      session.camera.orthographic = orthographic;
      session.camera.reverse_z = reverse_z;
      const FrameState state = evaluateFrame(scenario, session, 0);
      int front = 0;
      for (std::size_t i = 0; i < mesh_.indices.size(); i += 3) {
        const auto corners = cornersOf(mesh_, i);
        std::array<glm::vec3, 3> screen;
        for (std::size_t k = 0; k < 3; ++k) {
          const glm::vec4 clip =
              state.projection * state.view * state.models[0] * glm::vec4(positionOf(*corners[k]), 1);
          screen[k] = glm::vec3(clip) / clip.w;
        }
        const glm::vec3 a = positionOf(*corners[0]);
        const glm::vec3 face = glm::cross(positionOf(*corners[1]) - a, positionOf(*corners[2]) - a);
        const glm::vec3 to_camera = orthographic ? state.camera_position : state.camera_position - a;
        const float facing = glm::dot(glm::normalize(face), glm::normalize(to_camera));
        if (std::abs(facing) < 1e-3f) continue;
        ASSERT_EQ(vulkanArea(screen) > 0, (facing > 0) == kFrontFaceCounterClockwise) << "triangle " << i / 3;
        front += facing > 0 ? 1 : 0;
      }
      EXPECT_GT(front, 0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, MeshOf, testing::ValuesIn(kMeshes),
                         [](const auto& each) { return each.param.name; });

TEST(Mesh, SphereHasItsRadius) {
  MeshSpec spec = ofKind(MeshKind::kSphere, 16, 8);
  spec.radius = 2.5f;
  for (const Vertex& vertex : buildMesh(spec).vertices)
    EXPECT_NEAR(glm::length(positionOf(vertex)), 2.5, 1e-5);
}

TEST(Mesh, RevolutionPassesThroughItsProfile) {
  MeshSpec spec = vase({{0.3f, -1}, {0.7f, 0}, {0.2f, 2}});
  spec.segments_v = 2;  // rows at the points themselves
  const Mesh mesh = buildMesh(spec);
  for (std::size_t row = 0; row < 3; ++row) {
    const Vertex& vertex = mesh.vertices[row * static_cast<std::size_t>(spec.segments_u + 1)];
    EXPECT_NEAR(std::hypot(vertex.position[0], vertex.position[2]), spec.profile[row][0], 1e-6);
    EXPECT_NEAR(vertex.position[1], spec.profile[row][1], 1e-6);
  }
}

TEST(Mesh, TerrainFollowsItsSeedAndHeight) {
  MeshSpec spec = ofKind(MeshKind::kTerrain, 20, 20);
  const auto heights = [](const MeshSpec& terrain) {
    std::vector<float> values;
    for (const Vertex& vertex : buildMesh(terrain).vertices) values.push_back(vertex.position[1]);
    return values;
  };
  const std::vector<float> first = heights(spec);
  EXPECT_EQ(first, heights(spec));
  EXPECT_GT(*std::max_element(first.begin(), first.end()),
            *std::min_element(first.begin(), first.end()) + 0.05f);
  spec.seed = 2;
  EXPECT_NE(first, heights(spec));
  spec.height = 0;
  for (const float height : heights(spec)) EXPECT_EQ(height, 0);
}

}  // namespace
}  // namespace reprise
