// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/minkowski_sum.h"

#include <utility>

#include "engine/sets/parameters.h"
#include "engine/sets/piece_sums.h"
#include "engine/sets/vector_kernels.h"

namespace raygauge {

MinkowskiSum::MinkowskiSum(std::shared_ptr<const ConvexSet> A, std::shared_ptr<const ConvexSet> B)
    : ConvexSet(checked_set("Minkowski sum", "A", A)->dimension()), A_(std::move(A)), B_(std::move(B)) {
  check_dimension("Minkowski sum", "B", checked_set("Minkowski sum", "B", B_)->dimension(), dimension());
}

double MinkowskiSum::do_support(const double* u, double* point) const {
  Scratch b(dimension());
  const double value = A_->support_unchecked(u, point) + B_->support_unchecked(u, b.data());
  for (int k = 0; k < dimension(); ++k) point[k] += b.data()[k];
  return value;
}

void MinkowskiSum::do_center(double* point) const {
  Scratch b(dimension());
  A_->center_unchecked(point);
  B_->center_unchecked(b.data());
  for (int k = 0; k < dimension(); ++k) point[k] += b.data()[k];
}

void MinkowskiSum::do_magnitude(double* magnitude) const {
  Scratch b(dimension());
  A_->magnitude_unchecked(magnitude);
  B_->magnitude_unchecked(b.data());
  for (int k = 0; k < dimension(); ++k) magnitude[k] += b.data()[k];
}

// A ball of A around its centre and one of B around c less that centre.
double MinkowskiSum::do_inner_radius(const double* c) const {
  Scratch center(dimension()), rest(dimension());
  A_->center_unchecked(center.data());
  for (int k = 0; k < dimension(); ++k) rest.data()[k] = c[k] - center.data()[k];
  return sum_of_radii(A_->inner_radius_unchecked(center.data()), B_->inner_radius_unchecked(rest.data()), c,
                      center.data(), dimension());
}

SupportStructure MinkowskiSum::do_structure() const noexcept {
  return structure_of_sum(A_->structure(), B_->structure());
}

void MinkowskiSum::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  A_->support_pieces_unchecked(u, pieces, SupportPieces::kCapacity - capacity);
  SupportPieces of_B = pieces.rest(pieces.count);
  B_->support_pieces_unchecked(u, of_B, SupportPieces::kCapacity - capacity + pieces.count);
  add_pieces(pieces, of_B, 1.0, capacity);
}

}  // namespace raygauge
