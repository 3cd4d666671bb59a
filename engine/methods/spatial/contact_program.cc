// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/contact_program.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/double_double.h"
#include "engine/numerics/fused.h"

namespace raygauge {
namespace {

// The weights for which the pieces of `step` are equally high after it. False where their slopes are as good
// as dependent.
template <class Real>
bool solve_active(const ContactPiece<Real>* pieces, ContactStep<Real>& step) {
  constexpr double kDependent = 1e-24;  // of squared sines
  const ContactPiece<Real>& first = pieces[step.piece[0]];
  Real e[2][2], rise[2];
  for (int i = 1; i < step.count; ++i) {
    const ContactPiece<Real>& other = pieces[step.piece[i]];
    rise[i - 1] = other.height - first.height;
    for (int k = 0; k < 2; ++k) e[i - 1][k] = other.slope[k] - first.slope[k];
  }
  step.y[0] = -first.slope[0];
  step.y[1] = -first.slope[1];
  if (step.count == 2) {
    const Real square = e[0][0] * e[0][0] + e[0][1] * e[0][1];
    if (!(rounded(square) > 0)) return false;
    const Real c = (rise[0] + step.y[0] * e[0][0] + step.y[1] * e[0][1]) / square;
    step.weight[1] = c;
    for (int k = 0; k < 2; ++k) step.y[k] = step.y[k] - c * e[0][k];
  } else if (step.count == 3) {
    const Real det = e[0][0] * e[1][1] - e[0][1] * e[1][0];
    const double size =
        rounded(e[0][0] * e[0][0] + e[0][1] * e[0][1]) * rounded(e[1][0] * e[1][0] + e[1][1] * e[1][1]);
    if (!(rounded(det) * rounded(det) > kDependent * size)) return false;
    const Real y0 = (rise[1] * e[0][1] - rise[0] * e[1][1]) / det;
    const Real y1 = (rise[0] * e[1][0] - rise[1] * e[0][0]) / det;
    const Real r0 = step.y[0] - y0, r1 = step.y[1] - y1;
    step.weight[1] = (r0 * e[1][1] - r1 * e[1][0]) / det;
    step.weight[2] = (r1 * e[0][0] - r0 * e[0][1]) / det;
    step.y[0] = y0;
    step.y[1] = y1;
  }
  Real rest{1};
  for (int i = 1; i < step.count; ++i) rest = rest - step.weight[i];
  step.weight[0] = rest;
  return true;
}

// Σ c h - |Σ c g|²/2, which the best weights make greatest.
double dual_value(const ContactPiece<double>* pieces, const ContactStep<double>& step) {
  double value = -0.5 * (step.y[0] * step.y[0] + step.y[1] * step.y[1]);
  for (int i = 0; i < step.count; ++i) value += step.weight[i] * pieces[step.piece[i]].height;
  return value;
}

// The best of the active sets that hold `entering` and pieces of `step`; false if none is better.
bool exchange(const ContactPiece<double>* pieces, int entering, ContactStep<double>& step) {
  const ContactStep<double> before = step;
  double best = dual_value(pieces, before);
  bool better = false;
  for (int chosen = 0; chosen < 1 << before.count; ++chosen) {
    ContactStep<double> trial;
    for (int i = 0; i < before.count; ++i) {
      if ((chosen >> i & 1) != 0 && trial.count < 2) trial.piece[trial.count++] = before.piece[i];
    }
    trial.piece[trial.count++] = entering;
    if (!solve_active(pieces, trial)) continue;
    const double value = dual_value(pieces, trial);
    if (*std::min_element(trial.weight, trial.weight + trial.count) < 0 || !(value > best)) continue;
    best = value;
    step = trial;
    better = true;
  }
  return better;
}

ContactStep<double> find_active(const ContactPiece<double>* pieces, int count) {
  constexpr double kNoise = 1e-15;
  ContactStep<double> step;
  step.count = 1;
  for (int i = 1; i < count; ++i) {
    if (pieces[i].height > pieces[step.piece[0]].height) step.piece[0] = i;
  }
  solve_active(pieces, step);
  for (int rounds = 0; rounds < 2 * kMostContactPieces; ++rounds) {
    const auto after = [&](int i) {
      return pieces[i].height + pieces[i].slope[0] * step.y[0] + pieces[i].slope[1] * step.y[1];
    };
    int highest = step.piece[0];
    for (int i = 0; i < count; ++i) {
      if (after(i) > after(highest)) highest = i;
    }
    const double size = std::fabs(pieces[highest].slope[0] * step.y[0]) +
                        std::fabs(pieces[highest].slope[1] * step.y[1]) + std::fabs(pieces[highest].height);
    if (!(after(highest) - after(step.piece[0]) > kNoise * size)) break;
    if (!exchange(pieces, highest, step)) break;
  }
  return step;
}

template <class Real>
ContactStep<Real> contact_step_of(const ContactPiece<Real>* pieces, int count) {
  ContactPiece<double> near[kMostContactPieces];
  int top = 0;
  for (int i = 1; i < count; ++i) {
    if (pieces[i].height > pieces[top].height) top = i;
  }
  for (int i = 0; i < count; ++i) {
    near[i].height = rounded(pieces[i].height - pieces[top].height);
    for (int k = 0; k < 2; ++k) near[i].slope[k] = rounded(pieces[i].slope[k]);
  }
  const ContactStep<double> found = find_active(near, count);
  if constexpr (kIsDouble<Real>) return found;
  ContactStep<Real> step;
  step.count = found.count;
  std::copy_n(found.piece, 3, step.piece);
  if (!solve_active(pieces, step)) {
    for (int i = 0; i < found.count; ++i) step.weight[i] = Real{found.weight[i]};
    for (int k = 0; k < 2; ++k) step.y[k] = Real{found.y[k]};
  }
  return step;
}

// The weight c of the second piece makes  c (h_1 - h_0) - |g_0 + c (g_1 - g_0)|²/2  greatest.
ContactStep<double> step_of_two(const ContactPiece<double>* pieces) {
  const double *g0 = pieces[0].slope, *g1 = pieces[1].slope;
  const double e[2] = {g1[0] - g0[0], g1[1] - g0[1]};
  const double square = e[0] * e[0] + e[1] * e[1], rise = pieces[1].height - pieces[0].height;
  const double gain = rise - (g0[0] * e[0] + g0[1] * e[1]);
  ContactStep<double> step;
  const bool both = gain > 0 && gain < square;
  const double c = both ? gain / square : (gain > 0 ? 1.0 : 0.0);
  step.count = both ? 2 : 1;
  step.piece[0] = both || !(gain > 0) ? 0 : 1;
  step.piece[1] = 1;
  step.weight[0] = both ? 1 - c : 1.0;
  step.weight[1] = c;
  for (int k = 0; k < 2; ++k) step.y[k] = -(g0[k] + c * e[k]);
  return step;
}

}  // namespace

TangentMetric::TangentMetric(const Vector3& u, const Matrix3& H, double lambda) {
  tangent[0] = any_orthogonal(u);
  tangent[1] = cross(u, tangent[0]);
  const Vector3 H0 = H * tangent[0], H1 = H * tangent[1];
  const double h[3] = {dot(tangent[0], H0), dot(tangent[0], H1), dot(tangent[1], H1)};
  factorise(h, lambda);
}

TangentMetric::TangentMetric(const Vector3& t0, const Vector3& t1, const double* h, double lambda)
    : tangent{t0, t1} {
  factorise(h, lambda);
}

void TangentMetric::factorise(const double* h, double lambda) {
  const double a = h[0] + lambda, b = h[1], c = h[2] + lambda;
  trace = a + c;
  inverse[0] = 1 / std::sqrt(std::max(a, 1e-15 * trace));
  below = b * inverse[0];
  inverse[1] = 1 / std::sqrt(std::max(c - below * below, 1e-15 * trace));
}

template <>
ContactStep<double> contact_step(const ContactPiece<double>* pieces, int count) {
  if (count == 1) {
    ContactStep<double> step;
    step.count = 1;
    step.weight[0] = 1;
    for (int k = 0; k < 2; ++k) step.y[k] = -pieces->slope[k];
    return step;
  }
  if (count == 2) return step_of_two(pieces);
  return contact_step_of<double>(pieces, count);
}

template <>
RAYGAUGE_FUSED ContactStep<DoubleDouble> contact_step(const ContactPiece<DoubleDouble>* pieces, int count) {
  return contact_step_of<DoubleDouble>(pieces, count);
}

}  // namespace raygauge
