#include "fitting/solve/fit_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fitting/solve/family_fit.h"
#include "fitting/solve/student_t.h"
#include "runtime/base/check.h"

namespace reprise {

namespace {

constexpr int kAssumedPoints = 4;  // that scatter by exactly sigma
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<ErrorPoint> usablePoints(std::span<const ErrorPoint> points, double assumed_scatter) {
  std::vector<ErrorPoint> usable;
  for (const ErrorPoint& point : points) {
    if (point.period_frames >= 2 && std::isfinite(point.error) && point.error >= 0) usable.push_back(point);
  }
  std::stable_sort(usable.begin(), usable.end(), [](const ErrorPoint& a, const ErrorPoint& b) {
    return a.period_frames < b.period_frames;
  });
  double largest = 0;
  for (const ErrorPoint& point : usable) largest = std::max(largest, point.error);
  for (ErrorPoint& point : usable) {
    const bool given = std::isfinite(point.sigma) && point.sigma > 0;
    if (!given) point.sigma = assumed_scatter * std::max(point.error, 0.01 * largest);
  }
  return usable;
}

double informationCriterion(const FamilyFit& fit, std::size_t point_count) {
  const double n = static_cast<double>(point_count) + kAssumedPoints;
  const double k = static_cast<double>(fit.model->parameters.size()) + 1;
  return n * std::log((fit.chi_squared + kAssumedPoints) / n) + 2 * k + 2 * k * (k + 1) / (n - k - 1);
}

int degreesOfFreedom(std::size_t point_count, std::size_t parameter_count) {
  return kAssumedPoints + (point_count > parameter_count ? static_cast<int>(point_count - parameter_count) : 0);
}

double rSquared(const FamilyFit& fit, std::span<const ErrorPoint> points) {
  double mean = 0, largest = 0;
  for (const ErrorPoint& point : points) {
    mean += point.error / static_cast<double>(points.size());
    largest = std::max(largest, point.error);
  }
  double unexplained = 0, total = 0;
  for (const ErrorPoint& point : points) {
    const double residual = point.error - fit.model->value(fit.parameters.data(), point.period_frames);
    unexplained += residual * residual;
    total += (point.error - mean) * (point.error - mean);
  }
  if (unexplained <= 1e-18 * largest * largest) return 1;
  return total > 0 ? 1 - unexplained / total : 0;
}

ErrorFit zeroFit(std::vector<ErrorPoint> points) {
  ErrorFit fit;
  fit.family = "constant";
  fit.parameters = {{"a", 0, 0, 0}};
  fit.covariance = {0};
  fit.residuals.assign(points.size(), 0.0);
  fit.points = std::move(points);
  fit.r_squared = 1;
  fit.verdict = FitVerdict::kGood;
  fit.explanation = "every measured error is 0";
  return fit;
}

struct RelativeMisfit {
  double squares = 0;  // Σ (residual / predicted)²
  double assumed = 0;  // mean of (sigma / predicted)²
};

RelativeMisfit relativeMisfit(const ErrorFit& fit) {
  double largest = 0;
  for (const ErrorPoint& point : fit.points) largest = std::max(largest, point.error);
  RelativeMisfit misfit;
  for (std::size_t i = 0; i < fit.points.size(); ++i) {
    const double predicted = std::max(fit.points[i].error - fit.residuals[i], 0.01 * largest);
    const double residual = fit.residuals[i] / predicted, sigma = fit.points[i].sigma / predicted;
    misfit.squares += residual * residual;
    misfit.assumed += sigma * sigma / static_cast<double>(fit.points.size());
  }
  return misfit;
}

void addIntervals(const FamilyFit& family, ErrorFit* fit) {
  const std::size_t count = family.parameters.size();
  const int freedom = degreesOfFreedom(fit->points.size(), count);
  FamilyCovariance covariance = familyCovariance(family, fit->points);
  for (double& value : covariance.values) value *= (family.chi_squared + kAssumedPoints) / freedom;
  for (std::size_t i = 0; i < count; ++i) {
    const ModelParameter& bounds = family.model->parameters[i];
    FittedParameter parameter{bounds.name, family.parameters[i], bounds.lower, bounds.upper};
    if (covariance.determined[i]) {
      const double half = studentT975(freedom) * std::sqrt(covariance.values[i * count + i]);
      parameter.lo = std::max(bounds.lower, parameter.value - half);
      parameter.hi = std::min(bounds.upper, parameter.value + half);
    }
    fit->parameters.push_back(parameter);
  }
  fit->covariance = std::move(covariance.values);
}

void addVerdict(const ErrorFitOptions& options, double squares, ErrorFit* fit) {
  const std::size_t points = fit->points.size(), count = fit->parameters.size();
  const double misfit = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(points, count + 1) - count));
  const std::string percent = std::to_string(std::lround(100 * misfit)) + "%";
  if (points <= count) {
    fit->verdict = FitVerdict::kFewPoints;
    fit->explanation = std::to_string(points) + " measured periods for " + std::to_string(count) +
                       " parameters: the model meets them and nothing vouches for it";
  } else if (misfit > options.poor_scatter) {
    fit->verdict = FitVerdict::kPoor;
    fit->explanation = "the best model of the family still misses the measured errors by " + percent;
  } else {
    fit->verdict = FitVerdict::kGood;
    fit->explanation = "misses the measured errors by " + percent;
  }
}

// The family with the least criterion among those that converged; null if none did.
const FamilyFit* pickFamily(const std::vector<FamilyFit>& families, const std::vector<FamilyScore>& scores) {
  const FamilyFit* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < families.size(); ++i) {
    if (!families[i].converged || !(scores[i].aicc < least - 1e-6)) continue;
    least = scores[i].aicc;
    best = &families[i];
  }
  return best;
}

ErrorFit describeFit(const FamilyFit& family, std::vector<ErrorPoint> points, const ErrorFitOptions& options) {
  ErrorFit fit;
  fit.family = family.model->name;
  fit.points = std::move(points);
  for (const ErrorPoint& point : fit.points) {
    fit.residuals.push_back(point.error - family.model->value(family.parameters.data(), point.period_frames));
  }
  fit.r_squared = rSquared(family, fit.points);
  fit.aicc = informationCriterion(family, fit.points.size());
  addIntervals(family, &fit);
  const RelativeMisfit misfit = relativeMisfit(fit);
  fit.scatter = std::sqrt((misfit.squares + kAssumedPoints * misfit.assumed) /
                          degreesOfFreedom(fit.points.size(), family.parameters.size()));
  if (family.converged) {
    addVerdict(options, misfit.squares, &fit);
  } else {
    fit.verdict = FitVerdict::kNotConverged;
    fit.explanation = "the solver did not converge in " + std::to_string(options.max_iterations) + " iterations";
  }
  return fit;
}

}  // namespace

ErrorFit fitErrorModel(std::span<const ErrorPoint> points, const ErrorFitOptions& options) {
  REPRISE_CHECK(options.assumed_scatter > 0, options.assumed_scatter);
  REPRISE_CHECK(options.family.empty() || findErrorModel(options.family), options.family);
  std::vector<ErrorPoint> usable = usablePoints(points, options.assumed_scatter);
  if (usable.empty()) {
    ErrorFit fit;
    fit.explanation = "no finite error at a period of 2 or more";
    return fit;
  }
  const bool all_zero = std::all_of(usable.begin(), usable.end(), [](const ErrorPoint& point) {
    return point.error == 0;
  });
  if (all_zero) return zeroFit(std::move(usable));

  std::vector<FamilyFit> families;
  std::vector<FamilyScore> scores;
  for (const ErrorModel& model : errorModels()) {
    if (!options.family.empty() && options.family != model.name) continue;
    families.push_back(fitFamily(model, usable, options.max_iterations));
    const FamilyFit& family = families.back();
    scores.push_back({model.name, informationCriterion(family, usable.size()), rSquared(family, usable),
                      family.converged});
  }
  const FamilyFit* picked = pickFamily(families, scores);
  ErrorFit fit = describeFit(picked ? *picked : families.front(), std::move(usable), options);
  fit.families = std::move(scores);
  return fit;
}

ErrorPrediction predictError(const ErrorFit& fit, std::uint32_t period_frames) {
  REPRISE_CHECK(period_frames >= 1, period_frames);
  if (!isUsable(fit.verdict)) return {kNan, kNan, kNan};
  const ErrorModel* model = findErrorModel(fit.family);
  REPRISE_CHECK(model && model->parameters.size() == fit.parameters.size(), fit.family, fit.parameters.size());
  std::vector<double> parameters, derivatives(fit.parameters.size());
  for (const FittedParameter& parameter : fit.parameters) parameters.push_back(parameter.value);
  const double value = model->value(parameters.data(), period_frames);
  model->gradient(parameters.data(), period_frames, derivatives.data());
  double variance = fit.scatter * value * fit.scatter * value;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    for (std::size_t j = 0; j < parameters.size(); ++j) {
      variance += derivatives[i] * derivatives[j] * fit.covariance[i * parameters.size() + j];
    }
  }
  const double half =
      studentT975(degreesOfFreedom(fit.points.size(), parameters.size())) * std::sqrt(std::max(0.0, variance));
  return {std::clamp(value, 0.0, 1.0), std::clamp(value - half, 0.0, 1.0), std::clamp(value + half, 0.0, 1.0)};
}

}  // namespace reprise
