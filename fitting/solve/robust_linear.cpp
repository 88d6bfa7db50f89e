#include "fitting/solve/robust_linear.h"

#include <ceres/ceres.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fitting/solve/quiet_solver.h"
#include "runtime/base/check.h"

namespace reprise {

namespace {

constexpr int kRounds = 8;
constexpr double kHuberBend = 1.345;      // 95% efficiency for normal scatter
constexpr double kFirstScatter = 0.1;     // before residuals have shown it
constexpr double kLeastScatter = 1e-6;    // exact rows: keeps the loss from having no width
constexpr double kMadToSigma = 1.4826;

// Which terms take part; the others' coefficients are held at 0.
using TermSet = std::vector<int>;

class RowResidual : public ceres::CostFunction {
 public:
  RowResidual(const LinearRow& row, const TermSet& terms, double weight) {
    for (const int term : terms) terms_.push_back(row.terms[term] * weight);
    observed_ = row.observed * weight;
    set_num_residuals(1);
    mutable_parameter_block_sizes()->push_back(static_cast<int>(terms.size()));
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    residuals[0] = -observed_;
    for (std::size_t i = 0; i < terms_.size(); ++i) residuals[0] += terms_[i] * parameters[0][i];
    if (jacobians && jacobians[0]) std::copy(terms_.begin(), terms_.end(), jacobians[0]);
    return true;
  }

 private:
  std::vector<double> terms_;
  double observed_ = 0;
};

double predictRow(const LinearRow& row, const std::vector<double>& coefficients) {
  double predicted = 0;
  for (std::size_t i = 0; i < coefficients.size(); ++i) predicted += row.terms[i] * coefficients[i];
  return predicted;
}

// A prediction may be 0 (all coefficients at their bound) where the observation is not.
double weightOf(const LinearRow& row, const std::vector<double>& coefficients) {
  return 1 / std::max(predictRow(row, coefficients), 0.05 * row.observed);
}

struct RoundSolution {
  std::vector<double> coefficients;
  double cost = std::numeric_limits<double>::infinity();
  bool converged = false;
};

RoundSolution solveUnbounded(std::span<const LinearRow> rows, const TermSet& terms, const std::vector<double>& last,
                             double scatter, int max_iterations) {
  std::vector<double> values;
  for (const int term : terms) values.push_back(last[term]);
  ceres::Problem problem;
  for (const LinearRow& row : rows) {
    problem.AddResidualBlock(new RowResidual(row, terms, weightOf(row, last)),
                             new ceres::HuberLoss(kHuberBend * scatter), values.data());
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = max_iterations;
  options.function_tolerance = 1e-10;
  options.parameter_tolerance = 1e-9;
  options.num_threads = 1;
  ceres::Solver::Summary summary;
  silenceSolverLog();
  ceres::Solve(options, &problem, &summary);
  RoundSolution solution{std::vector<double>(last.size(), 0.0), summary.final_cost, false};
  for (std::size_t i = 0; i < terms.size(); ++i) solution.coefficients[terms[i]] = values[i];
  solution.converged = summary.termination_type == ceres::CONVERGENCE && std::isfinite(summary.final_cost);
  return solution;
}

bool hasNegative(const std::vector<double>& coefficients) {
  return std::any_of(coefficients.begin(), coefficients.end(), [](double value) { return value < 0; });
}

// The problem is convex: an unbounded solution without negative coefficients is the bounded one, else the bounded one is the
// best of those with some coefficients at 0. Ceres' own bounds stall where the optimum lies on them.
RoundSolution solveRound(std::span<const LinearRow> rows, const std::vector<double>& last, double scatter,
                         int max_iterations) {
  const unsigned all = (1u << last.size()) - 1;
  RoundSolution best;
  best.coefficients = last;
  for (unsigned members = all; members > 0; --members) {
    TermSet terms;
    for (int term = 0; term < static_cast<int>(last.size()); ++term) {
      if (members & (1u << term)) terms.push_back(term);
    }
    RoundSolution solution = solveUnbounded(rows, terms, last, scatter, max_iterations);
    if (!solution.converged || hasNegative(solution.coefficients)) continue;
    if (solution.cost < best.cost) best = std::move(solution);
    if (members == all) break;
  }
  return best;
}

double robustScatter(std::span<const LinearRow> rows, const std::vector<double>& coefficients) {
  std::vector<double> magnitudes;
  for (const LinearRow& row : rows) {
    magnitudes.push_back(std::abs(row.observed - predictRow(row, coefficients)) * weightOf(row, coefficients));
  }
  const std::size_t middle = magnitudes.size() / 2;
  std::nth_element(magnitudes.begin(), magnitudes.begin() + middle, magnitudes.end());
  const double n = static_cast<double>(rows.size()), freedom = n - static_cast<double>(coefficients.size());
  return std::max(kLeastScatter, kMadToSigma * magnitudes[middle] * std::sqrt(n / std::max(freedom, 1.0)));
}

std::vector<double> standardErrors(std::span<const LinearRow> rows, const RobustLinearFit& fit) {
  const int term_count = static_cast<int>(fit.coefficients.size());
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(term_count, term_count);
  for (const LinearRow& row : rows) {
    const double weight = weightOf(row, fit.coefficients);
    const double residual = std::abs(row.observed - predictRow(row, fit.coefficients)) * weight;
    const double bend = kHuberBend * fit.scatter;
    const double share = residual > bend ? bend / residual : 1;
    const Eigen::Map<const Eigen::VectorXd> terms(row.terms, term_count);
    normal += share * weight * weight * terms * terms.transpose();
  }
  const Eigen::FullPivLU<Eigen::MatrixXd> decomposition(normal);
  std::vector<double> errors(term_count, std::numeric_limits<double>::infinity());
  if (!decomposition.isInvertible()) return errors;
  const Eigen::MatrixXd inverse = decomposition.inverse();
  for (int i = 0; i < term_count; ++i) errors[i] = fit.scatter * std::sqrt(std::max(0.0, inverse(i, i)));
  return errors;
}

void checkRows(std::span<const LinearRow> rows, int term_count) {
  REPRISE_CHECK(!rows.empty() && term_count >= 1 && term_count <= 3, rows.size(), term_count);
  for (const LinearRow& row : rows) REPRISE_CHECK(row.observed > 0, row.observed);
}

}  // namespace

RobustLinearFit fitRobustLinear(std::span<const LinearRow> rows, int term_count, int max_iterations) {
  checkRows(rows, term_count);
  RobustLinearFit fit;
  fit.coefficients.assign(term_count, 1.0 / term_count);
  fit.scatter = kFirstScatter;
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<double> last = fit.coefficients;
    RoundSolution solution = solveRound(rows, last, fit.scatter, max_iterations);
    fit.coefficients = std::move(solution.coefficients);
    fit.converged = solution.converged;
    if (!fit.converged) return fit;
    fit.scatter = robustScatter(rows, fit.coefficients);
    double change = 0;
    for (int i = 0; i < term_count; ++i) change = std::max(change, std::abs(fit.coefficients[i] - last[i]));
    if (round > 0 && change < 1e-6) break;
  }
  fit.standard_errors = standardErrors(rows, fit);
  return fit;
}

double leastSingularValue(std::span<const LinearRow> rows, int term_count) {
  checkRows(rows, term_count);
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(term_count, term_count);
  for (const LinearRow& row : rows) {
    const Eigen::VectorXd terms = Eigen::Map<const Eigen::VectorXd>(row.terms, term_count) / row.observed;
    normal += terms * terms.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(normal / static_cast<double>(rows.size()));
  return std::sqrt(std::max(0.0, eigen.eigenvalues()(0)));
}

}  // namespace reprise
