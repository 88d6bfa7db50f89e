// Image error metrics. All are errors: 0 for identical images, in [0, 1], larger is worse.
//
// A metric reduces one frame to a value over the covered pixels; a session's value is the frames' combination: root of the
// pixel-weighted mean of squares for rms, pixel-weighted mean for most others; p95 takes the mean over frames, `largest` the worst frame, and
// metrics of tiles the 99th percentile over the tiles of all frames (tiles.h).
// A frame without covered pixels gives 0 and has no weight. A covered pixel that is not finite gives NaN: count such pixels
// (ErrorRow::nonfinite) and report them before metrics are read.
//
// A new metric is one file pair, one line in registry.cpp; tests/metrics iterates over metrics().
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "profiler/metrics/image.h"

namespace reprise {

class FlipOriginal;
struct Tile;

// All images and the mask must have the same extent (checked).
struct MetricInputs {
  const DisplayImage* original = nullptr;
  const DisplayImage* cached = nullptr;
  const DisplayImage* last_original = nullptr;  // of the frame before; null in the first frame
  const DisplayImage* last_cached = nullptr;
  const CoverageMask* mask = nullptr;
  const std::vector<std::uint8_t>* ages = nullptr;  // by pixel: frames since its payload was computed; null where the variant does not count
  const FlipOriginal* flip_original = nullptr;      // of `original`, for all variants of the frame; null: made where it is needed
  const std::vector<Tile>* tiles = nullptr;         // of `original` and `mask`, for all metrics (tiles.h); null: made where they are needed
};

enum class SessionCombination {
  kRootMeanSquare,  // weighted by covered pixels
  kMean,            // weighted by covered pixels
  kFrameMean,       // over the frames that have covered pixels
  kWorst,           // of all frames
  kTail             // 99th percentile over the tiles of all frames
};

struct Metric {
  std::string name;         // "rms", "mean", ...
  std::string description;  // one sentence with the formula
  SessionCombination combination = SessionCombination::kMean;
  bool expensive = false;   // computed only where asked for
  bool adapts = false;      // to how bright the original is: not the same when original and cached change places
  std::function<double(const MetricInputs&)> evaluate;              // empty for metrics of tiles
  std::function<std::vector<float>(const MetricInputs&)> tiles = {};  // kTail: the value of each tile that counts

  // Of the frame; of metrics of tiles their 99th percentile in it.
  double value(const MetricInputs& inputs) const;
};

// The registry, an explicit table; docs/metrics.md says what each is for.
std::span<const Metric> metrics();
const Metric* findMetric(const std::string& name);
std::string metricNames();  // "rms, mean, ..."

// What a frame of a session adds to it.
struct MetricFrame {
  double value = 0;
  double covered = 0;                                // pixels
  const std::vector<std::uint16_t>* tiles = nullptr; // kTail, as keptTiles has them
};

// A metric over the frames of a session, weighted by their covered pixels. NaN if no pixel was covered.
double combineFrames(const Metric& metric, std::span<const MetricFrame> frames);

}  // namespace reprise
