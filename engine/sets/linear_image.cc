// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/linear_image.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/double_double.h"
#include "engine/numerics/floating_point.h"
#include "engine/numerics/vector_kernels.h"
#include "engine/sets/bounded_inverse.h"
#include "engine/sets/capability_queries.h"
#include "engine/sets/set_sums.h"

namespace raygauge {
namespace {

// Of sums of n products in double-double arithmetic, relative to the sizes of what is added; more than they
// lose.
constexpr double kTwofold = 0x1p-90;

constexpr double kRoundedUp = 1 + 0x1p-50;
constexpr double kRoundedDown = 1 - 0x1p-50;

// M x, where x has its entries `stride` numbers apart.
template <class Real>
void map_linearly(const LinearMap& map, const Real* x, int stride, Real* image) noexcept {
  const int n = map.n;
  std::fill_n(image, n, Real{0});
  for (int j = 0; j < n; ++j) {
    const double* column = map.M + std::ptrdiff_t{j} * n;
    for (int k = 0; k < n; ++k) image[k] += x[std::ptrdiff_t{j} * stride] * column[k];
  }
}

// Mᵀu.
template <class Real>
void map_back(const LinearMap& map, const Real* u, Real* inner) noexcept {
  const int n = map.n;
  for (int j = 0; j < n; ++j) inner[j] = dot(u, map.M + std::ptrdiff_t{j} * n, n);
}

void apply(const LinearMap& map, const double* x, double* image) noexcept {
  map_linearly(map, x, 1, image);
  for (int k = 0; k < map.n; ++k) image[k] += map.t[k];
}

bool is_translated(const LinearMap& map) noexcept {
  return !std::all_of(map.t, map.t + map.n, [](double t_k) { return t_k == 0; });
}

bool has_inverse(const LinearMap& map) noexcept {
  return map.inverse == nullptr || map.inverse->inverse().size() > 0;
}

// A lower bound on min |M z|/|z|.
double least_stretch(const LinearMap& map) noexcept {
  return map.inverse != nullptr ? map.inverse->least_stretch() : (1 - map.defect) * kRoundedDown;
}

// M⁻¹ image, to the precision of the approximate inverse.
template <class Real>
void divide(const LinearMap& map, const Real* image, Real* x) noexcept {
  const int n = map.n;
  if (map.inverse == nullptr) {
    map_back(map, image, x);
    return;
  }
  std::fill_n(x, n, Real{0});
  for (int k = 0; k < n; ++k) {
    const double* column = map.inverse->inverse().col(k).data();
    for (int i = 0; i < n; ++i) x[i] += image[k] * column[i];
  }
}

// M⁻¹ image, refined once: the error of the approximate inverse is squared.
template <class Real>
void find_preimage(const LinearMap& map, const Real* image, Real* x) noexcept {
  const int n = map.n;
  BasicScratch<Real> rest(n), correction(n);
  divide(map, image, x);
  map_linearly(map, x, 1, rest.data());
  for (int k = 0; k < n; ++k) rest.data()[k] = image[k] - rest.data()[k];
  divide(map, rest.data(), correction.data());
  for (int k = 0; k < n; ++k) x[k] += correction.data()[k];
}

// M⁻ᵀ inner, the normal of the image where S has the normal `inner`; refined likewise.
template <class Real>
void map_normal(const LinearMap& map, const Real* inner, Real* normal) noexcept {
  const int n = map.n;
  const auto divide_transposed = [&](const Real* v, Real* w) {
    if (map.inverse == nullptr) {
      map_linearly(map, v, 1, w);
    } else {
      for (int k = 0; k < n; ++k) w[k] = dot(v, map.inverse->inverse().col(k).data(), n);
    }
  };
  BasicScratch<Real> rest(n), correction(n);
  divide_transposed(inner, normal);
  map_back(map, normal, rest.data());
  for (int k = 0; k < n; ++k) rest.data()[k] = inner[k] - rest.data()[k];
  divide_transposed(rest.data(), correction.data());
  for (int k = 0; k < n; ++k) normal[k] += correction.data()[k];
}

// An upper bound on |M⁻¹(image - t) - x| = |M⁻¹r|, r = image - t - M x in double-double arithmetic.
double preimage_error(const LinearMap& map, const double* image, const double* x) {
  const int n = map.n;
  if (map.reverses_axes && !is_translated(map)) return 0;
  Scratch residual(n), zero(n);
  double rounding = kUnderflow;
  for (int k = 0; k < n; ++k) {
    DoubleDouble r = two_sum(image[k], -map.t[k]);
    double size = std::fabs(image[k]) + std::fabs(map.t[k]);
    for (int j = 0; j < n; ++j) {
      const double M_kj = map.M[std::ptrdiff_t{j} * n + k];
      r = r - two_product(M_kj, x[j]);
      size += std::fabs(M_kj * x[j]);
    }
    residual.data()[k] = r.rounded();
    zero.data()[k] = 0;
    rounding += std::fabs(residual.data()[k]) * 0x1p-52 + n * kTwofold * size;
  }
  const double of_residual = map.inverse != nullptr
                                 ? map.inverse->image_length(residual.data(), zero.data())
                                 : length(residual.data(), n) * (1 + 2 * map.defect) * kRoundedUp;
  return (of_residual + rounding / least_stretch(map)) * kRoundedUp;
}

}  // namespace

double LinearImage::do_support(const double* u, double* point) const {
  const int n = dimension();
  Scratch direction(n), x(n);
  map_back(map_, u, direction.data());
  const double value = S_->support_unchecked(direction.data(), x.data());
  apply(map_, x.data(), point);
  return value + dot(u, map_.t, n);
}

void LinearImage::do_center(double* point) const {
  Scratch x(dimension());
  S_->center_unchecked(x.data());
  apply(map_, x.data(), point);
}

// Twice: the products with M lose as much again as S does.
void LinearImage::do_magnitude(double* magnitude) const {
  const int n = dimension();
  Scratch inner(n);
  S_->magnitude_unchecked(inner.data());
  for (int k = 0; k < n; ++k) {
    magnitude[k] = std::fabs(map_.t[k]);
    for (int j = 0; j < n; ++j) {
      magnitude[k] += 2 * std::fabs(map_.M[std::ptrdiff_t{j} * n + k]) * inner.data()[j];
    }
  }
}

// The ball around the preimage of c is the ball around x less their distance.
double LinearImage::do_inner_radius(const double* c) const {
  const int n = dimension();
  if (!has_inverse(map_)) return 0;
  Scratch shifted(n), x(n);
  for (int k = 0; k < n; ++k) shifted.data()[k] = c[k] - map_.t[k];
  divide(map_, shifted.data(), x.data());
  const double radius = S_->inner_radius_unchecked(x.data()) - preimage_error(map_, c, x.data());
  return radius > 0 ? radius * least_stretch(map_) * kRoundedDown : 0.0;
}

bool LinearImage::has_flat_faces() const noexcept { return S_->flat_faces() != nullptr && has_inverse(map_); }

bool LinearImage::has_gauge() const noexcept {
  return S_->gauge() != nullptr && has_inverse(map_) && !is_translated(map_);
}

bool LinearImage::has_symmetry() const noexcept { return map_.exchanges_axes && S_->symmetry() != nullptr; }

template <class Real>
void LinearImage::list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const {
  const int n = dimension();
  BasicScratch<Real> direction(n), column(n);
  Real* v = column.data();
  map_back(map_, u, direction.data());
  // A Hessian that is graded along S's axes is not along others.
  pieces.graded = pieces.graded && map_.exchanges_axes;
  support_pieces(*S_, direction.data(), pieces, SupportPieces::kCapacity - capacity);
  const Real shift = dot(u, map_.t, n);
  for (int i = 0; i < pieces.count; ++i) {
    pieces.value[static_cast<std::size_t>(i)] += shift;
    map_linearly(map_, pieces.point(i), 1, v);
    for (int k = 0; k < n; ++k) pieces.point(i)[k] = v[k] + map_.t[k];
    Real* H = pieces.hessian(i);  // becomes M H Mᵀ: columns first, then rows
    for (int j = 0; j < n; ++j) {
      map_linearly(map_, H + std::ptrdiff_t{j} * n, 1, v);
      std::copy_n(v, n, H + std::ptrdiff_t{j} * n);
    }
    for (int j = 0; j < n; ++j) {
      map_linearly(map_, H + j, n, v);
      for (int k = 0; k < n; ++k) H[std::ptrdiff_t{k} * n + j] = v[k];
    }
  }
}

// A direction u of the image is Mᵀu for S.
template <class Real>
bool LinearImage::find_normal(const Real* u, const Real* v, Real* normal) const {
  const int n = dimension();
  BasicScratch<Real> from(n), to(n), inner(n);
  map_back(map_, u, from.data());
  map_back(map_, v, to.data());
  if (!facet_normal(*S_, from.data(), to.data(), inner.data())) return false;
  map_normal(map_, inner.data(), normal);
  return true;
}

// Nearest before the map, not after it.
template <class Real>
void LinearImage::find_point(const Real* normal, const Real* target, Real* point) const {
  const int n = dimension();
  BasicScratch<Real> inner_normal(n), shifted(n), inner(n);
  map_back(map_, normal, inner_normal.data());
  for (int k = 0; k < n; ++k) shifted.data()[k] = target[k] - map_.t[k];
  find_preimage(map_, shifted.data(), inner.data());
  S_->flat_faces()->point(inner_normal.data(), inner.data(), shifted.data());
  map_linearly(map_, shifted.data(), 1, point);
  for (int k = 0; k < n; ++k) point[k] += map_.t[k];
}

// gauge_S(M⁻¹x) <= gauge_S(y) + |M⁻¹x - y|/R_S, R_S the radius of a ball around the origin inside S.
double LinearImage::do_gauge(const double* x, double* normal) const {
  const int n = dimension();
  Scratch inner(n), inner_normal(n);
  divide(map_, x, inner.data());
  const double gauge = S_->gauge()->bound(inner.data(), inner_normal.data());
  if (!(gauge < kInfinity)) return kInfinity;
  map_normal(map_, inner_normal.data(), normal);
  const double astray = preimage_error(map_, x, inner.data());
  if (astray == 0) return gauge;
  std::fill_n(inner_normal.data(), n, 0.0);
  const double radius = S_->inner_radius_unchecked(inner_normal.data());
  const double bound = (gauge + astray / radius) * kRoundedUp;
  return radius > 0 && bound < kInfinity ? bound : kInfinity;
}

bool LinearImage::do_quad_gauge_normal(const Quad* x, Quad* normal) const {
  BasicScratch<Quad> inner(dimension()), inner_normal(dimension());
  find_preimage(map_, x, inner.data());
  if (!S_->gauge()->normal(inner.data(), inner_normal.data())) return false;
  map_normal(map_, inner_normal.data(), normal);
  return true;
}

// Without a rounding error only where the axes keep their lengths or are scaled alike: M⁻ᵀ is then M, but for
// a factor.
bool LinearImage::do_touches_origin(double* u) const {
  const int n = dimension();
  if (!map_.exchanges_axes) return false;
  Scratch inner(n);
  if (!S_->gauge()->touches_origin(inner.data())) return false;
  double scale = 0;
  for (int j = 0; j < n; ++j) {
    for (int k = 0; k < n; ++k) {
      const double entry = map_.M[std::ptrdiff_t{j} * n + k];
      if (entry == 0) continue;
      if (scale == 0) scale = std::fabs(entry);
      if (std::fabs(entry) != scale) return false;
      u[k] = std::copysign(1.0, entry) * inner.data()[j];
    }
  }
  return true;
}

// The face [c_j - e_j, c_j + e_j] of S is [m c_j + t_k ± |m| e_j] here, and the computed centre is off by
// rounding.
bool LinearImage::do_is_unconditional(double* extent) const {
  const int n = dimension();
  Scratch inner(n), center(n);
  if (!is_unconditional(*S_, inner.data())) return false;
  S_->center_unchecked(center.data());
  for (int j = 0; j < n; ++j) {
    for (int k = 0; k < n; ++k) {
      const double m = map_.M[std::ptrdiff_t{j} * n + k];
      if (m == 0) continue;
      const double e = std::fabs(m) * inner.data()[j], moved = m * center.data()[j];
      const double of_products =
          map_.reverses_axes ? 0.0 : 2 * kUnitRoundoff * (std::fabs(e) + std::fabs(moved)) + kUnderflow;
      extent[k] = e - of_products - rounding_of_sum(moved, map_.t[k]);
    }
  }
  return true;
}

template void LinearImage::list_pieces(const double*, SupportPieces&, int) const;
template void LinearImage::list_pieces(const Quad*, QuadSupportPieces&, int) const;
template bool LinearImage::find_normal(const double*, const double*, double*) const;
template bool LinearImage::find_normal(const Quad*, const Quad*, Quad*) const;
template void LinearImage::find_point(const double*, const double*, double*) const;
template void LinearImage::find_point(const Quad*, const Quad*, Quad*) const;

}  // namespace raygauge
