// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The certificates of NearestPoint.
#include <algorithm>
#include <cmath>

#include "engine/methods/nearest_point/nearest_point.h"
#include "engine/numerics/double_double.h"
#include "engine/numerics/floating_point.h"
#include "engine/numerics/vector_kernels.h"
#include "engine/proof/certificate.h"

namespace raygauge {

// Both bounds at v; in twice the precision where rounding may be what is left of the gap.
void NearestPoint::prove() {
  bound_by_length(combine_plainly());
  bound_by_normal(false);
  if (bounds_.reach(goal_) || gap() > std::max(goal_.tolerance * square_, 2 * noise())) return;
  bound_by_length(combine_twofold());
  bound_by_normal(true);
}

// Weak duality at u = -v. Points that beat those priced so far join the candidates.
void NearestPoint::bound_by_normal(bool twofold) {
  SupportValue h_A;
  double size = 0;
  for (int t = 0; t < sides_; ++t) {
    Side& side = side_[t];
    SupportValue h;
    if (twofold && side.points != nullptr) {
      for (int k = 0; k < n_; ++k)
        shifted_[static_cast<std::size_t>(k)] = side.sign * u_[static_cast<std::size_t>(k)];
      h = support_value_twofold(*kernels_, *side.points, shifted_.data(), zero_.data());
    } else {
      h = side.oracle.verify(u_.data(), side.sign, side.best, side.candidate.data());
      ++counters_.support_queries;
      side.best = h.value;
    }
    h_A.value += h.value;
    h_A.error += h.error;
    size += std::fabs(h.value);
  }
  h_A.error = (h_A.error + 2 * kUnitRoundoff * size) * (1 + 8 * kUnitRoundoff);
  const double h_Q = radius_ * length(u_.data(), n_);
  if (!bounds_.raise_lower(lower_bound(h_A, {h_Q, (n_ + 8) * kUnitRoundoff * h_Q}))) return;
  for (int k = 0; k < n_; ++k) normal_[static_cast<std::size_t>(k)] = u_[static_cast<std::size_t>(k)] / h_Q;
}

// |Σ α s - Σ β t| / r with what rounding may have lost of it. `error` is that of the difference in contact_.
void NearestPoint::bound_by_length(double error) {
  double off = 0;
  for (int t = 0; t < sides_; ++t) off += side_[t].oracle.coordinate_error();
  const double whole = length(contact_.data(), n_) * (1 + (n_ + 16) * 2 * kUnitRoundoff);
  bounds_.reduce_upper((whole + error + std::sqrt(n_) * off) / radius_ * (1 + 16 * kUnitRoundoff));
}

// The nearest points, and their difference in contact_; returns a bound on its error, as the weights add up
// to one but for rounding.
double NearestPoint::combine_plainly() {
  double sum[2] = {0, 0};
  double size = 0;
  std::fill_n(nearest_.data(), 2 * n_, 0.0);
  for (int i = 0; i < basis_.count(); ++i) sum[basis_.side(i)] += weights_[static_cast<std::size_t>(i)];
  for (int i = 0; i < basis_.count(); ++i) {
    const double weight = weights_[static_cast<std::size_t>(i)] / sum[basis_.side(i)];
    double* nearest = nearest_.data() + std::ptrdiff_t{basis_.side(i)} * n_;
    double sum_of_sizes = 0;
    for (int k = 0; k < n_; ++k) {
      nearest[k] += weight * point(i)[k];
      sum_of_sizes += std::fabs(point(i)[k]);
    }
    size += weight * sum_of_sizes;
  }
  for (int k = 0; k < n_; ++k)
    contact_[static_cast<std::size_t>(k)] =
        nearest_[static_cast<std::size_t>(k)] -
        nearest_[static_cast<std::size_t>(n_) + static_cast<std::size_t>(k)];
  return (n_ + basis_.count() + 8) * 2 * kUnitRoundoff * size + kUnderflow;
}

// The same in double-double arithmetic, one coordinate after the other.
double NearestPoint::combine_twofold() {
  DoubleDouble sum[2];
  double size = 0;
  for (int i = 0; i < basis_.count(); ++i) {
    sum[basis_.side(i)] = sum[basis_.side(i)] + weights_[static_cast<std::size_t>(i)];
    size += weights_[static_cast<std::size_t>(i)] *
            std::fabs(*std::max_element(point(i), point(i) + n_,
                                        [](double a, double b) { return std::fabs(a) < std::fabs(b); }));
  }
  for (int k = 0; k < n_; ++k) {
    DoubleDouble nearest[2];
    for (int i = 0; i < basis_.count(); ++i) {
      nearest[basis_.side(i)] =
          nearest[basis_.side(i)] + two_product(weights_[static_cast<std::size_t>(i)], point(i)[k]);
    }
    for (int t = 0; t < sides_; ++t) {
      nearest[t] = nearest[t] / sum[t];
      nearest_[static_cast<std::size_t>(t) * static_cast<std::size_t>(n_) + static_cast<std::size_t>(k)] =
          nearest[t].rounded();
    }
    contact_[static_cast<std::size_t>(k)] = (nearest[0] - nearest[1]).rounded();
  }
  return n_ * (basis_.count() + 8) * 0x1p-98 * size + kUnderflow;
}

void NearestPoint::report(DistanceStatus status, Effects effects, DistanceResult& result) {
  write_bounds(bounds_, std::sqrt(square_) / radius_, status, result);
  result.normal = Vector::Map(bounds_.lower() > 0 ? normal_.data() : u_.data(), n_);
  if (double* contact = result.room_for_contact(effects, n_)) {
    std::copy_n(contact_.data(), n_, contact);
    ++counters_.witness_evaluations;
  }
  result.counters = counters_;
}

}  // namespace raygauge
