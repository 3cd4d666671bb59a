// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/bodies/inner_polytope.h"
#include "raygauge/methods/result.h"

namespace raygauge {

/// How the curved pieces under a point of D bend at u: of each core's piece, about its own centre, the height
/// h = |Lᵀu| and how far the point is across u; and with S = L Lᵀ and its point y the form S - y yᵀ on the
/// plane across u, in the basis e, f.
struct PointBend {
  struct Piece {
    double height = 0, across = 0, ee = 0, ef = 0, ff = 0;
  };
  Piece of[2];  ///< zero where the piece is a vertex
};

/// What a depth is asked of: a difference D that the origin may be in, and a metric Q, both of R^3.
template <class Real>
class DepthOracle {
 public:
  using Vector = BasicVector3<Real>;

  virtual ~DepthOracle() = default;

  /// h_D(u), to |u| error(), and s_D(u), within error() of a point of D.
  virtual double support(const Vector& u, DepthPoint<Real>& point) = 0;

  /// A point of D, within error(), near the one that was recorded; of an oracle whose points are.
  virtual void support_again(const DepthMemory::Corner& /*corner*/, DepthPoint<Real>& /*point*/) {}

  /// Moves points to where the vertices, rims and curved surfaces that they are on are for u.
  virtual void follow(const Vector& /*u*/, DepthPoint<Real>* /*point*/, int /*count*/) {}

  /// Of a point that has followed u, of length 1.
  virtual PointBend bend(const Vector& /*u*/, const Vector& /*e*/, const Vector& /*f*/,
                         const DepthPoint<Real>& /*point*/) {
    return {};
  }

  /// A face of D that is likely to be the nearest, in closed form: four corners in order around n. False
  /// where none is known.
  virtual bool likely_face(DepthPoint<Real>* /*corner*/, Vector& /*n*/) { return false; }

  /// Whether follow() moves any: of cores that are curved, in doubles.
  bool follows() const noexcept { return follows_; }

  /// h_Q(u) for a u of length 1 to a few rounding units of doubles: a number that is not below it and one
  /// that is not above it.
  virtual double metric_upper(const Vector& u) = 0;
  virtual double metric_lower(const Vector& u) = 0;

  /// Whether h_Q(u) = |u|.
  bool is_euclidean() const noexcept { return euclidean_; }

  double error() const noexcept { return error_; }

  /// At least |s| for every support point.
  double size() const noexcept { return size_; }

 protected:
  double error_ = 0, size_ = 0;
  bool euclidean_ = false, follows_ = false;
};

}  // namespace raygauge
