// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/registries.h"

#include <memory>

#include "baselines/registry.h"
#include "engine/sets/point_set.h"
#include "generators/registry.h"

namespace raygauge::cli {
namespace {

bool takes_point_sets(const Component<SolveMethod>& method) {
  const auto points = std::make_shared<PointSet>(Eigen::MatrixXd{{-1.0, 1.0}});
  try {
    method.make(complete(method.name, method.parameters, {}))->load({points, points, {}});
  } catch (const InvalidParameterError&) {
    return false;
  }
  return true;
}

}  // namespace

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

MethodRegistry methods_for_point_sets() {
  const MethodRegistry all = all_methods();
  MethodRegistry registry("method");
  for (const std::string& name : all.names()) {
    if (takes_point_sets(all.find(name))) registry.add(all.find(name));
  }
  return registry;
}

}  // namespace raygauge::cli
