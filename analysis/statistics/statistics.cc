// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>

#include "analysis/constants.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

void require_values(const std::vector<double>& values, const char* what) {
  if (values.empty()) throw EmptySetError(std::string(what) + " of no values");
  if (std::any_of(values.begin(), values.end(), [](double x) { return std::isnan(x); }))
    throw NonFiniteError(std::string(what) + " of values with a NaN among them");
}

void require_confidence(double confidence) {
  if (!(confidence > 0 && confidence < 1))
    throw InvalidParameterError("confidence is " + std::to_string(confidence) + ", must lie in (0, 1)");
}

/// (1 - t) a + t b, where a or b may be infinite.
double between(double a, double b, double t) {
  if (a == b || t == 0) return a;
  if (t == 1) return b;
  return a + t * (b - a);
}

/// Order statistics of values without a NaN, asked for in any order: x(0) <= x(1) <= … What lies between
/// those that were asked for stays unsorted.
class OrderStatistics {
 public:
  explicit OrderStatistics(std::vector<double> values) : values_(std::move(values)) {}

  double operator()(std::size_t rank) {
    const auto after = std::lower_bound(known_.begin(), known_.end(), rank);
    if (after != known_.end() && *after == rank) return values_[rank];
    const auto at = [this](std::size_t i) { return values_.begin() + static_cast<std::ptrdiff_t>(i); };
    const auto first = after == known_.begin() ? values_.begin() : at(*std::prev(after) + 1);
    const auto last = after == known_.end() ? values_.end() : at(*after);
    std::nth_element(first, at(rank), last);
    known_.insert(after, rank);
    return values_[rank];
  }

 private:
  std::vector<double> values_;
  std::vector<std::size_t> known_;  ///< ranks whose values are in their places
};

/// P(B = k), B ~ Binomial(n, 1/2).
double binomial_half(std::size_t n, std::size_t k) {
  const auto x = static_cast<double>(n);
  const auto y = static_cast<double>(k);
  return std::exp(std::lgamma(x + 1) - std::lgamma(y + 1) - std::lgamma(x - y + 1) - x * std::log(2.0));
}

std::vector<double> logarithms(const std::vector<double>& values) {
  std::vector<double> logs;
  logs.reserve(values.size());
  for (const double x : values) {
    if (x <= 0)
      throw InvalidParameterError("a ratio of medians needs positive values, not " + std::to_string(x));
    logs.push_back(std::log(x));
  }
  return logs;
}

/// √(a² + b²), where either may be infinite, or inf - inf: then nothing is known.
double root_of_squares(double a, double b) {
  return std::isnan(a) || std::isnan(b) ? kInfinity : std::hypot(a, b);
}

}  // namespace

double quantile(std::vector<double> values, double p) {
  require_values(values, "quantile");
  if (!(p >= 0 && p <= 1))
    throw InvalidParameterError("order of a quantile is " + std::to_string(p) + ", must lie in [0, 1]");
  const double h = static_cast<double>(values.size() - 1) * p;
  const auto below = static_cast<std::size_t>(h);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  OrderStatistics x(std::move(values));
  return between(x(below), x(above), h - static_cast<double>(below));
}

double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

double mean(const std::vector<double>& values) {
  require_values(values, "mean");
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double geometric_mean(const std::vector<double>& values) {
  require_values(values, "geometric mean");
  double sum = 0;
  bool zero = false;
  for (const double x : values) {
    if (x < 0) throw InvalidParameterError("geometric mean of a negative value, " + std::to_string(x));
    zero = zero || x == 0;
    if (x > 0) sum += std::log(x);
  }
  return zero ? 0 : std::exp(sum / static_cast<double>(values.size()));
}

double shifted_geometric_mean(std::vector<double> values, double shift) {
  if (!(shift > 0)) throw InvalidParameterError("the shift of a geometric mean must be positive");
  if (std::any_of(values.begin(), values.end(), [](double x) { return x < 0; }))
    throw InvalidParameterError("a geometric mean of a negative value");
  for (double& x : values) x += shift;
  return geometric_mean(values) - shift;
}

Interval median_interval(std::vector<double> values, double confidence) {
  require_values(values, "interval of the median");
  require_confidence(confidence);
  const std::size_t n = values.size();
  OrderStatistics sorted(std::move(values));
  const auto x = [&](std::size_t rank) { return sorted(rank - 1); };

  // gamma = γ_d, narrower = γ_d+1; γ_d falls with d, down to d = ⌊(n + 1) / 2⌋.
  std::size_t d = 1;
  double gamma = 1 - 2 * binomial_half(n, 0);
  if (gamma < confidence || n < 2) return {x(1), x(n), std::max(gamma, 0.0)};
  double narrower = gamma - 2 * binomial_half(n, d);
  while (narrower >= confidence && 2 * (d + 1) <= n) {
    ++d;
    gamma = narrower;
    narrower = gamma - 2 * binomial_half(n, d);
  }
  if (2 * d >= n) return {x(d), x(n - d + 1), gamma};
  const auto size = static_cast<double>(n);
  const auto depth = static_cast<double>(d);
  const double I = (gamma - confidence) / (gamma - narrower);
  const double lambda = (size - depth) * I / (depth + (size - 2 * depth) * I);
  return {between(x(d), x(d + 1), lambda), between(x(n - d + 1), x(n - d), lambda), confidence};
}

Ratio ratio_of_medians(const std::vector<double>& numerator, const std::vector<double>& denominator,
                       double confidence) {
  const std::vector<double> logs_a = logarithms(numerator);
  const std::vector<double> logs_b = logarithms(denominator);
  const Interval of_a = median_interval(logs_a, confidence);
  const Interval of_b = median_interval(logs_b, confidence);
  const double a = median(logs_a);
  const double b = median(logs_b);
  const double down = root_of_squares(a - of_a.lower, of_b.upper - b);
  const double up = root_of_squares(of_a.upper - a, b - of_b.lower);
  const double ratio = median(numerator) / median(denominator);
  return {
      ratio,
      {std::isfinite(a - b) ? std::exp(a - b - down) : 0,
       std::isfinite(a - b) ? std::exp(a - b + up) : kInfinity, std::min(of_a.confidence, of_b.confidence)}};
}

}  // namespace raygauge
