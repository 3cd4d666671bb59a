// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/exact_rank.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace raygauge {
namespace {

__extension__ using Wide = __int128;
using Word = std::uint64_t;

constexpr Word kPrime = (Word{1} << 31U) - 1;  // products of two residues fit into a word
constexpr double kBitsOfPrime = 30.99;
constexpr int kMostBits = 62;    // of an entry: sums of r <= 2^30 products with residues fit into a wide word
constexpr int kNarrowBits = 62;  // of such sums, where 64 bits do

// x mod p for x < 2^63, by 2^31 ≡ 1: without branches, for many at a time.
inline Word reduced(Word x) {
  x = (x & kPrime) + (x >> 31U);
  x = (x & kPrime) + (x >> 31U);  // at most p + 3
  ++x;                            // so that p becomes 0
  return (x & kPrime) + (x >> 31U) - 1;
}

template <class Integer>
Word residue(Integer value) {
  const auto rest = static_cast<std::int64_t>(value % static_cast<Integer>(kPrime));
  return static_cast<Word>(rest < 0 ? rest + static_cast<std::int64_t>(kPrime) : rest);
}

Word inverse_of(Word a) {  // a^(p - 2), by Fermat
  Word result = 1;
  for (Word exponent = kPrime - 2; exponent > 0; exponent >>= 1U) {
    if (exponent % 2 == 1) result = reduced(result * a);
    a = reduced(a * a);
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

// Rows of residues.
class Residues {
 public:
  Residues(std::size_t rows, std::size_t width) : width_(width), data_(rows * width, 0) {}
  Word* row(std::size_t k) { return data_.data() + k * width_; }
  const Word* row(std::size_t k) const { return data_.data() + k * width_; }

  // row_k += factor row_j, from entry `first` on.
  void add(std::size_t k, Word factor, std::size_t j, std::size_t first) {
    Word* to = row(k);
    const Word* from = row(j);
    for (std::size_t c = first; c < width_; ++c) to[c] = reduced(to[c] + factor * from[c]);
  }
  void scale(std::size_t k, Word factor) {
    for (std::size_t c = 0; c < width_; ++c) row(k)[c] = reduced(row(k)[c] * factor);
  }

 private:
  std::size_t width_;
  std::vector<Word> data_;
};

// An integer matrix, by columns, its columns `chosen` first.
class IntegerMatrix {
 public:
  bool load(const MatrixOfDoubles& M, std::span<const int> chosen);
  /// Rows of a regular minor of the chosen columns come first. False where there is none modulo p.
  bool find_rows(const Stopwatch& stopwatch);
  bool invert(const Stopwatch& stopwatch);
  bool others_depend(const Stopwatch& stopwatch) const;
  void transpose();
  bool has_fewer_rows_to_ask() const { return rows_ < columns_; }

 private:
  std::int64_t& entry(int k, int i) { return entries_[at(k, i)]; }
  std::int64_t entry(int k, int i) const { return entries_[at(k, i)]; }
  std::size_t at(int k, int i) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(k);
  }
  double bits_of_column(int i) const;
  template <class Integer>
  bool depends(int column, double bits, const Stopwatch& stopwatch) const;
  void next_digits(const std::vector<Word>& rest, std::vector<Word>& digits) const;

  int rows_ = 0, columns_ = 0;
  int rank_ = 0;  // of the chosen columns
  int bits_ = 0;  // of the longest entry
  std::vector<std::int64_t> entries_;
  std::vector<Word> inverse_;  // of the minor mod p, by columns
};

bool IntegerMatrix::load(const MatrixOfDoubles& M, std::span<const int> chosen) {
  rows_ = M.rows;
  columns_ = M.columns;
  rank_ = static_cast<int>(chosen.size());
  std::vector<int> order(chosen.begin(), chosen.end());
  std::vector<bool> taken(static_cast<std::size_t>(columns_), false);
  for (const int i : chosen) taken[static_cast<std::size_t>(i)] = true;
  for (int i = 0; i < columns_; ++i) {
    if (!taken[static_cast<std::size_t>(i)]) order.push_back(i);
  }
  entries_.assign(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_), 0);
  bits_ = 0;
  for (int k = 0; k < rows_; ++k) {
    int lowest = std::numeric_limits<int>::max();
    double largest = 0;
    for (int i = 0; i < columns_; ++i) {
      const double value = M.data[i * M.ld + k];
      if (value == 0) continue;
      lowest = std::min(lowest, lowest_exponent(value));
      largest = std::max(largest, std::fabs(value));
    }
    if (largest == 0) continue;
    const int bits = std::ilogb(largest) - lowest + 1;
    if (bits > kMostBits) return false;
    bits_ = std::max(bits_, bits);
    for (int i = 0; i < columns_; ++i) {
      const double value = M.data[order[static_cast<std::size_t>(i)] * M.ld + k];
      entry(k, i) = static_cast<std::int64_t>(std::ldexp(value, -lowest));
    }
  }
  return true;
}

bool IntegerMatrix::find_rows(const Stopwatch& stopwatch) {
  const auto r = static_cast<std::size_t>(rank_);
  Residues rows(static_cast<std::size_t>(rows_), r);
  for (int k = 0; k < rows_; ++k) {
    for (int i = 0; i < rank_; ++i) rows.row(static_cast<std::size_t>(k))[i] = residue(entry(k, i));
  }
  for (int j = 0; j < rank_; ++j) {
    if (stopwatch.expired()) return false;
    const auto first = static_cast<std::size_t>(j);
    int pivot = j;
    while (pivot < rows_ && rows.row(static_cast<std::size_t>(pivot))[j] == 0) ++pivot;
    if (pivot == rows_) return false;
    if (pivot != j) {
      std::swap_ranges(rows.row(first), rows.row(first) + r, rows.row(static_cast<std::size_t>(pivot)));
      for (int i = 0; i < columns_; ++i) std::swap(entry(j, i), entry(pivot, i));
    }
    const Word inverse = inverse_of(rows.row(first)[j]);
    for (auto k = first + 1; k < static_cast<std::size_t>(rows_); ++k) {
      if (rows.row(k)[j] == 0) continue;
      rows.add(k, reduced((kPrime - rows.row(k)[j]) * inverse), first, first);
    }
  }
  return true;
}

// Gauss-Jordan elimination in place, with exchanges of rows.
bool IntegerMatrix::invert(const Stopwatch& stopwatch) {
  const auto r = static_cast<std::size_t>(rank_);
  Residues rows(r, r);
  std::vector<std::size_t> exchanged(r);
  for (std::size_t k = 0; k < r; ++k) {
    for (std::size_t i = 0; i < r; ++i)
      rows.row(k)[i] = residue(entry(static_cast<int>(k), static_cast<int>(i)));
  }
  for (std::size_t j = 0; j < r; ++j) {
    if (stopwatch.expired()) return false;
    std::size_t pivot = j;
    while (pivot < r && rows.row(pivot)[j] == 0) ++pivot;
    if (pivot == r) return false;
    exchanged[j] = pivot;
    if (pivot != j) std::swap_ranges(rows.row(j), rows.row(j) + r, rows.row(pivot));
    const Word inverse = inverse_of(rows.row(j)[j]);
    rows.row(j)[j] = 1;
    rows.scale(j, inverse);
    for (std::size_t k = 0; k < r; ++k) {
      const Word entry = rows.row(k)[j];
      if (k == j || entry == 0) continue;
      rows.row(k)[j] = 0;
      rows.add(k, kPrime - entry, j, 0);
    }
  }
  for (std::size_t j = r; j-- > 0;) {
    for (std::size_t k = 0; k < r && exchanged[j] != j; ++k) {
      std::swap(rows.row(k)[j], rows.row(k)[exchanged[j]]);
    }
  }
  inverse_.resize(r * r);
  for (std::size_t i = 0; i < r; ++i) {
    for (std::size_t k = 0; k < r; ++k) inverse_[k * r + i] = rows.row(i)[k];
  }
  return true;
}

// M_R⁻¹ rest mod p.
void IntegerMatrix::next_digits(const std::vector<Word>& rest, std::vector<Word>& digits) const {
  const auto r = static_cast<std::size_t>(rank_);
  std::fill(digits.begin(), digits.end(), 0);
  for (std::size_t k = 0; k < r; ++k) {
    if (rest[k] == 0) continue;
    const Word* column = inverse_.data() + k * r;
    const Word factor = rest[k];
    for (std::size_t i = 0; i < r; ++i) digits[i] = reduced(digits[i] + factor * column[i]);
  }
}

double IntegerMatrix::bits_of_column(int i) const {
  double square = 1;
  for (int k = 0; k < rows_; ++k) {
    const auto value = static_cast<double>(entry(k, i));
    square += value * value;
  }
  return 0.5 * std::log2(square) * (1 + 1e-12) + 1e-12;
}

// Whether the residual of the column is zero modulo p^K > 2^bits.
template <class Integer>
bool IntegerMatrix::depends(int column, double bits, const Stopwatch& stopwatch) const {
  std::vector<Integer> s(static_cast<std::size_t>(rows_));
  for (int k = 0; k < rows_; ++k) s[static_cast<std::size_t>(k)] = entry(k, column);
  std::vector<Word> rest(static_cast<std::size_t>(rank_)), digits(rest.size());
  const auto count = static_cast<std::int64_t>(bits / kBitsOfPrime) + 2;
  for (std::int64_t digit = 0; digit < count; ++digit) {
    if (stopwatch.expired()) return false;
    std::transform(s.begin(), s.begin() + rank_, rest.begin(), residue<Integer>);
    next_digits(rest, digits);
    for (int i = 0; i < rank_; ++i) {
      const auto factor = static_cast<Integer>(digits[static_cast<std::size_t>(i)]);
      if (factor == 0) continue;
      const std::int64_t* of_chosen = entries_.data() + at(0, i);
      for (int k = 0; k < rows_; ++k) s[static_cast<std::size_t>(k)] -= factor * of_chosen[k];
    }
    for (Integer& rest_of_row : s) {
      const Integer quotient = rest_of_row / static_cast<Integer>(kPrime);
      if (quotient * static_cast<Integer>(kPrime) != rest_of_row) return false;
      rest_of_row = quotient;
    }
    // Zero for good: z has no more digits.
    if (std::all_of(s.begin(), s.end(), [](const Integer& value) { return value == 0; })) return true;
  }
  return true;
}

bool IntegerMatrix::others_depend(const Stopwatch& stopwatch) const {
  double bits = 1;
  for (int i = 0; i < rank_; ++i) bits += bits_of_column(i);
  const bool narrow = bits_ + 33 + std::log2(rank_ + 1.0) < kNarrowBits;
  for (int i = rank_; i < columns_; ++i) {
    const double all = bits + bits_of_column(i);
    const bool depend = narrow ? depends<std::int64_t>(i, all, stopwatch) : depends<Wide>(i, all, stopwatch);
    if (!depend) return false;
  }
  return true;
}

void IntegerMatrix::transpose() {
  std::vector<std::int64_t> turned(entries_.size());
  for (int k = 0; k < rows_; ++k) {
    for (int i = 0; i < columns_; ++i) {
      turned[static_cast<std::size_t>(k) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i)] =
          entry(k, i);
    }
  }
  entries_ = std::move(turned);
  std::swap(rows_, columns_);
}

}  // namespace

bool columns_span(const MatrixOfDoubles& M, std::span<const int> chosen, const Stopwatch& stopwatch) {
  const auto rank = static_cast<std::ptrdiff_t>(chosen.size());
  if (rank > M.rows) return false;
  IntegerMatrix integers;
  if (!integers.load(M, chosen) || !integers.find_rows(stopwatch)) return false;
  if (rank == M.rows || rank == M.columns) return true;
  if (integers.has_fewer_rows_to_ask()) integers.transpose();
  return integers.invert(stopwatch) && integers.others_depend(stopwatch);
}

}  // namespace raygauge
