#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "profiler/scenario/passes.h"
#include "profiler/scenario/standard_names.h"
#include "profiler/scene/frame_state.h"
#include "profiler/scene/model_values.h"
#include "profiler/scene/track.h"

namespace reprise {
namespace {

std::size_t cellCount(const BlockMember& member) {
  return static_cast<std::size_t>(member.rows) * static_cast<std::size_t>(member.columns);
}

std::vector<float> cutMatrix(const glm::mat4& matrix, const BlockMember& member) {
  std::vector<float> values;
  for (int column = 0; column < member.columns; ++column) {
    for (int row = 0; row < member.rows; ++row) values.push_back(matrix[column][row]);
  }
  return values;
}

std::vector<float> firstOf(std::vector<float> values, const BlockMember& member) {
  values.resize(cellCount(member), 0.0f);
  return values;
}

// The values of a member, column by column, in the member's shape.
std::vector<float> semanticValues(Semantic semantic, const FrameState& state, std::size_t object,
                                  const BlockMember& member) {
  const glm::vec3& eye = state.camera_position;
  const auto width = static_cast<float>(state.width), height = static_cast<float>(state.height);
  switch (semantic) {
    case Semantic::kView:
      return cutMatrix(state.view, member);
    case Semantic::kProjection:
      return cutMatrix(state.projection, member);
    case Semantic::kViewProjection:
      return cutMatrix(state.projection * state.view, member);
    case Semantic::kModel:
      return cutMatrix(state.models[object], member);
    case Semantic::kNormalMatrix:
      return cutMatrix(glm::mat4(glm::inverse(glm::transpose(glm::mat3(state.models[object])))), member);
    case Semantic::kCameraPosition:
      return firstOf({eye.x, eye.y, eye.z, 1}, member);
    case Semantic::kTime:
      return firstOf({state.time_s}, member);
    case Semantic::kFrame:
      return firstOf({static_cast<float>(state.frame)}, member);
    case Semantic::kResolution:
      return firstOf({width, height, 1 / width, 1 / height}, member);
    default:
      return {};
  }
}

void storeScalar(std::vector<std::byte>& block, std::size_t offset, ScalarKind kind, float value) {
  if (offset + 4 > block.size()) return;
  std::uint32_t bits = 0;
  if (kind == ScalarKind::kFloat) {
    std::memcpy(&bits, &value, 4);
  } else if (kind == ScalarKind::kInt) {
    // 2147483520 is the greatest float below 2^31, 4294967040 below 2^32.
    bits = static_cast<std::uint32_t>(
        static_cast<std::int32_t>(std::lround(std::clamp(value, -2147483648.0f, 2147483520.0f))));
  } else {
    bits = static_cast<std::uint32_t>(std::lround(std::clamp(value, 0.0f, 4294967040.0f)));
  }
  std::memcpy(block.data() + offset, &bits, 4);
}

std::size_t cellOffset(const BlockMember& member, int column, int row) {
  const auto major = static_cast<std::size_t>(member.row_major ? row : column);
  const auto minor = static_cast<std::size_t>(member.row_major ? column : row);
  return member.columns == 1 ? static_cast<std::size_t>(row) * 4 : major * member.matrix_stride + minor * 4;
}

void storeMember(std::vector<std::byte>& block, const BlockMember& member, const std::vector<float>& values) {
  const std::size_t cells = cellCount(member);
  for (std::uint32_t element = 0; element < std::max(1u, member.array_length); ++element) {
    for (int column = 0; column < member.columns; ++column) {
      for (int row = 0; row < member.rows; ++row) {
        const std::size_t index = element * cells + static_cast<std::size_t>(column * member.rows + row);
        if (index >= values.size()) return;
        const std::size_t offset = member.offset + static_cast<std::size_t>(element) * member.array_stride;
        storeScalar(block, offset + cellOffset(member, column, row), member.scalar, values[index]);
      }
    }
  }
}

const Track* trackOf(const UniformBinding& binding, const SessionSpec& session) {
  const auto override_track = session.uniforms.find(binding.member);
  return override_track != session.uniforms.end() ? &override_track->second
                                                  : std::get_if<Track>(&binding.source);
}

std::string blockOf(const std::string& member) {
  return member.substr(0, member.find('.'));
}

// What a member gets from a source that is no track.
struct SourceFill {
  const Scenario& scenario;
  const FrameState& state;
  std::size_t object;
  const BlockMember& member;

  std::vector<float> operator()(Semantic semantic) const {
    if (isModelSemantic(semantic)) return modelValues(semantic, scenario, state, object);
    if (semantic != Semantic::kShadowViewProjection) return semanticValues(semantic, state, object, member);
    const auto shadow = standardShadow(scenario);
    return shadow ? fromPass(*shadow, Semantic::kViewProjection) : std::vector<float>{};
  }
  std::vector<float> operator()(const PassSource& source) const {
    const auto pass = findPass(scenario, source.pass);
    return pass ? fromPass(*pass, source.semantic) : std::vector<float>{};
  }
  std::vector<float> operator()(const Track&) const { return {}; }
  std::vector<float> fromPass(std::size_t pass, Semantic semantic) const {
    return semanticValues(semantic, seenByPass(scenario, state, pass), object, member);
  }
};

}  // namespace

std::vector<std::byte> fillBlock(const Scenario& scenario, const SessionSpec& session,
                                 const FrameState& state, std::size_t object, const std::string& block_name,
                                 const std::vector<BlockMember>& members, std::uint32_t size_bytes) {
  REPRISE_CHECK(object < state.models.size(), object, state.models.size());
  std::vector<std::byte> block(size_bytes);
  const double time_s = static_cast<double>(state.frame) * session.speed * scenario.frame_time_s;
  for (const UniformBinding& binding : scenario.uniforms) {
    if (blockOf(binding.member) != block_name) continue;
    const std::string name = binding.member.substr(std::min(binding.member.size(), block_name.size() + 1));
    const auto member =
        std::find_if(members.begin(), members.end(), [&](const BlockMember& m) { return m.name == name; });
    if (member == members.end()) continue;
    const Track* track = trackOf(binding, session);
    storeMember(block, *member, track ? evaluateTrack(*track, time_s, scenario.seed)
                                      : std::visit(SourceFill{scenario, state, object, *member}, binding.source));
  }
  for (const BlockMember& member : members) {
    const auto semantic = standardSemantic(block_name + "." + member.name);
    if (!semantic) continue;
    storeMember(block, member, SourceFill{scenario, state, object, member}(*semantic));
  }
  return block;
}

}  // namespace reprise
