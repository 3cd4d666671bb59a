// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/certificate_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raygauge::soak {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kHuge = 0x1p500;

// An enclosure of a support value.
struct Enclosure {
  double below = -kInfinity;
  double above = kInfinity;
};

// max_i sign u·p_i: in plain doubles with a running error bound, then the points that may attain the maximum
// again in twice the precision (Dot2 of Ogita, Rump & Oishi 2005, whose error is below
// 2⁻⁵³|u·p| + (n+2)² 2⁻¹⁰⁵ Σ|u_k p_k|).
class Support {
 public:
  Support(const Eigen::MatrixXd& points, const Vector& u, double sign)
      : points_(points), u_(u), sign_(sign) {}

  Enclosure value() const {
    double best = -kInfinity, error = 0;
    for (Eigen::Index i = 0; i < points_.cols(); ++i) {
      double sum = 0, size = 0;
      for (Eigen::Index k = 0; k < u_.size(); ++k) {
        const double term = sign_ * u_[k] * points_(k, i);
        sum += term;
        size += std::fabs(term);
      }
      best = std::max(best, sum);
      error = std::max(error, static_cast<double>(u_.size() + 2) * 0x1p-52 * size);
    }
    return among(best - 2 * error, error);
  }

 private:
  Enclosure among(double threshold, double error) const {
    const auto n = static_cast<double>(u_.size());
    Enclosure result{-kInfinity, -kInfinity};
    for (Eigen::Index i = 0; i < points_.cols(); ++i) {
      if (sign_ * u_.dot(points_.col(i)) < threshold - error) continue;
      const double value = sign_ * dot2(i);
      // error >= (n+2) 2⁻⁵² Σ|u_k p_k|, which leaves (n+2) 2⁻⁵³ error of Dot2's second term.
      const double lost = 0x1p-51 * std::fabs(value) + (n + 2) * 0x1p-52 * error + 0x1p-1000;
      result.below = std::max(result.below, value - lost);
      result.above = std::max(result.above, value + lost);
    }
    return result;
  }

  double dot2(Eigen::Index i) const {
    double high = 0, low = 0;
    for (Eigen::Index k = 0; k < u_.size(); ++k) {
      const double p = u_[k] * points_(k, i);
      const double product_error = std::fma(u_[k], points_(k, i), -p);
      const double s = high + p;
      const double t = s - high;
      low += product_error + ((high - (s - t)) + (p - t));
      high = s;
    }
    return high + low;
  }

  const Eigen::MatrixXd& points_;
  const Vector& u_;
  double sign_;
};

bool is_claimed(DistanceStatus status) {
  return status == DistanceStatus::optimal || status == DistanceStatus::contains_origin ||
         status == DistanceStatus::unreachable;
}

bool in_range(const Eigen::MatrixXd& x) { return x.cwiseAbs().maxCoeff() < kHuge; }

}  // namespace

std::string falsehood(const DistanceResult& result, const Truth& truth, double tolerance) {
  if (!(result.lower >= 0 && result.lower <= result.upper)) return "not 0 <= lower <= upper";
  if (!(result.lower <= truth.rounded.lower)) return "lower > d";
  if (!(result.upper >= truth.rounded.upper)) return "upper < d";
  if (!(result.lower <= result.distance && result.distance <= result.upper)) {
    return is_claimed(result.status) || !std::isnan(result.distance) ? "distance outside the bounds" : "";
  }
  if (result.status == DistanceStatus::contains_origin &&
      (truth.status != DistanceStatus::contains_origin || result.distance != 0)) {
    return "contains_origin, but it does not";
  }
  if (result.status == DistanceStatus::unreachable &&
      (truth.status != DistanceStatus::unreachable || result.distance != kInfinity)) {
    return "unreachable, but it is not";
  }
  if (result.status == DistanceStatus::optimal &&
      !(std::isfinite(result.upper) && result.upper - result.lower <= tolerance * result.upper)) {
    return "optimal, but wider than the tolerance";
  }
  return "";
}

DualValue dual_value(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q, const Vector& u) {
  if (u.size() != A.rows() || !in_range(u) || !in_range(A) || !in_range(Q)) return {};
  const Enclosure h_A = Support(A, u, 1).value();
  const Enclosure h_Q = Support(Q, u, -1).value();
  if (!(h_A.above < 0 && h_Q.below > 0 && h_Q.above < kInfinity)) return {};
  constexpr double kRounding = 0x1p-51;
  return {true, -h_A.above / h_Q.above * (1 - kRounding), -h_A.below / h_Q.below * (1 + kRounding)};
}

}  // namespace raygauge::soak
