// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/spatial_pair.h"
#include "engine/proof/bounds.h"

namespace raygauge {

/// How a fixed-size solve ended. Where it is `open` the bounds hold, but another method has to close them.
enum class SpatialEnd : std::uint8_t { closed, intersecting, separated, open };

/// A combination of at most four support points. Points and weights from `count` on are not there: nobody
/// reads them, and they are written whole before `count` is raised.
struct SpatialCombination {
  int count = 0;
  SpatialPoint point[4];
  double weight[4] = {0, 0, 0, 0};
};

/// The answer to a query about a pair, in the frame of its first body. Every solve begins with a new one; the
/// steps that work on it, one kind after the other, only ever better its bounds.
struct SpatialAnswer {
  SpatialEnd end = SpatialEnd::open;
  Bounds bounds;
  Vector3 normal;  ///< outer normal of what touches the difference D, of any length: it proves bounds.lower()
  Vector3 hint;    ///< the best normal met, though it may prove nothing: where to go on from
  SpatialCombination combination;  ///< of the last steps; it proves bounds.upper(), but for rounding
  int iterations = 0;

  /// Of a new solve: nothing is known, and the combination has no points. Steps begin with a hint of their
  /// own.
  void begin() noexcept {
    end = SpatialEnd::open;
    bounds = {};
    normal = {};
    combination.count = iterations = 0;
  }

  /// A bound that outer normal u proves.
  void raise_lower(double bound, const Vector3& u) noexcept {
    if (bounds.raise_lower(bound)) normal = u;
  }

  /// Whether the bounds of a distance are close enough; the end is `closed` then.
  bool closes(double tolerance) noexcept {
    if (!(bounds.lower() > 0) || !bounds.close(tolerance)) return false;
    end = SpatialEnd::closed;
    return true;
  }

  /// For other steps: the bounds stay.
  void begin_steps() noexcept {
    end = SpatialEnd::open;
    hint = {};
    combination.count = iterations = 0;
  }
};

/// Where a solve begins: with the vertices of the last one, or with its direction; and what it has to find.
struct SpatialStart {
  bool fine_normal = false;  ///< of a growth distance, for gradients: off by the gap, not by its root
  bool has_normal = false;
  Vector3 normal;
  int count = 0;
  std::int32_t index_1[4], index_2[4];
};

/// Bounds on the distance of the bodies, rounding errors outward: from above by the length of a difference of
/// points of their cores, from below by u·s(u) of a unit vector u, `along`.
inline double upper_bound(const SpatialPair& pair, double length) noexcept {
  constexpr double kRounding = 1 + 0x1p-48;  // of a few operations on numbers that are certain otherwise
  return (length + pair.error()) * kRounding - pair.radius();
}
inline double upper_bound(const SpatialPair& pair, const Vector3& v) noexcept {
  return upper_bound(pair, length(v));
}
inline double lower_bound(const SpatialPair& pair, double along) noexcept {
  constexpr double kUp = 1 + 0x1p-48, kDown = 1 - 0x1p-48;
  return (-along - pair.error()) * kDown - pair.radius() * kUp;
}

/// When to leave a pair to other steps: if it is known to be nearer than `near`, in units of its size, unless
/// it is nearer than `very_near`, where hardly a step is left; `at_rounding`: where error() alone keeps the
/// bounds apart. Never, as they stand.
struct SpatialNearness {
  double near = 0, very_near = 0;
  bool at_rounding = false;
};

/// The Euclidean distance of two bodies: that of the origin to D, less the balls of both, by the algorithm of
/// Gilbert, Johnson & Keerthi on the cores. With s_l support points, v = Σ c_l s_l the point nearest to the
/// origin of their hull, and w the support point for -v,
///
///     v·w/|v| <= d(cores) <= |v|,
///
/// both with SpatialPair::error() outward. `intersecting` is proven by a v shorter than the balls, or by four
/// support points whose hull contains the origin deeper than that error. It ends `open` where `leave` says
/// so, and where v is so short that rounding decides on its direction.
void spatial_distance(SpatialPair& pair, double tolerance, const SpatialStart& start,
                      const SpatialNearness& leave, SpatialAnswer& answer);

/// Whether balls that are known to be inside the bodies have a point in common: these meet for certain.
bool meet_deep(const SpatialPair& pair);

}  // namespace raygauge
