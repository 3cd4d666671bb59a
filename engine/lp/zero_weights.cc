// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/zero_weights.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace raygauge {
namespace {

__extension__ using Wide = __int128;
__extension__ using UnsignedWide = unsigned __int128;
using Word = std::uint64_t;

constexpr Word kPrime = (Word{1} << 31U) - 1;  // products of two residues fit into a word
constexpr double kBitsOfPrime = 30.99;
constexpr int kMostBits = 62;  // of an entry: sums of m <= 2^30 products with residues fit into a wide word

Word residue(Wide value) {
  const auto rest = static_cast<std::int64_t>(value % static_cast<Wide>(kPrime));
  return static_cast<Word>(rest < 0 ? rest + static_cast<std::int64_t>(kPrime) : rest);
}

Word inverse_of(Word a) {  // a^(p - 2), by Fermat
  Word result = 1;
  for (Word exponent = kPrime - 2; exponent > 0; exponent >>= 1U) {
    if (exponent % 2 == 1) result = result * a % kPrime;
    a = a * a % kPrime;
  }
  return result;
}

// Exponent of the lowest bit that is set.
int lowest_exponent(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::fabs(fraction), 53));
  return exponent - 53 + __builtin_ctzll(static_cast<unsigned long long>(mantissa));
}

class PadicSolution {
 public:
  // False where the rows need more than 62 bits.
  bool scale(const double* B, std::ptrdiff_t ld, int m);
  bool invert(const Stopwatch& stopwatch);
  bool are_zero(std::span<const int> positions, const Stopwatch& stopwatch) const;

 private:
  std::int64_t entry(int k, int i) const { return B_[at(k, i)]; }
  std::size_t at(int k, int i) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(m_) + static_cast<std::size_t>(k);
  }
  void next_digits(const std::vector<Word>& rest, std::vector<Word>& digits) const;
  void subtract_digits(const std::vector<Word>& digits, std::vector<Wide>& r) const;
  double bits_of_bound() const;

  int m_ = 0;
  std::vector<std::int64_t> B_;  // by columns
  std::vector<Word> C_;          // B⁻¹ mod p, by columns
};

bool PadicSolution::scale(const double* B, std::ptrdiff_t ld, int m) {
  m_ = m;
  B_.assign(static_cast<std::size_t>(m) * static_cast<std::size_t>(m), 0);
  for (int k = 0; k < m; ++k) {
    int lowest = std::numeric_limits<int>::max();
    double largest = 0;
    for (int i = 0; i < m; ++i) {
      const double value = B[i * ld + k];
      if (value == 0) continue;
      lowest = std::min(lowest, lowest_exponent(value));
      largest = std::max(largest, std::fabs(value));
    }
    if (largest == 0 || std::ilogb(largest) - lowest >= kMostBits) return false;
    for (int i = 0; i < m; ++i) {
      B_[at(k, i)] = static_cast<std::int64_t>(std::ldexp(B[i * ld + k], -lowest));
    }
  }
  return true;
}

// Gauss-Jordan elimination of [B, I] modulo p, by columns of the inverse's transpose: rows of [B, I] are what
// is combined, and they are kept as such.
bool PadicSolution::invert(const Stopwatch& stopwatch) {
  const auto m = static_cast<std::size_t>(m_);
  std::vector<Word> rows(2 * m * m, 0);  // row k: B_k and then I_k
  for (int k = 0; k < m_; ++k) {
    Word* row = rows.data() + static_cast<std::size_t>(k) * 2 * m;
    for (int i = 0; i < m_; ++i) row[i] = residue(entry(k, i));
    row[m + static_cast<std::size_t>(k)] = 1;
  }
  for (std::size_t j = 0; j < m; ++j) {
    if (stopwatch.expired()) return false;
    std::size_t pivot = j;
    while (pivot < m && rows[pivot * 2 * m + j] == 0) ++pivot;
    if (pivot == m) return false;
    Word* row = rows.data() + j * 2 * m;
    if (pivot != j) std::swap_ranges(row, row + 2 * m, rows.data() + pivot * 2 * m);
    const Word inverse = inverse_of(row[j]);
    for (std::size_t c = j; c < 2 * m; ++c) row[c] = row[c] * inverse % kPrime;
    for (std::size_t k = 0; k < m; ++k) {
      Word* other = rows.data() + k * 2 * m;
      if (k == j || other[j] == 0) continue;
      const Word factor = kPrime - other[j];
      for (std::size_t c = j; c < 2 * m; ++c) other[c] = (other[c] + factor * row[c]) % kPrime;
    }
  }
  C_.resize(m * m);
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t k = 0; k < m; ++k) C_[k * m + i] = rows[i * 2 * m + m + k];
  }
  return true;
}

// C r mod p.
void PadicSolution::next_digits(const std::vector<Word>& rest, std::vector<Word>& digits) const {
  const auto m = static_cast<std::size_t>(m_);
  std::vector<Word> low(m, 0), high(m, 0);
  std::fill(digits.begin(), digits.end(), 0);
  for (std::size_t k = 0; k < m; ++k) {
    if (rest[k] == 0) continue;
    const Word* column = C_.data() + k * m;
    for (std::size_t i = 0; i < m; ++i) {
      const Word product = rest[k] * column[i];  // < 2^62; its halves are summed apart
      low[i] += product & 0xffffffffU;
      high[i] += product >> 32U;
    }
  }
  for (std::size_t i = 0; i < m; ++i) {
    digits[i] = residue((static_cast<Wide>(high[i]) << 32U) + static_cast<Wide>(low[i]));
  }
}

// r <- (r - B d) / p, which leaves no remainder.
void PadicSolution::subtract_digits(const std::vector<Word>& digits, std::vector<Wide>& r) const {
  for (int i = 0; i < m_; ++i) {
    const auto digit = static_cast<Wide>(digits[static_cast<std::size_t>(i)]);
    if (digit == 0) continue;
    const std::int64_t* column = B_.data() + at(0, i);
    for (int k = 0; k < m_; ++k) r[static_cast<std::size_t>(k)] -= digit * column[k];
  }
  for (Wide& rest : r) rest /= static_cast<Wide>(kPrime);
}

// log2 Π_j |B_j|, rounded up, and of e_m in place of one of them.
double PadicSolution::bits_of_bound() const {
  double bits = 1;
  for (int i = 0; i < m_; ++i) {
    double square = 1;
    for (int k = 0; k < m_; ++k) {
      const auto value = static_cast<double>(entry(k, i));
      square += value * value;
    }
    bits += 0.5 * std::log2(square) * (1 + 1e-12) + 1e-12;
  }
  return bits;
}

bool PadicSolution::are_zero(std::span<const int> positions, const Stopwatch& stopwatch) const {
  const auto m = static_cast<std::size_t>(m_);
  std::vector<Wide> r(m, 0);
  std::vector<Word> rest(m), digits(m);
  r[m - 1] = 1;
  const auto count = static_cast<std::int64_t>(bits_of_bound() / kBitsOfPrime) + 2;
  for (std::int64_t digit = 0; digit < count; ++digit) {
    if (stopwatch.expired()) return false;
    std::transform(r.begin(), r.end(), rest.begin(), residue);
    next_digits(rest, digits);
    for (const int i : positions) {
      if (digits[static_cast<std::size_t>(i)] != 0) return false;
    }
    subtract_digits(digits, r);
  }
  return true;
}

}  // namespace

bool weights_are_zero(const double* B, std::ptrdiff_t ld, int m, std::span<const int> positions,
                      const Stopwatch& stopwatch) {
  PadicSolution solution;
  return solution.scale(B, ld, m) && solution.invert(stopwatch) && solution.are_zero(positions, stopwatch);
}

}  // namespace raygauge
