// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/hard/planted.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/floating_point.h"
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

constexpr std::int64_t kSpread = 10;

PointClouds plant(const InstanceKey& key, const char* name, int N, const Parameters& parameters) {
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

void shear(PointClouds& clouds, const InstanceKey& key, const char* name, const Parameters& parameters) {
  RandomStream stream(key, name, RandomPurpose::placement);
  apply_unimodular(clouds, stream, static_cast<double>(integer_parameter(parameters, "entry")));
}

// Columns `columns` of `points` become random points with y·p = 0 (`flat`) or any, the last of them minus the
// sum of the others: 0 is in the relative interior of their hull.
void surround_origin(Eigen::MatrixXd& points, const std::vector<std::ptrdiff_t>& columns, const Functional& y,
                     bool flat, RandomStream& stream) {
  Vector sum = Vector::Zero(points.rows());
  for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
    const double level = flat ? 0.0 : random_integer(stream, -100, 100);
    points.col(columns[i]) = point_on(y, level, kSpread, stream);
    sum += points.col(columns[i]);
  }
  points.col(columns.back()) = -sum;
}

// So many of N columns, chosen at random: the fraction `ties` of them, at least `least`.
std::vector<std::ptrdiff_t> some_columns(int N, double ties, int least, RandomStream& stream) {
  std::vector<std::ptrdiff_t> columns = stream.permutation(N);
  const auto count = std::clamp(static_cast<int>(ties * N), std::min(least, N), N);
  columns.resize(static_cast<std::size_t>(count));
  return columns;
}

Instance generate_origin(const InstanceKey& key, const Parameters& parameters) {
  const char* name = "hard_planted_origin";
  const bool inside = string_parameter(parameters, "place") == "interior";
  const double ties = real_parameter(parameters, "ties");
  RandomStream shape(key, name, RandomPurpose::shape);
  RandomStream stream_of_A(key, name, RandomPurpose::points_of_A);
  RandomStream stream_of_Q(key, name, RandomPurpose::points_of_Q);
  const Functional y = random_functional(shape, key.n);
  PointClouds clouds{Eigen::MatrixXd(key.n, key.N), Eigen::MatrixXd(key.n, key.N)};
  for (int i = 0; i < key.N; ++i) {
    clouds.Q.col(i) = point_on(y, kLevel - random_slack(stream_of_Q, ties), kSpread, stream_of_Q);
    clouds.A.col(i) = point_on(y, 1 + random_slack(stream_of_A, 0), kSpread, stream_of_A);
  }
  const int least = inside ? std::min(key.N, key.n + 2) : 3;
  surround_origin(clouds.A, some_columns(key.N, inside ? 0 : ties, least, shape), y, !inside, stream_of_A);
  shear(clouds, key, name, parameters);
  return to_instance(clouds, 0);
}

Instance generate_unreachable(const InstanceKey& key, const Parameters& parameters) {
  const char* name = "hard_planted_unreachable";
  const double ties = real_parameter(parameters, "ties");
  RandomStream shape(key, name, RandomPurpose::shape);
  RandomStream stream_of_A(key, name, RandomPurpose::points_of_A);
  RandomStream stream_of_Q(key, name, RandomPurpose::points_of_Q);
  const Functional y = random_functional(shape, key.n);
  PointClouds clouds{Eigen::MatrixXd(key.n, key.N), Eigen::MatrixXd(key.n, key.N)};
  for (int i = 0; i < key.N; ++i) {
    clouds.Q.col(i) = point_on(y, -random_slack(stream_of_Q, 0), kSpread, stream_of_Q);
    clouds.A.col(i) = point_on(y, 1 + random_slack(stream_of_A, ties), kSpread, stream_of_A);
  }
  surround_origin(clouds.Q, some_columns(key.N, ties, 3, shape), y, true, stream_of_Q);
  shear(clouds, key, name, parameters);
  return to_instance(clouds, kInfinity);
}

double planted_distance(const Parameters& parameters) {
  return static_cast<double>(integer_parameter(parameters, "lambda"));
}

Instance generate_ties(const InstanceKey& key, const Parameters& parameters) {
  return to_instance(plant(key, "hard_planted_ties", key.N, parameters), planted_distance(parameters));
}

Instance generate_unimodular(const InstanceKey& key, const Parameters& parameters) {
  PointClouds clouds = plant(key, "hard_planted_unimodular", key.N, parameters);
  shear(clouds, key, "hard_planted_unimodular", parameters);
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

ParameterInfo ties_parameter() {
  return {"ties", 0.5, 0, 1, "fraction of points on the optimal hyperplane", {}};
}

ParameterInfo entry_parameter() {
  return {"entry", std::int64_t{1000}, 1, 1e4, "largest entry of the map", {}, "1", {"entry"}};
}

std::vector<ParameterInfo> planted_parameters(std::vector<ParameterInfo> more = {}) {
  std::vector<ParameterInfo> all = {
      {"lambda", std::int64_t{3}, 1, 1e6, "the planted distance", {}},
      ties_parameter(),
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
  return generator_component("hard_planted_unimodular",
                             "as hard_planted_ties, after an ill-conditioned integer map",
                             planted_parameters({entry_parameter()}), generate_unimodular);
}

Component<Generator> hard_planted_origin_generator() {
  return generator_component(
      "hard_planted_origin", "integer points with the origin on a face or inside",
      {{"place", std::string("face"), {}, {}, "where in A the origin is", {"face", "interior"}},
       ties_parameter(),
       entry_parameter()},
      generate_origin);
}

Component<Generator> hard_planted_unreachable_generator() {
  return generator_component("hard_planted_unreachable",
                             "a plane between A and a Q that surrounds the origin in it",
                             {ties_parameter(), entry_parameter()}, generate_unreachable);
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
