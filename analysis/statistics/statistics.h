// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace raygauge {

/// Quantile of order p in [0, 1], Hyndman–Fan type 7: with x sorted and h = (n - 1) p,
/// x_⌊h⌋ + (h - ⌊h⌋)(x_⌊h⌋+1 - x_⌊h⌋). Infinities are values like others: a quantile that lies beside one,
/// and not on a finite value, is infinite. Throws EmptySetError without values, NonFiniteError for a NaN,
/// InvalidParameterError for p outside [0, 1].
double quantile(std::vector<double> values, double p);

/// quantile(values, 0.5).
double median(std::vector<double> values);

/// Arithmetic mean. Throws EmptySetError without values, NonFiniteError for a NaN.
double mean(const std::vector<double>& values);

/// exp(mean(log x)). Throws EmptySetError without values, NonFiniteError for a NaN, InvalidParameterError for
/// a negative value. A zero makes it zero.
double geometric_mean(const std::vector<double>& values);

/// exp(mean(log(x + shift))) - shift, shift > 0: small values count less than in the geometric mean. Throws
/// as geometric_mean().
double shifted_geometric_mean(std::vector<double> values, double shift);

/// An interval that is meant to cover a true value in a fraction `confidence` of experiments.
struct Interval {
  double lower = 0;
  double upper = 0;
  double confidence =
      0;  ///< the level that is attained, which small samples may keep below the one asked for
};

/// Interval for the median of the population that `values` are a sample of: the binomial order-statistic
/// interval, interpolated after Hettmansperger and Sheather (1986, "Confidence intervals based on
/// interpolated order statistics"). With x_(1) <= … <= x_(n) and B ~ Binomial(n, 1/2), [x_(d), x_(n-d+1)]
/// covers the median of any continuous distribution with probability γ_d = 1 - 2 P(B < d). Between the d with
/// γ_d >= confidence > γ_d+1, both ends move inwards by λ = (n - d) I / (d + (n - 2d) I),
/// I = (γ_d - confidence) / (γ_d - γ_d+1).
/// No assumption of normality, no random numbers. With fewer than 6 values 95 % cannot be attained: the range
/// of the values is returned, with its γ_1 = 1 - 2^(1-n). Throws as quantile(), and InvalidParameterError for
/// a confidence outside (0, 1).
Interval median_interval(std::vector<double> values, double confidence = 0.95);

/// A ratio with its interval.
struct Ratio {
  double ratio = 0;
  Interval interval;
};

/// median(numerator) / median(denominator) of two independent samples of positive values. The interval
/// combines the two median_interval()s of the logarithms by the method of variance estimates recovery (Zou
/// and Donner 2008): with log medians a, b and their intervals [l_a, u_a], [l_b, u_b],
/// log lower = a - b - √((a - l_a)² + (u_b - b)²), log upper = a - b + √((u_a - a)² + (b - l_b)²).
/// Conservative: simulated coverage of lognormal samples is 97.7 % with 6 values each, 97.2 % with 10 to 15,
/// 97.0 % with 20, 96.4 % with 40 and 96.1 % with 100. Where the samples are positively correlated (the same
/// instances) it is wider than need be, and paired_ratio() the one to take. Infinite
/// values (unsolved) give infinite ends. Throws as median_interval(), and InvalidParameterError for a value
/// that is not positive.
Ratio ratio_of_medians(const std::vector<double>& numerator, const std::vector<double>& denominator,
                       double confidence = 0.95);

}  // namespace raygauge
