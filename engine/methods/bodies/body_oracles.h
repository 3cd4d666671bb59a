// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/kernels/kernel.h"
#include "engine/methods/bodies/depth_search.h"
#include "engine/methods/spatial/precise_pair.h"
#include "engine/methods/spatial/spatial_pair.h"

namespace raygauge {

/// The Euclidean metric.
template <class Real>
class EuclideanOracle : public DepthOracle<Real> {
 public:
  using Vector = BasicVector3<Real>;

  EuclideanOracle() { this->euclidean_ = true; }
  double metric_upper(const Vector& u) override { return length_of(u) * (1 + 0x1p-50); }
  double metric_lower(const Vector& u) override { return length_of(u) * (1 - 0x1p-50); }
};

/// D = S1 - S2 of two cores in the frame of the first, in doubles. Of cores in R^2 D × [-size, size], which
/// is as deep as D: that is no deeper than its size.
class SpatialOracle final : public EuclideanOracle<double> {
 public:
  explicit SpatialOracle(SpatialPair& pair);
  double support(const Vector3& u, DepthPoint<double>& point) override;

  void support_again(const DepthMemory::Corner& corner, DepthPoint<double>& point) override;
  void follow(const Vector& u, DepthPoint<double>* point, int count) override;
  PointBend bend(const Vector& u, const Vector& e, const Vector& f, const DepthPoint<double>& point) override;
  bool likely_face(DepthPoint<double>* corner, Vector& n) override;

 private:
  static void put(const SpatialPoint& found, DepthPoint<double>& point);

  SpatialPair& pair_;
};

/// The same in double-double arithmetic, in the frame of the world; the points of both bodies are in that of
/// the first.
class PreciseOracle final : public EuclideanOracle<DoubleDouble> {
 public:
  /// False where the numbers are too large or too small.
  bool bind(const SpatialPair& pair);
  double support(const PreciseVector3& u, DepthPoint<DoubleDouble>& point) override;

  std::int64_t queries() const noexcept { return precise_.queries(); }

 private:
  const SpatialPair* pair_ = nullptr;
  PrecisePair precise_;
  double height_ = 0;
};

}  // namespace raygauge
