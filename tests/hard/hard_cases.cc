// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/hard/hard_cases.h"

#include <cctype>

namespace raygauge {
namespace {

constexpr int kLargestCube = 8;  // 256 points; beyond, 2^n tells nothing new
const std::string kCross = "cross_polytope", kCube = "cube", kSimplex = "simplex";
const std::string kPoint = "point", kAroundOrigin = "around_origin";

std::vector<HardCase> bodies_and_boxes() {
  return {{"hard_point", {{"body", kCross}}},
          {"hard_point", {{"body", kSimplex}}},
          {"hard_point", {{"body", kCube}}, kLargestCube},
          {"hard_box", {{"body", kCross}}, kLargestCube},
          {"hard_box", {{"body", kCube}}, kLargestCube},
          {"hard_lattice", {{"body", kCross}}, 5},
          {"hard_lattice", {{"body", kCube}}, 5},
          {"hard_far", {{"body", kCross}}},
          {"hard_far", {{"body", kSimplex}}, 20},
          {"hard_far", {{"body", kCube}}, kLargestCube},
          {"hard_cross_polytope", {}, kLargestCube},
          {"hard_scaled_simplex", {{"body", kCross}}},
          {"hard_scaled_simplex", {{"body", kCube}}, kLargestCube},
          {"hard_vertex", {{"body", kCross}, {"lambda", 0.1}}},
          {"hard_vertex", {{"body", kCube}, {"feature", std::string("edge_midpoint")}}, kLargestCube},
          {"hard_vertex", {{"body", kSimplex}, {"feature", std::string("edge_midpoint")}, {"lambda", 0.3}}}};
}

std::vector<HardCase> planted() {
  return {{"hard_planted_ties", {}},
          {"hard_planted_ties", {{"ties", 1.0}}},
          {"hard_planted_unimodular", {{"entry", std::int64_t{30}}}},
          {"hard_planted_unimodular", {}},
          {"hard_planted_origin", {{"entry", std::int64_t{30}}}},
          {"hard_planted_origin", {{"place", std::string("interior")}}},
          {"hard_planted_unreachable", {{"entry", std::int64_t{30}}}},
          {"hard_duplicates", {}},
          {"hard_scaled", {{"exponent", std::int64_t{500}}}},
          {"hard_scaled", {{"exponent", std::int64_t{-500}}}},
          {"hard_scaled_object", {}},
          {"hard_scaled_object", {{"exponent", std::int64_t{-500}}}, 20}};
}

std::vector<HardCase> thin() {
  return {{"hard_needle", {{"aspect", 1e3}}},
          {"hard_needle", {{"aspect", 1e12}}},
          {"hard_needle", {{"aspect", 0x1p10}, {"sheared", true}}},
          {"hard_needle", {{"aspect", 0x1p39}, {"sheared", true}}},
          {"hard_near_face", {{"delta", 1e-3}}},
          {"hard_near_face", {{"delta", 1e-300}}},
          {"hard_near_face", {{"body", kCube}}, kLargestCube},
          {"hard_contact", {}},
          {"hard_contact", {{"ulps", std::int64_t{1}}}},
          {"hard_contact", {{"ulps", std::int64_t{-1}}}},
          {"hard_contact", {{"body", kCube}, {"ulps", std::int64_t{-1}}}, kLargestCube},
          {"hard_origin_near_facet", {}, 50, true},
          {"hard_origin_near_facet", {{"delta", 0x1p-40}}},
          {"hard_origin_near_facet", {{"delta", 1e-300}}, 50, true}};
}

std::vector<HardCase> origin() {
  return {{"hard_origin_in_object", {{"place", std::string("interior")}}},
          {"hard_origin_in_object", {{"place", std::string("face")}}},
          {"hard_origin_in_object", {{"place", std::string("vertex")}, {"body", kSimplex}}},
          {"hard_origin_on_boundary", {}},
          {"hard_origin_on_boundary", {{"reachable", false}}},
          {"hard_origin_outside", {}},
          {"hard_origin_outside", {{"reachable", false}}},
          {"hard_flat", {}},
          {"hard_flat", {{"crossing", false}}},
          {"hard_flat", {{"crossing", false}, {"delta", 1e-300}}}};
}

HardCase rounded(const std::string& generator, const Parameters& parameters) {
  return {generator, parameters, 50, true};
}

std::vector<HardCase> balls() {
  return {{"hard_tangent_disc", {{"epsilon", 0x1p-10}}},
          rounded("hard_tangent_disc", {{"epsilon", 1e-8}}),
          {"hard_tangent_disc", {{"epsilon", 0.0}}},
          {"hard_p_norm_ball", {{"p", 1.0}}, 50, false, 8},
          rounded("hard_p_norm_ball", {{"p", 1 + 1e-6}}),
          rounded("hard_p_norm_ball", {{"p", 1.5}}),
          rounded("hard_p_norm_ball", {}),
          rounded("hard_p_norm_ball", {{"p", 100.0}}),
          rounded("hard_p_norm_ball", {{"p", 1e6}}),
          rounded("hard_p_norm_ball", {{"object", kPoint}}),
          {"hard_p_norm_ball", {{"object", kAroundOrigin}}},
          {"hard_ellipsoid", {{"aspect", 1.0}}},
          {"hard_ellipsoid", {}},
          {"hard_ellipsoid", {{"aspect", 1e8}}},
          {"hard_ellipsoid", {{"aspect", 1e8}, {"object", kPoint}}},
          {"hard_ellipsoid", {{"aspect", 1e8}, {"object", kAroundOrigin}}}};
}

std::vector<HardCase> cones() {
  std::vector<HardCase> all = {{"hard_truncated_cone", {{"place", std::string("axis")}, {"object", kPoint}}},
                               {"hard_truncated_cone", {{"object", kAroundOrigin}}}};
  for (const std::string shape : {"truncated", "cone", "cylinder", "inverted"}) {
    for (const std::string place : {"side", "cap", "rim", "axis"}) {
      all.push_back({"hard_truncated_cone", {{"shape", shape}, {"place", place}}});
    }
  }
  return all;
}

std::vector<HardCase> capsules() {
  std::vector<HardCase> all = {{"hard_capsule", {{"ratio", 1e-3}, {"place", std::string("side")}}},
                               {"hard_capsule", {{"place", std::string("tip")}, {"object", kPoint}}},
                               {"hard_capsule", {{"object", kAroundOrigin}}}};
  for (const std::string place : {"side", "cap", "seam", "tip"}) {
    for (const double ratio : {1.0, 1e3})
      all.push_back({"hard_capsule", {{"place", place}, {"ratio", ratio}}});
  }
  return all;
}

std::vector<HardCase> near_axis() {
  std::vector<HardCase> all;
  for (const std::string body : {"cone", "cylinder", "capsule"}) {
    for (const std::string& object : {std::string("homothet"), kPoint}) {
      all.push_back({"hard_near_axis", {{"body", body}, {"object", object}}, 50, body == "capsule"});
    }
  }
  return all;
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all;
  for (const auto& group : {bodies_and_boxes(), planted(), thin(), origin()}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

std::vector<HardCase> smooth_hard_cases() {
  std::vector<HardCase> all;
  for (const auto& group : {balls(), cones(), capsules(), near_axis()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

std::vector<HardCase> hard_cases_of_unknown_distance() {
  return {{"hard_moment_curve", {}},
          {"hard_polygons", {}},
          {"hard_minkowski_difference", {}},
          {"hard_low_rank", {{"rank", std::int64_t{0}}}},
          {"hard_low_rank", {{"rank", std::int64_t{1}}}},
          {"hard_low_rank", {{"rank", std::int64_t{2}}}},
          {"hard_needle", {{"aspect", 1e9}, {"sheared", true}}},
          {"clustered", {}},
          {"needle", {{"aspect", 1e10}}}};
}

std::vector<int> dimensions_of(const HardCase& tested, int limit) {
  std::vector<int> dimensions;
  for (const int n : {2, 3, 5, 8, 20, 50}) {
    if (n <= tested.largest_n && n <= limit) dimensions.push_back(n);
  }
  return dimensions;
}

std::string label(const HardCase& tested) {
  std::string text = tested.generator;
  if (!tested.parameters.empty()) text.append("_").append(to_string(tested.parameters));
  for (char& c : text) {
    if (c == '-') c = 'm';
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return text;
}

}  // namespace raygauge
