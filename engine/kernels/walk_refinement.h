// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// What a walk has found in single precision, refined in double. Part of kernel_impl.h.
#pragma once

#include "engine/kernels/walk_columns.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

// R v.
template <int N>
inline Sixteen multiply(const FacetWalk& walk, int dimension, const float* v, std::ptrdiff_t stride) {
  const int n = N > 0 ? N : dimension;
  constexpr int kPoints = Vec<float>::kPoints;
  Sixteen even;
  Sixteen odd;
  int k = 0;
  for (; k + 1 < n; k += 2) {
    even.add(v[k * stride], Sixteen::at(walk.R + k * kPoints));
    odd.add(v[(k + 1) * stride], Sixteen::at(walk.R + (k + 1) * kPoints));
  }
  if (k < n) even.add(v[k * stride], Sixteen::at(walk.R + k * kPoints));
  for (int t = 0; t < kPacksPerBlock; ++t) even.part[t] += odd.part[t];
  return even;
}

// 16 numbers in double.
struct SixteenDoubles {
  static constexpr int kPacks = 16 / kWidth;
  Pack part[kPacks] = {};

  template <class Real>
  static SixteenDoubles at(const Real* p) {
    SixteenDoubles s;
    for (int t = 0; t < kPacks; ++t) s.part[t] = load_wide(p + t * kWidth);
    return s;
  }
  void to(double* p) const {
    for (int t = 0; t < kPacks; ++t) store(p + t * kWidth, part[t]);
  }
  void add(double s, const SixteenDoubles& v) {
    for (int t = 0; t < kPacks; ++t) part[t] += s * v.part[t];
  }
  double dot(const SixteenDoubles& v) const {
    Pack sum = part[0] * v.part[0];
    for (int t = 1; t < kPacks; ++t) sum += part[t] * v.part[t];
    return reduce_lanes(sum, [](Pack a, Pack b) { return a + b; })[0];
  }
};

// Basic column i.
inline const double* point_of(const FacetWalkPoints& points, const FacetWalk& walk, int i) {
  return points.points + static_cast<std::ptrdiff_t>(points.order[walk.id[i]]) * 16;
}

// b - B x.
inline SixteenDoubles rest_of(const FacetWalkPoints& points, const FacetWalk& walk, int n) {
  SixteenDoubles rest = SixteenDoubles::at(walk.wanted);
  for (int i = 0; i < n; ++i) rest.add(-walk.share[i], SixteenDoubles::at(point_of(points, walk, i)));
  return rest;
}

// R += (I - R B) R, in single precision.
template <int N>
inline void improve_inverse(const FacetWalkPoints& points, int dimension, FacetWalk* walk) {
  const int n = N > 0 ? N : dimension;
  Sixteen errors[16];
  for (int j = 0; j < n; ++j) {
    const double* point = point_of(points, *walk, j);
    alignas(64) float numbers[16] = {};
    for (int k = 0; k < n; ++k) numbers[k] = static_cast<float>(-point[k]);
    Sixteen error = multiply<N>(*walk, n, numbers, 1);
    error.to(numbers);
    numbers[j] += 1;
    errors[j] = Sixteen::at(numbers);
  }
  for (int k = 0; k < n; ++k) {
    Sixteen R = Sixteen::at(walk->R + k * 16);
    alignas(64) float old[16];
    R.to(old);
    for (int j = 0; j < n; ++j) R.add(old[j], errors[j]);
    R.to(walk->R + k * 16);
  }
}

// Two steps of iterative refinement of x and of y, in double by the inverse in single precision.
template <int N>
inline void refine_walk(const FacetWalkPoints& points, int dimension, FacetWalk* walk) {
  const int n = N > 0 ? N : dimension;
  alignas(64) double numbers[16] = {};
  SixteenDoubles x = SixteenDoubles::at(walk->x);
  SixteenDoubles y = SixteenDoubles::at(walk->y);
  double drift = 0;
  for (int step = 0; step < 2; ++step) {
    x.to(walk->share);
    rest_of(points, *walk, n).to(numbers);
    for (int k = 0; k < n; ++k) x.add(numbers[k], SixteenDoubles::at(walk->R + k * 16));
    for (int i = 0; i < n; ++i) {
      const double error = 1 - y.dot(SixteenDoubles::at(point_of(points, *walk, i)));
      drift = step == 0 && absolute(error) > drift ? absolute(error) : drift;
      numbers[i] = error;
    }
    const SixteenDoubles errors = SixteenDoubles::at(numbers);
    for (int k = 0; k < n; ++k) walk->dual[k] = errors.dot(SixteenDoubles::at(walk->R + k * 16));
    for (int t = 0; t < SixteenDoubles::kPacks; ++t) y.part[t] += load(walk->dual + t * kWidth);
  }
  y.to(walk->dual);
  for (Pack& part : x.part) part = part > Pack{} ? part : Pack{};
  x.to(walk->share);
  rest_of(points, *walk, n).to(walk->rest);
  constexpr double kDrifted = 1e-5;
  if (drift > kDrifted) improve_inverse<N>(points, n, walk);
  for (int k = 0; k < n; ++k) walk->y[k] = static_cast<float>(walk->dual[k]);
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
