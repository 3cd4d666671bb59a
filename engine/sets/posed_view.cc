// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/posed_view.h"

#include "engine/sets/parameters.h"

namespace raygauge {
namespace {

LinearMap map_of(const ConvexSet& S, const Pose& pose) {
  check_dimension("pose", "its rotation", pose.dimension(), S.dimension());
  LinearMap map;
  map.n = S.dimension();
  map.M = pose.rotation_data();
  map.t = pose.translation_data();
  map.defect = pose.defect();
  map.exchanges_axes = map.reverses_axes = pose.is_axis_exchange();
  return map;
}

}  // namespace

PosedView::PosedView(const ConvexSet& S, const Pose& pose) : LinearImage(S, map_of(S, pose)) {}

}  // namespace raygauge
