// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "raygauge/scene/continuous.h"
#include "raygauge/scene/motion.h"
#include "raygauge/scene/scene.h"

namespace raygauge {

/// Two bodies, seen from the link that carries both where there is one: what both have of its motion changes
/// no Euclidean distance, and would add to the bounds of both. Other bodies are seen as they are; all must
/// outlive the object.
class Riders {
 public:
  /// `euclidean`: whether distances do not depend on how a pair is turned.
  Riders(const Body& a, const Body& b, bool euclidean);

  const Body& a() const noexcept { return ride_ ? rider_a_ : a_; }
  const Body& b() const noexcept { return ride_ ? rider_b_ : b_; }

  /// An answer about these at time t, in the space of the scene from now on.
  void to_scene(double t, PairAnswer& answer) const;

 private:
  const Body& a_;
  const Body& b_;
  std::optional<SharedRide> ride_;
  Body rider_a_, rider_b_;
};

}  // namespace raygauge
