// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/sets/linear_image.h"
#include "raygauge/sets/pose.h"

namespace raygauge {

/// {R x + t : x in S}, a set in a pose, for the time of a query: neither is copied and nothing is allocated.
/// See LinearImage for what it keeps of S.
class PosedView final : public LinearImage {
 public:
  /// Throws DimensionMismatchError.
  PosedView(const ConvexSet& S, const Pose& pose);
};

/// A posed set as one set: the set itself where it has no pose, otherwise a view held here.
class InPose {
 public:
  explicit InPose(const Posed& posed) : set_(&posed.set) {
    if (posed.pose != nullptr) set_ = &view_.emplace(posed.set, *posed.pose);
  }
  InPose(const InPose&) = delete;
  InPose& operator=(const InPose&) = delete;

  const ConvexSet& set() const noexcept { return *set_; }

 private:
  const ConvexSet* set_;
  std::optional<PosedView> view_;
};

}  // namespace raygauge
