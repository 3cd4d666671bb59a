// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace raygauge {

/// Log times of one thing (a method in a cell) that was measured several times on two sides.
struct RunSeries {
  std::string block;           ///< the sides of all series of a block change places together
  std::string group;           ///< whose mean is tested as well: a method
  std::vector<double> values;  ///< paired: one difference new - base a pair, NaN without one; else base's
                               ///< runs, then new's
};

/// p values of "the labels base and new mean nothing" against "new is larger", or smaller where it is
/// smaller.
struct RandomisationResult {
  std::vector<double> series;  ///< adjusted p value of each series
  std::vector<double> groups;  ///< of each group, in the order asked for
};

struct RandomisationOptions {
  std::size_t draws = 4999;  ///< of random labels, where there are more ways than that; else all are taken
  std::uint64_t seed = 1;    ///< the same p values on every machine
};

/// Randomisation test of pairs whose order was drawn at random, for each block and pair by itself: with
/// labels that mean nothing, every difference has either sign with probability 1/2. The statistic of a series
/// is the mean of its differences, cut off at twice their median size (so that one disturbed pair does not
/// decide), over the scale; that of a group the same of the mean of its series. The p values compare with the
/// largest statistic over all series and groups (Westfall and Young 1993): the probability of any false alarm
/// is at most the level, whatever disturbs the machine and however the series depend on each other.
RandomisationResult test_pairs(const std::vector<RunSeries>& series, const std::vector<std::string>& groups,
                               const RandomisationOptions& options = {});

/// The same for independent runs, the first `base_runs` of each series being of base: the labels of whole
/// runs change places. It takes for granted that runs without a change are exchangeable.
RandomisationResult test_runs(const std::vector<RunSeries>& series, std::size_t base_runs,
                              const std::vector<std::string>& groups,
                              const RandomisationOptions& options = {});

}  // namespace raygauge
