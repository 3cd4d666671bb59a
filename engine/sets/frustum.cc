// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/frustum.h"

#include <algorithm>
#include <cmath>

#include "engine/sets/vector_kernels.h"

namespace raygauge {
namespace {

// How near the axis a way must pass, as a share of where it began, for the axis to be worth a query.
constexpr double kPassesBy = 0.5;

}  // namespace

// The distances of c from the two planes and from the nappe, which is z -> R(z) = r_b - k z in the half-plane
// of c and the axis.
double Frustum::inner_radius(const double* c) const {
  const auto n = static_cast<int>(base.size());
  const double* a = axis.direction().data();
  Scratch offset(n), radial(n);
  double size = base_radius + top_radius;
  double height = 0;
  for (int k = 0; k < n; ++k) {
    offset.data()[k] = c[k] - base[k];
    size += std::fabs(c[k]) + std::fabs(base[k]) + std::fabs(top[k]);
    height += (top[k] - base[k]) * a[k];
  }
  if (!(height > 0)) return 0;
  const double z = dot(offset.data(), a, n);
  const double away = axis.radial_part(offset.data(), radial.data());
  const double slope = (base_radius - top_radius) / height;
  const double to_nappe = (base_radius - slope * z - away) / std::sqrt(1 + slope * slope);
  return proven_length(std::min({z, height - z, to_nappe}), size, n);
}

template <class Real>
void Frustum::support_pieces(const Real* u, BasicSupportPieces<Real>& pieces) const {
  const auto n = static_cast<int>(base.size());
  const Real* a = axis.components<Real>();
  Real* unit = pieces.point(0);
  Real* H_b = pieces.hessian(0);
  Real* H_t = pieces.hessian(1);
  const Real across = axis.radial_part(u, unit);
  const Real curvature = across > 0 ? 1 / across : Real{0};
  for (int j = 0; j < n; ++j) {
    for (int k = 0; k < n; ++k) {
      const Real projector = (j == k ? 1 : 0) - a[j] * a[k] - unit[j] * unit[k];
      H_b[j * n + k] = base_radius * curvature * projector;
      H_t[j * n + k] = top_radius * curvature * projector;
    }
  }
  for (int k = 0; k < n; ++k) pieces.point(1)[k] = top[k] + top_radius * unit[k];
  for (int k = 0; k < n; ++k) unit[k] = base[k] + base_radius * unit[k];
  pieces.value[0] = dot(u, base.data(), n) + base_radius * across;
  pieces.value[1] = dot(u, top.data(), n) + top_radius * across;
  pieces.count = 2;
}

template <class Real>
bool Frustum::facet_normal(const Real* u, const Real* v, Real* normal) const {
  const auto n = static_cast<int>(base.size());
  const Real* a = axis.components<Real>();
  const Real along_u = dot(u, a, n);
  const Real along_v = dot(v, a, n);
  Real begin = 0, way = 0, progress = 0;  // |u_⊥|², |v_⊥ - u_⊥|², -u_⊥·(v_⊥ - u_⊥)
  for (int k = 0; k < n; ++k) {
    const Real u_k = u[k] - along_u * a[k];
    const Real step_k = v[k] - along_v * a[k] - u_k;
    begin += u_k * u_k;
    way += step_k * step_k;
    progress -= u_k * step_k;
  }
  if (!(progress > 0)) return false;
  const Real t = std::min(Real{1}, progress / way);
  const Real nearest = begin - t * (2 * progress - t * way);
  const Real along = along_u + t * (along_v - along_u);
  const double radius = along > 0 ? top_radius : base_radius;
  if (!(radius > 0) || nearest > kPassesBy * kPassesBy * begin) return false;
  for (int k = 0; k < n; ++k) normal[k] = along > 0 ? a[k] : -a[k];
  return true;
}

template <class Real>
void Frustum::facet_point(const Real* normal, const Real* target, Real* point) const {
  const auto n = static_cast<int>(base.size());
  const bool at_top = dot(normal, axis.components<Real>(), n) > 0;
  const Vector& disc = at_top ? top : base;
  BasicScratch<Real> offset(n);
  for (int k = 0; k < n; ++k) offset.data()[k] = target[k] - disc[k];
  const Real radius = at_top ? top_radius : base_radius;
  const Real away = std::min(axis.radial_part(offset.data(), point), radius);
  for (int k = 0; k < n; ++k) point[k] = disc[k] + away * point[k];
}

template void Frustum::support_pieces(const double*, SupportPieces&) const;
template void Frustum::support_pieces(const Quad*, QuadSupportPieces&) const;
template bool Frustum::facet_normal(const double*, const double*, double*) const;
template bool Frustum::facet_normal(const Quad*, const Quad*, Quad*) const;
template void Frustum::facet_point(const double*, const double*, double*) const;
template void Frustum::facet_point(const Quad*, const Quad*, Quad*) const;

}  // namespace raygauge
