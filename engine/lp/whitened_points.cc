// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/whitened_points.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/decompositions.h"

namespace raygauge {
namespace {

constexpr double kSpan = 1e-15;  // the least entry of the diagonal of R, relative to the largest

// Rows first … first + size of W, in blocks; the last one is repeated where the last block has room.
std::ptrdiff_t place(const Eigen::MatrixXd& W, Eigen::Index first, Eigen::Index size,
                     AlignedBuffer<double>& out) {
  constexpr Eigen::Index kLanes = PointSet::kLanes;
  const Eigen::Index blocks = (size + kLanes - 1) / kLanes, n = W.cols();
  out.reserve(static_cast<std::size_t>(blocks * n * kLanes));
  for (Eigen::Index i = 0; i < blocks * kLanes; ++i) {
    const Eigen::Index row = first + std::min(i, size - 1);
    double* lane = out.data() + i / kLanes * n * kLanes + i % kLanes;
    for (Eigen::Index k = 0; k < n; ++k) lane[k * kLanes] = W(row, k);
  }
  return blocks;
}

}  // namespace

bool WhitenedPoints::compute(const ColumnPool& A, const ColumnPool& Q, int n) {
  n_ = n;
  size_A_ = A.size();
  size_Q_ = Q.size();
  const Eigen::Index rows = size_A_ + size_Q_;
  if (rows < n) return false;
  Eigen::MatrixXd P(rows, n);
  Eigen::VectorXd point(n);
  for (Eigen::Index i = 0; i < rows; ++i) {
    if (i < size_A_) {
      A.copy_point(i, point.data());
    } else {
      Q.copy_point(i - size_A_, point.data());
    }
    P.row(i) = point;
  }
  const auto triangle = orthonormalise(P, kSpan);
  if (!triangle) return false;
  const double size = std::sqrt(static_cast<double>(rows));
  R_.resize(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
  Eigen::Map<Eigen::MatrixXd>(R_.data(), n, n) = *triangle / size;
  P *= size;
  blocks_A_ = place(P, 0, size_A_, A_);
  blocks_Q_ = place(P, size_A_, size_Q_, Q_);
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
