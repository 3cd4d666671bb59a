// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/example2.h"

#include "generators/component.h"
#include "generators/separated_spheres.h"

namespace raygauge::example2 {
namespace {

constexpr const char* kName = "example2";

Instance generate(const InstanceKey& key, const Parameters& parameters) {
  RandomStream stream_of_A(key, kName, RandomPurpose::points_of_A);
  RandomStream stream_of_Q(key, kName, RandomPurpose::points_of_Q);
  PointClouds clouds{random_sphere_points(stream_of_A, key.n, key.N),
                     random_sphere_points(stream_of_Q, key.n, key.N)};
  move_apart(clouds, key, kName, real_parameter(parameters, "separation"));
  return to_instance(clouds);
}

}  // namespace
}  // namespace raygauge::example2

namespace raygauge {

Component<Generator> example2_generator() {
  return generator_component(example2::kName,
                             "N random points on each of two separated unit spheres (Example 2)",
                             {separation_parameter()}, example2::generate);
}

}  // namespace raygauge
