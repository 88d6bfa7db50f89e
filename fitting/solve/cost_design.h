// Whether training frames can tell the terms of the cost model apart (Eq. 5, cost_model.h), judged before any time is fitted.
//
// Each frame is a row (hits, misses, 1) with the fragments over their mean. The least singular value σ of the rows over √N bounds
// what N times with the relative scatter s can say: some mix of Δhit, Δmiss and c stays uncertain by s / (σ √N) of a frame's time. σ must
// be such that this is 0.5 at most with s = 0.1 (what frame times on a CPU scatter by), and never under 0.01; these are the
// bounds of fit_cost.h with a scatter that is assumed instead of found. σ falls to 0 where coverage is the same in all frames, where
// the share of misses is, and where one follows the other.
#pragma once

#include <span>
#include <string>

#include "fitting/solve/fit_cost.h"

namespace reprise {

struct CostDesign {
  std::size_t frames = 0;           // with fragments
  double least_coverage = 0, most_coverage = 0;      // shaded fragments a frame
  double least_miss_share = 0, most_miss_share = 0;  // of a frame's fragments
  double singular_value = 0, needed_singular_value = 0;
  double coverage_deviation = 0;    // standard deviation of the fragments over their mean
  double miss_share_deviation = 0;  // standard deviation of the share

  bool isIdentifiable() const { return singular_value >= needed_singular_value; }
};

// Points without fragments are left out; times are not looked at.
CostDesign judgeCostDesign(std::span<const CostPoint> points);

// What varies too little, by how much, what was expected and what to do about it, in one sentence or two; "" if identifiable.
std::string explainCostDesign(const CostDesign& design);

}  // namespace reprise
