// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/variant.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raygauge::soak {
namespace {

constexpr int kLargestExponent = 500;  // 2^500 ≈ 1e150

bool chance(RandomStream& stream, double probability) { return stream.uniform() < probability; }

// The binary exponents of the smallest and the largest coordinate that is not zero.
struct Exponents {
  int smallest = std::numeric_limits<int>::max();
  int largest = std::numeric_limits<int>::min();
  void include(const Eigen::Ref<const Eigen::MatrixXd>& coordinates) {
    for (Eigen::Index j = 0; j < coordinates.cols(); ++j) {
      for (Eigen::Index k = 0; k < coordinates.rows(); ++k) {
        if (coordinates(k, j) == 0) continue;
        const int exponent = std::ilogb(coordinates(k, j));
        smallest = std::min(smallest, exponent);
        largest = std::max(largest, exponent);
      }
    }
  }
  // Whether times 2^shift is exact, and no coordinate goes beyond 1e±150 that was not there before.
  bool allow(int shift) const {
    if (largest < smallest) return false;  // nothing but zeros
    return shift > 0 ? largest + shift <= kLargestExponent : smallest + shift >= -kLargestExponent;
  }
};

// Columns of `points`: all with weight, others with probability `kept`, copies with probability `copied`.
void choose_columns(const std::vector<bool>& carries, double kept, double copied, RandomStream& stream,
                    std::vector<Eigen::Index>& from) {
  from.clear();
  for (std::size_t i = 0; i < carries.size(); ++i) {
    if (carries[i] || chance(stream, kept)) from.push_back(static_cast<Eigen::Index>(i));
  }
  if (from.empty()) from.push_back(0);  // Q where A contains the origin, or where Q cannot reach A
  if (copied > 0) {
    for (std::size_t i = 0, size = from.size(); i < size; ++i) {
      if (chance(stream, copied)) from.push_back(from[i]);
    }
  }
  for (std::size_t i = from.size(); i > 1; --i) {
    std::swap(from[i - 1], from[static_cast<std::size_t>(stream.integer(0, static_cast<int>(i) - 1))]);
  }
}

void gather(const Eigen::MatrixXd& points, const std::vector<Eigen::Index>& from, Eigen::MatrixXd& chosen) {
  chosen.resize(points.rows(), static_cast<Eigen::Index>(from.size()));
  for (Eigen::Index i = 0; i < chosen.cols(); ++i)
    chosen.col(i) = points.col(from[static_cast<std::size_t>(i)]);
}

bool sum_is_exact(double a, double b) {
  const double s = a + b;
  const double t = s - a;
  return (a - (s - t)) + (b - t) == 0;
}

bool row_sum_is_exact(const Eigen::MatrixXd& points, Eigen::Index i, Eigen::Index j, double sign) {
  for (Eigen::Index c = 0; c < points.cols(); ++c) {
    if (!sum_is_exact(points(i, c), sign * points(j, c))) return false;
  }
  return true;
}

}  // namespace

void Variant::make(const ProvenInstance& base, RandomStream& stream) {
  shift_ = 0;
  choose_points(base, stream);
  move_points(base, stream);
  turn_axes(stream);
  if (chance(stream, 0.3)) shear(stream);
  if (chance(stream, 0.3)) scale_axes(stream);
  if (chance(stream, 0.3)) scale_sets(stream);
}

void Variant::choose_points(const ProvenInstance& base, RandomStream& stream) {
  const double kept = chance(stream, 0.4) ? 1 : stream.uniform();
  const double copied = chance(stream, 0.15) ? stream.uniform() : 0;
  choose_columns(base.carries_A, kept, copied, stream, from_A_);
  choose_columns(base.carries_Q, kept, copied, stream, from_Q_);
  gather(base.A, from_A_, A_);
  gather(base.Q, from_Q_, Q_);
}

void Variant::move_points(const ProvenInstance& base, RandomStream& stream) {
  if (chance(stream, 0.3)) return;
  const double share = chance(stream, 0.5) ? 1 : 0.2;
  const double size = std::exp2(-52 * stream.uniform());
  const bool radially = chance(stream, 0.2);
  const auto move = [&](Eigen::MatrixXd& points, const std::vector<Eigen::Index>& from,
                        const std::vector<bool>& carries, double outwards, auto may_join) {
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      if (carries[static_cast<std::size_t>(from[static_cast<std::size_t>(i)])] || !chance(stream, share))
        continue;
      point_ = points.col(i);
      if (radially) {
        point_ *= std::exp2(outwards * static_cast<double>(stream.integer(1, 3)));
      } else {
        for (double& x : point_) x += x * size * (stream.uniform() - 0.5);
      }
      if (may_join(point_)) points.col(i) = point_;
    }
  };
  move(A_, from_A_, base.carries_A, 1, [&](const Vector& a) { return base.may_join_A(a); });
  move(Q_, from_Q_, base.carries_Q, -1, [&](const Vector& q) { return base.may_join_Q(q); });
}

void Variant::turn_axes(RandomStream& stream) {
  for (Eigen::Index k = 0; k < A_.rows(); ++k) {
    const Eigen::Index other = stream.integer(0, k);
    if (other != k) {
      A_.row(k).swap(A_.row(other));
      Q_.row(k).swap(Q_.row(other));
    }
    if (chance(stream, 0.5)) {
      A_.row(k) *= -1;
      Q_.row(k) *= -1;
    }
  }
}

void Variant::shear(RandomStream& stream) {
  const Eigen::Index n = A_.rows();
  if (n < 2) return;
  for (Eigen::Index count = stream.integer(1, 2 * n); count > 0; --count) {
    const Eigen::Index i = stream.integer(0, n - 1);
    const Eigen::Index j = (i + stream.integer(1, n - 1)) % n;
    const double sign = chance(stream, 0.5) ? 1 : -1;
    if (!row_sum_is_exact(A_, i, j, sign) || !row_sum_is_exact(Q_, i, j, sign)) continue;
    A_.row(i) += sign * A_.row(j);
    Q_.row(i) += sign * Q_.row(j);
  }
}

void Variant::scale_axes(RandomStream& stream) {
  const auto reach = stream.integer(1, 20);
  for (Eigen::Index k = 0; k < A_.rows(); ++k) {
    const auto shift = static_cast<int>(stream.integer(-reach, reach));
    Exponents exponents;
    exponents.include(A_.row(k));
    exponents.include(Q_.row(k));
    if (!exponents.allow(shift)) continue;
    A_.row(k) *= std::ldexp(1.0, shift);
    Q_.row(k) *= std::ldexp(1.0, shift);
  }
}

void Variant::scale_sets(RandomStream& stream) {
  const auto shift = static_cast<int>(stream.integer(-kLargestExponent, kLargestExponent));
  const bool both = chance(stream, 0.6);
  Exponents exponents;
  exponents.include(A_);
  if (both) exponents.include(Q_);
  if (!exponents.allow(shift)) return;
  A_ *= std::ldexp(1.0, shift);
  if (both) {
    Q_ *= std::ldexp(1.0, shift);
  } else {
    shift_ = shift;
  }
}

}  // namespace raygauge::soak
