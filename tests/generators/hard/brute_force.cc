// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/generators/hard/brute_force.h"

#include <cmath>
#include <limits>
#include <span>
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

// One step of Gauss and Jordan's elimination, on one more vector: row `pivot` of `column` becomes row `row`,
// in which column becomes 1 there and 0 elsewhere.
void eliminate(const RationalVector& column, std::size_t pivot, std::size_t row, RationalVector& vector) {
  std::swap(vector[row], vector[pivot]);
  if (vector[row] == 0) return;
  vector[row] /= column[pivot];
  for (std::size_t i = 0; i < vector.size(); ++i) {
    const Rational& entry = column[i == pivot ? row : i];
    if (i != row && entry != 0) vector[i] -= entry * vector[row];
  }
}

// Tries every set of independent columns: each is a smaller one and a column behind its last.
class Search {
 public:
  Search(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q)
      : columns_of_Q_(static_cast<std::size_t>(Q.cols())), rows_(static_cast<std::size_t>(A.rows()) + 1) {
    RationalVector right(rows_);
    right.back() = 1;
    extend(columns_of(A, Q), right);
  }

  const std::optional<Rational>& best() const { return best_; }

 private:
  // `columns`, those behind the last one chosen, and `right`: after the elimination of the chosen.
  void extend(std::span<const RationalVector> columns, const RationalVector& right) {
    const std::size_t row = is_of_Q_.size();
    for (; !columns.empty(); columns = columns.subspan(1)) {
      const bool is_of_Q = columns.size() <= columns_of_Q_;
      if (row == 0 && is_of_Q) return;  // Σα = 1 needs a point of A
      const RationalVector& column = columns.front();
      std::size_t pivot = row;
      while (pivot < rows_ && column[pivot] == 0) ++pivot;
      if (pivot == rows_) continue;  // dependent, with whatever is added
      is_of_Q_.push_back(is_of_Q);
      RationalVector next_right = right;
      eliminate(column, pivot, row, next_right);
      try_solution(next_right);
      if (row + 1 < rows_) {
        std::vector<RationalVector> next(columns.begin() + 1, columns.end());
        for (RationalVector& other : next) eliminate(column, pivot, row, other);
        extend(next, next_right);
      }
      is_of_Q_.pop_back();
    }
  }

  // The chosen columns times the first entries of `right` are (0; 1), if its other entries are 0.
  void try_solution(const RationalVector& right) {
    Rational distance = 0;
    for (std::size_t k = 0; k < rows_; ++k) {
      const bool is_chosen = k < is_of_Q_.size();
      if (is_chosen ? right[k] < 0 : right[k] != 0) return;
      if (is_chosen && is_of_Q_[k]) distance += right[k];
    }
    if (!best_ || distance < *best_) best_ = distance;
  }

  std::size_t columns_of_Q_;
  std::size_t rows_;
  std::vector<bool> is_of_Q_;  // of the chosen columns
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
