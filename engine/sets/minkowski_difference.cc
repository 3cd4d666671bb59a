// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/minkowski_difference.h"

#include <utility>

#include "engine/sets/parameters.h"
#include "engine/sets/piece_sums.h"
#include "engine/sets/vector_kernels.h"

namespace raygauge {

MinkowskiDifference::MinkowskiDifference(std::shared_ptr<const ConvexSet> A2,
                                         std::shared_ptr<const ConvexSet> A1)
    : ConvexSet(checked_set("Minkowski difference", "A2", A2)->dimension()),
      A2_(std::move(A2)),
      A1_(std::move(A1)) {
  check_dimension("Minkowski difference", "A1", checked_set("Minkowski difference", "A1", A1_)->dimension(),
                  dimension());
}

double MinkowskiDifference::do_support(const double* u, double* point) const {
  const int n = dimension();
  Scratch opposite(n), a1(n);
  for (int k = 0; k < n; ++k) opposite.data()[k] = -u[k];
  const double value = A2_->support_unchecked(u, point) + A1_->support_unchecked(opposite.data(), a1.data());
  for (int k = 0; k < n; ++k) point[k] -= a1.data()[k];
  return value;
}

void MinkowskiDifference::do_center(double* point) const {
  Scratch a1(dimension());
  A2_->center_unchecked(point);
  A1_->center_unchecked(a1.data());
  for (int k = 0; k < dimension(); ++k) point[k] -= a1.data()[k];
}

void MinkowskiDifference::do_magnitude(double* magnitude) const {
  Scratch a1(dimension());
  A2_->magnitude_unchecked(magnitude);
  A1_->magnitude_unchecked(a1.data());
  for (int k = 0; k < dimension(); ++k) magnitude[k] += a1.data()[k];
}

// A ball of A2 around its centre and one of A1 around that centre less c.
double MinkowskiDifference::do_inner_radius(const double* c) const {
  Scratch center(dimension()), rest(dimension());
  A2_->center_unchecked(center.data());
  for (int k = 0; k < dimension(); ++k) rest.data()[k] = center.data()[k] - c[k];
  return sum_of_radii(A2_->inner_radius_unchecked(center.data()), A1_->inner_radius_unchecked(rest.data()), c,
                      center.data(), dimension());
}

SupportStructure MinkowskiDifference::do_structure() const noexcept {
  return structure_of_sum(A2_->structure(), A1_->structure());
}

void MinkowskiDifference::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  const int n = dimension();
  Scratch opposite(n);
  for (int k = 0; k < n; ++k) opposite.data()[k] = -u[k];
  A2_->support_pieces_unchecked(u, pieces, SupportPieces::kCapacity - capacity);
  SupportPieces of_A1 = pieces.rest(pieces.count);
  A1_->support_pieces_unchecked(opposite.data(), of_A1, SupportPieces::kCapacity - capacity + pieces.count);
  add_pieces(pieces, of_A1, -1.0, capacity);
}

}  // namespace raygauge
