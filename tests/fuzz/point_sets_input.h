// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>
#include <vector>

#include "raygauge/sets/point_set.h"

namespace raygauge::fuzz {

/// Two small point sets and a tolerance from arbitrary bytes; bytes that are missing count as zero.
///
///     byte 0: n - 1 mod 4;   byte 1: N_A - 1 mod 8;   byte 2: N_Q - 1 mod 12;   byte 3: tolerance, see
///     below; then the coordinates of A and of Q, point by point, each a byte k and what it asks for: k mod 8
///     = 0…3: the integer of the next byte, signed;
///               4:   that integer times 2^e, e the next two bytes, signed, mod 1024;
///               5:   the double of the next eight bytes, 0 if it is not finite;
///               6:   a coordinate that went before, the next byte says how long ago;
///               7:   the same, moved by k / 64 - 2 neighbouring doubles.
class PointSetsInput {
 public:
  explicit PointSetsInput(std::string_view bytes) : bytes_(bytes) {
    n_ = 1 + take() % 4;
    const int N_A = 1 + take() % 8, N_Q = 1 + take() % 12;
    constexpr double kTolerances[] = {1e-6, 1e-9, 1e-12, 0x1p-50};
    tolerance_ = kTolerances[take() % 4];
    A_ = matrix(N_A);
    Q_ = matrix(N_Q);
  }

  const Eigen::MatrixXd& A() const { return A_; }
  const Eigen::MatrixXd& Q() const { return Q_; }
  double tolerance() const { return tolerance_; }

 private:
  std::uint8_t take() {
    if (bytes_.empty()) return 0;
    const auto byte = static_cast<std::uint8_t>(bytes_.front());
    bytes_.remove_prefix(1);
    return byte;
  }

  double small_integer() { return static_cast<std::int8_t>(take()); }

  double any_double() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits |= static_cast<std::uint64_t>(take()) << (8 * i);
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return std::isfinite(value) ? value : 0;
  }

  double earlier() {
    const std::size_t back = take();
    return seen_.empty() ? 1.0 : seen_[seen_.size() - 1 - back % seen_.size()];
  }

  static double moved(double value, int steps) {
    const double towards = std::copysign(std::numeric_limits<double>::max(), steps);
    for (int i = 0; i < std::abs(steps); ++i) value = std::nextafter(value, towards);
    return value;
  }

  double coordinate() {
    const std::uint8_t kind = take();
    if (kind % 8 <= 3) return small_integer();
    if (kind % 8 == 5) return any_double();
    if (kind % 8 == 6) return earlier();
    if (kind % 8 == 7) return moved(earlier(), kind / 64 - 2);
    const double mantissa = small_integer();
    const int low = take(), high = take();
    return std::ldexp(mantissa, static_cast<std::int16_t>(low | high << 8) % 1024);
  }

  Eigen::MatrixXd matrix(int N) {
    Eigen::MatrixXd points(n_, N);
    for (int i = 0; i < N; ++i) {
      for (int k = 0; k < n_; ++k) {
        const double value = coordinate();
        points(k, i) = std::isfinite(value) ? value : 0;
        seen_.push_back(points(k, i));
      }
    }
    return points;
  }

  std::string_view bytes_;
  std::vector<double> seen_;
  int n_ = 1;
  double tolerance_ = 0;
  Eigen::MatrixXd A_, Q_;
};

}  // namespace raygauge::fuzz
