// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <string>
#include <utility>
#include <vector>

#include "bench/tuning_rows.h"
#include "engine/methods/bodies/tuning.h"
#include "engine/methods/spatial/tuning.h"
#include "scene/simulation/tuning.h"

namespace raygauge::bench {
namespace {

TunedMethod spatial() {
  const std::vector<std::pair<std::string, std::string>> curved = {
      {"ellipsoid", "ellipsoid"}, {"cylinder", "cylinder"}, {"cylinder", "ellipsoid"}, {"hull 8", "pointed"}};
  const std::vector<std::pair<std::string, std::string>> hulls = {
      {"box", "hull 2000"}, {"hull 200", "hull 200"}, {"hull 200", "hull 2000"}, {"hull 2000", "hull 2000"}};
  const Workload near = pairs(curved, "1e-4", PairAsk::distance),
                 far = pairs(curved, "apart", PairAsk::distance);
  const Workload growths = pairs(curved, "apart", PairAsk::growth),
                 facets = pairs(hulls, "1e-4", PairAsk::distance);
  const std::string of_near = "curved, 1e-4 apart", of_hulls = "hulls of 200 to 2000, 1e-4 apart";
  return {
      "spatial",
      {{{"kLongestContactStep", tuned::kLongestContactStep}, {0.12, 0.25, 1, 2}, of_near, near},
       {{"kShorterContactStep", tuned::kShorterContactStep}, {0.1, 0.2, 0.5, 0.7}, of_near, near},
       {{"kLongerContactStep", tuned::kLongerContactStep}, {1, 1.5, 4, 8}, of_near, near},
       {{"kNearCurved", tuned::kNearCurved}, {3e-3, 1e-2, 0.1, 0.3}, of_near, near},
       {{"kNearCurved", tuned::kNearCurved}, {3e-3, 1e-2, 0.1, 0.3}, "curved, apart", far},
       {{"kNearFacets", tuned::kNearFacets}, {6e-3, 2e-2, 6e-2, 0.3}, of_hulls, facets},
       {{"kTouchingFacets", tuned::kTouchingFacets}, {1e-9, 1e-7, 1e-5, 1e-4}, of_hulls, facets},
       {{"kFewPointsOfHulls", tuned::kFewPointsOfHulls}, {30, 100, 1000, 4000}, of_hulls, facets},
       {{"kFewPointsFromStart", tuned::kFewPointsFromStart},
        {100, 500, 2000, 20000},
        of_hulls + ", warm",
        pairs(hulls, "1e-4", PairAsk::warm)},
       {{"kLongestGrowthStep", tuned::kLongestGrowthStep}, {0.2, 0.4, 1.2, 2.5}, "curved, growth", growths},
       {{"kFirstTilt", tuned::kFirstTilt}, {0.5, 1, 3, 6}, "curved, growth", growths}}};
}

TunedMethod bodies() {
  const std::vector<std::pair<std::string, std::string>> kinds = {{"box", "cylinder"},
                                                                  {"cylinder", "ellipsoid"},
                                                                  {"cone", "pointed"},
                                                                  {"box", "hull 200"},
                                                                  {"hull 200", "hull 200"}};
  const std::vector<std::pair<std::string, std::string>> rounded = {
      {"ball", "cylinder"}, {"capsule", "ellipsoid"}, {"capsule", "cone"}, {"ball", "hull 200"}};
  const std::string of_warm = "overlap, on a way";
  const Workload warm = pairs(kinds, "overlap", PairAsk::depth_warm);
  return {"bodies",
          {{{"kShareOfCores", tuned::kShareOfCores},
            {0.1, 0.25, 0.5, 1},
            "balls and capsules, 0.01 deep",
            pairs(rounded, "slight", PairAsk::depth)},
           {{"kStepsWorthRecording", tuned::kStepsWorthRecording}, {0, 1, 6, 12}, of_warm, warm},
           {{"kStepsWorthRecording", tuned::kStepsWorthRecording},
            {0, 1, 6, 12},
            "overlap, at rest",
            pairs(kinds, "overlap", PairAsk::depth_at_rest)},
           {{"kCornersWorthRecording", tuned::kCornersWorthRecording}, {16, 32, 64, 255}, of_warm, warm},
           {{"kGrownPolytope", tuned::kGrownPolytope}, {1, 1.1, 1.5, 3}, of_warm, warm},
           {{"kUnevenFacet", tuned::kUnevenFacet},
            {0.25, 1, 1e3, 1e6},
            "depths, n = 4, 5, 6, N = 200",
            depths({{4, 200}, {5, 200}, {6, 200}})}}};
}

TunedMethod simulation() {
  const Workload heap = heap_steps(200, 0.6, 0.64), packed = heap_steps(200, 1.1, 1.13);
  const std::string on = "40 steps, 200 bodies",
                    of_packed =
                        "30 steps, 200 bodies at rest (their ways part: below a fifth nothing is told)";
  return {"simulation",
          {{{"kManyContacts", tuned::kManyContacts}, {25, 50, 200, 400}, of_packed, packed},
           {{"kRoughFriction", tuned::kRoughFriction}, {1e-6, 1e-5, 1e-3, 1e-2}, of_packed, packed},
           {{"kPatienceOfPasses", tuned::kPatienceOfPasses}, {8, 15, 60, 120}, on, heap},
           {{"kPatienceOfRoughPasses", tuned::kPatienceOfRoughPasses}, {3, 5, 20, 40}, of_packed, packed},
           {{"kPassesOfLook", tuned::kPassesOfLook}, {1, 4, 16, 32}, on, heap},
           {{"kFirstSteepness", tuned::kFirstSteepness}, {10, 30, 100, 1000}, of_packed, packed},
           {{"kPatienceOfRounds", tuned::kPatienceOfRounds}, {5, 10, 25, 40}, of_packed, packed},
           {{"kContactsOfThreads", tuned::kContactsOfThreads},
            {8, 16, 64, 128},
            "2 threads, " + on,
            heap_steps(200, 0.6, 0.64, 2),
            Clock::wall},
           {{"kBodiesOfThreads", tuned::kBodiesOfThreads},
            {4, 8, 32, 64},
            "2 threads, 60 steps, 60 bodies",
            heap_steps(60, 0.5, 0.56, 2),
            Clock::wall}}};
}

}  // namespace

std::vector<TunedMethod> tuned_methods_of_bodies() { return {spatial(), bodies(), simulation()}; }

}  // namespace raygauge::bench
