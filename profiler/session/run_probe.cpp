// Ranges of payload and depth, and by how much payloads change, from the 32-bit histories that branch variants write.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "profiler/session/stage.h"

namespace reprise {
namespace {

// A frame's history: RGBA texels of each target of the payload.
struct ProbedFrame {
  std::vector<std::vector<float>> targets;
  std::vector<float> depth;  // RGBA texels too; empty where depth lies in the alpha of the last target

  float channel(std::size_t pixel, int channel) const {
    return targets[static_cast<std::size_t>(channel) / 4][pixel * 4 + static_cast<std::size_t>(channel) % 4];
  }
  float storedDepth(std::size_t pixel) const { return depth.empty() ? targets.back()[pixel * 4 + 3] : depth[pixel * 4]; }
};

void widenByPixel(const std::vector<PayloadValue>& payload, const ProbedFrame& frame, std::size_t pixel, ProbeResult& probe) {
  for (const PayloadValue& value : payload) {
    if (value.guard_channel != kNoGuard && frame.channel(pixel, value.guard_channel) == 0) continue;
    for (int channel = value.first_channel; channel < value.first_channel + value.channels; ++channel) {
      const auto at = static_cast<std::size_t>(channel);
      probe.payload_min[at] = std::min(probe.payload_min[at], frame.channel(pixel, channel));
      probe.payload_max[at] = std::max(probe.payload_max[at], frame.channel(pixel, channel));
    }
  }
}

// covered: one byte per pixel, 0 where nothing was drawn.
void widen(const Recipe& recipe, const ProbedFrame& frame, const std::vector<std::uint8_t>& covered, ProbeResult& probe) {
  const CacheConstants& constants = recipe.constants;
  for (std::size_t pixel = 0; pixel < covered.size(); ++pixel) {
    if (covered[pixel] == 0) continue;
    ++probe.covered;
    const float stored = frame.storedDepth(pixel);
    if (!(stored > 0)) {
      ++probe.nonfinite_payload;
      continue;
    }
    const float depth = (stored - constants.depth_range[1]) / constants.depth_range[0];
    probe.depth_min = std::min(probe.depth_min, depth);
    probe.depth_max = std::max(probe.depth_max, depth);
    widenByPixel(recipe.payload, frame, pixel, probe);
  }
}

constexpr std::size_t kWatchedPixels = 16384;

// What evenly spread pixels of the last probed frame held, to see by how much the next frame differs.
class PayloadWatch {
 public:
  void see(const Recipe& recipe, const ProbedFrame& frame, const std::vector<std::uint8_t>& covered, ProbeResult& probe) {
    const std::size_t stride = std::max<std::size_t>(1, (covered.size() + kWatchedPixels - 1) / kWatchedPixels);
    std::vector<ChannelFloats> seen;
    for (std::size_t pixel = 0; pixel < covered.size(); pixel += stride) seen.push_back(payloadAt(recipe.payload, frame, pixel, covered[pixel] != 0));
    for (std::size_t at = 0; at < last_.size(); ++at)
      for (std::size_t channel = 0; channel < kMostPayloadChannels; ++channel) {
        const float change = std::abs(seen[at][channel] - last_[at][channel]);
        if (change > probe.payload_change[channel]) probe.payload_change[channel] = change;
      }
    last_ = std::move(seen);
  }

 private:
  // NaN, which differs from nothing by more than anything, where a channel holds no valid value.
  static ChannelFloats payloadAt(const std::vector<PayloadValue>& payload, const ProbedFrame& frame, std::size_t pixel, bool covered) {
    ChannelFloats values;
    values.fill(std::numeric_limits<float>::quiet_NaN());
    if (!covered || !(frame.storedDepth(pixel) > 0)) return values;
    for (const PayloadValue& value : payload) {
      if (value.guard_channel != kNoGuard && frame.channel(pixel, value.guard_channel) == 0) continue;
      for (int channel = value.first_channel; channel < value.first_channel + value.channels; ++channel)
        values[static_cast<std::size_t>(channel)] = frame.channel(pixel, channel);
    }
    return values;
  }

  std::vector<ChannelFloats> last_;
};

Result<std::vector<float>> readResource(Stage& stage, Readback& readback, const Player& player, const std::string& name) {
  const auto image = player.resource(name);
  if (!image) return std::vector<float>{};
  REPRISE_ASSIGN(const auto bytes, readback.read(*stage.commands, {image->image, image->format, image->extent, image->layout}));
  return payloadFloats(bytes, image->format, player.recipe().payload.front());
}

Result<ProbedFrame> readFrame(Stage& stage, Readback& readback, const Player& player) {
  ProbedFrame frame;
  for (std::size_t target = 0; target < kMostPayloadTargets; ++target) {
    REPRISE_ASSIGN(std::vector<float> texels, readResource(stage, readback, player, payloadTarget(target)));
    if (texels.empty()) break;
    frame.targets.push_back(std::move(texels));
  }
  REPRISE_ASSIGN(frame.depth, readResource(stage, readback, player, kPayloadDepth));
  return frame;
}

ProbeResult emptyProbe(std::size_t entry) {
  ProbeResult probe;
  probe.entry = static_cast<int>(entry);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  probe.payload_min.fill(kInfinity);
  probe.payload_max.fill(-kInfinity);
  probe.depth_min = kInfinity;
  probe.depth_max = -kInfinity;
  return probe;
}

// Channels that the payload does not have, and probes that saw nothing, give 0 instead of infinities.
void settle(ProbeResult& probe) {
  for (std::size_t channel = 0; channel < kMostPayloadChannels; ++channel)
    if (!(probe.payload_max[channel] >= probe.payload_min[channel])) probe.payload_min[channel] = probe.payload_max[channel] = 0;
  if (!(probe.depth_max >= probe.depth_min)) probe.depth_min = probe.depth_max = 0;
}

// Pixels of the frame that was rendered last with a colour that is not finite, in any output.
Result<std::uint64_t> countNonfinite(Stage& stage, Readback& readback) {
  std::vector<std::uint8_t> found(static_cast<std::size_t>(stage.targets.extent.width) * stage.targets.extent.height);
  for (const Image& image : stage.targets.colors) {
    REPRISE_ASSIGN(const auto texels, readback.read(*stage.commands, {image.image.get(), image.format, stage.targets.extent,
                                                                      VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL}));
    const std::vector<float> rgba = toFloats(texels, image.format);
    for (std::size_t at = 0; at < rgba.size(); ++at)
      if (!std::isfinite(rgba[at])) found[at / 4] = 1;
  }
  return static_cast<std::uint64_t>(std::count(found.begin(), found.end(), 1));
}

}  // namespace

Result<JobResult> runProbe(const Job& job, const JobListener& progress) {
  REPRISE_ASSIGN(const std::unique_ptr<Stage> stage, setStage(job));
  REPRISE_ASSIGN(Player original, createOriginalPlayer(*stage));
  REPRISE_ASSIGN(std::deque<Player> players, createPlayers(*stage));
  Readback readback(*stage->context);
  JobResult result = emptyResult(*stage);
  for (std::size_t entry = 0; entry < players.size(); ++entry) result.probes.push_back(emptyProbe(entry));
  std::vector<PayloadWatch> watches(players.size());
  const int session_frames = stage->session->frames > 0 ? stage->session->frames : stage->scenario.frames;
  const int frames = std::min(frameCount(job, *stage), session_frames);
  for (int step = 0; step < frames; ++step) {
    // Spread over the whole session: the range matters, not the order.
    const int frame = frames > 1 ? step * (session_frames - 1) / (frames - 1) : 0;
    REPRISE_TRY(beginFrame(*stage, frame, job.fence_timeout_s));
    const auto render = [&](Player& player) {
      player.invalidate();
      return stage->commands->run([&](VkCommandBuffer buffer) { return stage->renderer->record(buffer, player, stage->targets, 1, {}); }, job.fence_timeout_s);
    };
    REPRISE_TRY(render(original));
    REPRISE_ASSIGN(const std::uint64_t nonfinite, countNonfinite(*stage, readback));
    REPRISE_ASSIGN(const std::vector<std::uint8_t> covered, coveredPixels(*stage, readback));
    for (std::size_t entry = 0; entry < players.size(); ++entry) {
      REPRISE_TRY(render(players[entry]));
      REPRISE_ASSIGN(const ProbedFrame frame_read, readFrame(*stage, readback, players[entry]));
      // Entries that keep nothing, such as the original, are probed for their colours alone.
      if (!frame_read.targets.empty()) {
        widen(players[entry].recipe(), frame_read, covered, result.probes[entry]);
        watches[entry].see(players[entry].recipe(), frame_read, covered, result.probes[entry]);
      }
      result.probes[entry].nonfinite_color += nonfinite;
    }
    if (progress) progress({step + 1, frames});
  }
  for (ProbeResult& probe : result.probes) settle(probe);
  return result;
}

}  // namespace reprise
