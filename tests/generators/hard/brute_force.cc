// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/generators/hard/brute_force.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace raygauge {
namespace {

using RationalVector = std::vector<Rational>;

// Columns (a_i; 1) and (-q_j; 0) of the linear program; the right-hand side is (0; 1).
std::vector<RationalVector> columns_of(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q) {
  std::vector<RationalVector> columns;
  for (Eigen::Index i = 0; i < A.cols(); ++i) {
    columns.emplace_back(A.col(i).begin(), A.col(i).end());
    columns.back().emplace_back(1);
  }
  for (Eigen::Index j = 0; j < Q.cols(); ++j) {
    columns.emplace_back();
    for (const double coordinate : Q.col(j)) columns.back().push_back(-Rational(coordinate));
    columns.back().emplace_back(0);
  }
  return columns;
}

// The unique solution of Σ x_k column_k = (0; 1); empty if there is none or the columns are dependent.
std::optional<RationalVector> solve(const std::vector<const RationalVector*>& columns) {
  const std::size_t rows = columns.front()->size();
  const std::size_t count = columns.size();
  std::vector<RationalVector> tableau(rows, RationalVector(count + 1));
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t k = 0; k < count; ++k) tableau[row][k] = (*columns[k])[row];
  }
  tableau[rows - 1][count] = 1;
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t pivot = k;
    while (pivot < rows && tableau[pivot][k] == 0) ++pivot;
    if (pivot == rows) return std::nullopt;
    std::swap(tableau[k], tableau[pivot]);
    for (std::size_t row = 0; row < rows; ++row) {
      if (row == k || tableau[row][k] == 0) continue;
      const Rational factor = tableau[row][k] / tableau[k][k];
      for (std::size_t j = k; j <= count; ++j) tableau[row][j] -= factor * tableau[k][j];
    }
  }
  for (std::size_t row = count; row < rows; ++row) {
    if (tableau[row][count] != 0) return std::nullopt;
  }
  RationalVector x(count);
  for (std::size_t k = 0; k < count; ++k) x[k] = tableau[k][count] / tableau[k][k];
  return x;
}

class Search {
 public:
  Search(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q)
      : columns_(columns_of(A, Q)), columns_of_A_(static_cast<std::size_t>(A.cols())) {
    extend(0);
  }

  const std::optional<Rational>& best() const { return best_; }

 private:
  void extend(std::size_t first) {
    if (!chosen_.empty()) try_chosen();
    if (chosen_.size() == columns_.front().size()) return;
    for (std::size_t k = first; k < columns_.size(); ++k) {
      if (chosen_.empty() && k >= columns_of_A_) return;  // Σα = 1 needs a point of A
      chosen_.push_back(&columns_[k]);
      extend(k + 1);
      chosen_.pop_back();
    }
  }

  void try_chosen() {
    const auto x = solve(chosen_);
    if (!x) return;
    Rational distance = 0;
    for (std::size_t k = 0; k < x->size(); ++k) {
      if ((*x)[k] < 0) return;
      if (chosen_[k] >= &columns_[0] + columns_of_A_) distance += (*x)[k];
    }
    if (!best_ || distance < *best_) best_ = distance;
  }

  std::vector<RationalVector> columns_;
  std::size_t columns_of_A_;
  std::vector<const RationalVector*> chosen_;
  std::optional<Rational> best_;
};

}  // namespace

std::optional<Rational> brute_force_distance(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q) {
  return Search(A, Q).best();
}

bool is_nearest_double(const Rational& exact, double rounded) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Rational error = abs(exact - Rational(rounded));
  return 2 * error <= Rational(std::nextafter(rounded, kInfinity)) - Rational(rounded) &&
         2 * error <= Rational(rounded) - Rational(std::nextafter(rounded, -kInfinity));
}

}  // namespace raygauge
