// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/randomisation_test.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <utility>

#include "analysis/statistics/statistics.h"

namespace raygauge {
namespace {

/// Weight of each observation of each block under one choice of labels.
using Weights = std::vector<std::vector<double>>;

/// Values over their scales, and what belongs together.
struct Standardised {
  std::vector<std::vector<double>> values;  ///< cut off; 0 where missing
  std::vector<double> scales;
  std::vector<std::size_t> blocks;
  std::vector<std::vector<std::size_t>> groups;  ///< the series of each
  std::size_t block_count = 0;
};

double median_magnitude(const std::vector<double>& values) {
  std::vector<double> magnitudes;
  for (const double x : values)
    if (!std::isnan(x)) magnitudes.push_back(std::abs(x));
  return magnitudes.empty() ? 0 : median(magnitudes);
}

/// Median of ||x_j| - |x_k||: free of the change where all values have it.
double own_scale(const std::vector<double>& values) {
  std::vector<double> differences;
  for (std::size_t j = 0; j < values.size(); ++j) {
    for (std::size_t k = 0; k < j; ++k) {
      const double difference = std::abs(std::abs(values[j]) - std::abs(values[k]));
      if (!std::isnan(difference)) differences.push_back(difference);
    }
  }
  return differences.empty() ? median_magnitude(values) : median(differences);
}

constexpr double kSmallestScale = 1e-12;

/// Half the scale of the median series, a quarter of the series' own, a quarter of its group's mean: own
/// scales of few values are too uncertain. None of them depends on the labels.
std::vector<double> scales_of(const std::vector<RunSeries>& series) {
  std::vector<double> own;
  std::map<std::string, std::pair<double, double>> groups;  // sum and count
  for (const RunSeries& each : series) {
    own.push_back(own_scale(each.values));
    groups[each.group].first += own.back();
    groups[each.group].second += 1;
  }
  const double pooled = std::max(median(own), kSmallestScale);
  for (std::size_t s = 0; s < series.size(); ++s) {
    const auto& [sum, count] = groups[series[s].group];
    own[s] = pooled / 2 + (own[s] + sum / count) / 4;
  }
  return own;
}

/// Values are cut off at twice this: half the median magnitude of the series, half that of the median series.
std::vector<double> cuts_of(const std::vector<RunSeries>& series) {
  std::vector<double> own;
  for (const RunSeries& each : series) own.push_back(median_magnitude(each.values));
  const double pooled = std::max(median(own), kSmallestScale);
  for (double& cut : own) cut = pooled + std::min(cut, 2 * pooled);
  return own;
}

Standardised standardised(const std::vector<RunSeries>& series, const std::vector<std::string>& groups) {
  Standardised result;
  result.scales = scales_of(series);
  const std::vector<double> cuts = cuts_of(series);
  std::map<std::string, std::size_t> blocks;
  for (std::size_t s = 0; s < series.size(); ++s) {
    result.blocks.push_back(blocks.emplace(series[s].block, blocks.size()).first->second);
    std::vector<double> values = series[s].values;
    for (double& x : values) x = std::isnan(x) ? 0 : std::clamp(x, -cuts[s], cuts[s]);
    result.values.push_back(std::move(values));
  }
  for (const std::string& group : groups) {
    std::vector<std::size_t> members;
    for (std::size_t s = 0; s < series.size(); ++s)
      if (series[s].group == group) members.push_back(s);
    result.groups.push_back(std::move(members));
  }
  result.block_count = blocks.size();
  return result;
}

/// The statistics of all series, then of all groups.
std::vector<double> statistics_of(const Standardised& data, const Weights& weights) {
  std::vector<double> means;
  std::vector<double> result;
  for (std::size_t s = 0; s < data.values.size(); ++s) {
    const std::vector<double>& w = weights[data.blocks[s]];
    means.push_back(std::inner_product(w.begin(), w.end(), data.values[s].begin(), 0.0));
    result.push_back(means.back() / data.scales[s]);
  }
  for (const std::vector<std::size_t>& members : data.groups) {
    double sum = 0;
    double variance = 0;
    for (const std::size_t s : members) {
      sum += means[s];
      variance += data.scales[s] * data.scales[s];
    }
    result.push_back(members.empty() ? 0 : sum / std::sqrt(variance));
  }
  return result;
}

/// Counts in how many of the choices of labels that `next` makes the largest statistic reaches each observed
/// one. `next` returns false when all choices have been made.
RandomisationResult compared(const Standardised& data, const Weights& as_labelled, bool exhaustive,
                             const std::function<bool(Weights&)>& next) {
  constexpr double kRounding = 1e-9;
  const std::vector<double> observed = statistics_of(data, as_labelled);
  std::vector<std::size_t> reached(observed.size(), exhaustive ? 0 : 1);
  std::size_t choices = exhaustive ? 0 : 1;  // a sample counts the labels as they are too
  Weights weights = as_labelled;
  while (next(weights)) {
    ++choices;
    const std::vector<double> drawn = statistics_of(data, weights);
    const double largest = *std::max_element(drawn.begin(), drawn.end());
    for (std::size_t i = 0; i < observed.size(); ++i)
      reached[i] += largest >= std::abs(observed[i]) * (1 - kRounding) ? 1 : 0;
  }
  std::vector<double> p;
  for (const std::size_t count : reached)
    p.push_back(static_cast<double>(count) / static_cast<double>(choices));
  const auto middle = p.begin() + static_cast<std::ptrdiff_t>(data.values.size());
  return {{p.begin(), middle}, {middle, p.end()}};
}

}  // namespace

RandomisationResult test_pairs(const std::vector<RunSeries>& series, const std::vector<std::string>& groups,
                               const RandomisationOptions& options) {
  const Standardised data = standardised(series, groups);
  const std::size_t pairs = series.front().values.size();
  const double weight = 1 / static_cast<double>(pairs);
  const Weights as_labelled(data.block_count, std::vector<double>(pairs, weight));
  const std::size_t bits = data.block_count * pairs;
  const bool exhaustive = bits < 63 && (std::uint64_t{1} << bits) <= options.draws;
  std::mt19937_64 random(options.seed);
  std::uint64_t choice = 0;
  return compared(data, as_labelled, exhaustive, [&](Weights& weights) {
    if (choice == (exhaustive ? std::uint64_t{1} << bits : options.draws)) return false;
    std::size_t bit = 0;
    std::uint64_t word = choice++;
    for (std::vector<double>& block : weights) {
      for (double& w : block) {
        if (!exhaustive && bit % 64 == 0) word = random();
        w = (word >> (bit++ % 64) & 1U) != 0 ? -weight : weight;
      }
    }
    return true;
  });
}

namespace {

/// Series about their medians over all runs, which the labels have no part in.
std::vector<RunSeries> centred(std::vector<RunSeries> series) {
  for (RunSeries& each : series) {
    std::vector<double> finite;
    for (const double x : each.values)
      if (!std::isnan(x)) finite.push_back(x);
    const double middle = finite.empty() ? 0 : median(finite);
    for (double& x : each.values) x = x == middle ? 0 : x - middle;
  }
  return series;
}

/// Number of ways to choose k of n, or `limit` if there are more.
std::size_t choices_of(std::size_t n, std::size_t k, std::size_t limit) {
  double count = 1;
  for (std::size_t i = 0; i < k; ++i) count *= static_cast<double>(n - i) / static_cast<double>(i + 1);
  return count > static_cast<double>(limit) ? limit : static_cast<std::size_t>(std::llround(count));
}

}  // namespace

RandomisationResult test_runs(const std::vector<RunSeries>& series, std::size_t base_runs,
                              const std::vector<std::string>& groups, const RandomisationOptions& options) {
  Standardised data = standardised(centred(series), groups);
  std::fill(data.blocks.begin(), data.blocks.end(), 0U);
  const std::size_t runs = series.front().values.size();
  std::vector<char> is_new(runs, 1);
  std::fill_n(is_new.begin(), base_runs, char{0});
  const auto weights_of = [&](const std::vector<char>& labels) {
    std::vector<double> weights;
    for (const char label : labels)
      weights.push_back(label != 0 ? 1 / static_cast<double>(runs - base_runs)
                                   : -1 / static_cast<double>(base_runs));
    return weights;
  };
  const Weights as_labelled = {weights_of(is_new)};
  const bool exhaustive = choices_of(runs, base_runs, options.draws + 1) <= options.draws;
  std::mt19937_64 random(options.seed);
  std::size_t choice = 0;
  return compared(data, as_labelled, exhaustive, [&](Weights& weights) {
    if (exhaustive) {
      if (choice++ > 0 && !std::next_permutation(is_new.begin(), is_new.end())) return false;
    } else {
      if (choice++ == options.draws) return false;
      for (std::size_t i = runs - 1; i > 0; --i) std::swap(is_new[i], is_new[random() % (i + 1)]);
    }
    weights = {weights_of(is_new)};
    return true;
  });
}

}  // namespace raygauge
