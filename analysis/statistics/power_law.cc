// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/power_law.h"

#include <cmath>
#include <string>

#include "analysis/constants.h"
#include "analysis/statistics/student_t.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

std::vector<double> logarithms(const std::vector<double>& values, const char* name) {
  std::vector<double> logs;
  logs.reserve(values.size());
  for (const double v : values) {
    if (!(v > 0 && std::isfinite(v))) {
      throw InvalidParameterError("power law: " + std::string(name) + " is " + std::to_string(v) +
                                  ", must be positive and finite");
    }
    logs.push_back(std::log(v));
  }
  return logs;
}

/// Half the width of the interval, in standard errors.
double t_quantile(std::size_t points, double confidence) {
  return points <= 2 ? kInfinity : student_t_quantile(points - 2, (1 + confidence) / 2);
}

void check(const std::vector<double>& x, const std::vector<double>& y, double confidence) {
  if (x.size() != y.size()) {
    throw DimensionMismatchError("power law: " + std::to_string(x.size()) + " values of x, " +
                                 std::to_string(y.size()) + " of y");
  }
  if (!(confidence > 0 && confidence < 1))
    throw InvalidParameterError("confidence of a power law must lie in (0, 1)");
  if (x.size() < 2) throw InvalidParameterError("power law: at least two points are needed");
}

/// Means of two samples, and sums of products of deviations from them.
struct Moments {
  Moments(const std::vector<double>& u, const std::vector<double>& v) : u_mean(mean(u)), v_mean(mean(v)) {
    for (std::size_t i = 0; i < u.size(); ++i) {
      uu += (u[i] - u_mean) * (u[i] - u_mean);
      uv += (u[i] - u_mean) * (v[i] - v_mean);
      vv += (v[i] - v_mean) * (v[i] - v_mean);
    }
  }
  double u_mean, v_mean;
  double uu = 0, uv = 0, vv = 0;
};

/// The sum of squares that the line v = intercept + slope u leaves.
double residual_sum(const std::vector<double>& u, const std::vector<double>& v, double intercept,
                    double slope) {
  double sum = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double error = v[i] - intercept - slope * u[i];
    sum += error * error;
  }
  return sum;
}

/// Student's intervals of the exponent and of the factor.
void add_intervals(PowerLaw& fit, const Moments& moments, double intercept, double confidence) {
  const double t = t_quantile(fit.points, confidence);
  if (std::isinf(t)) {
    fit.exponent_interval = {-t, t, confidence};
    fit.factor_interval = {0, t, confidence};
    return;
  }
  const double of_mean = 1 / static_cast<double>(fit.points);
  const double slope_half = t * fit.residual / std::sqrt(moments.uu);
  const double intercept_half =
      t * fit.residual * std::sqrt(of_mean + moments.u_mean * moments.u_mean / moments.uu);
  fit.exponent_interval = {fit.exponent - slope_half, fit.exponent + slope_half, confidence};
  fit.factor_interval = {std::exp(intercept - intercept_half), std::exp(intercept + intercept_half),
                         confidence};
}

}  // namespace

PowerLaw fit_power_law(const std::vector<double>& x, const std::vector<double>& y, double confidence) {
  check(x, y, confidence);
  const std::vector<double> u = logarithms(x, "x");
  const std::vector<double> v = logarithms(y, "y");
  const Moments moments(u, v);
  if (moments.uu == 0) throw InvalidParameterError("power law: all x are equal");

  PowerLaw fit;
  fit.points = u.size();
  fit.exponent = moments.uv / moments.uu;
  const double intercept = moments.v_mean - fit.exponent * moments.u_mean;
  fit.factor = std::exp(intercept);
  const double rss = residual_sum(u, v, intercept, fit.exponent);
  fit.residual = fit.points > 2 ? std::sqrt(rss / static_cast<double>(fit.points - 2)) : 0;
  fit.r_squared = moments.vv > 0 ? 1 - rss / moments.vv : 1;
  add_intervals(fit, moments, intercept, confidence);
  return fit;
}

}  // namespace raygauge
