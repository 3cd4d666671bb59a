// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/power_law.h"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <string>

#include "analysis/constants.h"
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
  if (points <= 2) return kInfinity;
  const boost::math::students_t distribution(static_cast<double>(points - 2));
  return boost::math::quantile(distribution, (1 + confidence) / 2);
}

}  // namespace

PowerLaw fit_power_law(const std::vector<double>& x, const std::vector<double>& y, double confidence) {
  if (x.size() != y.size()) {
    throw DimensionMismatchError("power law: " + std::to_string(x.size()) + " values of x, " +
                                 std::to_string(y.size()) + " of y");
  }
  if (!(confidence > 0 && confidence < 1))
    throw InvalidParameterError("confidence of a power law must lie in (0, 1)");
  const std::vector<double> u = logarithms(x, "x");
  const std::vector<double> v = logarithms(y, "y");
  const std::size_t count = u.size();
  if (count < 2) throw InvalidParameterError("power law: at least two points are needed");
  const double u_mean = mean(u);
  const double v_mean = mean(v);
  double s_uu = 0;
  double s_uv = 0;
  double s_vv = 0;
  for (std::size_t i = 0; i < count; ++i) {
    s_uu += (u[i] - u_mean) * (u[i] - u_mean);
    s_uv += (u[i] - u_mean) * (v[i] - v_mean);
    s_vv += (v[i] - v_mean) * (v[i] - v_mean);
  }
  if (s_uu == 0) throw InvalidParameterError("power law: all x are equal");

  PowerLaw fit;
  fit.points = count;
  fit.exponent = s_uv / s_uu;
  const double intercept = v_mean - fit.exponent * u_mean;
  fit.factor = std::exp(intercept);
  double rss = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double error = v[i] - intercept - fit.exponent * u[i];
    rss += error * error;
  }
  fit.residual = count > 2 ? std::sqrt(rss / static_cast<double>(count - 2)) : 0;
  fit.r_squared = s_vv > 0 ? 1 - rss / s_vv : 1;

  const double t = t_quantile(count, confidence);
  if (std::isinf(t)) {
    fit.exponent_interval = {-t, t, confidence};
    fit.factor_interval = {0, t, confidence};
    return fit;
  }
  const double slope_half = t * fit.residual / std::sqrt(s_uu);
  const double intercept_half =
      t * fit.residual * std::sqrt(1 / static_cast<double>(count) + u_mean * u_mean / s_uu);
  fit.exponent_interval = {fit.exponent - slope_half, fit.exponent + slope_half, confidence};
  fit.factor_interval = {std::exp(intercept - intercept_half), std::exp(intercept + intercept_half),
                         confidence};
  return fit;
}

}  // namespace raygauge
