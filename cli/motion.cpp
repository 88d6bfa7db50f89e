#include "cli/motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/report/text.h"
#include "cli/train.h"
#include "profiler/scene/frame_state.h"

namespace reprise {
namespace {

// The block that an input is, as scenarios fill it.
struct FilledBlock {
  std::string name;
  const std::vector<BlockMember>* members = nullptr;
  std::uint32_t size_bytes = 0;
  std::vector<ByteRange> read;
};

std::optional<FilledBlock> blockOf(const ShaderInterface& interface, const PositionInput& input) {
  FilledBlock block;
  block.read = input.read;
  if (input.source == PositionSource::kPushConstants) {
    block.name = interface.push_constant_name;
    block.members = &interface.push_constant_members;
    for (const PushConstantRange& range : interface.push_constants) block.size_bytes = std::max(block.size_bytes, range.offset + range.size_bytes);
    return block;
  }
  const auto found = std::find_if(interface.descriptors.begin(), interface.descriptors.end(), [&](const Descriptor& descriptor) {
    return descriptor.kind == DescriptorKind::kUniformBlock && descriptor.set == input.set && descriptor.binding == input.binding;
  });
  if (input.source != PositionSource::kUniformBlock || found == interface.descriptors.end()) return std::nullopt;
  block.name = found->name;
  block.members = &found->members;
  block.size_bytes = found->size_bytes;
  return block;
}

struct SceneOfBlocks {
  const Scenario& scenario;
  const SessionSpec& session;
  std::vector<FilledBlock> blocks;

  // What the position of an object reads in a frame, one range after the other.
  std::vector<std::byte> read(const FrameState& state, std::size_t object) const {
    std::vector<std::byte> bytes;
    for (const FilledBlock& block : blocks) {
      const std::vector<std::byte> filled = fillBlock(scenario, session, state, object, block.name, *block.members, block.size_bytes);
      for (const ByteRange& range : block.read) {
        const std::size_t from = std::min<std::size_t>(range.offset, filled.size()), to = std::min<std::size_t>(from + range.size, filled.size());
        bytes.insert(bytes.end(), filled.begin() + static_cast<std::ptrdiff_t>(from), filled.begin() + static_cast<std::ptrdiff_t>(to));
      }
    }
    return bytes;
  }

  // All objects stand where they stood in the first frame.
  bool still() const {
    std::vector<std::vector<std::byte>> first;
    const int frames = session.frames > 0 ? session.frames : scenario.frames;
    for (int frame = 0; frame < frames; ++frame) {
      const FrameState state = evaluateFrame(scenario, session, frame);
      for (std::size_t object = 0; object < scenario.objects.size(); ++object) {
        std::vector<std::byte> now = read(state, object);
        if (frame == 0) first.push_back(std::move(now));
        else if (now != first[object]) return false;
      }
    }
    return true;
  }
};

// The largest change of the candidate's payload that its encoding would keep; 0: none.
float visibleChange(const Candidate& candidate, const Subject& subject, const ValueRanges& ranges, const ChannelFloats& change) {
  const Encoding encoding = baseOptions(subject, ranges, candidate).encoding;
  float most = 0;
  for (std::size_t channel = 0; channel < kMostPayloadChannels; ++channel)
    if (change[channel] > encodingStep(encoding, isInteger(candidate.scalar), ranges.payload_min[channel], ranges.payload_max[channel]))
      most = std::max(most, change[channel]);
  return most;
}

}  // namespace

Result<void> expectMotion(const Subject& subject) {
  if (subject.scenario.motion == MotionSource::kNone) return {};
  const Result<std::vector<PositionInput>> inputs = positionInputs(subject.program.vertex);
  if (!inputs.ok() || !inputs->empty()) return {};
  return Error{ErrorKind::kRefused, "motion.none",
               "gl_Position reads no uniform, push constant or buffer, so every pixel stays where it is and what moves in the image cannot be "
               "followed; where the image does stand still (a still background, a 2D layer) say motion = \"none\" at the top of the scenario",
               {subject.scenario.vertex_path, 0, 0}};
}

bool standsStill(const Scenario& scenario, const ShaderInterface& interface, const std::vector<PositionInput>& inputs) {
  std::vector<FilledBlock> blocks;
  for (const PositionInput& input : inputs) {
    std::optional<FilledBlock> block = blockOf(interface, input);
    if (!block) return false;
    blocks.push_back(std::move(*block));
  }
  return std::all_of(scenario.sessions.begin(), scenario.sessions.end(),
                     [&](const SessionSpec& session) { return SceneOfBlocks{scenario, session, blocks}.still(); });
}

double encodingStep(Encoding encoding, bool integer, float low, float high) {
  if (integer) return 0;
  const double span = static_cast<double>(high) - static_cast<double>(low);
  const double largest = std::max(std::abs(static_cast<double>(low)), std::abs(static_cast<double>(high)));
  switch (encoding) {
    case Encoding::kRgba8: return span / 255;
    case Encoding::kRgba16: return span / 65535;
    case Encoding::kRgba16f: return largest / 1024;
    case Encoding::kRgba32f: return largest / 8388608;
  }
  return 0;
}

std::optional<std::string> suspectMotion(const Subject& subject, const Training& training, const std::string& chosen) {
  std::string payload;
  float change = 0;
  for (std::size_t at = 0; at < subject.candidates.size() && change == 0; ++at) {
    const Candidate& candidate = subject.candidates[at];
    const auto ranges = training.ranges.find(at);
    const auto changes = training.changes.find(at);
    if (ranges == training.ranges.end() || changes == training.changes.end() || (!chosen.empty() && candidate.id != chosen)) continue;
    payload = candidate.name.empty() ? candidate.id : candidate.name;
    change = visibleChange(candidate, subject, ranges->second, changes->second);
  }
  if (change == 0) return std::nullopt;
  const Result<std::vector<PositionInput>> inputs = positionInputs(subject.program.vertex);
  if (!inputs.ok() || !standsStill(subject.scenario, subject.program.interface, *inputs)) return std::nullopt;
  return fmt::format("{}: no pixel moves in any session by what gl_Position reads, yet {} changes by up to {} at one pixel. Where surfaces do move "
                     "in the image, as in a full-screen pass over a G-buffer, hits show them where they were: the result is wrong then. Where camera "
                     "and surfaces stand still and lights or other inputs change, it may be right",
                     kMotionSuspect, payload, formatNumber(change));
}

}  // namespace reprise
