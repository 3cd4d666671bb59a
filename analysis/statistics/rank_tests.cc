// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/rank_tests.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

/// Indices that sort the values upwards.
std::vector<std::size_t> sorting_order(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  return order;
}

struct Ranks {
  std::vector<std::size_t> doubled;  ///< twice the rank: mean ranks of ties are halves
  double tie_term = 0;               ///< Σ (t³ - t) over groups of t equal values
};

Ranks ranks_of(const std::vector<double>& values) {
  const std::vector<std::size_t> order = sorting_order(values);
  Ranks ranks;
  ranks.doubled.resize(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first + 1;
    while (last < order.size() && values[order[last]] == values[order[first]]) ++last;
    for (std::size_t i = first; i < last; ++i) ranks.doubled[order[i]] = first + last + 1;
    const auto t = static_cast<double>(last - first);
    ranks.tie_term += t * t * t - t;
    first = last;
  }
  return ranks;
}

void require_no_nan(const std::vector<double>& values) {
  if (std::any_of(values.begin(), values.end(), [](double x) { return std::isnan(x); }))
    throw NonFiniteError("rank test of values with a NaN among them");
}

double two_sided_normal(double distance, double variance) {
  if (!(variance > 0)) return 1;
  return std::min(1.0, std::erfc(std::max(0.0, distance) / std::sqrt(2 * variance)));
}

/// P(sum of a random half of the ranks <= the smaller of the two sums), doubled.
double exact_signed_rank_p(const std::vector<std::size_t>& doubled_ranks, std::size_t smaller_sum) {
  const std::size_t total = std::accumulate(doubled_ranks.begin(), doubled_ranks.end(), std::size_t{0});
  std::vector<double> probability(total + 1, 0.0);
  probability[0] = 1;
  std::size_t reached = 0;
  for (const std::size_t rank : doubled_ranks) {
    reached += rank;
    for (std::size_t sum = reached + 1; sum-- > 0;)
      probability[sum] = (probability[sum] + (sum >= rank ? probability[sum - rank] : 0)) / 2;
  }
  double tail = 0;
  for (std::size_t sum = 0; sum <= smaller_sum; ++sum) tail += probability[sum];
  return std::min(1.0, 2 * tail);
}

}  // namespace

double signed_rank_p(const std::vector<double>& differences) {
  require_no_nan(differences);
  std::vector<double> sizes;
  std::vector<bool> positive;
  for (const double d : differences) {
    if (d == 0) continue;
    sizes.push_back(std::abs(d));
    positive.push_back(d > 0);
  }
  if (sizes.empty()) return 1;
  const Ranks ranks = ranks_of(sizes);
  std::size_t above = 0;
  std::size_t total = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    total += ranks.doubled[i];
    if (positive[i]) above += ranks.doubled[i];
  }
  const std::size_t smaller = std::min(above, total - above);
  constexpr std::size_t kExact = 50;
  if (sizes.size() <= kExact) return exact_signed_rank_p(ranks.doubled, smaller);
  const auto n = static_cast<double>(sizes.size());
  const double variance = n * (n + 1) * (2 * n + 1) / 24 - ranks.tie_term / 48;
  return two_sided_normal(n * (n + 1) / 4 - static_cast<double>(smaller) / 2 - 0.5, variance);
}

double rank_sum_p(const std::vector<double>& first, const std::vector<double>& second) {
  if (first.empty() || second.empty()) throw EmptySetError("rank-sum test of an empty sample");
  require_no_nan(first);
  require_no_nan(second);
  std::vector<double> all = first;
  all.insert(all.end(), second.begin(), second.end());
  const Ranks ranks = ranks_of(all);
  double rank_sum = 0;
  for (std::size_t i = 0; i < first.size(); ++i) rank_sum += static_cast<double>(ranks.doubled[i]) / 2;
  const auto a = static_cast<double>(first.size());
  const auto b = static_cast<double>(second.size());
  const double count = a + b;
  const double variance = a * b / 12 * (count + 1 - ranks.tie_term / (count * (count - 1)));
  return two_sided_normal(std::abs(rank_sum - a * (count + 1) / 2) - 0.5, variance);
}

std::vector<double> holm_adjusted(const std::vector<double>& p_values) {
  std::vector<double> adjusted(p_values.size());
  double largest = 0;
  std::size_t left = p_values.size();
  for (const std::size_t i : sorting_order(p_values)) {
    largest = std::max(largest, std::min(1.0, static_cast<double>(left) * p_values[i]));
    adjusted[i] = largest;
    --left;
  }
  return adjusted;
}

}  // namespace raygauge
