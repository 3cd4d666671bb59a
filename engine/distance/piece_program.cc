// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/distance/piece_program.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/sets/vector_kernels.h"

namespace raygauge {
namespace {

constexpr double kNoPivot = 1e-15;        // of a pivot, relative to the largest entry
constexpr double kSlightly = 1e-14;       // how far the model of a piece may exceed the maximum
constexpr double kSlack = 1e-13;          // of dependent equations, relative to the curvature
constexpr double kLeastCurvature = 1e-9;  // added where the pieces have none, relative to the points

}  // namespace

void PieceProgram::begin(int n) {
  n_ = n;
  systems_ = 0;
}

const double* PieceProgram::solve(const double* u, const Objective& objective, PieceList& A, PieceList& Q) {
  warm_start(A);
  warm_start(Q);
  const int most = n_ + A.count + Q.count;
  const auto room = static_cast<std::size_t>(most);
  system_.reserve(room * (room + 1));
  step_.reserve(room);
  // The maxima are compared at second order, the active set is held together at first order: where the two
  // disagree the search would go on for ever, and a step that is good for the greatest pieces has to do.
  const int enough = 4 + A.active_count + Q.active_count;
  for (int round = 0; round < enough + 2 * most; ++round) {
    if (!solve_system(u, objective, A, Q)) return nullptr;
    if (drop_negative(A) || drop_negative(Q)) continue;
    if (round >= enough) return step_.data();
    const bool added_A = add_violated(A, 1.0);
    const bool added_Q = add_violated(Q, -1.0);
    if (!added_A && !added_Q) return step_.data();
  }
  return nullptr;
}

// The active set begins with the pieces that carried weight in the step before, if there was one, and with
// the greatest.
void PieceProgram::warm_start(PieceList& list) {
  list.active_count = 0;
  if (list.warm) {
    for (int i = 0; i < list.count; ++i) {
      if (list.weight[static_cast<std::size_t>(i)] > 0) {
        list.active[static_cast<std::size_t>(list.active_count++)] = i;
      }
    }
  }
  if (list.active_count == 0) {
    std::fill_n(list.weight.data(), list.count, 0.0);
    list.weight[static_cast<std::size_t>(list.best)] = 1.0;
  }
  const auto end = list.active.data() + list.active_count;
  if (std::find(list.active.data(), end, list.best) == end) {
    list.active[static_cast<std::size_t>(list.active_count++)] = list.best;
  }
}

void PieceProgram::add_curvature(const PieceList& list, double weight) {
  if (!list.curved) return;
  for (int a = 0; a < list.active_count; ++a) {
    const int i = list.active[static_cast<std::size_t>(a)];
    const double share = weight * std::max(list.weight[static_cast<std::size_t>(i)], 0.0);
    const double* H = list.hessian(i);
    for (int j = 0; j < n_; ++j) {
      double* row = system_.data() + std::ptrdiff_t{j} * columns_;
      for (int k = 0; k < n_; ++k) row[k] += share * H[j * n_ + k];
    }
  }
}

// Gradients of the active pieces less that of the reference, as rows and as columns.
void PieceProgram::add_differences(const PieceList& list, double sign, int row) {
  const int reference = list.active[0];
  const double* s_0 = list.point(reference);
  for (int a = 1; a < list.active_count; ++a, ++row) {
    const int i = list.active[static_cast<std::size_t>(a)];
    const double* s_i = list.point(i);
    double* entries = system_.data() + std::ptrdiff_t{row} * columns_;
    for (int k = 0; k < n_; ++k) {
      const double difference = sign * (s_i[k] - s_0[k]);
      entries[k] = difference;
      system_.data()[std::ptrdiff_t{k} * columns_ + row] = difference;
    }
    entries[columns_ - 1] =
        list.value[static_cast<std::size_t>(reference)] - list.value[static_cast<std::size_t>(i)];
  }
}

// Where edges of A and Q are parallel, as those of homothets are, their rows are dependent: a little slack on
// each makes the weights unique.
bool PieceProgram::solve_system(const double* u, const Objective& objective, PieceList& A, PieceList& Q) {
  return solve_system(u, objective, A, Q, 0) || solve_system(u, objective, A, Q, kSlack);
}

bool PieceProgram::solve_system(const double* u, const Objective& objective, PieceList& A, PieceList& Q,
                                double slack) {
  const int rows_A = n_;
  const int rows_Q = rows_A + A.active_count - 1;
  const int size = rows_Q + Q.active_count - 1;
  columns_ = size + 1;
  ++systems_;
  double* K = system_.data();
  std::fill_n(K, std::ptrdiff_t{size} * columns_, 0.0);
  add_curvature(A, objective.weight_A);
  add_curvature(Q, objective.weight_Q);
  add_differences(A, 1.0, rows_A);
  add_differences(Q, -1.0, rows_Q);
  const double* s_A = A.point(A.active[0]);
  const double* s_Q = Q.point(Q.active[0]);
  double trace = 0, length = 0;
  for (int k = 0; k < n_; ++k) {
    trace += K[k * columns_ + k];
    length += objective.weight_A * std::fabs(s_A[k]) + objective.weight_Q * std::fabs(s_Q[k]);
  }
  // H u = 0: this fixes u·d; and something to divide by where the pieces are flat.
  const double along = std::max(trace, kLeastCurvature * length);
  for (int j = 0; j < n_; ++j) {
    double* row = K + std::ptrdiff_t{j} * columns_;
    for (int k = 0; k < n_; ++k) row[k] += along * u[j] * u[k];
    row[j] += kNoPivot * along;
    row[size] = objective.weight_Q * s_Q[j] - objective.weight_A * s_A[j];
    if (objective.linear != nullptr) row[size] -= objective.linear[j];
  }
  for (int i = n_; slack > 0 && i < size; ++i) {
    const double* row = K + std::ptrdiff_t{i} * columns_;
    K[std::ptrdiff_t{i} * columns_ + i] = -slack * dot(row, row, n_) / along;
  }
  if (!eliminate(size)) return false;
  read_weights(A, objective.weight_A, rows_A);
  read_weights(Q, objective.weight_Q, rows_Q);
  return true;
}

// Gaussian elimination; the solution is left in step_. Without multipliers the matrix is positive definite
// and needs no exchange of rows.
bool PieceProgram::eliminate(int size) {
  const bool definite = size == n_;
  double* K = system_.data();
  double largest = 0;
  for (int i = 0; i < size; ++i) {
    const int end = definite ? i + 1 : size;
    for (int k = definite ? i : 0; k < end; ++k) largest = std::max(largest, std::fabs(K[i * columns_ + k]));
  }
  const double threshold = 1e-3 * kNoPivot * largest;
  for (int p = 0; p < size; ++p) {
    if (!definite) exchange_rows(p, size);
    double* row = K + std::ptrdiff_t{p} * columns_;
    if (!(std::fabs(row[p]) > threshold)) return false;
    const double inverse = 1 / row[p];
    for (int i = p + 1; i < size; ++i) {
      double* other = K + std::ptrdiff_t{i} * columns_;
      const double factor = other[p] * inverse;
      for (int k = p + 1; k <= size; ++k) other[k] -= factor * row[k];
    }
    row[p] = inverse;
  }
  double* x = step_.data();
  bool finite = true;
  for (int p = size - 1; p >= 0; --p) {
    const double* row = K + std::ptrdiff_t{p} * columns_;
    double sum = row[size];
    for (int k = p + 1; k < size; ++k) sum -= row[k] * x[k];
    x[p] = sum * row[p];
    finite = finite && std::isfinite(x[p]);
  }
  return finite;
}

// The largest entry of column p, from row p on, comes to row p.
void PieceProgram::exchange_rows(int p, int size) {
  double* K = system_.data();
  int best = p;
  for (int i = p + 1; i < size; ++i) {
    if (std::fabs(K[std::ptrdiff_t{i} * columns_ + p]) > std::fabs(K[std::ptrdiff_t{best} * columns_ + p]))
      best = i;
  }
  if (best == p) return;
  double* row = K + std::ptrdiff_t{p} * columns_;
  std::swap_ranges(row + p, row + columns_, K + std::ptrdiff_t{best} * columns_ + p);
}

void PieceProgram::read_weights(PieceList& list, double scale, int row) const {
  std::fill_n(list.weight.data(), list.count, 0.0);
  double sum = 0;
  for (int a = 1; a < list.active_count; ++a, ++row) {
    const double weight = step_[static_cast<std::size_t>(row)] / scale;
    list.weight[static_cast<std::size_t>(list.active[static_cast<std::size_t>(a)])] = weight;
    sum += weight;
  }
  list.weight[static_cast<std::size_t>(list.active[0])] = 1 - sum;
}

bool PieceProgram::drop_negative(PieceList& list) const {
  int worst = -1;
  double least = 0;
  for (int a = 0; a < list.active_count; ++a) {
    const double weight = list.weight[static_cast<std::size_t>(list.active[static_cast<std::size_t>(a)])];
    if (weight < least) {
      least = weight;
      worst = a;
    }
  }
  if (worst < 0) return false;
  list.weight[static_cast<std::size_t>(list.active[static_cast<std::size_t>(worst)])] = 0;
  --list.active_count;
  list.active[static_cast<std::size_t>(worst)] = list.active[static_cast<std::size_t>(list.active_count)];
  return true;
}

double PieceProgram::model(const PieceList& list, int i, double sign) const {
  const double* d = step_.data();
  double value = list.value[static_cast<std::size_t>(i)] + sign * dot(list.point(i), d, n_);
  if (!list.curved) return value;
  const double* H = list.hessian(i);
  for (int j = 0; j < n_; ++j) value += 0.5 * d[j] * dot(H + std::ptrdiff_t{j} * n_, d, n_);
  return value;
}

bool PieceProgram::add_violated(PieceList& list, double sign) const {
  if (list.count == list.active_count) return false;
  const double reference = model(list, list.active[0], sign);
  double most = reference + kSlightly * std::fabs(reference);
  int violated = -1;
  for (int i = 0; i < list.count; ++i) {
    const auto end = list.active.data() + list.active_count;
    if (std::find(list.active.data(), end, i) != end) continue;
    const double value = model(list, i, sign);
    if (value > most) {
      most = value;
      violated = i;
    }
  }
  if (violated < 0) return false;
  list.active[static_cast<std::size_t>(list.active_count++)] = violated;
  return true;
}

}  // namespace raygauge
