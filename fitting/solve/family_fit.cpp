#include "fitting/solve/family_fit.h"

#include <ceres/ceres.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fitting/solve/quiet_solver.h"

namespace reprise {

namespace {

// (ε̂(n) − ε) / sigma of one point, with the model's own derivatives.
class PointResidual : public ceres::CostFunction {
 public:
  PointResidual(const ErrorModel& model, const ErrorPoint& point) : model_(model), point_(point) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->push_back(static_cast<int>(model.parameters.size()));
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    residuals[0] = (model_.value(parameters[0], point_.period_frames) - point_.error) / point_.sigma;
    if (jacobians && jacobians[0]) {
      model_.gradient(parameters[0], point_.period_frames, jacobians[0]);
      for (std::size_t i = 0; i < model_.parameters.size(); ++i) jacobians[0][i] /= point_.sigma;
    }
    return std::isfinite(residuals[0]);
  }

 private:
  const ErrorModel& model_;
  const ErrorPoint point_;
};

FamilyFit fitFrom(const ErrorModel& model, std::span<const ErrorPoint> points, std::vector<double> start,
                  int max_iterations) {
  FamilyFit fit{&model, std::move(start), 0, false};
  ceres::Problem problem;
  for (const ErrorPoint& point : points) {
    problem.AddResidualBlock(new PointResidual(model, point), nullptr, fit.parameters.data());
  }
  for (std::size_t i = 0; i < model.parameters.size(); ++i) {
    const int index = static_cast<int>(i);
    problem.SetParameterLowerBound(fit.parameters.data(), index, model.parameters[i].lower);
    problem.SetParameterUpperBound(fit.parameters.data(), index, model.parameters[i].upper);
    fit.parameters[i] = std::clamp(fit.parameters[i], model.parameters[i].lower, model.parameters[i].upper);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = max_iterations;
  options.function_tolerance = 1e-12;
  options.parameter_tolerance = 1e-10;
  options.num_threads = 1;
  ceres::Solver::Summary summary;
  silenceSolverLog();
  ceres::Solve(options, &problem, &summary);
  fit.chi_squared = 2 * summary.final_cost;
  fit.converged = summary.termination_type == ceres::CONVERGENCE && std::isfinite(fit.chi_squared);
  return fit;
}

bool isAtBound(const ModelParameter& parameter, double value) {
  const double slack = 1e-9 * (parameter.upper - parameter.lower);
  return value <= parameter.lower + slack || value >= parameter.upper - slack;
}

}  // namespace

FamilyFit fitFamily(const ErrorModel& model, std::span<const ErrorPoint> points, int max_iterations) {
  FamilyFit best{&model, {}, std::numeric_limits<double>::infinity(), false};
  for (const std::vector<double>& start : model.starts(points)) {
    FamilyFit fit = fitFrom(model, points, start, max_iterations);
    const bool better = fit.converged != best.converged ? fit.converged : fit.chi_squared < best.chi_squared;
    if (better || best.parameters.empty()) best = std::move(fit);
  }
  return best;
}

FamilyCovariance familyCovariance(const FamilyFit& fit, std::span<const ErrorPoint> points) {
  const ErrorModel& model = *fit.model;
  const std::size_t count = model.parameters.size();
  Eigen::MatrixXd jacobian(points.size(), count);
  std::vector<double> derivatives(count);
  for (std::size_t row = 0; row < points.size(); ++row) {
    model.gradient(fit.parameters.data(), points[row].period_frames, derivatives.data());
    for (std::size_t i = 0; i < count; ++i) jacobian(row, i) = derivatives[i] / points[row].sigma;
  }
  FamilyCovariance covariance{std::vector<double>(count * count, 0.0), std::vector<bool>(count, false)};
  std::vector<int> free;
  for (std::size_t i = 0; i < count; ++i) {
    if (!isAtBound(model.parameters[i], fit.parameters[i]) && jacobian.col(i).norm() > 0) {
      free.push_back(static_cast<int>(i));
    }
  }
  if (free.empty()) return covariance;
  Eigen::MatrixXd reduced(points.size(), free.size());
  for (std::size_t j = 0; j < free.size(); ++j) reduced.col(j) = jacobian.col(free[j]).normalized();
  const Eigen::MatrixXd normal = reduced.transpose() * reduced;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(normal);
  if (eigen.eigenvalues()(0) < 1e-10) return covariance;
  const Eigen::MatrixXd inverse = normal.inverse();
  for (std::size_t i = 0; i < free.size(); ++i) {
    covariance.determined[free[i]] = true;
    for (std::size_t j = 0; j < free.size(); ++j) {
      covariance.values[free[i] * count + free[j]] =
          inverse(i, j) / (jacobian.col(free[i]).norm() * jacobian.col(free[j]).norm());
    }
  }
  return covariance;
}

}  // namespace reprise
