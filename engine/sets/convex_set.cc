// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/convex_set.h"

#include <string>

#include "engine/numerics/vector_kernels.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

void check_direction(const ConstVectorRef& u, int dimension) {
  if (u.size() != dimension) {
    throw DimensionMismatchError("direction has " + std::to_string(u.size()) +
                                 " coordinates, the set lives in R^" + std::to_string(dimension));
  }
  if (!u.allFinite()) throw NonFiniteError("direction has a NaN or infinite coordinate");
}

}  // namespace

ConvexSet::ConvexSet(int dimension) : dimension_(dimension) {
  if (dimension < 1) {
    throw InvalidParameterError("a set of dimension " + std::to_string(dimension) +
                                ": its points have no coordinates");
  }
}

double ConvexSet::support_function(const ConstVectorRef& u) const {
  check_direction(u, dimension_);
  Vector point(dimension_);
  return do_support(u.data(), point.data());
}

Vector ConvexSet::support_mapping(const ConstVectorRef& u) const {
  check_direction(u, dimension_);
  Vector point(dimension_);
  do_support(u.data(), point.data());
  return point;
}

void ConvexSet::do_magnitude(double* magnitude) const {
  Scratch axis(dimension_), point(dimension_);
  do_center(magnitude);
  std::fill_n(axis.data(), dimension_, 0.0);
  for (int k = 0; k < dimension_; ++k) {
    magnitude[k] = std::fabs(magnitude[k]);
    for (const double sign : {1.0, -1.0}) {
      axis.data()[k] = sign;
      do_support(axis.data(), point.data());
      magnitude[k] = std::max(magnitude[k], std::fabs(point.data()[k]));
    }
    axis.data()[k] = 0;
  }
}

double ConvexSet::do_inner_radius(const double* /*c*/) const { return 0; }

Vector ConvexSet::center() const {
  Vector point(dimension_);
  do_center(point.data());
  return point;
}

}  // namespace raygauge
