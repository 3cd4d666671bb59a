// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/float_start.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace raygauge {
namespace {

constexpr double kZero = 1e-10;      ///< values and reduced costs up to here count as zero
constexpr double kMinPivot = 1e-9;   ///< smallest pivot element
constexpr int kRefactorPeriod = 30;  ///< pivots between fresh inverses

using Matrix = Eigen::MatrixXd;

/// All columns, every row scaled by a power of two to a largest entry in [1/2, 1).
Matrix scaled_matrix(const ExactColumns& columns) {
  Matrix M(columns.rows() + 1, columns.count());
  for (std::ptrdiff_t j = 0; j < columns.count(); ++j) columns.copy(j, M.col(j).data());
  for (int row = 0; row + 1 < columns.rows(); ++row) {
    int exponent = 0;
    std::frexp(M.row(row).cwiseAbs().maxCoeff(), &exponent);
    for (double& entry : M.row(row)) entry = std::ldexp(entry, -exponent);
  }
  return M;
}

class FloatSimplex {
 public:
  explicit FloatSimplex(const ExactColumns& columns)
      : M_(scaled_matrix(columns)),
        m_(columns.rows()),
        basic_(static_cast<std::size_t>(m_), kArtificial),
        inverse_(Matrix::Identity(m_, m_)) {}

  /// One pivot. False at the end: optimal, infeasible, or lost in rounding.
  bool step() {
    const std::ptrdiff_t entering = find_entering();
    if (entering < 0) return false;
    const Vector y = inverse_ * M_.col(entering).head(m_);
    const int row = find_leaving(y);
    if (row < 0) return false;
    const Eigen::RowVectorXd pivot_row = inverse_.row(row) / y[row];
    inverse_.noalias() -= y * pivot_row;
    inverse_.row(row) = pivot_row;
    basic_[static_cast<std::size_t>(row)] = entering;
    if (++pivots_ % kRefactorPeriod == 0) refactor();
    return inverse_.allFinite();
  }

  std::vector<std::ptrdiff_t> structural() const {
    std::vector<std::ptrdiff_t> result;
    std::copy_if(basic_.begin(), basic_.end(), std::back_inserter(result), [](auto j) { return j >= 0; });
    return result;
  }

 private:
  static constexpr std::ptrdiff_t kArtificial = -1;

  bool is_artificial(int row) const { return basic_[static_cast<std::size_t>(row)] < 0; }
  double value(int row) const { return inverse_(row, m_ - 1); }

  /// The column of most negative reduced cost: of the sum of artificial variables while that is positive,
  /// then of the cost.
  std::ptrdiff_t find_entering() const {
    Vector infeasibility_dual = Vector::Zero(m_ + 1), cost_dual = Vector::Zero(m_ + 1);
    double infeasibility = 0;
    for (int row = 0; row < m_; ++row) {
      if (is_artificial(row)) {
        infeasibility += std::max(0.0, value(row));
        infeasibility_dual.head(m_) += inverse_.row(row);
      } else {
        cost_dual.head(m_) += M_(m_, basic_[static_cast<std::size_t>(row)]) * inverse_.row(row);
      }
    }
    cost_dual[m_] = -1;
    const Vector& dual = infeasibility > kZero ? infeasibility_dual : cost_dual;
    Eigen::RowVectorXd gain = dual.transpose() * M_;
    for (const std::ptrdiff_t j : basic_) {
      if (j >= 0) gain[j] = 0;
    }
    Eigen::Index best = 0;
    return gain.maxCoeff(&best) > kZero * (1 + dual.cwiseAbs().maxCoeff()) ? best : -1;
  }

  /// Ratio test; of the rows that tie within kZero the one with the largest pivot element.
  int find_leaving(const Vector& y) const {
    double limit = std::numeric_limits<double>::infinity();
    for (int row = 0; row < m_; ++row) {
      if (y[row] > kMinPivot) limit = std::min(limit, (std::max(0.0, value(row)) + kZero) / y[row]);
    }
    int best = -1;
    for (int row = 0; row < m_; ++row) {
      if (!(y[row] > kMinPivot) || std::max(0.0, value(row)) / y[row] > limit) continue;
      if (best < 0 || y[row] > y[best]) best = row;
    }
    return best;
  }

  void refactor() {
    Matrix B = Matrix::Identity(m_, m_);
    for (int row = 0; row < m_; ++row) {
      if (!is_artificial(row)) B.col(row) = M_.col(basic_[static_cast<std::size_t>(row)]).head(m_);
    }
    inverse_ = B.inverse();
  }

  Matrix M_;  ///< the rows of the program, then the costs
  Eigen::Index m_;
  std::vector<std::ptrdiff_t> basic_;
  Matrix inverse_;
  int pivots_ = 0;
};

}  // namespace

std::vector<std::ptrdiff_t> float_start(const ExactColumns& columns,
                                        std::chrono::steady_clock::time_point deadline) {
  FloatSimplex simplex(columns);
  const int most_pivots = 50 * columns.rows() + 100;
  for (int pivot = 0; pivot < most_pivots && std::chrono::steady_clock::now() < deadline; ++pivot) {
    if (!simplex.step()) break;
  }
  return simplex.structural();
}

}  // namespace raygauge
