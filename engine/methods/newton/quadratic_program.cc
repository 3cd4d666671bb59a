// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/newton/quadratic_program.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "engine/numerics/vector_kernels.h"

namespace raygauge {
namespace {

template <class Real>
constexpr double kNoPivot = 9 * kRoundoff<Real>;  // of a pivot, relative to the largest entry
template <class Real>
constexpr double kSlightly = 90 * kRoundoff<Real>;  // how far the model of a piece may exceed the maximum
template <class Real>
constexpr double kSlack = 900 * kRoundoff<Real>;  // of dependent equations, relative to the curvature
constexpr double kLeastCurvature = 1e-9;          // added where the pieces have none, relative to the points

// Numbers beyond the range of doubles are as good as infinite here.
template <class Real>
bool is_finite(Real x) {
  return std::isfinite(static_cast<double>(x));
}

}  // namespace

template <class Real>
void QuadraticProgram<Real>::begin(int n) {
  n_ = n;
  systems_ = 0;
}

template <class Real>
const Real* QuadraticProgram<Real>::solve(const Real* u, const Objective& objective, PieceList<Real>& A,
                                          PieceList<Real>& Q) {
  warm_start(A);
  warm_start(Q);
  const int most = n_ + A.count + Q.count;
  const auto room = static_cast<std::size_t>(most);
  system_.reserve(room * (room + 1));
  step_.reserve(room);
  stretch_.reserve(room);
  // The maxima are compared at second order, the active set is held together at first order: where the two
  // disagree the search would go on for ever, and a step that is good for the greatest pieces has to do.
  const int enough = 4 + A.active_count + Q.active_count;
  bool retried = false;
  for (int round = 0; round < enough + 2 * most; ++round) {
    if (!solve_system(u, objective, A, Q)) return nullptr;
    if (drop_negative(A) || drop_negative(Q)) continue;
    if (round >= enough) return step_.data();
    const bool added_A = add_violated(A, 1);
    const bool added_Q = add_violated(Q, -1);
    if (added_A || added_Q) continue;
    // The curvature was that of the weights before, and there was none: what the new ones have is worth a
    // try.
    if (!flat_ || retried) return step_.data();
    retried = true;
  }
  return nullptr;
}

// The active set begins with the pieces that carried weight in the step before, if there was one, and with
// the greatest.
template <class Real>
void QuadraticProgram<Real>::warm_start(PieceList<Real>& list) {
  list.active_count = 0;
  if (list.warm) {
    for (int i = 0; i < list.count; ++i) {
      if (list.weight[static_cast<std::size_t>(i)] > 0) {
        list.active[static_cast<std::size_t>(list.active_count++)] = i;
      }
    }
  }
  if (list.active_count == 0) {
    std::fill_n(list.weight.data(), list.count, Real{0});
    list.weight[static_cast<std::size_t>(list.best)] = 1;
  }
  const auto end = list.active.data() + list.active_count;
  if (std::find(list.active.data(), end, list.best) == end) {
    list.active[static_cast<std::size_t>(list.active_count++)] = list.best;
  }
}

template <class Real>
void QuadraticProgram<Real>::add_curvature(const PieceList<Real>& list, Real weight) {
  if (!list.curved) return;
  for (int a = 0; a < list.active_count; ++a) {
    const int i = list.active[static_cast<std::size_t>(a)];
    const Real share = weight * std::max(list.weight[static_cast<std::size_t>(i)], Real{0});
    const Real* H = list.hessian(i);
    for (int j = 0; j < n_; ++j) {
      Real* row = system_.data() + std::ptrdiff_t{j} * columns_;
      for (int k = 0; k < n_; ++k) row[k] += share * H[j * n_ + k];
    }
  }
}

// Gradients of the active pieces less that of the reference, as rows and as columns, brought to the length
// `along` of what else is in the system: pieces may be as near to each other as they like.
template <class Real>
void QuadraticProgram<Real>::add_differences(const PieceList<Real>& list, int sign, int row, Real along) {
  const int reference = list.active[0];
  const Real* s_0 = list.point(reference);
  for (int a = 1; a < list.active_count; ++a, ++row) {
    const int i = list.active[static_cast<std::size_t>(a)];
    const Real* s_i = list.point(i);
    Real* entries = system_.data() + std::ptrdiff_t{row} * columns_;
    for (int k = 0; k < n_; ++k) entries[k] = sign * (s_i[k] - s_0[k]);
    const Real length = elementary::sqrt(dot(entries, entries, n_));
    const Real stretch = length > 0 ? along / length : Real{1};
    stretch_[static_cast<std::size_t>(row)] = stretch;
    for (int k = 0; k < n_; ++k) {
      entries[k] *= stretch;
      system_.data()[std::ptrdiff_t{k} * columns_ + row] = entries[k];
    }
    entries[columns_ - 1] =
        stretch * (list.value[static_cast<std::size_t>(reference)] - list.value[static_cast<std::size_t>(i)]);
  }
}

// Where edges of A and Q are parallel, as those of homothets are, their rows are dependent: a little slack on
// each makes the weights unique. It stays in quadruple precision, where it is far below any tolerance.
template <class Real>
bool QuadraticProgram<Real>::solve_system(const Real* u, const Objective& objective, PieceList<Real>& A,
                                          PieceList<Real>& Q) {
  const bool edges = A.active_count > 1 && Q.active_count > 1;
  const bool strict = std::is_same_v<Real, double> || !edges;
  return (strict && solve_system(u, objective, A, Q, 0)) || solve_system(u, objective, A, Q, kSlack<Real>);
}

template <class Real>
bool QuadraticProgram<Real>::solve_system(const Real* u, const Objective& objective, PieceList<Real>& A,
                                          PieceList<Real>& Q, Real slack) {
  const int rows_A = n_;
  const int rows_Q = rows_A + A.active_count - 1;
  const int size = rows_Q + Q.active_count - 1;
  columns_ = size + 1;
  ++systems_;
  Real* K = system_.data();
  std::fill_n(K, std::ptrdiff_t{size} * columns_, Real{0});
  add_curvature(A, objective.weight_A);
  add_curvature(Q, objective.weight_Q);
  const Real* s_A = A.point(A.active[0]);
  const Real* s_Q = Q.point(Q.active[0]);
  Real trace = 0, length = 0;
  for (int k = 0; k < n_; ++k) {
    trace += K[k * columns_ + k] * (objective.graded ? u[k] * u[k] : Real{1});
    length += objective.weight_A * elementary::fabs(s_A[k]) + objective.weight_Q * elementary::fabs(s_Q[k]);
  }
  // H u = 0: this fixes u·d; and something to divide by where the pieces are flat.
  flat_ = !(trace > 0);
  const Real along = std::max<Real>(trace, kLeastCurvature * length);
  for (int j = 0; j < n_; ++j) {
    Real* row = K + std::ptrdiff_t{j} * columns_;
    for (int k = 0; k < n_; ++k) row[k] += along * u[j] * u[k];
    row[j] += kNoPivot<Real> * along;
    row[size] = objective.weight_Q * s_Q[j] - objective.weight_A * s_A[j];
    if (objective.linear != nullptr) row[size] -= objective.linear[j];
  }
  add_differences(A, 1, rows_A, along);
  add_differences(Q, -1, rows_Q, along);
  for (int i = n_; i < size; ++i) K[std::ptrdiff_t{i} * columns_ + i] = -slack * along;
  if (!eliminate(size, objective.graded)) return false;
  read_weights(A, objective.weight_A, rows_A);
  read_weights(Q, objective.weight_Q, rows_Q);
  return true;
}

// The systems of R^2 and R^3 have sizes known when compiled.
template <class Real>
bool QuadraticProgram<Real>::eliminate(int size, bool graded) {
  switch (size) {
    case 2:
      return eliminate_sized(std::integral_constant<int, 2>{}, graded);
    case 3:
      return eliminate_sized(std::integral_constant<int, 3>{}, graded);
    case 4:
      return eliminate_sized(std::integral_constant<int, 4>{}, graded);
    case 5:
      return eliminate_sized(std::integral_constant<int, 5>{}, graded);
    default:
      return eliminate_sized(size, graded);
  }
}

// Gaussian elimination; the solution is left in step_. Without multipliers the matrix is positive definite
// and needs no exchange of rows; nor do its pivots change, relative to its diagonal, with the scale of a row
// and its column.
template <class Real>
template <class Size>
bool QuadraticProgram<Real>::eliminate_sized(Size size, bool graded) {
  const bool definite = size == n_;
  const int columns = size + 1;
  Real* K = system_.data();
  Real* x = step_.data();
  Real largest = 0;
  for (int i = 0; i < size; ++i) {
    const int end = definite ? i + 1 : size;
    for (int k = definite ? i : 0; k < end; ++k)
      largest = std::max(largest, elementary::fabs(K[i * columns + k]));
  }
  for (int i = 0; i < size; ++i) x[i] = graded ? K[i * columns + i] : largest;
  for (int p = 0; p < size; ++p) {
    if (!definite) exchange_rows(p, size);
    Real* row = K + p * columns;
    if (!(elementary::fabs(row[p]) > Real{1e-3} * kNoPivot<Real> * x[p])) return false;
    const Real inverse = 1 / row[p];
    for (int i = p + 1; i < size; ++i) {
      Real* other = K + i * columns;
      const Real factor = other[p] * inverse;
      for (int k = p + 1; k <= size; ++k) other[k] -= factor * row[k];
    }
    row[p] = inverse;
  }
  bool finite = true;
  for (int p = size - 1; p >= 0; --p) {
    const Real* row = K + p * columns;
    Real sum = row[size];
    for (int k = p + 1; k < size; ++k) sum -= row[k] * x[k];
    x[p] = sum * row[p];
    finite = finite && is_finite(x[p]);
  }
  return finite;
}

// The largest entry of column p, from row p on, comes to row p.
template <class Real>
void QuadraticProgram<Real>::exchange_rows(int p, int size) {
  Real* K = system_.data();
  int best = p;
  for (int i = p + 1; i < size; ++i) {
    if (elementary::fabs(K[std::ptrdiff_t{i} * columns_ + p]) >
        elementary::fabs(K[std::ptrdiff_t{best} * columns_ + p]))
      best = i;
  }
  if (best == p) return;
  Real* row = K + std::ptrdiff_t{p} * columns_;
  std::swap_ranges(row + p, row + columns_, K + std::ptrdiff_t{best} * columns_ + p);
}

template <class Real>
void QuadraticProgram<Real>::read_weights(PieceList<Real>& list, Real scale, int row) const {
  std::fill_n(list.weight.data(), list.count, Real{0});
  Real sum = 0;
  for (int a = 1; a < list.active_count; ++a, ++row) {
    const Real weight =
        step_[static_cast<std::size_t>(row)] * stretch_[static_cast<std::size_t>(row)] / scale;
    list.weight[static_cast<std::size_t>(list.active[static_cast<std::size_t>(a)])] = weight;
    sum += weight;
  }
  list.weight[static_cast<std::size_t>(list.active[0])] = 1 - sum;
}

template <class Real>
bool QuadraticProgram<Real>::drop_negative(PieceList<Real>& list) const {
  int worst = -1;
  Real least = 0;
  for (int a = 0; a < list.active_count; ++a) {
    const Real weight = list.weight[static_cast<std::size_t>(list.active[static_cast<std::size_t>(a)])];
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

template <class Real>
Real QuadraticProgram<Real>::model(const PieceList<Real>& list, int i, int sign) const {
  const Real* d = step_.data();
  Real value = list.value[static_cast<std::size_t>(i)] + sign * dot(list.point(i), d, n_);
  if (!list.curved) return value;
  const Real* H = list.hessian(i);
  for (int j = 0; j < n_; ++j) value += 0.5 * d[j] * dot(H + std::ptrdiff_t{j} * n_, d, n_);
  return value;
}

template <class Real>
bool QuadraticProgram<Real>::add_violated(PieceList<Real>& list, int sign) const {
  if (list.count == list.active_count) return false;
  const Real reference = model(list, list.active[0], sign);
  Real most = reference + kSlightly<Real> * elementary::fabs(reference);
  int violated = -1;
  for (int i = 0; i < list.count; ++i) {
    const auto end = list.active.data() + list.active_count;
    if (std::find(list.active.data(), end, i) != end) continue;
    const Real value = model(list, i, sign);
    if (value > most) {
      most = value;
      violated = i;
    }
  }
  if (violated < 0) return false;
  list.active[static_cast<std::size_t>(list.active_count++)] = violated;
  return true;
}

template class QuadraticProgram<double>;
template class QuadraticProgram<Quad>;

}  // namespace raygauge
