// Image error metrics. All are errors: 0 for identical images, in [0, 1], larger is worse.
//
// A metric reduces one frame to a value over the covered pixels; a session's value is the frames' combination: root of the
// pixel-weighted mean of squares for rms, pixel-weighted mean for the others, except p95 (mean over frames).
// A frame without covered pixels gives 0 and has no weight. A covered pixel that is not finite gives NaN: count such pixels
// (ErrorRow::nonfinite) and report them before metrics are read.
//
// A new metric is one file pair, one line in registry.cpp; tests/metrics iterates over metrics().
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "profiler/metrics/image.h"

namespace reprise {

// All images and the mask must have the same extent (checked).
struct MetricInputs {
  const DisplayImage* original = nullptr;
  const DisplayImage* cached = nullptr;
  const DisplayImage* last_original = nullptr;  // of the frame before; null in the first frame
  const DisplayImage* last_cached = nullptr;
  const CoverageMask* mask = nullptr;
  const std::vector<std::uint8_t>* ages = nullptr;  // by pixel: frames since the payload that it shows was computed; null where not known
};

enum class SessionCombination {
  kRootMeanSquare,  // weighted by covered pixels
  kMean,            // weighted by covered pixels
  kFrameMean        // over the frames that have covered pixels
};

struct Metric {
  std::string name;         // "rms", "mean", "p95", "ssim", "flip", "over8", "flicker"
  std::string description;  // one sentence with the formula
  SessionCombination combination = SessionCombination::kMean;
  bool expensive = false;   // computed only where asked for
  std::function<double(const MetricInputs&)> evaluate;
};

// The registry, an explicit table: rms, mean, p95, ssim (1 - SSIM), flip, over8 (share of pixels whose largest channel
// difference exceeds 8/255; Mueller 2021), flicker (RMS of the frame-to-frame change of the difference).
std::span<const Metric> metrics();
const Metric* findMetric(const std::string& name);

// Values of a metric over the frames of a session, weighted by their covered pixels. NaN if no pixel was covered.
double combineFrames(const Metric& metric, std::span<const double> per_frame, std::span<const double> covered);

}  // namespace reprise
