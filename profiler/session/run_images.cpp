// Pictures of one frame for people: original, cached, amplified error, hits and misses, payload.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "profiler/session/display.h"
#include "profiler/session/read_kinds.h"
#include "profiler/session/stage.h"

namespace reprise {
namespace {

// "#rrggbb" as RGB in [0, 1].
std::array<float, 3> colorFrom(const char* text) {
  const std::string hex = text;
  std::array<float, 3> color;
  for (std::size_t channel = 0; channel < 3; ++channel)
    color[channel] = static_cast<float>(std::stoi(hex.substr(1 + 2 * channel, 2), nullptr, 16)) / 255.0f;
  return color;
}

DisplayImage errorImage(const DisplayImage& original, const DisplayImage& cached) {
  DisplayImage image = original;
  for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = std::min(1.0f, std::abs(original.rgb[i] - cached.rgb[i]) * kImageErrorGain);
  return image;
}

DisplayImage kindImage(std::span<const std::uint8_t> kinds, const DisplayImage& like) {
  DisplayImage image = like;
  const std::array<std::array<float, 3>, 3> colors = {colorFrom("#d9d9d9"), colorFrom(kHitColorText), colorFrom(kMissColorText)};
  for (std::size_t pixel = 0; pixel < kinds.size(); ++pixel)
    std::copy_n(colors[std::min<std::size_t>(kinds[pixel], 2)].begin(), 3, &image.rgb[pixel * 3]);
  return image;
}

// Each channel spread over the range that it has in this frame; one channel is shown as grey.
DisplayImage payloadImage(const std::vector<float>& cache, int channels, const DisplayImage& like) {
  DisplayImage image = like;
  for (int channel = 0; channel < 3; ++channel) {
    const auto source = static_cast<std::size_t>(std::min(channel, channels - 1));
    float low = INFINITY, high = -INFINITY;
    for (std::size_t at = source; at < cache.size(); at += 4) low = std::min(low, cache[at]), high = std::max(high, cache[at]);
    const float scale = high > low ? 1 / (high - low) : 0;
    for (std::size_t pixel = 0; pixel * 4 < cache.size(); ++pixel)
      image.rgb[pixel * 3 + static_cast<std::size_t>(channel)] = std::clamp((cache[pixel * 4 + source] - low) * scale, 0.0f, 1.0f);
  }
  return image;
}

class ImageRun {
 public:
  ImageRun(const Job& job, Stage& stage) : job_(job), stage_(stage), readback_(*stage.context) {}

  Result<JobResult> run(const JobListener& progress) {
    result_ = emptyResult(stage_);
    REPRISE_ASSIGN(Player original, createOriginalPlayer(stage_));
    REPRISE_ASSIGN(std::deque<Player> players, createPlayers(stage_));
    const int last_frame = job_.strip_frames.empty() ? job_.image_frame : std::max(job_.image_frame, job_.strip_frames.back());
    for (int frame = 0; frame <= last_frame; ++frame) {
      REPRISE_TRY(beginFrame(stage_, frame, job_.fence_timeout_s));
      const bool shown = frame == job_.image_frame;
      const bool in_strip = std::binary_search(job_.strip_frames.begin(), job_.strip_frames.end(), frame);
      const std::string strip = "strip_" + std::to_string(frame);
      if (shown || in_strip) {
        REPRISE_TRY(render(original, 1));
        REPRISE_ASSIGN(original_, display());
        if (shown) REPRISE_TRY(write(original_, "original"));
        if (in_strip) REPRISE_TRY(write(original_, strip + "_original"));
      }
      const std::size_t playing = frame > job_.image_frame ? std::min<std::size_t>(1, players.size()) : players.size();
      for (std::size_t entry = 0; entry < playing; ++entry) {
        REPRISE_TRY(render(players[entry], job_.entries[entry].period_frames));
        if (shown) REPRISE_TRY(writeEntry(players[entry], players.size() == 1 ? "" : "_" + std::to_string(entry)));
        if (in_strip && entry == 0) {
          REPRISE_ASSIGN(const DisplayImage cached, display());
          REPRISE_TRY(write(cached, strip + "_cached"));
        }
      }
      if (progress) progress({frame + 1, last_frame + 1});
    }
    return std::move(result_);
  }

 private:
  Result<void> render(Player& player, std::uint32_t period) {
    return stage_.commands->run([&](VkCommandBuffer buffer) { return stage_.renderer->record(buffer, player, stage_.targets, period, {}); },
                                job_.fence_timeout_s);
  }

  Result<DisplayImage> display() {
    DisplayImage image{static_cast<int>(stage_.scenario.width), static_cast<int>(stage_.scenario.height), {}};
    const VkFormat format = stage_.renderer->colorFormat(0);
    REPRISE_ASSIGN(const auto texels, readback_.read(*stage_.commands, {stage_.targets.colors[0].image.get(), format, stage_.targets.extent,
                                                                        VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL}));
    toDisplay(texels, format, {stage_.scenario.tone_map, stage_.scenario.exposure}, image, nullptr);
    return image;
  }

  Result<void> write(const DisplayImage& image, const std::string& name) {
    const std::filesystem::path file = std::filesystem::path(job_.image_dir) / (name + ".png");
    REPRISE_TRY(writePng(image, file));
    result_.images.push_back(file.string());
    return {};
  }

  Result<void> writeEntry(const Player& player, const std::string& suffix) {
    REPRISE_ASSIGN(const DisplayImage cached, display());
    REPRISE_TRY(write(cached, "cached" + suffix));
    REPRISE_TRY(write(errorImage(original_, cached), "error" + suffix));
    REPRISE_ASSIGN(const PixelKinds told, readKinds(readback_, *stage_.commands, player));
    if (!told.kind.empty()) REPRISE_TRY(write(kindImage(told.kind, cached), "hit_miss" + suffix));
    if (const auto cache = player.resource(payloadTarget(0))) {
      REPRISE_ASSIGN(const auto bytes, readback_.read(*stage_.commands, {cache->image, cache->format, cache->extent, cache->layout}));
      const PayloadValue& payload = player.recipe().payload.front();
      const std::vector<float> values = payloadFloats(bytes, cache->format, payload);
      REPRISE_TRY(write(payloadImage(values, payload.channels, cached), "payload" + suffix));
    }
    return {};
  }

  const Job& job_;
  Stage& stage_;
  Readback readback_;
  DisplayImage original_;
  JobResult result_;
};

}  // namespace

Result<JobResult> runImages(const Job& job, const JobListener& progress) {
  REPRISE_ASSIGN(const std::unique_ptr<Stage> stage, setStage(job));
  return ImageRun(job, *stage).run(progress);
}

}  // namespace reprise
