// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/registries.h"

#include <gtest/gtest.h>

#include "raygauge/sets/point_set.h"

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

TEST(Registries, PointSetsAreTakenByEveryMethodButThoseOfGeneralSets) {
  const MethodRegistry methods = all_methods();
  for (const char* name : {"column_generation", "newton", "object_distance", "zheng_yamane"})
    EXPECT_TRUE(methods.find(name).point_sets);
  for (const std::string& name : methods.names()) {
    bool general = false;
    for (const char* kind : {"nlopt", "libsvm", "fcl", "bullet", "cgal", "libccd", "mujoco", "ode"})
      general = general || name.starts_with(kind);
    EXPECT_EQ(methods.find(name).point_sets, !general) << name;
  }
}

TEST(Registries, ThreeMethodsAreTheEngines) {
  const MethodRegistry methods = all_methods();
  std::vector<std::string> engine;
  for (const std::string& name : methods.names())
    if (methods.find(name).role == Role::engine) engine.push_back(name);
  EXPECT_EQ(engine,
            (std::vector<std::string>{"column_generation", "newton", "object_distance", "zheng_yamane"}));
  EXPECT_THROW(methods.find("direct"), UnknownNameError)
      << "not even by a name from before the first release";
}

}  // namespace
}  // namespace raygauge::cli::test_registries
