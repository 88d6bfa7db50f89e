#include "fitting/solve/fit_cost.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fitting/solve/robust_linear.h"
#include "fitting/solve/student_t.h"

namespace reprise {

namespace {

constexpr double kLeastSingularValue = 0.01;
constexpr double kMostUncertainty = 0.5;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Which parameters the rows can tell apart; what is not told apart is assumed.
enum class Terms { kAll, kWithoutOverhead, kHitEqualsMiss, kHitEqualsMissWithoutOverhead };

int termCount(Terms terms) {
  switch (terms) {
    case Terms::kAll: return 3;
    case Terms::kWithoutOverhead: return 2;
    case Terms::kHitEqualsMiss: return 2;
    case Terms::kHitEqualsMissWithoutOverhead: return 1;
  }
  return 0;
}

// Divisors that bring fragments and times to order 1, so that one tolerance of the solver suits all.
struct Units {
  double fragments = 1;
  double frame_time_ms = 1;
  double nsPerFragment() const { return frame_time_ms / fragments * 1e6; }
};

bool isUsablePoint(const CostPoint& point) {
  return std::isfinite(point.hits) && std::isfinite(point.misses) && point.hits >= 0 && point.misses >= 0 &&
         point.hits + point.misses > 0 && std::isfinite(point.frame_time_ms) && point.frame_time_ms > 0;
}

LinearRow makeRow(const CostPoint& point, Terms terms, const Units& units) {
  const double hits = point.hits / units.fragments, misses = point.misses / units.fragments;
  const double observed = point.frame_time_ms / units.frame_time_ms;
  switch (terms) {
    case Terms::kAll: return {{hits, misses, 1}, observed};
    case Terms::kWithoutOverhead: return {{hits, misses, 0}, observed};
    case Terms::kHitEqualsMiss: return {{hits + misses, 1, 0}, observed};
    case Terms::kHitEqualsMissWithoutOverhead: return {{hits + misses, 0, 0}, observed};
  }
  return {};
}

std::vector<LinearRow> makeRows(const std::vector<CostPoint>& points, Terms terms, const Units& units) {
  std::vector<LinearRow> rows;
  for (const CostPoint& point : points) rows.push_back(makeRow(point, terms, units));
  return rows;
}

// Observed times carry their scatter into the scaling; the scatter of one row hardly moves the whole.
double tellsApart(const std::vector<CostPoint>& points, Terms terms, const Units& units) {
  return leastSingularValue(makeRows(points, terms, units), termCount(terms));
}

// The richest set of terms that the rows tell apart. scatter: relative, of the times; 0 if not known yet.
Terms identifiableTerms(const std::vector<CostPoint>& points, const Units& units, double scatter) {
  const double needed = std::max(
      kLeastSingularValue, scatter / (kMostUncertainty * std::sqrt(static_cast<double>(points.size()))));
  if (points.size() >= 3 && tellsApart(points, Terms::kAll, units) >= needed) return Terms::kAll;
  const double without_overhead = tellsApart(points, Terms::kWithoutOverhead, units);
  const double hit_equals_miss = tellsApart(points, Terms::kHitEqualsMiss, units);
  if (points.size() < 2 || std::max(without_overhead, hit_equals_miss) < needed) {
    return Terms::kHitEqualsMissWithoutOverhead;
  }
  return without_overhead >= hit_equals_miss ? Terms::kWithoutOverhead : Terms::kHitEqualsMiss;
}

std::string explainTerms(Terms terms) {
  switch (terms) {
    case Terms::kAll: return "";
    case Terms::kWithoutOverhead:
      return "unidentifiable: coverage does not vary enough to tell the overhead from the cost of fragments; an overhead of 0 "
             "is assumed, which holds at this coverage only";
    case Terms::kHitEqualsMiss:
      return "unidentifiable: the share of misses does not vary enough to tell hits from misses; equal costs are assumed, which "
             "holds at this hit rate only";
    case Terms::kHitEqualsMissWithoutOverhead:
      return "unidentifiable: neither coverage nor the share of misses varies enough; no overhead and equal costs of hits and "
             "misses are assumed, which holds at this coverage and hit rate only";
  }
  return "";
}

FittedParameter makeParameter(const char* name, double value, double standard_error, double factor) {
  const double half = factor * standard_error;
  return {name, value, std::max(0.0, value - half), value + half};
}

void addParameters(const RobustLinearFit& solution, Terms terms, const Units& units, CostFit* fit) {
  const std::size_t points = fit->residuals_ms.size();
  const int freedom = static_cast<int>(points) - termCount(terms);
  const bool has_intervals = freedom > 0 && solution.standard_errors.size() == solution.coefficients.size();
  const double factor = freedom > 0 ? studentT975(freedom) : 1;
  const auto fragmentCost = [&](const char* name, std::size_t i) {
    const double error = has_intervals ? solution.standard_errors[i] : kInfinity;
    return makeParameter(name, solution.coefficients[i] * units.nsPerFragment(), error * units.nsPerFragment(), factor);
  };
  const bool equal = terms == Terms::kHitEqualsMiss || terms == Terms::kHitEqualsMissWithoutOverhead;
  fit->hit_ns = fragmentCost("hit_ns", 0);
  fit->miss_ns = fragmentCost("miss_ns", equal ? 0 : 1);
  if (terms == Terms::kAll || terms == Terms::kHitEqualsMiss) {
    const std::size_t i = equal ? 1 : 2;
    const double error = has_intervals ? solution.standard_errors[i] : kInfinity;
    fit->overhead_ms = makeParameter("overhead_ms", solution.coefficients[i] * units.frame_time_ms,
                                     error * units.frame_time_ms, factor);
  } else {
    fit->overhead_ms = {"overhead_ms", 0, 0, kInfinity};
  }
  fit->cost = {fit->hit_ns.value, fit->miss_ns.value, fit->overhead_ms.value};
}

void addResiduals(const std::vector<CostPoint>& points, CostFit* fit) {
  double mean = 0;
  for (const CostPoint& point : points) mean += point.frame_time_ms / static_cast<double>(points.size());
  double unexplained = 0, total = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CostPoint& point = points[i];
    const double residual = point.frame_time_ms - frameTimeMs(fit->cost, point.hits, point.misses);
    fit->residuals_ms[i] = residual;
    unexplained += residual * residual;
    total += (point.frame_time_ms - mean) * (point.frame_time_ms - mean);
  }
  const bool exact = unexplained <= 1e-12 * mean * mean;
  fit->r_squared = exact ? 1 : total > 0 ? 1 - unexplained / total : 0;
}

void addVerdict(Terms terms, const CostFitOptions& options, CostFit* fit) {
  const std::string percent = std::to_string(std::lround(100 * fit->scatter)) + "%";
  if (terms != Terms::kAll) {
    fit->verdict = FitVerdict::kUnidentifiable;
    fit->explanation = explainTerms(terms);
  } else if (fit->residuals_ms.size() <= 3) {
    fit->verdict = FitVerdict::kFewPoints;
    fit->explanation = "3 frames for 3 parameters: the model meets them and nothing vouches for it";
  } else if (fit->scatter > options.poor_scatter) {
    fit->verdict = FitVerdict::kPoor;
    fit->explanation = "frame times scatter about the model by " + percent;
  } else {
    fit->verdict = FitVerdict::kGood;
    fit->explanation = "frame times scatter about the model by " + percent;
  }
}

}  // namespace

CostFit fitCost(std::span<const CostPoint> all_points, const CostFitOptions& options) {
  CostFit fit;
  std::vector<CostPoint> points;
  std::copy_if(all_points.begin(), all_points.end(), std::back_inserter(points), isUsablePoint);
  if (points.empty()) {
    fit.explanation = "no frame with fragments and a positive time";
    return fit;
  }
  Units units{0, 0};
  for (const CostPoint& point : points) {
    units.fragments += (point.hits + point.misses) / static_cast<double>(points.size());
    units.frame_time_ms += point.frame_time_ms / static_cast<double>(points.size());
  }

  Terms terms = identifiableTerms(points, units, 0);
  RobustLinearFit solution;
  for (int attempt = 0; attempt < 3; ++attempt) {
    solution = fitRobustLinear(makeRows(points, terms, units), termCount(terms), options.max_iterations);
    // The scatter is known only now; it may leave fewer terms that can be told apart.
    const Terms supported = identifiableTerms(points, units, solution.converged ? solution.scatter : 0);
    if (!solution.converged || termCount(supported) >= termCount(terms)) break;
    terms = supported;
  }
  fit.scatter = solution.scatter;
  fit.residuals_ms.assign(points.size(), 0.0);
  addParameters(solution, terms, units, &fit);
  addResiduals(points, &fit);
  if (solution.converged) {
    addVerdict(terms, options, &fit);
  } else {
    fit.verdict = FitVerdict::kNotConverged;
    fit.explanation = "the solver did not converge in " + std::to_string(options.max_iterations) + " iterations";
  }
  return fit;
}

double predictFrameTime(const CostFit& fit, double hits, double misses) {
  if (!isUsable(fit.verdict)) return std::numeric_limits<double>::quiet_NaN();
  return frameTimeMs(fit.cost, hits, misses);
}

}  // namespace reprise
