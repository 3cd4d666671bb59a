// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "generators/registry.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sweep/instance.h"

namespace raygauge {

/// The points of a set that a generator made, one a column. Throws std::bad_cast if it is no point set.
inline Eigen::MatrixXd points_of(const std::shared_ptr<const ConvexSet>& set) {
  return dynamic_cast<const PointSet&>(*set).points();
}

inline const GeneratorRegistry& all_generators() {
  static const GeneratorRegistry kRegistry = [] {
    GeneratorRegistry made("generator");
    register_generators(made);
    return made;
  }();
  return kRegistry;
}

/// The instance that the registered generator `name` makes for `key`.
inline Instance generate(const std::string& name, const InstanceKey& key, const Parameters& parameters = {}) {
  return all_generators().make(name, parameters)->generate(key);
}

}  // namespace raygauge
