// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/queries/riders.h"

namespace raygauge {

Riders::Riders(const Body& a, const Body& b, bool euclidean) : a_(a), b_(b) {
  if (euclidean) ride_ = shared_ride(*a.motion, *b.motion);
  if (!ride_) return;
  rider_a_ = a;
  rider_b_ = b;
  rider_a_.motion = ride_->a;
  rider_b_.motion = ride_->b;
}

void Riders::to_scene(double t, PairAnswer& answer) const {
  if (!ride_) return;
  const Placement carrier = ride_->carrier->at(t);
  for (SmallVector* point : {&answer.point_a, &answer.point_b}) {
    if (point->size() > 0) *point = carrier.turned(*point) + carrier.t;
  }
  for (SmallVector* direction : {&answer.normal, &answer.gradient}) {
    if (direction->size() > 0) *direction = carrier.turned(*direction);
  }
}

}  // namespace raygauge
