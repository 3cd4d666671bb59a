// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/minkowski_difference.h"

#include <utility>

#include "engine/numerics/vector_kernels.h"
#include "engine/sets/parameters.h"
#include "engine/sets/set_sums.h"

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
  Scratch second(dimension());
  return sum_support(*A2_, *A1_, -1.0, u, point, second.data());
}

void MinkowskiDifference::do_center(double* point) const { sum_center(*A2_, *A1_, -1.0, point); }

void MinkowskiDifference::do_magnitude(double* magnitude) const { sum_magnitude(*A2_, *A1_, magnitude); }

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

bool MinkowskiDifference::do_is_unconditional(double* extent) const {
  return sum_is_unconditional(*A2_, *A1_, extent);
}

void MinkowskiDifference::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  sum_pieces(*A2_, *A1_, -1.0, u, pieces, capacity);
}

void MinkowskiDifference::do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const {
  sum_pieces(*A2_, *A1_, -1.0, u, pieces, capacity);
}

}  // namespace raygauge
