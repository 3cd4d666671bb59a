// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/proven_cap.h"

#include <algorithm>

#include "engine/methods/spatial/triangle_normal.h"

namespace raygauge {

namespace {

bool holds_any(const DepthPoint<double>* const* corner, const DepthPoint<double>& farthest) noexcept {
  return is_same(farthest, *corner[0]) || is_same(farthest, *corner[1]) || is_same(farthest, *corner[2]);
}

int count_same(const DepthPoint<double>* const* corner) noexcept {
  return int{is_same(*corner[0], *corner[1])} + int{is_same(*corner[1], *corner[2])} +
         int{is_same(*corner[2], *corner[0])};
}

}  // namespace

bool share_a_face(const DepthPoint<double>* const* corner, const DepthPoint<double>& farthest) noexcept {
  return count_same(corner) == 0 && holds_any(corner, farthest);
}

bool share_a_bend(const DepthPoint<double>* const* corner, const DepthPoint<double>& farthest) noexcept {
  return count_same(corner) > 0 && holds_any(corner, farthest);
}

// Newton's method for the plane that touches the pieces under the corners: the point s(u) of a piece moves
// across u. What the corners lose by the last turn is its square times half a radius of curvature.
bool ProvenCap::follow(double most, double tolerance, DepthOracle<double>& oracle) {
  constexpr int kMostSteps = 4;
  constexpr double kAway = 0.5, kSettled = 0.5;  // squares of a turn; kSettled relative to the tolerance
  for (int step = 0; step < kMostSteps; ++step) {
    const Vector3 u = n_;
    oracle.follow(u, corner_, 3);
    const Vector3 n = triangle_normal<double>(corner_[0].s, corner_[1].s, corner_[2].s);
    const double square = dot(n, n);
    if (!(square > 0)) return false;
    n_ = n * (1 / std::sqrt(square));
    const Vector3 turn = n_ - u;
    const double turned = dot(turn, turn);
    if (!(turned < kAway && dot(n_, corner_[0].s) <= most)) return false;
    if (turned < kSettled * tolerance) return true;
  }
  return false;
}

// The margins are far above what rounding loses of products of vectors up to `size`, divided by an edge.
bool ProvenCap::measure(double size, double error) noexcept {
  constexpr double kLeastEdge = 1e-4, kRounding = 1e-9;  // of the size
  constexpr double kLeastCosine = 0.01;                  // no cap is half of the sphere
  double nearest = size, least = dot(n_, corner_[0].s);
  for (int k = 0; k < count_; ++k) {
    const Vector3 &a = corner_[k].s, &b = corner_[k + 1 < count_ ? k + 1 : 0].s, edge = b - a;
    const double square = dot(edge, edge);
    if (!(square > kLeastEdge * kLeastEdge * size * size)) return false;
    nearest = std::fmin(nearest, dot(cross(a, b), n_) / std::sqrt(square));
    least = std::fmin(least, dot(n_, a));
  }
  height_ = least * (1 - 0x1p-48) - error * (1 + 0x1p-48);
  nearest -= kRounding * size;
  if (!(height_ > kRounding * size && nearest > 0)) return false;
  const double share = nearest / least, square = share * share;
  cosine_ = std::fmax((1 - square) / (1 + square), kLeastCosine) + kRounding;
  return cosine_ < 1;
}

bool ProvenCap::find(const DepthPoint<double>* const* corner, const Vector3& n, double most, double tolerance,
                     DepthOracle<double>& oracle) {
  for (int k = 0; k < 3; ++k) corner_[k] = *corner[k];
  n_ = n;
  return follow(most, tolerance, oracle) && measure(oracle.size(), oracle.error());
}

bool ProvenCap::take_face(const DepthPoint<double>* corner, const Vector3& n,
                          const DepthOracle<double>& oracle) {
  std::copy_n(corner, 4, corner_);
  count_ = 4;
  n_ = n;
  return measure(oracle.size(), oracle.error());
}

// Of four corners the first and the third are those of two triangles.
bool ProvenCap::contact(const Vector3& u, double tolerance, Vector3& a1, Vector3& a2) const noexcept {
  const double size = std::sqrt(dot(u, u));
  if (is_bent_) {
    constexpr double kSame = 1e-5;
    const Vector3 away = u * (1 / size) - n_;
    if (!(dot(away, away) < kSame * kSame)) return false;
    a1 = corner_[0].a1 + (corner_[1].a1 - corner_[0].a1) * share_;
    a2 = corner_[0].a2 + (corner_[1].a2 - corner_[0].a2) * share_;
    return true;
  }
  const int next = count_ == 4 && dot(u, cross(corner_[2].s, corner_[0].s)) < 0 ? 2 : 1;
  const DepthPoint<double>* const at[3] = {corner_, corner_ + next, corner_ + next + 1};
  double weight[3], sum = 0;
  for (int k = 0; k < 3; ++k) {
    weight[k] = std::fmax(dot(u, cross(at[(k + 1) % 3]->s, at[(k + 2) % 3]->s)), 0.0);
    sum += weight[k];
  }
  if (!(sum > 0 && dot(n_, u) >= size * (1 - tolerance))) return false;
  a1 = a2 = {};
  for (int k = 0; k < 3; ++k) {
    a1 = a1 + at[k]->a1 * (weight[k] / sum);
    a2 = a2 + at[k]->a2 * (weight[k] / sum);
  }
  return true;
}

}  // namespace raygauge
