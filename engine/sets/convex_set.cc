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
    throw InvalidParameterError("dimension must be at least 1, got " + std::to_string(dimension));
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

bool ConvexSet::do_quad_gauge_normal(const Quad* /*x*/, Quad* /*normal*/) const { return false; }

bool ConvexSet::do_touches_origin(double* /*u*/) const { return false; }

double ConvexSet::do_gauge(const double* /*x*/, double* /*normal*/) const {
  return std::numeric_limits<double>::infinity();
}

void ConvexSet::do_support_pieces(const double* /*u*/, SupportPieces& /*pieces*/, int /*capacity*/) const {}

bool ConvexSet::do_facet_normal(const double* /*u*/, const double* /*v*/, double* /*normal*/) const {
  return false;
}

void ConvexSet::do_facet_point(const double* normal, const double* /*target*/, double* point) const {
  do_support(normal, point);
}

bool ConvexSet::do_is_unconditional(double* /*extent*/) const { return false; }

void ConvexSet::do_quad_pieces(const Quad* /*u*/, QuadSupportPieces& /*pieces*/, int /*capacity*/) const {}

bool ConvexSet::do_quad_facet_normal(const Quad* /*u*/, const Quad* /*v*/, Quad* /*normal*/) const {
  return false;
}

void ConvexSet::do_quad_facet_point(const Quad* /*normal*/, const Quad* /*target*/, Quad* /*point*/) const {}

Vector ConvexSet::center() const {
  Vector point(dimension_);
  do_center(point.data());
  return point;
}

bool ConvexSet::do_spatial_shape(SpatialShape&) const { return false; }

}  // namespace raygauge
