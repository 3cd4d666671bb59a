// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/h_polytope.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "engine/numerics/floating_point.h"
#include "engine/sets/parameters.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

using End = InequalitySimplex::End;

// How far beyond its inequalities the centre of a flat or empty set may lie, relative to them.
constexpr double kFlat = 1e-12;

const Eigen::Ref<const Eigen::MatrixXd>& checked_rows(const Eigen::Ref<const Eigen::MatrixXd>& G,
                                                      const ConstVectorRef& g) {
  check_finite_matrix("h_polytope", "G", G);
  checked_finite("h_polytope", "g", g);
  if (G.rows() < 1) throw InvalidParameterError("h_polytope: G needs at least one row");
  if (g.size() != G.rows()) {
    throw DimensionMismatchError("h_polytope: G has " + std::to_string(G.rows()) + " rows, g " +
                                 std::to_string(g.size()) + " entries");
  }
  for (Eigen::Index i = 0; i < G.rows(); ++i) {
    if (G.row(i).isZero(0))
      throw InvalidParameterError("h_polytope: row " + std::to_string(i) + " of G is zero");
  }
  return G;
}

[[noreturn]] void throw_unbounded() {
  throw InvalidParameterError("h_polytope: {x : G x <= g} is not bounded");
}

// Σ_k |G_ik x_k|, to which rounding errors of G_i·x are relative.
double size_of(const InequalitySimplex::RowMatrix& G, Eigen::Index i,
               const Eigen::Map<const Eigen::VectorXd>& x) {
  return G.row(i).cwiseAbs().dot(x.cwiseAbs());
}

}  // namespace

HPolytope::HPolytope(const Eigen::Ref<const Eigen::MatrixXd>& G, const ConstVectorRef& g)
    : ConvexSet(static_cast<int>(G.cols())), program_(checked_rows(G, g), g) {
  find_center();
  find_extent();
}

// The largest ball inside: maximize t subject to G_i·x + |G_i| t <= g_i.
void HPolytope::find_center() {
  const int n = dimension();
  Eigen::MatrixXd rows(G().rows(), n + 1);
  rows << G(), G().rowwise().norm();
  const InequalitySimplex balls(rows, g());
  Vector x = Vector::Zero(n + 1);
  x[n] = (g().array() / rows.col(n).array()).minCoeff();
  InequalitySimplex::Vertex at = balls.start_at(x);
  if (balls.maximise(Vector::Unit(n + 1, n), at) == End::unbounded) throw_unbounded();
  center_ = at.x.head(n);
  const double scale = g().lpNorm<Eigen::Infinity>() + center_.norm();
  if (at.x[n] < -kFlat * scale) throw EmptySetError("h_polytope: no x satisfies G x <= g");
}

// From the centre to a vertex, and from there to the extents along the axes.
void HPolytope::find_extent() {
  const int n = dimension();
  start_ = program_.start_at(center_);
  magnitude_ = center_.cwiseAbs();
  for (int k = 0; k < n; ++k) {
    for (const double sign : {1.0, -1.0}) {
      if (program_.maximise(sign * Vector::Unit(n, k), start_) == End::unbounded) throw_unbounded();
      magnitude_ = magnitude_.cwiseMax(start_.x.cwiseAbs());
    }
  }
}

double HPolytope::do_support(const double* u, double* point) const {
  const Eigen::Map<const Eigen::VectorXd> direction(u, dimension());
  InequalitySimplex::Vertex at = start_;
  program_.maximise(direction, at);
  Vector::Map(point, dimension()) = at.x;
  return direction.dot(at.x);
}

void HPolytope::do_center(double* point) const { Vector::Map(point, dimension()) = center_; }

void HPolytope::do_magnitude(double* magnitude) const { Vector::Map(magnitude, dimension()) = magnitude_; }

double HPolytope::do_inner_radius(const double* c) const {
  const Eigen::Map<const Eigen::VectorXd> x(c, dimension());
  const double relative = 2 * (dimension() + 4) * kUnitRoundoff;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < G().rows(); ++i) {
    const double rounding = relative * (size_of(G(), i, x) + std::fabs(g()[i]));
    least = std::min(least, (g()[i] - G().row(i).dot(x) - rounding) / (G().row(i).norm() * (1 + relative)));
  }
  return std::max(0.0, least * (1 - 4 * kUnitRoundoff));
}

double HPolytope::do_gauge(const double* x, double* normal) const {
  const Eigen::Map<const Eigen::VectorXd> at(x, dimension());
  const double relative = 2 * (dimension() + 4) * kUnitRoundoff;
  double gauge = 0;
  Vector::Map(normal, dimension()) = G().row(0);
  for (Eigen::Index i = 0; i < G().rows(); ++i) {
    if (!(g()[i] > 0)) return std::numeric_limits<double>::infinity();
    const double above = G().row(i).dot(at) + relative * size_of(G(), i, at) + kUnderflow;
    const double bound = above / g()[i] * (1 + 4 * kUnitRoundoff);
    if (!(bound > gauge)) continue;
    gauge = bound;
    Vector::Map(normal, dimension()) = G().row(i);
  }
  return gauge;
}

}  // namespace raygauge
