// Errors, hits and misses: every frame once as the original, then by every entry, compared pixel by pixel.
#include <algorithm>
#include <cstring>

#include "profiler/metrics/metrics.h"
#include "profiler/session/display.h"
#include "profiler/session/stage.h"

namespace reprise {
namespace {

struct Rendered {
  DisplayImage image, last;
  std::vector<std::uint8_t> nonfinite;
  bool has_last = false;
};

class ErrorRun {
 public:
  ErrorRun(const Job& job, Stage& stage) : job_(job), stage_(stage), readback_(*stage.context) {
    for (const Metric& metric : metrics())
      if (!metric.expensive || std::find(job.metrics.begin(), job.metrics.end(), metric.name) != job.metrics.end()) metrics_.push_back(&metric);
    original_.image.width = mask_.width = static_cast<int>(stage.scenario.width);
    original_.image.height = mask_.height = static_cast<int>(stage.scenario.height);
    cached_.resize(job.entries.size());
    for (Rendered& one : cached_) one.image.width = original_.image.width, one.image.height = original_.image.height;
  }

  Result<JobResult> run(const JobListener& progress) {
    REPRISE_ASSIGN(Player original, createOriginalPlayer(stage_));
    REPRISE_ASSIGN(std::deque<Player> players, createPlayers(stage_));
    JobResult result;
    result.errors.resize(job_.entries.size());
    const int frames = frameCount(job_, stage_);
    for (int frame = 0; frame < frames; ++frame) {
      stage_.renderer->setFrame(*stage_.session, evaluateFrame(stage_.scenario, *stage_.session, frame));
      REPRISE_TRY(render(original, 1, original_));
      if (hasUninstrumented()) REPRISE_TRY(readDepth());
      for (std::size_t entry = 0; entry < players.size(); ++entry) {
        REPRISE_TRY(render(players[entry], job_.entries[entry].period_frames, cached_[entry]));
        ErrorRow row;
        row.frame = frame;
        REPRISE_TRY(count(players[entry], row));
        compare(cached_[entry], row);
        result.errors[entry].push_back(std::move(row));
      }
      if (progress) progress({frame + 1, frames});
    }
    return result;
  }

 private:
  bool hasUninstrumented() const {
    return std::any_of(stage_.packages.begin(), stage_.packages.end(), [](const Package& package) {
      return std::none_of(package.variant.resources.begin(), package.variant.resources.end(), [](const Resource& one) { return one.name == "kind"; });
    });
  }

  Result<void> render(Player& player, std::uint32_t period, Rendered& into) {
    REPRISE_TRY(stage_.commands->run([&](VkCommandBuffer buffer) { return stage_.renderer->record(buffer, player, stage_.targets, period, {}); },
                                     job_.fence_timeout_s));
    std::swap(into.image.rgb, into.last.rgb);
    into.has_last = !into.last.rgb.empty();
    into.last.width = into.image.width;
    into.last.height = into.image.height;
    const VkFormat format = stage_.renderer->colorFormat(0);
    REPRISE_ASSIGN(const auto texels, readback_.read(*stage_.commands, {stage_.targets.colors[0].image.get(), format, stage_.targets.extent,
                                                                        VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL}));
    toDisplay(texels, format, {stage_.scenario.tone_map, stage_.scenario.exposure}, into.image, &into.nonfinite);
    return {};
  }

  // Entries without counters (references): what the original covers, all of it missed.
  Result<void> readDepth() {
    depth_mask_.assign(static_cast<std::size_t>(mask_.width) * static_cast<std::size_t>(mask_.height), 2);
    if (stage_.renderer->depthFormat() != VK_FORMAT_D32_SFLOAT) return {};
    REPRISE_ASSIGN(const auto texels, readback_.read(*stage_.commands, {stage_.targets.depth.image.get(), VK_FORMAT_D32_SFLOAT, stage_.targets.extent,
                                                                        VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL}));
    const float clear = stage_.renderer->clearDepth();
    for (std::size_t pixel = 0; pixel < depth_mask_.size(); ++pixel) {
      float depth;
      std::memcpy(&depth, &texels[pixel * 4], 4);
      if (depth == clear) depth_mask_[pixel] = 0;
    }
    return {};
  }

  Result<void> count(const Player& player, ErrorRow& row) {
    const auto kind = player.resource("kind");
    if (!kind) {
      mask_.kind = depth_mask_;
    } else {
      REPRISE_ASSIGN(const auto kinds, readback_.read(*stage_.commands, {kind->image, kind->format, kind->extent, kind->layout}));
      mask_.kind.resize(kinds.size());
      std::memcpy(mask_.kind.data(), kinds.data(), kinds.size());
      const auto counts = player.resource("counts");
      REPRISE_ASSIGN(const auto fragments, readback_.read(*stage_.commands, {counts->image, counts->format, counts->extent, counts->layout}));
      double hits = 0, misses = 0;
      for (std::size_t at = 0; at < fragments.size(); at += 16) {
        float shaded[2];
        std::memcpy(shaded, &fragments[at], sizeof shaded);
        hits += static_cast<double>(shaded[0]);
        misses += static_cast<double>(shaded[1]);
      }
      row.shaded_hits = static_cast<std::uint64_t>(hits);
      row.shaded_misses = static_cast<std::uint64_t>(misses);
    }
    for (const std::uint8_t one : mask_.kind) {
      row.hits += one == 1;
      row.misses += one == 2;
    }
    row.covered = row.hits + row.misses;
    if (!kind) row.shaded_misses = row.misses;
    return {};
  }

  // Pixels that are not finite are counted and left out, never averaged away.
  void compare(Rendered& cached, ErrorRow& row) {
    for (std::size_t pixel = 0; pixel < mask_.kind.size(); ++pixel) {
      if (mask_.kind[pixel] == 0 || (original_.nonfinite[pixel] | cached.nonfinite[pixel]) == 0) continue;
      ++row.nonfinite;
      mask_.kind[pixel] = 0;
    }
    if (row.covered == row.nonfinite) return;
    MetricInputs inputs{&original_.image, &cached.image, original_.has_last ? &original_.last : nullptr,
                        cached.has_last ? &cached.last : nullptr, &mask_};
    for (const Metric* metric : metrics_) row.errors[metric->name] = metric->evaluate(inputs);
  }

  const Job& job_;
  Stage& stage_;
  Readback readback_;
  std::vector<const Metric*> metrics_;
  Rendered original_;
  std::vector<Rendered> cached_;
  CoverageMask mask_;
  std::vector<std::uint8_t> depth_mask_;
};

}  // namespace

Result<JobResult> runErrors(const Job& job, const JobListener& progress) {
  REPRISE_ASSIGN(const std::unique_ptr<Stage> stage, setStage(job));
  return ErrorRun(job, *stage).run(progress);
}

}  // namespace reprise
