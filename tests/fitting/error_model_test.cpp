// What holds for every model of the error family.
#include "fitting/models/error_model.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <set>

#include "tests/fitting/synthetic.h"

namespace reprise {
namespace {

// A point well inside the bounds of the model's parameters, drawn evenly in the logarithm.
std::vector<double> drawParameters(const ErrorModel& model) {
  std::vector<double> parameters;
  for (const ModelParameter& parameter : model.parameters) {
    const double unit = *rc::gen::inRange(0, 10'001) / 10'000.0;
    const double lower = std::max(parameter.lower, 1e-3 * parameter.upper) * 1.01;
    parameters.push_back(lower * std::pow(0.99 * parameter.upper / lower, unit));
  }
  return parameters;
}

TEST(ErrorModels, AreFoundByTheirNames) {
  std::set<std::string> names;
  for (const ErrorModel& model : errorModels()) {
    EXPECT_TRUE(names.insert(model.name).second) << model.name;
    EXPECT_EQ(findErrorModel(model.name), &model);
  }
  EXPECT_EQ(names, (std::set<std::string>{"constant", "exponential", "logarithm", "power"}));
  EXPECT_EQ(findErrorModel("cubic"), nullptr);
}

RC_GTEST_PROP(ErrorModels, HaveTheDerivativesTheyClaim, ()) {
  const double period = *rc::gen::inRange(2, 65);
  for (const ErrorModel& model : errorModels()) {
    const std::vector<double> parameters = drawParameters(model);
    std::vector<double> derivatives(parameters.size());
    model.gradient(parameters.data(), period, derivatives.data());
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const double step = 1e-5 * parameters[i];
      std::vector<double> above = parameters, below = parameters;
      above[i] += step;
      below[i] -= step;
      const double above_value = model.value(above.data(), period), below_value = model.value(below.data(), period);
      const double slope = (above_value - below_value) / (2 * step);
      // Central differences of order 1e-10 relative, and rounding of the values over the step.
      const double rounding = 1e-15 * std::abs(above_value) / step;
      RC_ASSERT(std::abs(slope - derivatives[i]) <= 1e-6 * std::abs(slope) + 10 * rounding);
    }
  }
}

RC_GTEST_PROP(ErrorModels, AreZeroAtPeriodOneAndNeverFall, ()) {
  for (const ErrorModel& model : errorModels()) {
    const std::vector<double> parameters = drawParameters(model);
    RC_ASSERT(model.value(parameters.data(), 1) == 0.0);
    double last = 0;
    for (int period = 2; period <= 128; ++period) {
      const double value = model.value(parameters.data(), period);
      RC_ASSERT(value >= last);
      last = value;
    }
  }
}

RC_GTEST_PROP(ErrorModels, StartInsideTheirBounds, (std::uint32_t seed)) {
  Noise noise(seed);
  std::vector<ErrorPoint> points;
  for (const std::uint32_t period : kPeriods) points.push_back({period, noise.uniform(0, 1), 0});
  points[0].error = 0;
  for (const ErrorModel& model : errorModels()) {
    const auto starts = model.starts(points);
    RC_ASSERT(!starts.empty());
    for (const std::vector<double>& start : starts) {
      RC_ASSERT(start.size() == model.parameters.size());
      for (std::size_t i = 0; i < start.size(); ++i) {
        RC_ASSERT(start[i] >= model.parameters[i].lower);
        RC_ASSERT(start[i] <= model.parameters[i].upper);
      }
    }
  }
}

TEST(ExponentialModel, IsEquation4) {
  const double parameters[] = {0.2, 0.1};
  EXPECT_NEAR(findErrorModel("exponential")->value(parameters, 11), 0.2 * (1 - std::exp(-1.0)), 1e-12);
}

}  // namespace
}  // namespace reprise
