// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/real.h"
#include "engine/sets/cores/core.h"
#include "raygauge/sets/pose.h"

namespace raygauge {

/// A point s of the difference of two cores with the points that it is the difference of, in the frames that
/// the pair says.
template <class Real>
struct PairPoint {
  BasicVector3<Real> s;
  BasicVector3<Real> a1, a2;
  /// Which pieces of their cores they are on: vertices from 0 on, smooth pieces below.
  std::int32_t index_1 = kSmoothPiece, index_2 = kSmoothPiece;

  bool has_same_pieces(const PairPoint& other) const noexcept {
    return index_1 == other.index_1 && index_2 == other.index_2;
  }

  /// Of body i.
  BasicVector3<Real>& a(int i) noexcept { return i == 0 ? a1 : a2; }
  const BasicVector3<Real>& a(int i) const noexcept { return i == 0 ? a1 : a2; }
  std::int32_t& index(int i) noexcept { return i == 0 ? index_1 : index_2; }
  std::int32_t index(int i) const noexcept { return i == 0 ? index_1 : index_2; }
};

/// The numbers of a pose that was checked: R, n × n by columns, t, and Pose::defect. They are not copied. The
/// identity has none.
struct PoseNumbers {
  PoseNumbers() = default;
  PoseNumbers(const double* rotation, const double* translation, double pose_defect)
      : R(rotation), t(translation), defect(pose_defect) {}
  explicit PoseNumbers(const Pose* pose) {
    if (pose != nullptr) *this = {pose->rotation_data(), pose->translation_data(), pose->defect()};
  }

  const double* R = nullptr;
  const double* t = nullptr;
  double defect = 0;
};

/// What a PairFrame is: where two bodies stand and where differences of their points are taken. In doubles
/// both are in the frame of the first body, so that one rotation is left of two; points of both cores are
/// kept in that frame.
struct FirstBodyFrame {
  using Real = double;
  static constexpr bool kKeepsVertices = true;  // what follows a normal is curved; vertices stay in place

  const SpatialShape& shape(int i) const noexcept { return *body[i]; }

  /// An outer normal of D as body i sees it, in its own frame.
  Vector3 into(int i, const Vector3& u) const noexcept { return i == 0 ? u : R.transposed_times(-u); }

  /// The point x of core i, given in that core's frame.
  void put(int i, const Vector3& x, PairPoint<double>& point) const noexcept {
    if (i == 0) {
      point.a1 = x;
    } else {
      point.a2 = R * x + t;
    }
  }
  static void subtract(PairPoint<double>& point) noexcept { point.s = point.a1 - point.a2; }

  /// The point of core i in that core's frame, and how far rounding may be off in a vector of length `away`.
  Vector3 own(int i, const PairPoint<double>& point) const noexcept {
    return i == 0 ? point.a1 : to_second(point.a2);
  }
  static double slack(int /*i*/, double away) noexcept { return 0x1p-48 * away; }

  /// A point of the second body's frame in the first one's, and back.
  Vector3 from_second(const Vector3& point) const noexcept { return R * point + t; }
  Vector3 to_second(const Vector3& point) const noexcept { return R.transposed_times(point - t); }

  /// A vector, or a point, of the first body's frame in the world's; n numbers.
  void to_world(const Vector3& vector, double* out) const noexcept { write(W * vector, out); }
  void point_to_world(const Vector3& point, double* out) const noexcept { write(W * point + w, out); }

  /// The normal of a plane. The pose takes it to R⁻ᵀu, which is Ru only where R is orthonormal; `close`: the
  /// plane is so near to the bodies that rounding errors of R matter.
  void normal_to_world(const Vector3& u, bool close, double* out) const noexcept {
    constexpr double kOrthonormal = 0x1p-44;
    const bool turned = close || defect > kOrthonormal;
    to_world(turned ? u - (W.transposed_times(W * u) - u) : u, out);
  }

  /// A vector of the world in the first body's frame.
  Vector3 to_body(const double* vector) const noexcept {
    return W.transposed_times({vector[0], vector[1], dimension == 3 ? vector[2] : 0.0});
  }

  const SpatialShape* body[2] = {nullptr, nullptr};
  int dimension = 3;
  Matrix3 R;  // second frame to first
  Vector3 t;
  Matrix3 W;  // first frame to world, and Pose::defect of W
  Vector3 w;
  double defect = 0;

 private:
  void write(const Vector3& x, double* out) const noexcept {
    out[0] = x.x;
    out[1] = x.y;
    if (dimension == 3) out[2] = x.z;
  }
};

/// In double-double arithmetic the frame is the world's, with both rotations as they are given: that is what
/// proves bounds for the very numbers of the poses. Points of the cores are each in their own frame.
struct WorldFrame {
  using Real = DoubleDouble;
  static constexpr bool kKeepsVertices = false;

  struct Body {
    const SpatialShape* shape = nullptr;
    double R[3][3];
    double ball = 0;  // the radius of a ball inside the image of the shape's ball
    double defect = 0;

    PreciseVector3 turn(const PreciseVector3& x) const noexcept { return rows(R, x); }
    PreciseVector3 turn(const Vector3& x) const noexcept { return rows(R, x); }
    PreciseVector3 turn_back(const PreciseVector3& u) const noexcept {
      const bool is_double = u.x.low == 0 && u.y.low == 0 && u.z.low == 0;
      return is_double ? columns(R, rounded(u)) : columns(R, u);
    }

   private:
    template <class V>
    static DoubleDouble product(double x, double y, double z, const V& v) noexcept {
      return loose_sum(loose_product(v.x, x), loose_product(v.y, y), loose_product(v.z, z));
    }
    template <class V>
    static PreciseVector3 rows(const double (&R)[3][3], const V& v) noexcept {
      return {product(R[0][0], R[0][1], R[0][2], v), product(R[1][0], R[1][1], R[1][2], v),
              product(R[2][0], R[2][1], R[2][2], v)};
    }
    template <class V>
    static PreciseVector3 columns(const double (&R)[3][3], const V& v) noexcept {
      return {product(R[0][0], R[1][0], R[2][0], v), product(R[0][1], R[1][1], R[2][1], v),
              product(R[0][2], R[1][2], R[2][2], v)};
    }
  };

  const SpatialShape& shape(int i) const noexcept { return *body[i].shape; }

  PreciseVector3 into(int i, const PreciseVector3& u) const noexcept {
    return body[i].turn_back(i == 0 ? u : -u);
  }

  static void put(int i, const PreciseVector3& x, PairPoint<DoubleDouble>& point) noexcept { point.a(i) = x; }
  static const PreciseVector3& own(int i, const PairPoint<DoubleDouble>& point) noexcept {
    return point.a(i);
  }
  double slack(int i, double away) const noexcept { return (4 * body[i].defect + 0x1p-48) * away; }
  // Vertices are doubles.
  void subtract(PairPoint<DoubleDouble>& point) const noexcept {
    point.s = sum_of(point.index_1 >= 0 ? body[0].turn(rounded(point.a1)) : body[0].turn(point.a1),
                     -(point.index_2 >= 0 ? body[1].turn(rounded(point.a2)) : body[1].turn(point.a2)), apart);
  }

  Body body[2];
  PreciseVector3 apart;  // t1 - t2
};

}  // namespace raygauge
