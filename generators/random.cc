// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/random.h"

#include <Random123/philox.h>

#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "generators/portable_log.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

void check_dimension(int n) {
  if (n < 1) throw InvalidParameterError("a random vector needs n >= 1, got n = " + std::to_string(n));
}

// Plain loops throughout: Eigen's reductions sum in an order that depends on the vector width.
double sum_of_squares(const Vector& x, Eigen::Index first = 0) {
  double sum = 0;
  for (Eigen::Index k = first; k < x.size(); ++k) sum += x[k] * x[k];
  return sum;
}

// v = e_1 - x for a unit vector x, so that the reflection I - 2 v vᵀ / vᵀv takes e_1 to x. Where x is near
// e_1, 1 - x_1 = (x_2² + … + x_m²) / (1 + x_1) avoids the cancellation; for x = e_1 any v orthogonal to e_1
// will do.
Vector reflection_to(const Vector& x) {
  Vector v = -x;
  v[0] = x[0] > 0 ? sum_of_squares(x, 1) / (1 + x[0]) : 1 - x[0];
  if (sum_of_squares(v) == 0) v[1] = 1;
  return v;
}

// block := (I - 2 v vᵀ / vᵀv) block.
void reflect(const Vector& v, Eigen::Ref<Eigen::MatrixXd> block) {
  const double scale = 2 / sum_of_squares(v);
  for (Eigen::Index j = 0; j < block.cols(); ++j) {
    double dot = 0;
    for (Eigen::Index i = 0; i < block.rows(); ++i) dot += v[i] * block(i, j);
    const double factor = scale * dot;
    for (Eigen::Index i = 0; i < block.rows(); ++i) block(i, j) -= factor * v[i];
  }
}

}  // namespace

std::uint64_t stable_hash(std::string_view name) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : name) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 1099511628211u;
  }
  return hash;
}

RandomStream::RandomStream(const InstanceKey& key, std::string_view generator, RandomPurpose purpose)
    : key_{key.seed, stable_hash(generator)},
      counter_{0, static_cast<std::uint64_t>(purpose),
               static_cast<std::uint32_t>(key.n) |
                   static_cast<std::uint64_t>(static_cast<std::uint32_t>(key.N)) << 32,
               static_cast<std::uint32_t>(key.repetition)} {}

void RandomStream::refill() {
  const r123::Philox4x64::ctr_type counter = {{counter_[0], counter_[1], counter_[2], counter_[3]}};
  const r123::Philox4x64::key_type key = {{key_[0], key_[1]}};
  const auto block = r123::Philox4x64()(counter, key);
  for (int i = 0; i < 4; ++i) words_[i] = block[static_cast<std::size_t>(i)];
  ++counter_[0];
  words_left_ = 4;
}

std::uint64_t RandomStream::bits() {
  if (words_left_ == 0) refill();
  return words_[4 - words_left_--];
}

double RandomStream::uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

std::int64_t RandomStream::integer(std::int64_t first, std::int64_t last) {
  if (first > last) {
    throw InvalidParameterError("random integer: first = " + std::to_string(first) +
                                " exceeds last = " + std::to_string(last));
  }
  const std::uint64_t range = static_cast<std::uint64_t>(last) - static_cast<std::uint64_t>(first) + 1;
  if (range == 0) return static_cast<std::int64_t>(bits());
  // The 2^64 mod range smallest words are rejected: what remains is a whole number of ranges.
  const std::uint64_t rejected = (0 - range) % range;
  std::uint64_t word = bits();
  while (word < rejected) word = bits();
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(first) + word % range);
}

double RandomStream::normal() {
  if (has_spare_normal_) {
    has_spare_normal_ = false;
    return spare_normal_;
  }
  double x = 0, y = 0, r2 = 0;
  do {
    x = 2 * uniform() - 1;
    y = 2 * uniform() - 1;
    r2 = x * x + y * y;
  } while (r2 >= 1 || r2 == 0);
  const double factor = std::sqrt(-2 * portable_log(r2) / r2);
  spare_normal_ = y * factor;
  has_spare_normal_ = true;
  return x * factor;
}

Vector RandomStream::unit_vector(int n) {
  check_dimension(n);
  constexpr double kSafeToDivide = 1e-100;
  Vector x(n);
  double norm = 0;
  do {
    for (int k = 0; k < n; ++k) x[k] = normal();
    norm = std::sqrt(sum_of_squares(x));
  } while (norm < kSafeToDivide);
  for (int k = 0; k < n; ++k) x[k] /= norm;
  return x;
}

// The subgroup algorithm (Diaconis & Shahshahani 1987): R_m = H(x) diag(1, R_{m-1}), where the reflection
// H(x) takes e_1 to x, uniform on the sphere of R^m. Each of the n-1 reflections changes the sign of the
// determinant; R_1 makes up for it.
Eigen::MatrixXd RandomStream::rotation(int n) {
  check_dimension(n);
  Eigen::MatrixXd R = Eigen::MatrixXd::Identity(n, n);
  R(n - 1, n - 1) = n % 2 == 1 ? 1 : -1;
  for (int m = 2; m <= n; ++m) reflect(reflection_to(unit_vector(m)), R.bottomRightCorner(m, m));
  return R;
}

std::vector<std::ptrdiff_t> RandomStream::permutation(std::ptrdiff_t size) {
  std::vector<std::ptrdiff_t> order(static_cast<std::size_t>(size));
  std::iota(order.begin(), order.end(), std::ptrdiff_t{0});
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[static_cast<std::size_t>(integer(0, static_cast<std::int64_t>(i) - 1))]);
  }
  return order;
}

}  // namespace raygauge
