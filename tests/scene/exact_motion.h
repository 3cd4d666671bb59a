// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "raygauge/numerics/quad.h"
#include "raygauge/scene/motion.h"

/// The exact motions, in quadruple precision and by other formulas than the engine's: what its placements and
/// bounds are compared with.
namespace raygauge::exact_motion {

using QuadVector = std::array<Quad, 3>;

inline Quad quad(double x) { return x; }

/// x ↦ R x + t in 3-space; the plane is its first two coordinates.
struct Frame {
  std::array<QuadVector, 3> R{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< by rows
  QuadVector t{0, 0, 0};

  QuadVector turned(const QuadVector& x) const {
    QuadVector y{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) y[i] += R[i][k] * x[k];
    }
    return y;
  }
  QuadVector operator()(const QuadVector& x) const {
    QuadVector y = turned(x);
    for (std::size_t i = 0; i < 3; ++i) y[i] += t[i];
    return y;
  }
  Frame operator*(const Frame& inner) const {
    Frame product;
    for (std::size_t k = 0; k < 3; ++k) {
      const QuadVector column = turned({inner.R[0][k], inner.R[1][k], inner.R[2][k]});
      for (std::size_t i = 0; i < 3; ++i) product.R[i][k] = column[i];
    }
    product.t = (*this)(inner.t);
    return product;
  }
  Frame transposed() const {
    Frame back;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) back.R[i][k] = R[k][i];
    }
    return back;
  }
};

template <class Vector>
QuadVector quad_vector(const Vector& v) {
  QuadVector q{0, 0, 0};
  for (Eigen::Index k = 0; k < v.size(); ++k) q[static_cast<std::size_t>(k)] = v[k];
  return q;
}

inline Frame frame_of(const Placement& where) {
  Frame frame;
  for (int i = 0; i < where.dimension(); ++i) {
    for (int k = 0; k < where.dimension(); ++k) {
      frame.R[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = where.R(i, k);
    }
  }
  frame.t = quad_vector(where.t);
  return frame;
}

inline Quad dot(const QuadVector& a, const QuadVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Quad norm(const QuadVector& a) { return elementary::sqrt(dot(a, a)); }

/// The rotation by |r| about r: (1 + A S + B S²)^(2^k) with S x = r × x / 2^k, A = sin θ/θ and B = (1 - cos
/// θ)/θ² by their power series, θ = |r|/2^k.
inline Frame rotation(const QuadVector& r) {
  QuadVector s = r;
  int halvings = 0;
  for (; dot(s, s) > quad(0.0625); ++halvings) {
    for (Quad& x : s) x /= 2;
  }
  const Quad square = dot(s, s);
  Quad A = 0, B = 0, term = 1;
  for (int k = 1; k <= 28; k += 2) {
    A += term;
    B += term / (k + 1);
    term *= -square / ((k + 1) * (k + 2));
  }
  Frame R;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) R.R[i][k] += B * (s[i] * s[k] - (i == k ? square : Quad(0)));
    const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
    R.R[l][j] += A * s[i];
    R.R[j][l] -= A * s[i];
  }
  for (int k = 0; k < halvings; ++k) R = R * R;
  return R;
}

/// r with rotation(r) = R, from a value nearby: steps by the skew part of what is left.
inline QuadVector rotation_vector(const Frame& R, QuadVector r) {
  for (int step = 0; step < 6; ++step) {
    const Frame left = R * rotation(r).transposed();
    const QuadVector more{(left.R[2][1] - left.R[1][2]) / 2, (left.R[0][2] - left.R[2][0]) / 2,
                          (left.R[1][0] - left.R[0][1]) / 2};
    // Of one axis with r, or nearly, steps add up; elsewhere they are small enough after the first.
    for (std::size_t k = 0; k < 3; ++k) r[k] += more[k];
  }
  return r;
}

inline Frame twist(const Placement& first, const TwistMotion::Rates& rates, double start, Quad t) {
  const Quad s = t - start;
  QuadVector turn = quad_vector(rates.spin);
  for (Quad& x : turn) x *= s;
  Frame frame = rotation(turn) * frame_of(first);
  frame.t = quad_vector(first.t);
  for (Eigen::Index k = 0; k < first.t.size(); ++k) {
    const Quad a = rates.acceleration.size() > 0 ? rates.acceleration[k] : 0.0;
    frame.t[static_cast<std::size_t>(k)] += s * quad(rates.velocity[k]) + s * s * a / 2;
  }
  return frame;
}

inline std::size_t piece_of(const std::vector<double>& times, Quad t) {
  std::size_t i = 0;
  while (i + 2 < times.size() && t >= quad(times[i + 1])) ++i;
  return i;
}

inline Frame keyframes(const std::vector<double>& times, const std::vector<Placement>& frames, Quad t) {
  const std::size_t i = piece_of(times, t);
  const Quad s = (t - times[i]) / (quad(times[i + 1]) - quad(times[i]));
  const Frame first = frame_of(frames[i]), last = frame_of(frames[i + 1]);
  Frame plain_first = first, plain_last = last;
  plain_first.t = plain_last.t = {0, 0, 0};
  const Frame D = plain_last * plain_first.transposed();
  Eigen::Matrix3d rounded;
  for (int j = 0; j < 9; ++j) {
    rounded(j / 3, j % 3) =
        static_cast<double>(D.R[static_cast<std::size_t>(j / 3)][static_cast<std::size_t>(j % 3)]);
  }
  const Eigen::AngleAxisd near{rounded};
  const double angle = near.angle() > EIGEN_PI ? near.angle() - 2 * EIGEN_PI : near.angle();
  QuadVector turn = rotation_vector(D, quad_vector(Eigen::Vector3d(angle * near.axis())));
  for (Quad& x : turn) x *= s;
  Frame frame = rotation(turn) * plain_first;
  for (std::size_t k = 0; k < 3; ++k) frame.t[k] = (1 - s) * first.t[k] + s * last.t[k];
  return frame;
}

inline Frame link(const KinematicTree& tree, const JointTrajectory& trajectory, const Placement& base,
                  int link, Quad t) {
  std::vector<int> path;
  for (int i = link; i >= 0; i = tree.links[static_cast<std::size_t>(i)].parent) path.push_back(i);
  const std::size_t piece = piece_of(trajectory.times, t);
  const Quad s =
      (t - trajectory.times[piece]) / (quad(trajectory.times[piece + 1]) - quad(trajectory.times[piece]));
  Frame here = frame_of(base);
  for (auto i = path.rbegin(); i != path.rend(); ++i) {
    const TreeLink& step = tree.links[static_cast<std::size_t>(*i)];
    here = here * frame_of(step.origin);
    if (step.kind == JointKind::fixed) continue;
    const auto column = static_cast<Eigen::Index>(piece);
    const Quad value = (1 - s) * quad(trajectory.values(step.joint, column)) +
                       s * quad(trajectory.values(step.joint, column + 1));
    const Quad q = quad(step.scale) * value + step.offset;
    QuadVector along = quad_vector(step.axis);
    for (Quad& x : along) x *= q;
    Frame moved;
    if (step.kind == JointKind::revolute) moved = rotation(along);
    if (step.kind == JointKind::prismatic) moved.t = along;
    here = here * moved;
  }
  return here;
}

}  // namespace raygauge::exact_motion
