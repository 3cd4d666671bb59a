// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/bodies/depth_search.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// D = A2 - A1 of any two sets of R^1 to R^3, and any metric, by their support mappings in doubles. In less
/// than three dimensions D × [-h, h] and Q × [-β, β] with β <= max |q| over Q and h >= |s| for all s in D:
/// tQ ⊆ D implies t β <= h, so that the depth is the same.
class GeneralOracle final : public DepthOracle<double> {
 public:
  /// All of one space, and they outlive the oracle.
  GeneralOracle(const ConvexSet& A1, const ConvexSet& A2, const ConvexSet& Q);

  double support(const Vector3& u, DepthPoint<double>& point) override;
  double metric_upper(const Vector3& u) override { return metric(u, 1); }
  double metric_lower(const Vector3& u) override { return metric(u, -1); }

  std::int64_t queries() const noexcept { return queries_; }

 private:
  double metric(const Vector3& u, double side);

  const ConvexSet &A1_, &A2_, &Q_;
  int n_;
  double magnitude_[3] = {0, 0, 0};  // of Q
  double height_[3] = {0, 0, 0};     // h along the axes beyond n, ...
  double metric_height_ = 0;         // ... and β
  std::int64_t queries_ = 0;
};

}  // namespace raygauge
