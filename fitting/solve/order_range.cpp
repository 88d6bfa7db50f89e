#include "fitting/solve/order_range.h"

#include <algorithm>
#include <cmath>

#include "runtime/base/check.h"

namespace reprise {

namespace {

constexpr double kNormal975 = 1.959964;
constexpr double kRounding = 1e-9;  // 100 * (1 - 0.9) / 2 is 5

OrderRange withoutEnds(std::vector<double>& values, std::size_t left_out) {
  std::sort(values.begin(), values.end());
  return {values[left_out], values[values.size() - 1 - left_out]};
}

}  // namespace

OrderRange medianInterval(std::vector<double> values) {
  REPRISE_CHECK(!values.empty(), "no values");
  const auto count = static_cast<double>(values.size());
  const double rank = std::floor((count - kNormal975 * std::sqrt(count)) / 2);
  return withoutEnds(values, rank > 1 ? static_cast<std::size_t>(rank) - 1 : 0);
}

OrderRange middleRange(std::vector<double> values, double share) {
  REPRISE_CHECK(!values.empty() && share > 0 && share <= 1, "a share of some values");
  return withoutEnds(values, static_cast<std::size_t>(static_cast<double>(values.size()) * (1 - share) / 2 + kRounding));
}

}  // namespace reprise
