// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/polytopes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "engine/numerics/double_double.h"
#include "engine/numerics/floating_point.h"
#include "engine/sets/inequality_simplex.h"
#include "engine/sets/parameters.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

using End = InequalitySimplex::End;

// How far beyond its inequalities the centre of a flat set may lie, relative to them; beyond, it is empty.
constexpr double kFlat = 1e-12;
// Of sums in double-double arithmetic, relative to the sizes of what is added; more than they lose.
constexpr double kTwofold = 0x1p-90;
// Of |u - Gᵀλ|_1 for unit vectors u: R <= constant + rest R bounds R by at most twice the constant.
constexpr double kLargestRest = 0.5;

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

// The largest ball {y : |y - x| <= t} inside, as a program in (x, t): maximize t subject to G_i·x + |G_i| t
// <= g_i, with |x_k| <= cube where that is finite. Where no ball fits, t is negative: the set is empty.
struct BallProgram {
  BallProgram(const InequalitySimplex::RowMatrix& G, const Vector& g, double cube) {
    const Eigen::Index m = G.rows(), n = G.cols(), more = std::isfinite(cube) ? 2 * n : 0;
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(m + more, n + 1);
    rows.topRows(m) << G, G.rowwise().norm();
    Vector bounds = Vector::Constant(m + more, cube);
    bounds.head(m) = g;
    if (more > 0)
      rows.bottomLeftCorner(more, n) << Eigen::MatrixXd::Identity(n, n), -Eigen::MatrixXd::Identity(n, n);
    program = InequalitySimplex(rows, bounds);
    Vector start = Vector::Zero(n + 1);
    start[n] = (g.array() / rows.col(n).head(m).array()).minCoeff();
    at = program.start_at(start);
    end = program.maximise(Vector::Unit(n + 1, n), at);
  }

  InequalitySimplex program;
  InequalitySimplex::Vertex at;
  End end;
};

// Beyond the size of the numbers in g: where the set has points, it has some that are nearer.
constexpr double kWide = 0x1p20;
// Multipliers of the cube, beside others that sum up to 1: less than this are rounding.
constexpr double kNoMultiplier = 1e-12;

// Whether inequalities without a vertex have no solution either: if the largest ball has a negative radius
// although no side of a cube holds it, multipliers of the rows alone prove it (Farkas).
bool is_empty(const InequalitySimplex::RowMatrix& G, const Vector& g) {
  const Eigen::Index n = G.cols();
  const double scale = g.lpNorm<Eigen::Infinity>();
  const BallProgram balls(G, g, kWide * scale);
  if (balls.end != End::optimal || !(balls.at.x[n] < -kFlat * scale)) return false;
  const Vector multipliers = balls.program.multipliers(Vector::Unit(n + 1, n), balls.at);
  for (Eigen::Index i = 0; i <= n; ++i) {
    if (balls.at.active[static_cast<std::size_t>(i)] >= G.rows() && std::fabs(multipliers[i]) > kNoMultiplier)
      return false;
  }
  return true;
}

[[noreturn]] void throw_empty() { throw EmptySetError("h_polytope: {x : G x <= g} is empty"); }

// Σ_k |G_ik x_k|, to which rounding errors of G_i·x are relative.
double size_of(const InequalitySimplex::RowMatrix& G, Eigen::Index i, const ConstVectorRef& x) {
  return G.row(i).cwiseAbs().dot(x.cwiseAbs());
}

// h(u) <= constant + rest R for any R >= |x_k|, x in S.
struct Bound {
  double constant = 0, rest = 0;
};

// Weak duality with the multipliers that are positive.
Bound bound_height(const InequalitySimplex& program, const ConstVectorRef& u,
                   const InequalitySimplex::Vertex& at) {
  const int n = static_cast<int>(u.size());
  const InequalitySimplex::RowMatrix& G = program.G();
  const Vector& g = program.g();
  const Vector lambda = program.multipliers(u, at);
  DoubleDouble constant;
  double size = 0;
  Bound bound;
  for (int i = 0; i < n; ++i) {
    const int row = at.active[static_cast<std::size_t>(i)];
    if (row < 0 || !(lambda[i] > 0)) continue;
    constant = constant + two_product(g[row], lambda[i]);
    size += std::fabs(g[row]) * lambda[i];
  }
  for (int k = 0; k < n; ++k) {
    DoubleDouble rest{u[k], 0};
    double sizes = std::fabs(u[k]);
    for (int i = 0; i < n; ++i) {
      const int row = at.active[static_cast<std::size_t>(i)];
      if (row < 0 || !(lambda[i] > 0)) continue;
      rest = rest - two_product(G(row, k), lambda[i]);
      sizes += std::fabs(G(row, k)) * lambda[i];
    }
    bound.rest += std::fabs(rest.rounded()) + n * kTwofold * sizes;
  }
  bound.constant = constant.rounded() + kUnitRoundoff * std::fabs(constant.rounded()) + n * kTwofold * size;
  bound.rest *= 1 + 2 * n * kUnitRoundoff;
  return bound;
}

}  // namespace

struct HPolytope::Program {
  Program(const Eigen::Ref<const Eigen::MatrixXd>& G, const ConstVectorRef& g) : simplex(G, g) {}

  InequalitySimplex simplex;
  InequalitySimplex::Vertex start;
};

HPolytope::HPolytope(const Eigen::Ref<const Eigen::MatrixXd>& G, const ConstVectorRef& g)
    : ConvexSet(static_cast<int>(G.cols())), program_(std::make_shared<Program>(checked_rows(G, g), g)) {
  find_center();
  find_extent();
}

HPolytope::~HPolytope() = default;

const InequalitySimplex::RowMatrix& HPolytope::G() const noexcept { return program_->simplex.G(); }
const Vector& HPolytope::g() const noexcept { return program_->simplex.g(); }

// That of a largest ball inside (Chebyshev).
void HPolytope::find_center() {
  const int n = dimension();
  const BallProgram balls(G(), g(), kInfinity);
  if (balls.end == End::unbounded && is_empty(G(), g())) throw_empty();
  if (balls.end == End::unbounded) throw_unbounded();
  center_ = balls.at.x.head(n);
  const double scale = g().lpNorm<Eigen::Infinity>() + center_.norm();
  if (balls.at.x[n] < -kFlat * scale) throw_empty();
  if (!(do_inner_radius(center_.data()) > 0)) {
    throw InvalidParameterError(
        "h_polytope: {x : G x <= g} has no interior, to rounding; give its corners as a point_set");
  }
  margins_ = g() - G() * center_;
  for (Eigen::Index i = 0; i < margins_.size(); ++i) margins_[i] -= rounding_of(i, center_);
}

// What rounding may add to g_i - G_i·x.
double HPolytope::rounding_of(Eigen::Index i, const ConstVectorRef& x) const {
  return 2 * (dimension() + 4) * kUnitRoundoff * (size_of(G(), i, x) + std::fabs(g()[i]));
}

// Onto the way to the centre, as far as the inequality that x breaks most asks.
void HPolytope::draw_inside(Vector& x) const {
  double share = 0;
  for (Eigen::Index i = 0; i < G().rows(); ++i) {
    if (G().row(i).dot(x) + rounding_of(i, x) <= g()[i]) continue;
    DoubleDouble beyond{-g()[i], 0};
    for (Eigen::Index k = 0; k < x.size(); ++k) beyond = beyond + two_product(G()(i, k), x[k]);
    const double broken =
        beyond.rounded() + dimension() * kTwofold * (size_of(G(), i, x) + std::fabs(g()[i]));
    if (broken > 0) share = std::max(share, broken / (broken + margins_[i]) * (1 + 8 * kUnitRoundoff));
  }
  if (share > 0) x += std::min(share, 1.0) * (center_ - x);
}

// Of x_k, or of -x_k for sign = -1, by the inequalities on x_k alone; none: infinite.
double HPolytope::bound_by_one_row(int k, double sign) const {
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < G().rows(); ++i) {
    const double entry = sign * G()(i, k);
    if (entry > 0 && G().row(i).lpNorm<1>() == entry) least = std::min(least, g()[i] / entry);
  }
  return least + kUnitRoundoff * std::fabs(least);
}

// From the centre to a vertex, and from there to the extents along the axes.
void HPolytope::find_extent() {
  const int n = dimension();
  const InequalitySimplex& program = program_->simplex;
  InequalitySimplex::Vertex& start = program_->start;
  start = program.start_at(center_);
  magnitude_ = center_.cwiseAbs();
  double constant = 0, rest = 0;  // R <= constant + rest R
  for (int k = 0; k < n; ++k) {
    for (const double sign : {1.0, -1.0}) {
      const Vector u = sign * Vector::Unit(n, k);
      if (program.maximise(u, start) == End::unbounded) throw_unbounded();
      magnitude_ = magnitude_.cwiseMax(start.x.cwiseAbs());
      Bound of_axis = bound_height(program, u, start);
      if (!(of_axis.rest < kLargestRest)) of_axis = {bound_by_one_row(k, sign), 0};
      constant = std::max(constant, of_axis.constant);
      rest = std::max(rest, of_axis.rest);
    }
  }
  extent_ = constant / (1 - rest) * (1 + 4 * kUnitRoundoff);
  if (!(rest < kLargestRest && extent_ < std::numeric_limits<double>::infinity()))
    throw InvalidParameterError(
        "h_polytope: {x : G x <= g} is not provably bounded: its inequalities are too nearly parallel");
}

double HPolytope::do_support(const double* u, double* point) const {
  const Eigen::Map<const Eigen::VectorXd> direction(u, dimension());
  InequalitySimplex::Vertex at = program_->start;
  program_->simplex.maximise(direction, at);
  const Bound proven = bound_height(program_->simplex, direction, at);
  const double by_extent = direction.lpNorm<1>() * extent_ * (1 + 2 * dimension() * kUnitRoundoff);
  const double by_duality = proven.constant + proven.rest * extent_;
  if (!at.x.allFinite()) at.x = center_;
  draw_inside(at.x);
  Vector::Map(point, dimension()) = at.x;
  return by_duality < by_extent ? by_duality : by_extent;
}

void HPolytope::do_center(double* point) const { Vector::Map(point, dimension()) = center_; }

void HPolytope::do_magnitude(double* magnitude) const { Vector::Map(magnitude, dimension()) = magnitude_; }

double HPolytope::do_inner_radius(const double* c) const {
  const Eigen::Map<const Eigen::VectorXd> x(c, dimension());
  const double relative = 2 * (dimension() + 4) * kUnitRoundoff;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < G().rows(); ++i) {
    least = std::min(least,
                     (g()[i] - G().row(i).dot(x) - rounding_of(i, x)) / (G().row(i).norm() * (1 + relative)));
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
