// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/queries/growth_body.h"
#include "engine/queries/method_chain.h"
#include "raygauge/sets/pose.h"

namespace raygauge {

/// The growth distance by the general methods: A is scaled about its centre, Q about its own or about the
/// origin of the world. `aim` has the threshold. Keeps memory from one solve to the next.
class GrowthSolve {
 public:
  const DistanceResult& solve(const Posed& A, const Posed& Q, bool about_origin, const Aim& aim,
                              WarmStart* warm, MethodChain& methods);

 private:
  PosedCenter A_, Q_;
};

}  // namespace raygauge
