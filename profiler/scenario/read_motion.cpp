#include "profiler/scenario/read_motion.h"

#include <cmath>
#include <numeric>

namespace reprise {

void readTrackAt(TableReader& reader, const std::string& key, Track& track, Need need) {
  const TomlNode* node = reader.find(key, need);
  if (!node) return;
  const std::string what = "'" + key + "' of " + reader.what();
  if (std::optional<Track> read = readTrack(*node, what, 3, reader.diagnostics())) track = *read;
}

void readDirection(TableReader& reader, const std::string& key, std::array<float, 3>& direction) {
  reader.readNumbers(key, direction);
  if (std::hypot(direction[0], direction[1], direction[2]) > 1e-6f) return;
  reader.diagnostics().add("value",
                           "'" + key + "' of " + reader.what() + " has no length, expected a direction",
                           reader.find(key)->place);
}

namespace {

// One number stands for the same scale along all axes.
void readScale(TableReader& reader, Track& scale) {
  const TomlNode* node = reader.find("scale");
  if (!node || !node->isNumber()) return readTrackAt(reader, "scale", scale);
  float factor = 1;
  reader.readNumber("scale", factor, kPositive);
  scale = FixedTrack{{factor, factor, factor}};
}

}  // namespace

Motion readMotion(const TomlNode& node, const std::string& what, Diagnostics& diagnostics) {
  Motion motion;
  TableReader reader(node, what, diagnostics);
  readTrackAt(reader, "translate", motion.translate);
  readTrackAt(reader, "rotate_deg", motion.rotate_deg);
  readScale(reader, motion.scale);
  readDirection(reader, "spin_axis", motion.spin_axis);
  reader.readNumber("spin_rad_per_frame", motion.spin_rad_per_frame);
  reader.finish();
  return motion;
}

namespace {

void readProfile(TableReader& reader, std::vector<std::array<float, 2>>& profile) {
  const TomlNode* node = reader.find("profile", Need::kRequired);
  if (!node) return;
  const std::string what = "'profile' of " + reader.what();
  if (node->kind != NodeKind::kArray || node->elements.size() < 2 || node->elements.size() > kMaxEntries) {
    reader.diagnostics().add("type",
                             what + " is " + describeNode(*node) +
                                 ", expected an array of at least 2 points [radius, y] from bottom to top",
                             node->place);
    return;
  }
  for (const TomlNode& point : node->elements) {
    std::array<float, 2> values = {0, 0};
    if (point.kind != NodeKind::kArray || point.elements.size() != 2) {
      reader.diagnostics().add("type",
                               "a point of " + what + " is " + describeNode(point) + ", expected [radius, y]",
                               point.place);
      continue;
    }
    numberOf(point.elements[0], "a radius of " + what, kNotNegative, values[0], reader.diagnostics());
    numberOf(point.elements[1], "a height of " + what, kAnyNumber, values[1], reader.diagnostics());
    if (!profile.empty() && values == profile.back()) {
      reader.diagnostics().add("value", what + " has the same point twice in a row", point.place);
    }
    profile.push_back(values);
  }
}

void readShape(TableReader& reader, MeshSpec& mesh) {
  switch (mesh.kind) {
    case MeshKind::kSphere:
      reader.readNumber("radius", mesh.radius, kPositive);
      break;
    case MeshKind::kTorusKnot:
      reader.readNumber("radius", mesh.radius, kPositive);
      reader.readNumber("tube_radius", mesh.tube_radius, kPositive);
      reader.readInteger("p", mesh.p, {1, 64});
      reader.readInteger("q", mesh.q, {1, 64});
      if (std::gcd(mesh.p, mesh.q) != 1) {
        reader.diagnostics().add("value",
                                 "'p' and 'q' of " + reader.what() + " are " + std::to_string(mesh.p) +
                                     " and " + std::to_string(mesh.q) +
                                     ", expected numbers without a common divisor",
                                 reader.table().place);
      }
      break;
    case MeshKind::kPlane:
      reader.readNumber("size", mesh.size, kPositive);
      break;
    case MeshKind::kTerrain:
      reader.readNumber("size", mesh.size, kPositive);
      reader.readNumber("height", mesh.height, kNotNegative);
      reader.readUnsigned("seed", mesh.seed);
      break;
    case MeshKind::kRevolution:
      readProfile(reader, mesh.profile);
      break;
    case MeshKind::kDisplacedSphere:
      reader.readNumber("radius", mesh.radius, kPositive);
      reader.readNumber("height", mesh.height, {0, 1});
      reader.readInteger("cells", mesh.cells, {1, kMaxSegments});
      reader.readUnsigned("seed", mesh.seed);
      break;
  }
}

}  // namespace

MeshSpec readMesh(const TomlNode& node, const std::string& what, Diagnostics& diagnostics) {
  MeshSpec mesh;
  TableReader reader(node, what, diagnostics);
  if (!reader.has("kind")) reader.find("kind", Need::kRequired);
  const std::size_t errors_before = diagnostics.errors.size();
  reader.readChoice("kind", mesh.kind, kMeshKinds);
  // Which other keys there are depends on the kind: without one, no more can be said about them.
  if (!reader.has("kind") || diagnostics.errors.size() != errors_before) return mesh;
  const bool closed = mesh.kind != MeshKind::kPlane && mesh.kind != MeshKind::kTerrain;
  reader.readInteger("segments_u", mesh.segments_u, {closed ? 3.0 : 1.0, kMaxSegments});
  reader.readInteger("segments_v", mesh.segments_v,
                     {mesh.kind == MeshKind::kTorusKnot ? 3.0
                      : mesh.kind == MeshKind::kSphere || mesh.kind == MeshKind::kDisplacedSphere ? 2.0
                                                        : 1.0,
                      kMaxSegments});
  readShape(reader, mesh);
  reader.finish();
  return mesh;
}

}  // namespace reprise
