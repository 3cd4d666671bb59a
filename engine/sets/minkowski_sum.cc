// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/minkowski_sum.h"

#include <utility>

#include "engine/numerics/vector_kernels.h"
#include "engine/sets/parameters.h"
#include "engine/sets/set_sums.h"

namespace raygauge {

MinkowskiSum::MinkowskiSum(std::shared_ptr<const ConvexSet> A, std::shared_ptr<const ConvexSet> B)
    : ConvexSet(checked_set("Minkowski sum", "A", A)->dimension()), A_(std::move(A)), B_(std::move(B)) {
  check_dimension("Minkowski sum", "B", checked_set("Minkowski sum", "B", B_)->dimension(), dimension());
}

double MinkowskiSum::do_support(const double* u, double* point) const {
  Scratch second(dimension());
  return sum_support(*A_, *B_, 1.0, u, point, second.data());
}

void MinkowskiSum::do_center(double* point) const { sum_center(*A_, *B_, 1.0, point); }

void MinkowskiSum::do_magnitude(double* magnitude) const { sum_magnitude(*A_, *B_, magnitude); }

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

bool MinkowskiSum::do_is_unconditional(double* extent) const {
  return sum_is_unconditional(*A_, *B_, extent);
}

void MinkowskiSum::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  sum_pieces(*A_, *B_, 1.0, u, pieces, capacity);
}

void MinkowskiSum::do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const {
  sum_pieces(*A_, *B_, 1.0, u, pieces, capacity);
}

}  // namespace raygauge
