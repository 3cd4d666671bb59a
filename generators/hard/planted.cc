// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/hard/planted.h"

#include <algorithm>
#include <cmath>

#include "generators/component.h"
#include "generators/hard/maps.h"

namespace raygauge {
namespace {

constexpr double kLevel = 100;  // K

// An integer functional y, with y_pivot = ±1 so that y·x = level can be solved in integers.
struct Functional {
  Vector y;
  Eigen::Index pivot;
};

Functional random_functional(RandomStream& stream, int n) {
  Functional functional{Vector(n), static_cast<Eigen::Index>(stream.integer(0, n - 1))};
  for (double& coordinate : functional.y) coordinate = signed_integer(stream, 1, 3);
  functional.y[functional.pivot] = signed_integer(stream, 1, 1);
  return functional;
}

// A random integer point x with y·x = level; coordinates other than the pivot are up to `spread` in size.
Vector point_on(const Functional& functional, double level, std::int64_t spread, RandomStream& stream) {
  const auto& [y, pivot] = functional;
  Vector x(y.size());
  double rest = level;
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    if (k == pivot) continue;
    x[k] = random_integer(stream, -spread, spread);
    rest -= y[k] * x[k];
  }
  x[pivot] = y[pivot] * rest;
  return x;
}

// How far beyond its hyperplane a point lies: 0 for the fraction `ties` of them, else up to 4K, so that Q
// reaches to the other side of the origin.
double random_slack(RandomStream& stream, double ties) {
  return stream.uniform() < ties ? 0 : random_integer(stream, 1, static_cast<std::int64_t>(4 * kLevel));
}

PointClouds plant(const InstanceKey& key, const char* name, int N, const Parameters& parameters) {
  constexpr std::int64_t kSpread = 10;
  const auto lambda = integer_parameter(parameters, "lambda");
  const double ties = real_parameter(parameters, "ties");
  RandomStream shape(key, name, RandomPurpose::shape);
  RandomStream stream_of_A(key, name, RandomPurpose::points_of_A);
  RandomStream stream_of_Q(key, name, RandomPurpose::points_of_Q);
  const Functional y = random_functional(shape, key.n);
  const auto scale = static_cast<double>(lambda);
  PointClouds clouds{Eigen::MatrixXd(key.n, N), Eigen::MatrixXd(key.n, N)};
  for (int i = 0; i < N; ++i) {
    clouds.Q.col(i) = point_on(y, kLevel - random_slack(stream_of_Q, ties), kSpread, stream_of_Q);
    clouds.A.col(i) =
        point_on(y, scale * kLevel + random_slack(stream_of_A, ties), kSpread * lambda, stream_of_A);
  }
  const Vector contact = point_on(y, kLevel, kSpread, shape);
  clouds.Q.col(shape.integer(0, N - 1)) = contact;
  clouds.A.col(shape.integer(0, N - 1)) = scale * contact;
  return clouds;
}

double planted_distance(const Parameters& parameters) {
  return static_cast<double>(integer_parameter(parameters, "lambda"));
}

Instance generate_ties(const InstanceKey& key, const Parameters& parameters) {
  return to_instance(plant(key, "hard_planted_ties", key.N, parameters), planted_distance(parameters));
}

Instance generate_unimodular(const InstanceKey& key, const Parameters& parameters) {
  PointClouds clouds = plant(key, "hard_planted_unimodular", key.N, parameters);
  RandomStream stream(key, "hard_planted_unimodular", RandomPurpose::placement);
  apply_unimodular(clouds, stream, static_cast<double>(integer_parameter(parameters, "entry")));
  return to_instance(clouds, planted_distance(parameters));
}

Instance generate_duplicates(const InstanceKey& key, const Parameters& parameters) {
  const auto copies = static_cast<int>(integer_parameter(parameters, "copies"));
  PointClouds clouds = plant(key, "hard_duplicates", std::max(1, key.N / copies), parameters);
  RandomStream stream(key, "hard_duplicates", RandomPurpose::order);
  clouds.A = repeated_and_shuffled(clouds.A, copies, stream);
  clouds.Q = repeated_and_shuffled(clouds.Q, copies, stream);
  return to_instance(clouds, planted_distance(parameters));
}

Instance generate_scaled(const InstanceKey& key, const Parameters& parameters) {
  PointClouds clouds = plant(key, "hard_scaled", key.N, parameters);
  const auto exponent = static_cast<int>(integer_parameter(parameters, "exponent"));
  clouds.A = scaled_by_power_of_two(clouds.A, exponent);
  clouds.Q = scaled_by_power_of_two(clouds.Q, exponent);
  return to_instance(clouds, planted_distance(parameters));
}

Instance generate_scaled_object(const InstanceKey& key, const Parameters& parameters) {
  PointClouds clouds = plant(key, "hard_scaled_object", key.N, parameters);
  const auto exponent = static_cast<int>(integer_parameter(parameters, "exponent"));
  clouds.A = scaled_by_power_of_two(clouds.A, exponent);
  return to_instance(clouds, std::ldexp(planted_distance(parameters), exponent));
}

std::vector<ParameterInfo> planted_parameters(std::vector<ParameterInfo> more = {}) {
  std::vector<ParameterInfo> all = {
      {"lambda", std::int64_t{3}, 1, 1e6, "the planted distance", {}},
      {"ties", 0.5, 0, 1, "fraction of points on the optimal hyperplane", {}},
  };
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

ParameterInfo exponent_parameter(std::int64_t default_value) {
  return {"exponent", default_value,          -900, 900, "power of two of the scale", {},
          "1",        {"scale", power_of_two}};
}

}  // namespace

Component<Generator> hard_planted_ties_generator() {
  return generator_component("hard_planted_ties", "integer points with a planted answer and many ties",
                             planted_parameters(), generate_ties);
}

Component<Generator> hard_planted_unimodular_generator() {
  return generator_component(
      "hard_planted_unimodular", "as hard_planted_ties, after an ill-conditioned integer map",
      planted_parameters(
          {{"entry", std::int64_t{1000}, 1, 1e4, "largest entry of the map", {}, "1", {"entry"}}}),
      generate_unimodular);
}

Component<Generator> hard_duplicates_generator() {
  return generator_component(
      "hard_duplicates", "as hard_planted_ties, every point many times over",
      planted_parameters({{"copies", std::int64_t{50}, 1, 1000, "copies of every point", {}}}),
      generate_duplicates);
}

Component<Generator> hard_scaled_generator() {
  return generator_component("hard_scaled", "as hard_planted_ties, both sets times a power of two",
                             planted_parameters({exponent_parameter(500)}), generate_scaled);
}

Component<Generator> hard_scaled_object_generator() {
  return generator_component("hard_scaled_object", "as hard_planted_ties, only A times a power of two",
                             planted_parameters({exponent_parameter(27)}), generate_scaled_object);
}

}  // namespace raygauge
