// Errors, hits and misses: every frame once as the original, then by every entry, compared pixel by pixel.
//
// A shader with several colour outputs is judged by the worst of them, metric by metric: a later pass of the application reads
// them all. Entries are played in batches that fit into memory; each batch renders the original again, which changes no row.
#include <algorithm>
#include <cstring>
#include <deque>
#include <future>

#include "profiler/metrics/flip.h"
#include "profiler/metrics/metrics.h"
#include "profiler/metrics/tiles.h"
#include "profiler/session/display.h"
#include "profiler/session/read_kinds.h"
#include "profiler/session/stage.h"

namespace reprise {
namespace {

constexpr std::size_t kBatchBytes = 400u << 20;

using Outputs = std::vector<DisplayImage>;

// The frame before; empty before the first.
struct Rendered {
  Outputs current, last;
  std::vector<std::uint8_t> nonfinite;  // in any output
};

// What an entry keeps from frame to frame, at least: resources of its recipe and its last displayed frame.
std::size_t entryBytes(const Recipe& recipe, std::size_t outputs, std::size_t pixels) {
  std::size_t per_pixel = outputs * sizeof(float) * 3;
  for (const Resource& resource : recipe.resources)
    per_pixel += static_cast<std::size_t>(bytesPerPixel(resource.format)) * (resource.lifetime == Lifetime::kHistory ? 2 : 1);
  return per_pixel * pixels;
}

Result<std::vector<const Metric*>> wantedMetrics(const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (findMetric(name) == nullptr) return Error{ErrorKind::kInput, "job.metric", "there is no metric '" + name + "'", {}};
  std::vector<const Metric*> wanted;
  for (const Metric& metric : metrics())
    if (!metric.expensive || std::find(names.begin(), names.end(), metric.name) != names.end()) wanted.push_back(&metric);
  return wanted;
}

class ErrorRun {
 public:
  ErrorRun(const Job& job, Stage& stage, std::vector<const Metric*> metrics)
      : job_(job), stage_(stage), readback_(*stage.context), metrics_(std::move(metrics)) {
    mask_.width = static_cast<int>(stage.scenario.width);
    mask_.height = static_cast<int>(stage.scenario.height);
  }

  Result<JobResult> run(const JobListener& progress) {
    JobResult result = emptyResult(stage_);
    result.errors.resize(job_.entries.size());
    progress_ = {0, static_cast<int>(batches().size()) * frameCount(job_, stage_)};
    for (const Batch& batch : batches()) REPRISE_TRY(runBatch(batch, result, progress));
    return result;
  }

 private:
  struct Batch {
    std::size_t first = 0, count = 0;
  };

  std::vector<Batch> batches() const {
    std::vector<Batch> list;
    std::size_t used = kBatchBytes;
    for (std::size_t entry = 0; entry < stage_.packages.size(); ++entry) {
      const std::size_t bytes = entryBytes(stage_.packages[entry].variant, stage_.targets.colors.size(),
                                           static_cast<std::size_t>(mask_.width) * static_cast<std::size_t>(mask_.height));
      if (list.empty() || used + bytes > kBatchBytes) {
        list.push_back({entry, 0});
        used = 0;
      }
      ++list.back().count;
      used += bytes;
    }
    return list;
  }

  Result<void> runBatch(const Batch& batch, JobResult& result, const JobListener& progress) {
    REPRISE_ASSIGN(Player original, createOriginalPlayer(stage_));
    std::deque<Player> players;
    bool all_count = true;
    for (std::size_t i = 0; i < batch.count; ++i) {
      REPRISE_ASSIGN(Player player, createPlayer(stage_, stage_.packages[batch.first + i]));
      players.push_back(std::move(player));
      all_count = all_count && tellsKinds(players.back().recipe());
    }
    original_ = {};
    cached_ = {};
    std::vector<Outputs> last(batch.count);
    const int frames = frameCount(job_, stage_);
    for (int frame = 0; frame < frames; ++frame) {
      REPRISE_TRY(beginFrame(stage_, frame, job_.fence_timeout_s));
      std::swap(original_.last, original_.current);
      REPRISE_TRY(render(original, 1, original_));
      flip_originals_.clear();
      for (const DisplayImage& image : original_.current) flip_originals_.emplace_back(image);
      if (!all_count) REPRISE_TRY(readDepth());
      for (std::size_t i = 0; i < batch.count; ++i) {
        std::swap(cached_.last, last[i]);
        REPRISE_TRY(render(players[i], job_.entries[batch.first + i].period_frames, cached_));
        cutDifferences(static_cast<float>(job_.entries[batch.first + i].most_difference));
        ErrorRow row;
        row.frame = frame;
        REPRISE_TRY(count(players[i], row));
        compare(row);
        result.errors[batch.first + i].push_back(std::move(row));
        // This frame becomes the entry's last one; the buffers of the frame before are used again.
        std::swap(last[i], cached_.current);
        std::swap(cached_.current, cached_.last);
      }
      ++progress_.done;
      if (progress) progress(progress_);
    }
    return {};
  }

  Result<void> render(Player& player, std::uint32_t period, Rendered& into) {
    REPRISE_TRY(stage_.commands->run([&](VkCommandBuffer buffer) { return stage_.renderer->record(buffer, player, stage_.targets, period, {}); },
                                     job_.fence_timeout_s));
    into.current.resize(stage_.targets.colors.size());
    std::vector<std::uint8_t> nonfinite;
    for (std::size_t i = 0; i < into.current.size(); ++i) {
      const Image& target = stage_.targets.colors[i];
      REPRISE_ASSIGN(const auto texels, readback_.read(*stage_.commands, {target.image.get(), target.format, stage_.targets.extent,
                                                                          VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL}));
      into.current[i].width = mask_.width;
      into.current[i].height = mask_.height;
      toDisplay(texels, target.format, {stage_.scenario.tone_map, stage_.scenario.exposure}, into.current[i], &nonfinite);
      if (i == 0) {
        into.nonfinite = nonfinite;
      } else {
        for (std::size_t pixel = 0; pixel < nonfinite.size(); ++pixel) into.nonfinite[pixel] |= nonfinite[pixel];
      }
    }
    return {};
  }

  void cutDifferences(float most) {
    if (!(most > 0)) return;
    for (std::size_t output = 0; output < cached_.current.size(); ++output) {
      const std::vector<float>& original = original_.current[output].rgb;
      std::vector<float>& cached = cached_.current[output].rgb;
      for (std::size_t i = 0; i < cached.size(); ++i) cached[i] = std::clamp(cached[i], original[i] - most, original[i] + most);
    }
  }

  // Entries without counters (references): what the original covers, all of it missed.
  Result<void> readDepth() {
    REPRISE_ASSIGN(depth_mask_, coveredPixels(stage_, readback_));
    for (std::uint8_t& kind : depth_mask_) kind = kind != 0 ? 2 : 0;
    return {};
  }

  Result<void> count(const Player& player, ErrorRow& row) {
    REPRISE_ASSIGN(PixelKinds told, readKinds(readback_, *stage_.commands, player));
    const bool counted = !told.kind.empty();
    mask_.kind = counted ? std::move(told.kind) : depth_mask_;
    ages_ = std::move(told.age);
    if (counted) REPRISE_TRY(countFragments(player, row));
    for (const std::uint8_t one : mask_.kind) {
      row.hits += one == 1;
      row.misses += one == 2;
    }
    row.covered = row.hits + row.misses;
    if (!counted) row.shaded_misses = row.misses;
    return {};
  }

  Result<void> countFragments(const Player& player, ErrorRow& row) {
    const auto counts = player.resource("counts");
    if (!counts) return {};
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
    return {};
  }

  // Pixels that are not finite are counted and left out, never averaged away.
  void compare(ErrorRow& row) {
    for (std::size_t pixel = 0; pixel < mask_.kind.size(); ++pixel) {
      if (mask_.kind[pixel] == 0 || (original_.nonfinite[pixel] | cached_.nonfinite[pixel]) == 0) continue;
      ++row.nonfinite;
      if (original_.nonfinite[pixel] == 0) ++row.spoiled;
      mask_.kind[pixel] = 0;
    }
    if (row.covered == row.nonfinite) return;
    tiles_.clear();
    for (const DisplayImage& original : original_.current) tiles_.push_back(tilesOf(original, mask_));
    // The device waits for this, on CPU devices with all its threads.
    std::vector<std::future<Judged>> judged;
    for (const Metric* metric : metrics_) judged.push_back(std::async(std::launch::async, [this, metric] { return worstOf(*metric); }));
    for (std::size_t i = 0; i < metrics_.size(); ++i) {
      Judged one = judged[i].get();
      row.errors[metrics_[i]->name] = one.value;
      if (metrics_[i]->tiles) row.tiles[metrics_[i]->name] = keptTiles(one.tiles);
    }
  }

  struct Judged {
    double value = 0;
    std::vector<float> tiles;
  };

  // Over the outputs: the worst of them, but the tiles of all.
  Judged worstOf(const Metric& metric) const {
    Judged worst;
    for (std::size_t i = 0; i < cached_.current.size(); ++i) {
      const MetricInputs inputs{.original = &original_.current[i], .cached = &cached_.current[i], .last_original = lastOf(original_, i),
                                .last_cached = lastOf(cached_, i), .mask = &mask_, .ages = ages_.empty() ? nullptr : &ages_,
                                .flip_original = &flip_originals_[i], .tiles = &tiles_[i]};
      const std::vector<float> tiles = metric.tiles ? metric.tiles(inputs) : std::vector<float>{};
      const double value = metric.tiles ? tailOf(tiles) : metric.evaluate(inputs);
      if (!(value <= worst.value)) worst.value = value;  // keeps a NaN, too
      worst.tiles.insert(worst.tiles.end(), tiles.begin(), tiles.end());
    }
    return worst;
  }

  static const DisplayImage* lastOf(const Rendered& rendered, std::size_t output) {
    return rendered.last.empty() || rendered.last[output].rgb.empty() ? nullptr : &rendered.last[output];
  }

  const Job& job_;
  Stage& stage_;
  Readback readback_;
  std::vector<const Metric*> metrics_;
  Rendered original_, cached_;
  std::deque<FlipOriginal> flip_originals_;  // of the frame, by output
  std::vector<std::vector<Tile>> tiles_;     // of the frame and the entry's mask, by output
  CoverageMask mask_;
  std::vector<std::uint8_t> ages_, depth_mask_;
  JobProgress progress_;
};

}  // namespace

Result<JobResult> runErrors(const Job& job, const JobListener& progress) {
  REPRISE_ASSIGN(std::vector<const Metric*> wanted, wantedMetrics(job.metrics));
  REPRISE_ASSIGN(const std::unique_ptr<Stage> stage, setStage(job));
  return ErrorRun(job, *stage, std::move(wanted)).run(progress);
}

}  // namespace reprise
