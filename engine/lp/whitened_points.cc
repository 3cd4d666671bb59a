// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/whitened_points.h"

#include <algorithm>
#include <cmath>

#include "engine/lp/affords.h"
#include "engine/numerics/decompositions.h"

namespace raygauge {
namespace {

using Eigen::MatrixXd;

constexpr double kSpan = 1e-15;     // the least entry of the diagonal of R, relative to the largest
constexpr double kSample = 1.5;     // points for each dimension that R is of
constexpr Eigen::Index kTurn = 64;  // points that are turned between two looks at the clock

// The points of both pools as columns.
MatrixXd gathered(const ColumnPool& A, const ColumnPool& Q, int n) {
  MatrixXd points(n, A.size() + Q.size());
  for (Eigen::Index i = 0; i < A.size(); ++i) A.copy_point(i, points.col(i).data());
  for (Eigen::Index i = 0; i < Q.size(); ++i) Q.copy_point(i, points.col(A.size() + i).data());
  return points;
}

// `count` of the points, evenly spread, as rows.
MatrixXd sample(const MatrixXd& points, Eigen::Index count) {
  MatrixXd rows(count, points.rows());
  for (Eigen::Index i = 0; i < count; ++i) rows.row(i) = points.col(i * points.cols() / count);
  return rows;
}

// R of `count` of the points; empty where they do not span R^n, or nearly so, or there is no time.
MatrixXd triangle(const MatrixXd& points, Eigen::Index count, const Stopwatch& stopwatch) {
  const auto n = static_cast<double>(points.rows());
  if (!affords(stopwatch, static_cast<double>(count) * n * n)) return {};
  MatrixXd R = qr_triangle(sample(points, count));
  const Eigen::VectorXd diagonal = R.diagonal().cwiseAbs();
  if (!(diagonal.minCoeff() > kSpan * diagonal.maxCoeff())) return {};
  return R / std::sqrt(static_cast<double>(count));
}

// Columns first … first + size of W, in blocks; the last one is repeated where the last block has room.
std::ptrdiff_t place(const MatrixXd& W, Eigen::Index first, Eigen::Index size, AlignedBuffer<double>& out) {
  constexpr Eigen::Index kLanes = PointSet::kLanes;
  const Eigen::Index blocks = (size + kLanes - 1) / kLanes, n = W.rows();
  out.reserve(static_cast<std::size_t>(blocks * n * kLanes));
  for (Eigen::Index i = 0; i < blocks * kLanes; ++i) {
    const Eigen::Index column = first + std::min(i, size - 1);
    double* lane = out.data() + i / kLanes * n * kLanes + i % kLanes;
    for (Eigen::Index k = 0; k < n; ++k) lane[k * kLanes] = W(k, column);
  }
  return blocks;
}

}  // namespace

bool WhitenedPoints::compute(const ColumnPool& A, const ColumnPool& Q, int n, const Stopwatch& stopwatch) {
  n_ = n;
  size_A_ = A.size();
  size_Q_ = Q.size();
  const Eigen::Index all = size_A_ + size_Q_;
  if (all < n) return false;
  MatrixXd points = gathered(A, Q, n);
  const Eigen::Index few = std::min(all, static_cast<Eigen::Index>(std::ceil(kSample * n)));
  MatrixXd R = triangle(points, few, stopwatch);
  if (R.size() == 0 && few < all) R = triangle(points, all, stopwatch);
  if (R.size() == 0) return false;
  for (Eigen::Index i = 0; i < all; i += kTurn) {
    if (stopwatch.expired()) return false;
    auto some = points.middleCols(i, std::min(kTurn, all - i));
    R.transpose().triangularView<Eigen::Lower>().solveInPlace(some);
  }
  R_.assign(R.data(), R.data() + R.size());
  blocks_A_ = place(points, 0, size_A_, A_);
  blocks_Q_ = place(points, size_A_, size_Q_, Q_);
  return true;
}

void WhitenedPoints::turn(double* u) const {
  Eigen::Map<Eigen::VectorXd> v(u, n_);
  v = Eigen::Map<const Eigen::MatrixXd>(R_.data(), n_, n_).triangularView<Eigen::Upper>() *
      Eigen::VectorXd(v);
}

void WhitenedPoints::turn_back(double* u) const {
  Eigen::Map<Eigen::VectorXd> v(u, n_);
  Eigen::Map<const Eigen::MatrixXd>(R_.data(), n_, n_).triangularView<Eigen::Upper>().solveInPlace(v);
}

}  // namespace raygauge
