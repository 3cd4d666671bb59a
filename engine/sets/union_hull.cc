// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/operations.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

#include "engine/numerics/floating_point.h"
#include "engine/numerics/vector_kernels.h"
#include "engine/sets/capability_queries.h"
#include "engine/sets/combined_view.h"
#include "engine/sets/parameters.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

using Sets = std::span<const std::shared_ptr<const ConvexSet>>;

class UnionView final : public CombinedView<UnionView> {
 public:
  explicit UnionView(Sets sets) : CombinedView(sets.front()->dimension()), sets_(sets) {}

  bool is_smooth() const noexcept;
  bool has_flat_faces() const noexcept;
  bool has_gauge() const noexcept;
  bool has_symmetry() const noexcept;
  template <class Real>
  void list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const;
  template <class Real>
  bool find_normal(const Real* u, const Real* v, Real* normal) const;
  template <class Real>
  void find_point(const Real* normal, const Real* target, Real* point) const;

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  SupportStructure do_structure() const noexcept override;
  double do_gauge(const double* x, double* normal) const override;
  bool do_quad_gauge_normal(const Quad* x, Quad* normal) const override;
  bool do_touches_origin(double* u) const override;
  bool do_is_unconditional(double* extent) const override;

  template <class Real>
  const ConvexSet& outermost(const Real* u) const;

  Sets sets_;
};

int dimension_of_first(Sets sets) {
  if (sets.empty()) throw EmptySetError("hull of a union: needs at least one set");
  return checked_set("hull of a union", "set 0", sets.front())->dimension();
}

double UnionView::do_support(const double* u, double* point) const {
  Scratch other(dimension());
  double best = sets_.front()->support_unchecked(u, point);
  for (std::size_t i = 1; i < sets_.size(); ++i) {
    const double value = sets_[i]->support_unchecked(u, other.data());
    if (value > best) {
      best = value;
      std::copy_n(other.data(), dimension(), point);
    }
  }
  return best;
}

void UnionView::do_center(double* point) const {
  Scratch one(dimension());
  const auto count = static_cast<double>(sets_.size());
  std::fill_n(point, dimension(), 0.0);
  for (const auto& set : sets_) {
    set->center_unchecked(one.data());
    for (int k = 0; k < dimension(); ++k) point[k] += one.data()[k] / count;
  }
}

void UnionView::do_magnitude(double* magnitude) const {
  Scratch one(dimension());
  std::fill_n(magnitude, dimension(), 0.0);
  for (const auto& set : sets_) {
    set->magnitude_unchecked(one.data());
    for (int k = 0; k < dimension(); ++k) magnitude[k] = std::max(magnitude[k], one.data()[k]);
  }
}

double UnionView::do_inner_radius(const double* c) const {
  double radius = 0;
  for (const auto& set : sets_) radius = std::max(radius, set->inner_radius_unchecked(c));
  return radius;
}

SupportStructure UnionView::do_structure() const noexcept {
  SupportStructure hull = sets_.front()->structure();
  for (const auto& set : sets_) hull = structure_of_sum(hull, set->structure());
  return hull == SupportStructure::point ? SupportStructure::polytope : hull;
}

bool UnionView::is_smooth() const noexcept {
  const auto has = [](const auto& set) { return set->smooth() != nullptr; };
  return std::all_of(sets_.begin(), sets_.end(), has);
}

bool UnionView::has_flat_faces() const noexcept {
  const auto has = [](const auto& set) { return set->flat_faces() != nullptr; };
  return std::any_of(sets_.begin(), sets_.end(), has);
}

bool UnionView::has_gauge() const noexcept {
  const auto has = [](const auto& set) { return set->gauge() != nullptr; };
  return std::any_of(sets_.begin(), sets_.end(), has);
}

bool UnionView::has_symmetry() const noexcept {
  const auto has = [](const auto& set) { return set->symmetry() != nullptr; };
  return std::all_of(sets_.begin(), sets_.end(), has);
}

template <class Real>
void UnionView::list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const {
  for (const auto& set : sets_) {
    const int before = pieces.count;
    BasicSupportPieces<Real> more = pieces.rest(before);
    support_pieces(*set, u, more, SupportPieces::kCapacity - capacity + before);
    if (more.count == 0) {
      pieces.count = 0;
      return;
    }
    for (int i = 0; i < more.count; ++i) {
      pieces.value.data()[before + i] = more.value[static_cast<std::size_t>(i)];
    }
    pieces.count = before + more.count;
  }
}

// The set that reaches farthest in direction u, which need not be more than a double.
template <class Real>
const ConvexSet& UnionView::outermost(const Real* u) const {
  const int n = dimension();
  Scratch direction(n), point(n);
  for (int k = 0; k < n; ++k) direction.data()[k] = static_cast<double>(u[k]);
  const ConvexSet* farthest = sets_.front().get();
  double best = -kInfinity;
  for (const auto& set : sets_) {
    const double value = set->support_unchecked(direction.data(), point.data());
    if (value > best) {
      best = value;
      farthest = set.get();
    }
  }
  return *farthest;
}

// A flat face of one of the sets is one of the hull if no other set reaches beyond it.
template <class Real>
bool UnionView::find_normal(const Real* u, const Real* v, Real* normal) const {
  return std::any_of(sets_.begin(), sets_.end(), [&](const auto& set) {
    return facet_normal(*set, u, v, normal) && &outermost(normal) == set.get();
  });
}

template <class Real>
void UnionView::find_point(const Real* normal, const Real* target, Real* point) const {
  const ConvexSet& set = outermost(normal);
  if (set.flat_faces() != nullptr) {
    set.flat_faces()->point(normal, target, point);
  } else if constexpr (std::is_same_v<Real, double>) {
    set.support_unchecked(normal, point);
  }
}

// The least bound: what is in tS_i is in the t-fold hull.
double UnionView::do_gauge(const double* x, double* normal) const {
  const int n = dimension();
  Scratch other(n);
  double least = kInfinity;
  for (const auto& set : sets_) {
    const double bound = gauge_bound(*set, x, other.data());
    if (!(bound < least)) continue;
    least = bound;
    std::copy_n(other.data(), n, normal);
  }
  return least;
}

// Of the set with the least gauge, v·x/h(v) for its normal v at x, as far as doubles tell.
bool UnionView::do_quad_gauge_normal(const Quad* x, Quad* normal) const {
  const int n = dimension();
  BasicScratch<Quad> v(n);
  Scratch direction(n), point(n);
  double least = kInfinity;
  for (const auto& set : sets_) {
    if (!gauge_normal(*set, x, v.data())) continue;
    normalize(v.data(), n, v.data());
    for (int k = 0; k < n; ++k) direction.data()[k] = static_cast<double>(v.data()[k]);
    const double reach = set->support_unchecked(direction.data(), point.data());
    const double gauge = static_cast<double>(dot(v.data(), x, n)) / reach;
    if (!(gauge < least)) continue;
    least = gauge;
    std::copy_n(v.data(), n, normal);
  }
  return least < kInfinity;
}

// With a normal u of one set, if all others touch the origin with the same, or have u·x < 0 throughout.
bool UnionView::do_touches_origin(double* u) const {
  const int n = dimension();
  Scratch other(n), magnitude(n);
  const auto first = std::find_if(sets_.begin(), sets_.end(),
                                  [&](const auto& set) { return raygauge::touches_origin(*set, u); });
  return first != sets_.end() && std::all_of(sets_.begin(), sets_.end(), [&](const auto& set) {
           if (raygauge::touches_origin(*set, other.data()) && std::equal(u, u + n, other.data()))
             return true;
           set->magnitude_unchecked(magnitude.data());
           double error = 0;
           for (int k = 0; k < n; ++k) error += std::fabs(u[k]) * magnitude.data()[k];
           return set->support_unchecked(u, other.data()) + ConvexSet::rounding_error(n) * error +
                      kUnderflow <
                  0;
         });
}

// About a common centre; any of the sets may be the one that reaches farthest.
bool UnionView::do_is_unconditional(double* extent) const {
  const int n = dimension();
  Scratch first(n), center(n), one(n);
  do_center(center.data());
  sets_.front()->center_unchecked(first.data());
  std::fill_n(extent, n, kInfinity);
  for (const auto& set : sets_) {
    set->center_unchecked(one.data());
    if (!std::equal(one.data(), one.data() + n, first.data()) || !is_unconditional(*set, one.data()))
      return false;
    for (int k = 0; k < n; ++k) extent[k] = std::min(extent[k], one.data()[k]);
  }
  for (int k = 0; k < n; ++k) {
    if (center.data()[k] == first.data()[k]) continue;
    const double away = std::fabs(center.data()[k] - first.data()[k]);
    extent[k] -= away + 4 * kUnitRoundoff * (away + std::fabs(extent[k]));
  }
  return true;
}

}  // namespace

UnionHull::UnionHull(std::vector<std::shared_ptr<const ConvexSet>> sets)
    : CombinedSet(dimension_of_first(sets)), sets_(std::move(sets)) {
  for (std::size_t i = 1; i < sets_.size(); ++i) {
    const std::string name = "set " + std::to_string(i);
    check_dimension("hull of a union", name, checked_set("hull of a union", name, sets_[i])->dimension(),
                    dimension());
  }
  set_view(std::make_unique<UnionView>(sets_));
}

}  // namespace raygauge
