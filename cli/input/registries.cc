// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/registries.h"

#include "baselines/command_method.h"
#include "baselines/registry.h"
#include "generators/registry.h"

namespace raygauge::cli {

GeneratorRegistry all_generators() {
  GeneratorRegistry registry("generator");
  register_generators(registry);
  return registry;
}

MethodRegistry all_methods() {
  MethodRegistry registry("method");
  register_engine_methods(registry);
  register_baselines(registry);
  return registry;
}

MethodRegistry sweep_methods() {
  MethodRegistry registry = all_methods();
  register_command_method(registry);
  return registry;
}

}  // namespace raygauge::cli
