// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/friction/loaded_friction.h"

#include "results/run/own_module.h"

namespace raygauge {

std::unique_ptr<FrictionSolver> loaded_friction() {
  const OwnModule siconos{
      "raygauge_siconos.so", false,
      "friction needs Siconos numerics: apt-get install libsiconos-numerics-dev, and build again"};
  using Create = FrictionSolver* (*)();
  const auto create = reinterpret_cast<Create>(function_of(siconos, "raygauge_create_friction"));
  return std::unique_ptr<FrictionSolver>(create());
}

}  // namespace raygauge
