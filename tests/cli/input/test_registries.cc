// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/registries.h"

#include <gtest/gtest.h>

#include "engine/sets/point_set.h"

namespace raygauge::cli::test_registries {
namespace {

bool loads_point_sets(SolveMethod& method) {
  const auto points = std::make_shared<PointSet>(Eigen::MatrixXd{{-1.0, 1.0}});
  try {
    method.load({points, points, {}});
  } catch (const InvalidParameterError&) {
    return false;
  }
  return true;
}

TEST(Registries, AMethodTakesPointSetsIfItSaysSo) {
  const MethodRegistry methods = all_methods();
  for (const std::string& name : methods.names()) {
    EXPECT_EQ(loads_point_sets(*methods.make(name, {})), methods.find(name).point_sets) << name;
  }
}

TEST(Registries, PointSetsAreTakenByEveryMethodButNloptsAndFcls) {
  const MethodRegistry methods = all_methods();
  for (const char* name : {"direct", "newton", "zheng_yamane"}) EXPECT_TRUE(methods.find(name).point_sets);
  for (const std::string& name : methods.names()) {
    const bool general = name.starts_with("nlopt") || name.starts_with("fcl");
    EXPECT_EQ(methods.find(name).point_sets, !general) << name;
  }
}

}  // namespace
}  // namespace raygauge::cli::test_registries
