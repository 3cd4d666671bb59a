// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Orthogonal factors that gain and lose columns. Part of kernel_impl.h. Vectors are padded to whole blocks of
// kLanes with zeros, and begin at cache lines.
#pragma once

#include "engine/kernels/gram_kernels.h"
#include "engine/kernels/pack.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

// One block of modified Gram-Schmidt: the products of C columns with p are taken together.
template <int C>
inline void project_columns(const double* Q, std::ptrdiff_t ld, double* p, double* coefficients) {
  Pack sum[C] = {};
  for (std::ptrdiff_t r = 0; r < ld; r += kWidth) {
    const Pack value = load(p + r);
    for (int j = 0; j < C; ++j) sum[j] = multiply_add(load(Q + j * ld + r), value, sum[j]);
  }
  Pack share[C];
  for (int j = 0; j < C; ++j) {
    const double c = reduce_lanes(sum[j], [](Pack a, Pack b) { return a + b; })[0];
    coefficients[j] += c;
    share[j] = broadcast(-c);
  }
  for (std::ptrdiff_t r = 0; r < ld; r += kWidth) {
    Pack value = load(p + r);
    for (int j = 0; j < C; ++j) value = multiply_add(load(Q + j * ld + r), share[j], value);
    store(p + r, value);
  }
}

void project_out(const double* Q, std::ptrdiff_t ld, int count, double* p, double* coefficients) {
  int j = 0;
  for (; j + 4 <= count; j += 4) project_columns<4>(Q + j * ld, ld, p, coefficients + j);
  for (; j < count; ++j) project_columns<1>(Q + j * ld, ld, p, coefficients + j);
}

void rotate(double* a, double* b, std::ptrdiff_t length, double cosine, double sine) {
  const Pack c = broadcast(cosine);
  const Pack s = broadcast(sine);
  for (std::ptrdiff_t r = 0; r < length; r += kWidth) {
    const Pack x = load(a + r);
    const Pack y = load(b + r);
    store(a + r, c * x + s * y);
    store(b + r, c * y - s * x);
  }
}

double add_multiple(double* v, const double* w, std::ptrdiff_t length, double s) {
  const Pack share = broadcast(s);
  Pack largest{};
  for (std::ptrdiff_t r = 0; r < length; r += kWidth) {
    const Pack x = multiply_add(load(w + r), share, load(v + r));
    store(v + r, x);
    largest = maximum(magnitude(x), largest);
  }
  return largest_lane(largest);
}

// R in rows, zero left of the diagonal, so that a row may be read from the block that holds its diagonal on.
void back_substitute(const double* R, std::ptrdiff_t ld, int count, double* x) {
  const std::ptrdiff_t end = (count + kLanes - 1) / kLanes * kLanes;
  for (int i = count; i < end; ++i) x[i] = 0;
  for (int i = count - 1; i >= 0; --i) {
    const double* row = R + i * ld;
    const double right = x[i];
    x[i] = 0;
    Pack sum{};
    for (std::ptrdiff_t r = i / kLanes * kLanes; r < end; r += kWidth)
      sum = multiply_add(load(row + r), load(x + r), sum);
    x[i] = (right - reduce_lanes(sum, [](Pack a, Pack b) { return a + b; })[0]) / row[i];
  }
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
