// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <vector>

#include "engine/methods/bodies/depth_oracle.h"

namespace raygauge {

/// Directions u about the normal n of a face of D, for all of which h_D(u) >= height(). With corners c_k of
/// the face, r the distance from the foot of the origin to the nearest of its edges, and θ the angle between
/// u and n,
///
///     h_D(u) >= max_k u·c_k >= n·c cos θ + r sin θ >= n·c    for    θ <= T = 2 atan(r / n·c).
///
/// Let P, in D, be a polytope about the origin, and u a direction with h_P(u) < height(). The ray along u
/// leaves P across a facet, and the angle between u and the normal n_f of that is less than
/// acos(offset/height()): the facet is no obstacle to the bound, if no direction so near to n_f is farther
/// than T from n.
class ProvenCap {
 public:
  /// From the corners of a facet with normal n: where they follow the normal, and the normal them, until both
  /// stay to a share `tolerance` of the height. False where this leads nowhere, beyond a height of `most`, or
  /// to a face that proves nothing.
  bool find(const DepthPoint<double>* const* corner, const Vector3& n, double most, double tolerance,
            DepthOracle<double>& oracle);

  /// Of a face of D that is known: four corners, in order around n, of length 1.
  bool take_face(const DepthPoint<double>* corner, const Vector3& n, const DepthOracle<double>& oracle);

  /// The same as find() of a facet whose corners are on one or two curved pieces: see bent_cap.cc.
  bool find_bent(const DepthPoint<double>* const* corner, const Vector3& n, double most, double tolerance,
                 DepthOracle<double>& oracle);

  const Vector3& normal() const noexcept { return n_; }
  double height() const noexcept { return height_; }

  /// Whether u, of length 1, is one of the directions.
  bool holds(const Vector3& u) const noexcept { return dot(n_, u) > cosine_; }

  /// Whether it takes the place of a facet with this normal and, proven, offset > 0.
  bool covers(const Vector3& n_f, double offset) const noexcept {
    constexpr double kRounding = 1e-12;
    const double near = dot(n_, n_f) - kRounding, share = offset / height_ - kRounding;
    if (!(near > cosine_ && share > cosine_)) return false;
    const double across = (1 - near * near) * (1 - share * share);
    return near * share - std::sqrt(std::fmax(across, 0.0)) > cosine_ + kRounding;
  }

  /// The points of both bodies where the ray along u meets the face; false unless that is as far as n is, to
  /// a share `tolerance`.
  bool contact(const Vector3& u, double tolerance, Vector3& a1, Vector3& a2) const noexcept;

 private:
  struct Bent;
  bool follow(double most, double tolerance, DepthOracle<double>& oracle);
  bool measure(double size, double error) noexcept;
  bool measure_bent(const Bent& bent, double size, double error) noexcept;

  DepthPoint<double> corner_[4];
  int count_ = 3;  // of the corners of a face
  Vector3 n_;
  double height_ = 0, cosine_ = 1;  // of T, rounded up
  double share_ = 0;                // of a bent face: of corner_[1]; that of corner_[0] is the rest
  bool is_bent_ = false;
};

/// The caps of one search.
class ProvenCaps {
 public:
  void clear() noexcept { caps_.clear(); }
  void add(const ProvenCap& cap) { caps_.push_back(cap); }
  const std::vector<ProvenCap>& all() const noexcept { return caps_; }

  bool hold(const Vector3& u) const noexcept {
    for (const ProvenCap& cap : caps_)
      if (cap.holds(u)) return true;
    return false;
  }

  /// Whether one takes the place of a facet, whose value is then that of the cap.
  bool cover(const Vector3& n_f, double& value) const noexcept {
    for (const ProvenCap& cap : caps_) {
      if (!(value > 0 && cap.covers(n_f, value))) continue;
      value = cap.height();
      return true;
    }
    return false;
  }

  bool contact(const Vector3& u, double tolerance, Vector3& a1, Vector3& a2) const noexcept {
    for (const ProvenCap& cap : caps_)
      if (cap.contact(u, tolerance, a1, a2)) return true;
    return false;
  }

 private:
  std::vector<ProvenCap> caps_;
};

/// Whether two points are on the same piece of D.
inline bool is_same(const DepthPoint<double>& a, const DepthPoint<double>& b) noexcept {
  return a.index_1 == b.index_1 && a.index_2 == b.index_2;
}

/// Whether the corners of a facet are on three different pieces of D, one of which is the farthest along its
/// normal.
bool share_a_face(const DepthPoint<double>* const* corner, const DepthPoint<double>& farthest) noexcept;

/// Whether they are on one or two, one of which is.
bool share_a_bend(const DepthPoint<double>* const* corner, const DepthPoint<double>& farthest) noexcept;

}  // namespace raygauge
