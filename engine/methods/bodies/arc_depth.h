// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "raygauge/numerics/vector3.h"

namespace raygauge {

/// The hull of the disc of radius `base` in the plane z = 0 and that of radius `top` <= `base` in the plane z
/// = full. The normals of its side are  across w + along z,  w of length 1 across z.
struct UprightFrustum {
  double base = 0, top = 0, full = 0, along = 0, across = 0;

  /// The highest point for u of length 1, on this rim.
  Vector3 point(const Vector3& u, bool is_top) const noexcept {
    constexpr double kAlongAxis = 1e-14;
    const double rho = std::sqrt(u.x * u.x + u.y * u.y), radius = is_top ? top : base;
    const double scale = rho > kAlongAxis ? radius / rho : 0.0;
    return {u.x * scale, u.y * scale, is_top ? full : 0.0};
  }
  Vector3 point(const Vector3& u) const noexcept { return point(u, is_top(u)); }
  bool is_top(const Vector3& u) const noexcept { return u.z > along; }
};

/// The least height of q + F, F a frustum, over an arc of directions across an edge. In the plane across the
/// edge F is the hull of two ellipses, or of an ellipse and a point. Over directions in which one rim, of
/// radius r, is the highest, the boundary has the radius of curvature
///
///     R(u) = r e_z²/ρ³,   ρ² = 1 - u_z²,   e the edge's direction,
///
/// so that for κ <= R(u) all over a piece of the arc h(u) - κ is the support function of a convex set there:
/// with the points p_1, p_2 for the ends u_1, u_2 of the piece
///
///     h(u) >= κ + max((p_1 - κ u_1)·u, (p_2 - κ u_2)·u).
///
/// The piece is halved where that is least, until it is as high as the bound.
class ArcDepth {
 public:
  /// `size`: at least |x| for every point x of the sum.
  void begin(const UprightFrustum& frustum, double size) noexcept {
    frustum_ = frustum;
    size_ = size;
    looks_ = 0;
  }

  /// The directions across `edge`, of length 1, are  x b_1 + y b_2,  b_1 the part of `first` across it.
  bool set_edge(const Vector3& edge, const Vector3& first, const Vector3& corner) noexcept;

  /// Over the directions from (x_1, y_1) to (x_2, y_2), counterclockwise, less than π apart. `upper`: what is
  /// known of the depth; a piece that is as high as that less a share of `gap` is high enough. False where
  /// this takes too long.
  bool search(double x_1, double y_1, double x_2, double y_2, double upper, double gap) noexcept;

  /// Of the last search: what is proven for all its directions, the least height that was seen, below `upper`
  /// if there is one, and its direction.
  double lower() const noexcept { return lower_; }
  double height() const noexcept { return height_; }
  Vector3 normal() const noexcept;

  /// Whether that is about as high all around: no direction is the only one.
  bool is_ring() const noexcept {
    constexpr double kEven = 1e-6;  // of the size
    return std::fabs(bend()) < kEven * size_;
  }

  /// Newton's method from normal(), where that is not at an end.
  void settle() noexcept;

  double along(const Vector3& u, int i) const noexcept { return dot(u, basis_[i]); }

 private:
  /// The direction x, y and the point p, q of the plane across the edge; u_z and ρ. Not set: there is a row
  /// of them.
  struct End {
    double x, y, p, q, height, z, rho;
  };
  struct Piece {
    End end[2];
    bool is_top;
  };
  static constexpr int kMostLooks = 160, kMostPieces = 32;

  /// The second derivative at the least height that was seen.
  double bend() const noexcept {
    return (is_top_ ? frustum_.top : frustum_.base) * edge_z_ / (best_.rho * best_.rho * best_.rho) -
           best_.height;
  }
  End look(double x, double y, bool is_top) noexcept;
  void keep(const End& end, bool is_top, bool is_inside) noexcept;
  double curvature_of(const Piece& piece) const noexcept;
  static double least_of(double x, double y, const Piece& piece) noexcept;
  double bound(const Piece& piece, double& x, double& y) const noexcept;
  bool halve(const Piece& whole, double upper, double gap) noexcept;
  int list_crossings(double x_1, double y_1, double x_2, double y_2, double (&at)[2][2]) const noexcept;

  UprightFrustum frustum_;
  double size_ = 0;
  Vector3 basis_[2], corner_;
  double q_[2] = {0, 0};  // the corner in the basis
  double edge_z_ = 0;     // squared
  int looks_ = 0;
  double lower_ = 0, height_ = 0;
  End best_{};
  bool is_top_ = false, is_inside_ = false;  // of a piece
};

}  // namespace raygauge
