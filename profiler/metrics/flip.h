// LDR-FLIP: mean over covered pixels of ΔE = (ΔE_c)^(1 − ΔE_f), in [0, 1]. ΔE_c is the colour difference after filtering
// with contrast sensitivity functions, ΔE_f that of edges and points.
// Source: P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. D. Fairchild, "FLIP: A Difference
// Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020, sections 4.1 (colour pipeline),
// 4.2 (feature pipeline) and 4.3 (final difference), with the constants of the authors' published code.
// Images are taken as sRGB-encoded, seen at 67 pixels per degree (a 0.7 m wide screen of 3840 pixels at 0.7 m). The filters
// reach over the border of the mask: uncovered pixels count as the original has them, in both images.
// Known to be wrong: blind to flicker; too strict where the viewer sits further away.
//
// tile_flip is the mean over the covered pixels of each tile (tiles.h), at the image as it is and, of dark tiles, at the exposure
// of 1.4, 2, 2.8 or 4 that is nearest to the tile's gain; the larger counts.
#pragma once

#include <memory>

#include "profiler/metrics/metrics.h"

namespace reprise {

// What FLIP takes of the original alone, half of its work: made once a frame for all variants, at each exposure when it is first needed.
// Safe to ask from several threads. The image must outlive it.
class FlipOriginal {
 public:
  explicit FlipOriginal(const DisplayImage& original);
  ~FlipOriginal();

  struct Halves;
  Halves& halves() const { return *halves_; }  // made as they are asked for

 private:
  std::unique_ptr<Halves> halves_;
};

Metric flipMetric();
Metric tileFlipMetric();

}  // namespace reprise
