// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_interior.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raygauge {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kMostSteps = 60;
constexpr int kPatience = 2;     // steps that come no nearer
constexpr double kInside = 0.7;  // of the way to the border of a cone: longer steps end farther from the law
constexpr double kShortStep = 0.05;  // no step after such a one comes nearer

auto tangent(const Vector3d& a) { return a.tail<2>(); }

// x_n² - |x_t|².
double determinant(const Vector3d& a) {
  const double length = tangent(a).norm();
  return (a[0] - length) * (a[0] + length);
}

// a ∘ b.
Vector3d product(const Vector3d& a, const Vector3d& b) {
  return {a.dot(b), a[0] * b[1] + b[0] * a[1], a[0] * b[2] + b[0] * a[2]};
}

// a ∘ quotient = b.
Vector3d quotient(const Vector3d& b, const Vector3d& a) {
  const double first = (a[0] * b[0] - tangent(a).dot(tangent(b))) / determinant(a);
  return {first, (b[1] - a[1] * first) / a[0], (b[2] - a[2] * first) / a[0]};
}

// The symmetric matrix whose square is 2 w wᵀ - J; of determinant(w) = 1.
Matrix3d root_of(const Vector3d& w) {
  Matrix3d root;
  root << w[0], tangent(w).transpose(), tangent(w),
      Eigen::Matrix2d::Identity() + tangent(w) * tangent(w).transpose() / (1 + w[0]);
  return root;
}

// The largest share of `by` that leaves x in the cone.
double way_to_border(const Vector3d& x, const Vector3d& by) {
  const double a = by[0] * by[0] - tangent(by).squaredNorm(), b = x[0] * by[0] - tangent(x).dot(tangent(by)),
               c = determinant(x), square = b * b - a * c;
  double way = by[0] < 0 ? -x[0] / by[0] : std::numeric_limits<double>::infinity();
  if (!(square >= 0)) return way;
  const double sum = -(b + std::copysign(std::sqrt(square), b));  // of c + 2 b t + a t² = 0
  for (const double root : {sum / a, c / sum})
    if (root > 0) way = std::min(way, root);
  return way;
}

// What r changes: by μ in the directions of friction.
Vector3d by_friction(const Vector3d& x, double mu) { return {x[0], mu * x[1], mu * x[2]}; }

}  // namespace

IslandInterior::IslandInterior(const FrictionIsland& island, double bound)
    : island_(island),
      bound_(bound),
      size_of_q_(island.size_of_q()),
      cones_(island.contacts.size()),
      r_(3 * static_cast<Eigen::Index>(island.contacts.size())),
      factors_(island) {
  for (std::size_t c = 0; c < cones_.size(); ++c) cones_[c].places = factors_.places_of(island.contacts[c]);
}

double IslandInterior::solve(double enough, Eigen::VectorXd& r) {
  begin();
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0, best_at = 0; k < kMostSteps && k <= best_at + kPatience; ++k) {
    const double residual = measure();
    if (residual < best) {
      best = residual;
      best_at = k;
      r = r_;
    }
    if (best <= enough || !step()) break;
  }
  return best;
}

// In the middle of the cones, at impulses and velocities of the island's sizes.
void IslandInterior::begin() {
  double speed = 0, slope = 0;
  for (const IslandContact& contact : island_.contacts) {
    speed = std::max(speed, contact.q.norm());
    slope = std::max(slope, contact.A_a.col(0).squaredNorm() + contact.A_b.col(0).squaredNorm());
  }
  for (Cone& cone : cones_) {
    cone.x = {speed / std::max(slope, 1e-300), 0, 0};
    cone.z = {speed, 0, 0};
  }
}

// What is lacking, and the residual of x.
double IslandInterior::measure() {
  mean_ = 0;
  for (std::size_t c = 0; c < cones_.size(); ++c) {
    r_.segment<3>(3 * static_cast<Eigen::Index>(c)) = by_friction(cones_[c].x, island_.contacts[c].mu);
    mean_ += cones_[c].x.dot(cones_[c].z);
  }
  mean_ /= static_cast<double>(cones_.size());
  velocities_.reset(island_, r_);
  for (std::size_t c = 0; c < cones_.size(); ++c) {
    Cone& cone = cones_[c];
    cone.lack = cone.z - by_friction(velocities_.of(island_.contacts[c]), island_.contacts[c].mu);
    cone.lack[0] -= tangent(cone.z).norm();
  }
  return island_residual(island_, bound_, size_of_q_, velocities_, r_);
}

// P² = β² (2 w wᵀ - J) takes x to z.
void IslandInterior::scale() {
  factors_.set_identity();
  for (std::size_t c = 0; c < cones_.size(); ++c) {
    Cone& cone = cones_[c];
    const double of_x = determinant(cone.x), of_z = determinant(cone.z),
                 beta = std::sqrt(std::sqrt(of_z / of_x));
    const Vector3d x = cone.x / std::sqrt(of_x), z = cone.z / std::sqrt(of_z);
    Vector3d w = z + Vector3d(x[0], -x[1], -x[2]);
    w /= 2 * std::sqrt((1 + x.dot(z)) / 2);
    const Vector3d mirrored(w[0], -w[1], -w[2]);
    cone.P = beta * root_of(w);
    cone.P_inverse = root_of(mirrored) / beta;
    cone.scaled = cone.P_inverse * cone.z;
    cone.by_lack = 2 * mirrored * mirrored.transpose();
    cone.by_lack.diagonal() += Vector3d(-1, 1, 1);
    cone.by_lack /= beta * beta;
    const double length = tangent(cone.z).norm();
    if (length > 0)
      cone.by_lack.rightCols<2>() += cone.by_lack.col(0) * (tangent(cone.z) / length).transpose();
    const Vector3d D = by_friction({1, 1, 1}, island_.contacts[c].mu);
    factors_.add(island_.contacts[c], cone.places, D.asDiagonal() * cone.by_lack * D.asDiagonal());
  }
  factors_.factorize();
}

// Of the right sides ρ.
void IslandInterior::find_step() {
  y_.setZero(6, island_.bodies);
  for (std::size_t c = 0; c < cones_.size(); ++c) {
    const IslandContact& contact = island_.contacts[c];
    const Cone& cone = cones_[c];
    const Vector3d r = by_friction(cone.P_inverse * cone.rho + cone.by_lack * cone.lack, contact.mu);
    push_bodies(contact, r, y_);
  }
  factors_.solve(y_);
  for (std::size_t c = 0; c < cones_.size(); ++c) {
    const IslandContact& contact = island_.contacts[c];
    Cone& cone = cones_[c];
    Vector3d u = by_friction(with_bodies(contact, Vector3d::Zero(), y_), contact.mu) - cone.lack;
    cone.by_x = cone.P_inverse * cone.rho - cone.by_lack * u;
    const double length = tangent(cone.z).norm();
    if (length > 0) u[0] += tangent(cone.z).dot(tangent(u)) / length;
    cone.by_z = u;
  }
}

double IslandInterior::longest_step() const {
  double longest = std::numeric_limits<double>::infinity();
  for (const Cone& cone : cones_)
    longest = std::min({longest, way_to_border(cone.x, cone.by_x), way_to_border(cone.z, cone.by_z)});
  return longest;
}

double IslandInterior::mean_after(double share) const {
  double sum = 0;
  for (const Cone& cone : cones_) sum += (cone.x + share * cone.by_x).dot(cone.z + share * cone.by_z);
  return sum / static_cast<double>(cones_.size());
}

// To where x · z would be 0 first, which tells how much of it is to be left, and by how much that step
// misses. False: it was short.
bool IslandInterior::step() {
  scale();
  for (Cone& cone : cones_) cone.rho = -cone.scaled;
  find_step();
  const double left = std::max(0.0, mean_after(std::min(1.0, longest_step())) / mean_);
  for (Cone& cone : cones_) {
    Vector3d wanted = -product(cone.P_inverse * cone.by_z, cone.P * cone.by_x);
    wanted[0] += left * left * left * mean_;
    cone.rho = quotient(wanted, cone.scaled) - cone.scaled;
  }
  find_step();
  const double share = std::min(1.0, kInside * longest_step());
  for (Cone& cone : cones_) {
    cone.x += share * cone.by_x;
    cone.z += share * cone.by_z;
  }
  return share >= kShortStep;
}

}  // namespace raygauge
