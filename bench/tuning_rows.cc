// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "bench/tuning_rows.h"

#include <utility>

#include "engine/kernels/tuning.h"
#include "engine/lp/tuning.h"
#include "engine/meshes/tuning.h"
#include "engine/methods/column_generation/tuning.h"
#include "engine/methods/nearest_point/tuning.h"
#include "engine/methods/newton/tuning.h"
#include "engine/methods/zheng_yamane/tuning.h"
#include "engine/queries/tuning.h"
#include "engine/sets/tuning.h"

namespace raygauge::bench {
namespace {

TunedMethod zheng_yamane() {
  const std::string name = "zheng_yamane";
  const Workload few = solves(name, {{3, 1000}, {5, 1000}, {10, 1000}});
  const Workload many = solves(name, {{20, 1000}, {50, 1000}});
  const std::string of_few = "n = 3, 5, 10, N = 1000", of_many = "n = 20, 50, N = 1000";
  return {name,
          {{{"kManyDimensionsOfRays", tuned::kManyDimensionsOfRays},
            {4, 8, 24, 64},
            "n = 6, 12, 20, 32, N = 1000",
            solves(name, {{6, 1000}, {12, 1000}, {20, 1000}, {32, 1000}})},
           {{"kRayMarginOfFew", tuned::kRayMarginOfFew}, {0.03, 0.07, 0.3, 0.6}, of_few, few},
           {{"kRayMarginOfMany", tuned::kRayMarginOfMany}, {0.1, 0.25, 1, 2}, of_many, many},
           {{"kOvertakingInFew", tuned::kOvertakingInFew}, {1.05, 1.15, 1.6, 2.5}, of_few, few},
           {{"kOvertakingInMany", tuned::kOvertakingInMany}, {1.3, 1.6, 2.5, 4}, of_many, many},
           {{"kFirstRayTolerance", tuned::kFirstRayTolerance}, {1e-3, 1e-2, 0.1, 0.3}, of_few, few},
           {{"kShortlistQueries", tuned::kShortlistQueries},
            {1, 4, 16, 64},
            "n = 10, 20, N = 10000",
            solves(name, {{10, 10000}, {20, 10000}})},
           {{"kRayWorthEntering", tuned::kRayWorthEntering},
            {0.1, 0.2, 0.6, 0.8},
            "n = 10, 20, N = 10000",
            solves(name, {{10, 10000}, {20, 10000}})}}};
}

TunedMethod column_generation_starts() {
  const std::string name = "column_generation";
  const Workload samples = solves(name, {{5, 20000}, {10, 20000}, {10, 100000}});
  const std::string of_samples = "n = 5, 10, N = 20000; n = 10, N = 10^5";
  return {name + ": where it begins",
          {{{"kLeastForAxes", tuned::kLeastForAxes},
            {4, 8, 32, 64},
            "cross-polytopes, n = 6, 12, 24, 48",
            solves_of(Shapes::cross_polytopes, {6, 12, 24, 48})},
           {{"kLeastForAxes", tuned::kLeastForAxes},
            {4, 8, 32, 64},
            "n = 6, 12, 24, N = 50 n",
            solves(name, {{6, 300}, {12, 600}, {24, 1200}})},
           {{"kNormalErrorOfFew", tuned::kNormalErrorOfFew},
            {0.04, 0.08, 0.3, 0.6},
            "n = 3, 5, 10, N = 500",
            solves(name, {{3, 500}, {5, 500}, {10, 500}})},
           {{"kNormalErrorOfMany", tuned::kNormalErrorOfMany},
            {0.01, 0.025, 0.1, 0.2},
            "n = 15, 30, 50, N = 3 n",
            solves(name, {{15, 45}, {30, 90}, {50, 150}})},
           {{"kDimensionsOfTableau", tuned::kDimensionsOfTableau},
            {2, 5, 15, 30},
            "n = 4, 8, 12, 20, N = 3 n",
            solves(name, {{4, 12}, {8, 24}, {12, 36}, {20, 60}})},
           {{"kNormalErrorOfSample", tuned::kNormalErrorOfSample},
            {0.005, 0.01, 0.04, 0.08},
            of_samples,
            samples},
           {{"kSpacingsOfSample", tuned::kSpacingsOfSample}, {0.2, 0.4, 1.6, 3}, of_samples, samples}}};
}

TunedMethod column_generation() {
  const std::string name = "column_generation";
  const Workload wide = solves(name, {{20, 10000}, {50, 10000}});
  return {
      name,
      {{{"kCheapNumbers", tuned::kCheapNumbers},
        {1 << 13, 1 << 15, 1 << 19, 1 << 21},
        "n = 5, 10, 20, N = 5000",
        solves(name, {{5, 5000}, {10, 5000}, {20, 5000}})},
       {{"kLeastToStall", tuned::kLeastToStall},
        {4, 8, 32, 64},
        "near, n = 6, 12, 24, 48, N = 2 n",
        solves(name, {{6, 12}, {12, 24}, {24, 48}, {48, 96}}, "near")},
       {{"kInteriorOfFew", tuned::kInteriorOfFew},
        {40, 55, 85, 110},
        "n = 50, 60, 80, 100, N = 2 n",
        solves(name, {{50, 100}, {60, 120}, {80, 160}, {100, 200}})},
       {{"kInteriorOfSome", tuned::kInteriorOfSome},
        {80, 100, 160, 200},
        "n = 90, 120, 150, N = 10 n",
        solves(name, {{90, 900}, {120, 1200}, {150, 1500}})},
       {{"kInteriorOfMany", tuned::kInteriorOfMany},
        {140, 170, 230, 300},
        "n = 150, 210, N = 50 n",
        solves(name, {{150, 7500}, {210, 10500}})},
       {{"kFewPointsPerDimension", tuned::kFewPointsPerDimension},
        {3, 5, 12, 20},
        "n = 90, N = 2 n, 5 n, 9 n",
        solves(name, {{90, 180}, {90, 450}, {90, 810}})},
       {{"kManyPointsPerDimension", tuned::kManyPointsPerDimension},
        {15, 30, 120, 240},
        "n = 140, N = 10 n, 20 n, 40 n",
        solves(name, {{140, 1400}, {140, 2800}, {140, 5600}})},
       {{"kReachOfViolators", tuned::kReachOfViolators}, {0, 0.1, 0.4, 0.8}, "n = 20, 50, N = 10^4", wide},
       {{"kShortlistDimension", tuned::kShortlistDimension},
        {4, 8, 32, 100},
        "n = 6, 12, 24, 48, N = 10^4",
        solves(name, {{6, 10000}, {12, 10000}, {24, 10000}, {48, 10000}})}}};
}

TunedMethod samples() {
  const std::string name = "column_generation";
  const Workload large = solves(name, {{3, 20000}, {5, 20000}, {10, 100000}});
  return {"linear programs: samples",
          {{{"kSampleDivisor", tuned::kSampleDivisor},
            {0.5, 1, 4, 8},
            "n = 3, 5, N = 20000; n = 10, N = 10^5",
            large},
           {{"kLeastSampleInFew", tuned::kLeastSampleInFew},
            {4, 8, 32, 64},
            "n = 3, 4, N = 2000, 20000",
            solves(name, {{3, 2000}, {4, 2000}, {3, 20000}, {4, 20000}})},
           {{"kLeastSampleInMore", tuned::kLeastSampleInMore},
            {2, 4, 16, 32},
            "n = 6, 10, 20, N = 2000",
            solves(name, {{6, 2000}, {10, 2000}, {20, 2000}})},
           {{"kManyDimensionsOfSample", tuned::kManyDimensionsOfSample},
            {12, 24, 96, 200},
            "n = 20, 40, 60, 100, N = 20 n",
            solves(name, {{20, 400}, {40, 800}, {60, 1200}, {100, 2000}})},
           {{"kSampleOverDimension", tuned::kSampleOverDimension},
            {2, 3, 6, 8},
            "n = 60, 100, N = 50 n",
            solves(name, {{60, 3000}, {100, 5000}})},
           {{"kWorthSampling", tuned::kWorthSampling},
            {1 << 13, 1 << 14, 1 << 16, 1 << 17},
            "n = 50, N = 500, 1000; n = 100, N = 1000",
            solves(name, {{50, 500}, {50, 1000}, {100, 1000}})},
           {{"kWorthRounding", tuned::kWorthRounding},
            {0, 2048, 32768, 1e9},
            "n = 10, 50, N = 10^4; n = 100, N = 5000",
            solves(name, {{10, 10000}, {50, 10000}, {100, 5000}})}}};
}

TunedMethod simplex() {
  const std::string name = "column_generation";
  return {"linear programs: the simplex",
          {{{"kChangesByTableau", tuned::kChangesByTableau},
            {4, 8, 48, 100},
            "n = 3, 5, 10, N = 1000",
            solves(name, {{3, 1000}, {5, 1000}, {10, 1000}})},
           {{"kChangesByShortlist", tuned::kChangesByShortlist},
            {1, 4, 16, 32},
            "n = 15, 30, 100, N = 3 n",
            solves(name, {{15, 45}, {30, 90}, {100, 300}})},
           {{"kColumnWorthEntering", tuned::kColumnWorthEntering},
            {0, 0.2, 0.6, 0.8},
            "n = 50, 100, 150, N = 5 n",
            solves(name, {{50, 250}, {100, 500}, {150, 750}})}}};
}

TunedMethod interior_point() {
  const std::string name = "column_generation";
  const Workload both = solves(name, {{100, 150}, {200, 400}, {200, 2000}});
  const std::string of_both = "n = 100, N = 1.5 n; n = 200, N = 2 n, 10 n";
  return {"linear programs: interior points",
          {{{"kManyPointsInside", tuned::kManyPointsInside}, {2, 3, 8, 30}, of_both, both},
           {{"kNegligibleColumns", tuned::kNegligibleColumns}, {1e-5, 1e-4, 1e-2, 0.1}, of_both, both},
           {{"kCoarseProducts", tuned::kCoarseProducts}, {1e-5, 1e-4, 1e-2, 0.1}, of_both, both},
           {{"kCorrectionsOfStep", tuned::kCorrectionsOfStep}, {0, 1, 2, 8}, of_both, both},
           {{"kWorthCorrecting", tuned::kWorthCorrecting}, {0.01, 0.02, 0.1, 0.2}, of_both, both}}};
}

TunedMethod threads() {
  const Workload two = solves("column_generation", {{4, 10000}, {10, 10000}, {10, 100000}}, "random", 2);
  const std::string on = "two threads, n = 4, 10, N = 10^4; n = 10, N = 10^5";
  return {"linear programs: threads",
          {{{"kSharedNumbers", tuned::kSharedNumbers},
            {1 << 11, 1 << 13, 1 << 17, 1 << 19},
            on,
            two,
            Clock::wall},
           {{"kNumbersWorthWaking", tuned::kNumbersWorthWaking},
            {1 << 13, 1 << 15, 1 << 19, 1 << 21},
            on,
            two,
            Clock::wall},
           {{"kNumbersOfChunk", tuned::kNumbersOfChunk},
            {1 << 10, 1 << 12, 1 << 16, 1 << 18},
            on,
            two,
            Clock::wall}}};
}

TunedMethod euclidean_and_smooth() {
  const Workload points = euclidean({{3, 1000}, {10, 1000}, {50, 1000}});
  const Workload smooth = solves_of(Shapes::ellipsoids, {3, 10, 50});
  const Workload powers = solves_of(Shapes::p_norm_balls, {3, 10, 50});
  const std::string of_points = "Euclidean, n = 3, 10, 50, N = 1000",
                    of_powers = "3-norm balls, n = 3, 10, 50";
  return {"nearest_point and newton",
          {{{"kPointWorthEntering", tuned::kPointWorthEntering}, {0.05, 0.15, 0.5, 0.8}, of_points, points},
           {{"kPointsOfOnePass", tuned::kPointsOfOnePass}, {1, 4, 64, 256}, of_points, points},
           {{"kLongestNewtonStep", tuned::kLongestNewtonStep},
            {0.25, 0.5, 2, 4},
            "ellipsoids, n = 3, 10, 50",
            smooth},
           {{"kLongestNewtonStep", tuned::kLongestNewtonStep}, {0.25, 0.5, 2, 4}, of_powers, powers},
           {{"kShorterNewtonStep", tuned::kShorterNewtonStep}, {0.1, 0.2, 0.6, 0.8}, of_powers, powers}}};
}

TunedMethod sets() {
  const Workload table = supports({3, 2000}), needle = supports({3, 2000}, true), tree = supports({5, 20000});
  return {"sets",
          {{{"kFewestNumbersOfTree", tuned::kFewestNumbersOfTree},
            {1 << 11, 1 << 13, 1 << 16, 1 << 18},
            "support, n = 5, N = 2000",
            supports({5, 2000})},
           {{"kBlocksOfLeaf", tuned::kBlocksOfLeaf}, {2, 4, 16, 32}, "support, n = 5, N = 20000", tree},
           {{"kTreePays", tuned::kTreePays},
            {0.01, 0.03, 0.3, 1},
            "support, n = 8, N = 5000",
            supports({8, 5000})},
           {{"kTreePaysBeyondCache", tuned::kTreePaysBeyondCache},
            {0.05, 0.2, 0.6, 1},
            "support, n = 10, N = 50000",
            supports({10, 50000})},
           {{"kNumbersBeyondCache", tuned::kNumbersBeyondCache},
            {1 << 13, 1 << 15, 1 << 18, 1 << 20},
            "support, n = 10, N = 20000",
            supports({10, 20000})},
           {{"kShortList", tuned::kShortList}, {1, 4, 8, 16}, "support, n = 3, N = 2000", table},
           {{"kLongestList", tuned::kLongestList}, {6, 12, 48, 96}, "the same of a needle", needle},
           {{"kMostCells", tuned::kMostCells}, {8, 16, 64, 128}, "support, n = 3, N = 2000", table},
           {{"kRoundEnough", tuned::kRoundEnough},
            {1, 2, 16, 1e5},
            "needle, n = 5, 10, N = 1000",
            solves("column_generation", {{5, 1000}, {10, 1000}}, "needle")}}};
}

TunedMethod trees() {
  return {"meshes",
          {{{"kOrientedTriangles", tuned::kOrientedTriangles},
            {32, 128, 2048, 1 << 20},
            "tori of 20000 triangles",
            tori(20000)},
           {{"kSearchedTriangles", tuned::kSearchedTriangles},
            {64, 256, 4096, 1 << 20},
            "tori of 20000 triangles",
            tori(20000)},
           {{"kSearchedTriangles", tuned::kSearchedTriangles},
            {64, 256, 4096, 1 << 20},
            "building a tree of 20000",
            torus_trees(20000)}}};
}

TunedMethod gauges_of_points() {
  const Workload walks = gauges_in({6, 1000}, 8192);
  const std::string on = "gauges of 8192 points, n = 6, N = 1000";
  return {"queries: gauges",
          {{{"kLeastForWalks", tuned::kLeastForWalks},
            {256, 512, 2048, 4096},
            "gauges of 1500 points, n = 6, N = 1000",
            gauges_in({6, 1000}, 1500)},
           {{"kLeastPointsOfWalks", tuned::kLeastPointsOfWalks},
            {15, 30, 120, 240},
            "gauges, n = 6, N = 500",
            gauges_in({6, 500}, 4096)},
           {{"kPointsOfFacet", tuned::kPointsOfFacet},
            {56, 112, 448, 896},
            "gauges of 65536 points, n = 4, N = 500",
            gauges_in({4, 500}, 65536)},
           {{"kFewPointsOfFacet", tuned::kFewPointsOfFacet},
            {12, 24, 96, 192},
            "gauges of 2048 points",
            gauges_in({6, 1000}, 2048)},
           {{"kFewFacets", tuned::kFewFacets}, {16, 32, 128, 256}, on, walks},
           {{"kListedPoints", tuned::kListedPoints}, {20, 35, 70, 100}, on, walks},
           {{"kChosenColumns", tuned::kChosenColumns}, {3, 5, 12, 16}, on, walks},
           {{"kPivotsOfWalk", tuned::kPivotsOfWalk}, {3, 6, 24, 48}, on, walks},
           {{"kFirstShare", tuned::kFirstShare}, {0.2, 0.35, 0.65, 0.9}, on, walks}}};
}

TunedMethod queries() {
  const Workload stream = streams({5, 100000});
  return {"queries",
          {{{"kManyDimensionsOfOrigin", tuned::kManyDimensionsOfOrigin},
            {8, 16, 64, 128},
            "n = 12, 24, 48, 96, N = 4 n",
            origins({{12, 48}, {24, 96}, {48, 192}, {96, 384}})},
           {{"kReachOfStream", tuned::kReachOfStream},
            {0.01, 0.02, 0.1, 0.2},
            "streams, n = 5, N = 10^5",
            stream},
           {{"kShareOfStream", tuned::kShareOfStream},
            {0.03, 0.1, 0.5, 0.9},
            "streams, n = 5, N = 10^5",
            stream}}};
}

}  // namespace

std::vector<TunedMethod> tuned_methods() {
  std::vector<TunedMethod> all;
  for (TunedMethod (*const of)() :
       {zheng_yamane, column_generation_starts, column_generation, samples, simplex, interior_point, threads,
        euclidean_and_smooth, sets, trees, gauges_of_points, queries}) {
    all.push_back(of());
  }
  for (TunedMethod& method : tuned_methods_of_bodies()) all.push_back(std::move(method));
  return all;
}

}  // namespace raygauge::bench
