// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Every exact_distance of the hard families, held to a brute-force solution in rational arithmetic.
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <ostream>

#include "tests/generators/hard/brute_force.h"
#include "tests/generators/points_of.h"

namespace raygauge::test_exact_distances {
namespace {

struct Case {
  std::string generator;
  Parameters parameters;
  int n = 2;
  int N = 8;
};

std::string label(const Case& tested) {
  std::string text = tested.generator + "_n" + std::to_string(tested.n) + "_" + to_string(tested.parameters);
  for (char& c : text) {
    if (c == '-') c = 'm';
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return text;
}

std::ostream& operator<<(std::ostream& out, const Case& tested) { return out << label(tested); }

class ExactDistance : public testing::TestWithParam<Case> {};

TEST_P(ExactDistance, IsTheBruteForceSolution) {
  constexpr int kRepetitions = 3;
  const auto& [generator, parameters, n, N] = GetParam();
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    const Instance instance = generate(generator, {5, n, N, repetition}, parameters);
    const auto truth = brute_force_distance(points_of(instance.A), points_of(instance.Q));
    ASSERT_TRUE(instance.exact_distance.has_value());
    ASSERT_EQ(truth.has_value(), std::isfinite(*instance.exact_distance));
    if (!truth) continue;
    EXPECT_TRUE(is_nearest_double(*truth, *instance.exact_distance))
        << *instance.exact_distance << " is claimed, " << *truth << " is true";
  }
}

const std::string kCube = "cube", kSimplex = "simplex", kCross = "cross_polytope";

INSTANTIATE_TEST_SUITE_P(
    BodiesAndBoxes, ExactDistance,
    testing::ValuesIn(std::vector<Case>{
        {"hard_point", {{"body", kCross}}, 1},
        {"hard_point", {{"body", kCross}}, 3},
        {"hard_point", {{"body", kCube}}, 3},
        {"hard_point", {{"body", kSimplex}}, 1},
        {"hard_point", {{"body", kSimplex}}, 4},
        {"hard_box", {{"body", kCross}}, 3},
        {"hard_box", {{"body", kCube}}, 3},
        {"hard_lattice", {{"body", kCross}}, 2},
        {"hard_lattice", {{"body", kCube}, {"k", std::int64_t{1}}}, 3},
        {"hard_lattice", {{"body", kCross}, {"k", std::int64_t{5}}}, 1},
        {"hard_far", {{"body", kCross}}, 3},
        {"hard_far", {{"body", kCube}}, 2},
        {"hard_far", {{"body", kSimplex}}, 4},
        {"hard_cross_polytope", {}, 1},
        {"hard_cross_polytope", {}, 3},
        {"hard_scaled_simplex", {{"body", kCross}}, 4},
        {"hard_scaled_simplex", {{"body", kCube}}, 3},
        {"hard_vertex", {{"body", kCross}, {"lambda", 0.1}}, 3},
        {"hard_vertex", {{"body", kCube}, {"feature", std::string("edge_midpoint")}}, 3},
        {"hard_vertex", {{"body", kCross}, {"feature", std::string("edge_midpoint")}, {"lambda", 1e-150}}, 2},
        {"hard_vertex", {{"body", kSimplex}, {"feature", std::string("edge_midpoint")}, {"lambda", 0.3}}, 4},
    }),
    [](const auto& test) { return label(test.param); });

INSTANTIATE_TEST_SUITE_P(
    Planted, ExactDistance,
    testing::ValuesIn(std::vector<Case>{
        {"hard_planted_ties", {}, 1},
        {"hard_planted_ties", {}, 3},
        {"hard_planted_ties", {{"lambda", std::int64_t{1000000}}, {"ties", 1.0}}, 3},
        {"hard_planted_ties", {{"ties", 0.0}}, 2, 1},
        {"hard_planted_unimodular", {}, 1},
        {"hard_planted_origin", {}, 1},
        {"hard_planted_origin", {}, 3},
        {"hard_planted_origin", {{"place", std::string("interior")}, {"entry", std::int64_t{1}}}, 3},
        {"hard_planted_origin", {{"ties", 0.0}}, 2, 2},
        {"hard_planted_unreachable", {}, 1},
        {"hard_planted_unreachable", {{"ties", 1.0}}, 3},
        {"hard_planted_unreachable", {{"entry", std::int64_t{1}}}, 3, 1},
        {"hard_planted_unimodular", {}, 3},
        {"hard_planted_unimodular", {{"lambda", std::int64_t{1000000}}, {"entry", std::int64_t{10000}}}, 3},
        {"hard_duplicates", {{"copies", std::int64_t{3}}}, 2},
        {"hard_scaled", {{"exponent", std::int64_t{500}}}, 2},
        {"hard_scaled", {{"exponent", std::int64_t{-500}}}, 2},
        {"hard_scaled_object", {}, 3},
        {"hard_scaled_object", {{"exponent", std::int64_t{-900}}}, 2},
    }),
    [](const auto& test) { return label(test.param); });

INSTANTIATE_TEST_SUITE_P(Thin, ExactDistance,
                         testing::ValuesIn(std::vector<Case>{
                             {"hard_needle", {}, 1},
                             {"hard_needle", {}, 2},
                             {"hard_needle", {{"aspect", 1e12}}, 3},
                             {"hard_needle", {{"aspect", 0x1p39}, {"sheared", true}}, 3},
                             {"hard_near_face", {{"body", kCube}, {"delta", 1e-3}}, 3},
                             {"hard_near_face", {{"body", kCross}, {"delta", 1e-300}}, 3},
                             {"hard_contact", {{"body", kCross}}, 3},
                             {"hard_contact", {{"body", kCube}}, 3},
                             {"hard_contact", {{"body", kCross}, {"ulps", std::int64_t{1}}}, 3},
                             {"hard_contact", {{"body", kCross}, {"ulps", std::int64_t{-1}}}, 3},
                             {"hard_contact", {{"body", kCube}, {"ulps", std::int64_t{-1}}}, 3},
                             {"hard_origin_near_facet", {}, 3},
                             {"hard_origin_near_facet", {{"delta", 1e-300}}, 3},
                             {"hard_origin_near_facet", {{"delta", 0.3}}, 4},
                         }),
                         [](const auto& test) { return label(test.param); });

INSTANTIATE_TEST_SUITE_P(
    Origin, ExactDistance,
    testing::ValuesIn(std::vector<Case>{
        {"hard_origin_in_object", {{"place", std::string("interior")}}, 3},
        {"hard_origin_in_object", {{"place", std::string("face")}}, 3},
        {"hard_origin_in_object", {{"place", std::string("vertex")}}, 3},
        {"hard_origin_in_object", {{"place", std::string("vertex")}, {"body", kSimplex}}, 1},
        {"hard_origin_on_boundary", {}, 2},
        {"hard_origin_on_boundary", {}, 4},
        {"hard_origin_on_boundary", {{"reachable", false}}, 2},
        {"hard_origin_on_boundary", {{"reachable", false}}, 4},
        {"hard_origin_outside", {}, 2},
        {"hard_origin_outside", {}, 4},
        {"hard_origin_outside", {{"reachable", false}}, 2},
        {"hard_origin_outside", {{"reachable", false}}, 4},
        {"hard_flat", {}, 2},
        {"hard_flat", {{"delta", 1e-300}}, 4},
        {"hard_flat", {{"crossing", false}}, 2},
        {"hard_flat", {{"crossing", false}}, 4},
    }),
    [](const auto& test) { return label(test.param); });

}  // namespace
}  // namespace raygauge::test_exact_distances
