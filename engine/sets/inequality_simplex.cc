// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/inequality_simplex.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/decompositions.h"
#include "engine/numerics/double_double.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

constexpr double kParallel =
    1e-11;  // an edge that rises against an inequality by less, per length, never meets it
constexpr double kTouching = 1e-13;  // slack that rounding may make of 0, relative to the numbers involved
constexpr int kFreshAfter = 64;      // exchanges between two inverses computed afresh
constexpr int kPatience = 50;        // exchanges in one point before Bland's rule

// b - Σ_k a_k x_k, in double-double arithmetic.
template <class Row, class Column>
double residual(double b, const Row& a, const Column& x) {
  DoubleDouble sum{b, 0};
  for (Eigen::Index k = 0; k < x.size(); ++k) sum = sum - two_product(a[k], x[k]);
  return sum.rounded();
}

}  // namespace

InequalitySimplex::InequalitySimplex(const Eigen::Ref<const Eigen::MatrixXd>& G, const ConstVectorRef& g)
    : G_(G), g_(g) {
  for (Eigen::Index i = 0; i < G_.rows(); ++i) {
    const int exponent = -std::ilogb(G_.row(i).lpNorm<Eigen::Infinity>());
    for (Eigen::Index k = 0; k < G_.cols(); ++k) G_(i, k) = std::scalbn(G_(i, k), exponent);
    g_[i] = std::scalbn(g_[i], exponent);
  }
}

InequalitySimplex::Vertex InequalitySimplex::start_at(const Vector& x) const {
  return {x, std::vector<int>(static_cast<std::size_t>(x.size()), -1),
          Eigen::MatrixXd::Identity(x.size(), x.size())};
}

// Steepest edge: the largest ascent per length. Unit vectors leave before anything else does, those of
// multiplier 0 too.
InequalitySimplex::Edge InequalitySimplex::choose_edge(const Vector& multipliers, const Vertex& at,
                                                       bool bland) const {
  Edge best;
  double steepest = 0;
  const double noise = 4 * kUnitRoundoff * multipliers.lpNorm<Eigen::Infinity>();
  for (int i = 0; i < static_cast<int>(multipliers.size()); ++i) {
    const double multiplier = multipliers[i];
    if (at.active[static_cast<std::size_t>(i)] < 0) return {i, multiplier > 0 ? 1.0 : -1.0};
    if (!(multiplier < -noise) || (bland && best.leaving >= 0)) continue;
    const double ascent = -multiplier / at.edges.col(i).norm();
    if (ascent > steepest) {
      steepest = ascent;
      best.leaving = i;
    }
  }
  return best;
}

// Harris: of the inequalities met almost at once the one that the direction meets most squarely.
int InequalitySimplex::first_met(const Vector& direction, const Vector& slack, bool bland,
                                 double& step) const {
  const Vector rise = G_ * direction;
  const double parallel = kParallel * direction.norm();
  const double slight = kTouching * (g_.lpNorm<Eigen::Infinity>() + slack.lpNorm<Eigen::Infinity>());
  double furthest = kInfinity;
  for (Eigen::Index i = 0; i < rise.size(); ++i) {
    if (rise[i] > parallel)
      furthest = std::min(furthest, (std::max(slack[i], 0.0) + (bland ? 0.0 : slight)) / rise[i]);
  }
  int row = -1;
  for (Eigen::Index i = 0; i < rise.size(); ++i) {
    if (!(rise[i] > parallel) || std::max(slack[i], 0.0) / rise[i] > furthest) continue;
    if (row < 0 || (!bland && rise[i] > rise[row])) row = static_cast<int>(i);
  }
  if (row >= 0) step = std::max(slack[row], 0.0) / rise[row];
  return row;
}

void InequalitySimplex::exchange(Vertex& at, int leaving, int row) const {
  const Vector along = at.edges.transpose() * G_.row(row).transpose();
  at.edges.col(leaving) /= along[leaving];
  for (Eigen::Index j = 0; j < along.size(); ++j) {
    if (j != leaving) at.edges.col(j) -= along[j] * at.edges.col(leaving);
  }
  at.active[static_cast<std::size_t>(leaving)] = row;
}

// The inverse afresh, and x moved to where the active inequalities are equations.
bool InequalitySimplex::factorise(Vertex& at) const {
  const Eigen::Index n = at.x.size();
  Eigen::MatrixXd B = Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (at.active[static_cast<std::size_t>(i)] >= 0)
      B.row(i) = G_.row(at.active[static_cast<std::size_t>(i)]);
  }
  at.edges = lu_inverse(B);
  for (int turn = 0; turn < 2; ++turn) {
    Vector off = Vector::Zero(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const int row = at.active[static_cast<std::size_t>(i)];
      if (row >= 0) off[i] = residual(g_[row], G_.row(row), at.x);
    }
    at.x += at.edges * off;
  }
  return at.edges.allFinite() && at.x.allFinite();
}

// λ of u = Bᵀ λ, corrected once by a residual in twice the precision.
Vector InequalitySimplex::multipliers(const ConstVectorRef& u, const Vertex& at) const {
  Vector lambda = at.edges.transpose() * u;
  const Eigen::Index n = u.size();
  Vector off(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    DoubleDouble sum{u[k], 0};
    for (Eigen::Index i = 0; i < n; ++i) {
      const int row = at.active[static_cast<std::size_t>(i)];
      const double entry = row >= 0 ? G_(row, k) : static_cast<double>(i == k);
      sum = sum - two_product(entry, lambda[i]);
    }
    off[k] = sum.rounded();
  }
  lambda += at.edges.transpose() * off;
  return lambda;
}

InequalitySimplex::End InequalitySimplex::maximise(const ConstVectorRef& u, Vertex& at) const {
  const auto limit = 200 + 20 * (G_.rows() + G_.cols());
  Vector slack = g_ - G_ * at.x;
  int idle = 0, since_fresh = 0;
  for (Eigen::Index exchanges = 0; exchanges < limit; ++exchanges) {
    const bool bland = idle > kPatience;
    Edge edge = choose_edge(at.edges.transpose() * u, at, bland);
    if (edge.leaving < 0) {
      if (since_fresh > 0 && !factorise(at)) return End::stalled;
      since_fresh = 0;
      edge = choose_edge(multipliers(u, at), at, bland);
      if (edge.leaving < 0) return End::optimal;
      slack = g_ - G_ * at.x;
    }
    double step = 0;
    Vector direction = edge.sign * at.edges.col(edge.leaving);
    int row = first_met(direction, slack, bland, step);
    if (row < 0 && at.active[static_cast<std::size_t>(edge.leaving)] < 0 &&
        !(std::fabs(u.dot(direction)) > 0)) {
      direction = -direction;
      row = first_met(direction, slack, bland, step);
    }
    if (row < 0) return End::unbounded;
    idle = step * direction.norm() > kTouching * at.x.norm() ? 0 : idle + 1;
    at.x += step * direction;
    exchange(at, edge.leaving, row);
    if (++since_fresh % kFreshAfter == 0 && !factorise(at)) return End::stalled;
    slack = g_ - G_ * at.x;
  }
  return End::stalled;
}

}  // namespace raygauge
