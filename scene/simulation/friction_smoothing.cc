// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_smoothing.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

namespace raygauge {
namespace {

constexpr double kLeastMu = 1e-9;  // below it a contact has no friction
constexpr double kRedundant =
    1e-10;  // of W, in slopes: contacts of one face on another share what they carry at will
constexpr double kLastTau = 1e-9;
constexpr double kClose = 0.1;    // of τ: |F| from which on τ falls
constexpr int kMostSteps = 60;    // for one τ
constexpr int kMostHalves = 20;   // of one step
constexpr int kMostFailures = 2;  // one after the other; then the path is lost

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

// x ∘ y = L_x y.
Matrix3 product_with(const Vector3& x) {
  Matrix3 L = x[0] * Matrix3::Identity();
  L.row(0) = x.transpose();
  L.col(0) = x;
  return L;
}

// x in the cone with x ∘ x = s.
Vector3 root_of(const Vector3& s) {
  const double length = s.tail<2>().norm();
  const double high = std::sqrt(std::max(s[0] + length, 0.0)), low = std::sqrt(std::max(s[0] - length, 0.0));
  Vector3 x;
  x[0] = (high + low) / 2;
  x.tail<2>() =
      length > 0 ? Eigen::Vector2d((high - low) / (2 * length) * s.tail<2>()) : Eigen::Vector2d::Zero();
  return x;
}

/// The problem in units in which W and q are near 1.
class Smoothed {
 public:
  explicit Smoothed(const FrictionProblem& given)
      : mu_(given.mu), size_(given.q.size()), W_(given.W), q_(given.q) {
    const double size_W = W_.diagonal().maxCoeff(), size_q = q_.lpNorm<Eigen::Infinity>();
    unit_ = size_q / size_W;
    W_ /= size_W;
    q_ /= size_q;
    for (std::size_t c = 0; c < mu_.size(); ++c) {
      if (!(mu_[c] > kLeastMu)) continue;
      const auto at = 3 * static_cast<Eigen::Index>(c);
      W_.row(at) /= mu_[c];
      W_.col(at) /= mu_[c];
      q_[at] /= mu_[c];
    }
    slope_W_ = W_;
    slope_W_.diagonal().array() += kRedundant * W_.diagonal().maxCoeff();
  }

  Eigen::VectorXd start() const {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(size_);
    for (Eigen::Index at = 0; at < size_; at += 3) y[at] = 1;
    return y;
  }

  Eigen::VectorXd impulses(const Eigen::VectorXd& y) const {
    Eigen::VectorXd r = unit_ * y;
    for (std::size_t c = 0; c < mu_.size(); ++c) {
      const auto at = 3 * static_cast<Eigen::Index>(c);
      if (mu_[c] > kLeastMu) r[at] /= mu_[c];
      r.segment<3>(at) = nearest_in_cone(r.segment<3>(at), mu_[c]);
    }
    return r;
  }

  /// |F|; the slope is kept if it is asked for.
  double look(const Eigen::VectorXd& y, double tau, bool slope) {
    w_ = W_ * y + q_;
    F_.resize(size_);
    if (slope) slope_.resize(size_, size_);
    for (std::size_t c = 0; c < mu_.size(); ++c) look_at(c, y, tau, slope);
    return F_.norm();
  }

  Eigen::VectorXd step() const { return slope_.partialPivLu().solve(-F_); }

 private:
  void look_at(std::size_t c, const Eigen::VectorXd& all, double tau, bool slope) {
    const auto at = 3 * static_cast<Eigen::Index>(c);
    if (!(mu_[c] > kLeastMu)) return look_without_friction(at, all, tau, slope);
    const Vector3 y = all.segment<3>(at), w = w_.segment<3>(at);
    const double slip = std::hypot(w[1], w[2], tau);
    const Vector3 z(w[0] + slip, w[1], w[2]);
    Vector3 s = product_with(y) * y + product_with(z) * z;
    s[0] += 2 * tau * tau;
    const Vector3 x = root_of(s);
    F_.segment<3>(at) = y + z - x;
    if (!slope) return;
    const Matrix3 inverse = product_with(x).inverse();
    Matrix3 way = Matrix3::Identity();  // dz by dw
    way.block<1, 2>(0, 1) = w.tail<2>().transpose() / slip;
    const Matrix3 by_z = (Matrix3::Identity() - inverse * product_with(z)) * way;
    slope_.middleRows<3>(at) = by_z * slope_W_.middleRows<3>(at);
    slope_.block<3, 3>(at, at) += Matrix3::Identity() - inverse * product_with(y);
  }

  void look_without_friction(Eigen::Index at, const Eigen::VectorXd& all, double tau, bool slope) {
    const double y = all[at], z = w_[at], x = std::sqrt(y * y + z * z + 2 * tau * tau);
    F_[at] = y + z - x;
    F_.segment<2>(at + 1) = all.segment<2>(at + 1);
    if (!slope) return;
    slope_.row(at) = (1 - z / x) * slope_W_.row(at);
    slope_(at, at) += 1 - y / x;
    slope_.middleRows<2>(at + 1).setZero();
    slope_.block<2, 2>(at + 1, at + 1).setIdentity();
  }

  std::vector<double> mu_;
  Eigen::Index size_;
  Eigen::MatrixXd W_, slope_W_, slope_;
  Eigen::VectorXd q_, w_, F_;
  double unit_ = 1;
};

// Newton's method at one τ. False: it did not come near.
bool solve_at(Smoothed& smoothed, double tau, Eigen::VectorXd& y) {
  double size = smoothed.look(y, tau, true);
  for (int k = 0; k < kMostSteps; ++k) {
    if (size <= kClose * tau) return true;
    const Eigen::VectorXd step = smoothed.step();
    if (!step.allFinite()) return false;
    double share = 1, next = size;
    for (int half = 0; half < kMostHalves; ++half) {
      next = smoothed.look(y + share * step, tau, false);
      if (next < (1 - share / 4) * size) break;
      share /= 2;
    }
    if (!(next < size)) return false;
    y += share * step;
    size = smoothed.look(y, tau, true);
  }
  return size <= kClose * tau;
}

}  // namespace

double follow_smoothed_friction(const FrictionProblem& problem, double rate, Eigen::VectorXd& r) {
  if (problem.q.isZero(0) || !(problem.W.diagonal().maxCoeff() > 0)) {
    r.setZero(problem.q.size());
    return friction_residual(problem, r);
  }
  Smoothed smoothed(problem);
  Eigen::VectorXd y = smoothed.start();
  double best = friction_residual(problem, r);
  double tau = 1;
  for (int failures = 0; tau >= kLastTau && failures < kMostFailures;) {
    failures = solve_at(smoothed, tau, y) ? 0 : failures + 1;
    const Eigen::VectorXd found = smoothed.impulses(y);
    const double residual = friction_residual(problem, found);
    if (residual < best) {
      best = residual;
      r = found;
    }
    tau *= rate;
  }
  return best;
}

}  // namespace raygauge
