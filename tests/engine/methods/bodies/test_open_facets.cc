// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/open_facets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace raygauge::test_open_facets {
namespace {

TEST(OpenFacets, KnowTheLeastOfThoseThatAreOpen) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> value(-1, 1);
  OpenFacets facets;
  EXPECT_EQ(facets.least().facet, OpenFacets::kNone);
  std::map<std::int32_t, double> open;
  for (std::int32_t count = 1; count < 60; ++count) {
    facets.resize(count);
    for (int turn = 0; turn < 8; ++turn) {
      const auto i = static_cast<std::int32_t>(random() % static_cast<std::uint64_t>(count));
      if (turn % 2 == 0) {
        open[i] = value(random);
        facets.open(i, open[i]);
      } else {
        open.erase(i);
        facets.close(i);
      }
      const auto least = std::min_element(open.begin(), open.end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; });
      EXPECT_EQ(facets.least().facet, least == open.end() ? OpenFacets::kNone : least->first);
      EXPECT_EQ(facets.least().value, least == open.end() ? OpenFacets::kClosed : least->second);
    }
  }
  facets.clear();
  EXPECT_EQ(facets.least().facet, OpenFacets::kNone);
}

}  // namespace
}  // namespace raygauge::test_open_facets
