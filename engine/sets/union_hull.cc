// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/union_hull.h"

#include <algorithm>
#include <string>
#include <utility>

#include "engine/numerics/vector_kernels.h"
#include "engine/sets/parameters.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

int dimension_of_first(const std::vector<std::shared_ptr<const ConvexSet>>& sets) {
  if (sets.empty()) throw EmptySetError("hull of a union: needs at least one set");
  return checked_set("hull of a union", "set 0", sets.front())->dimension();
}

}  // namespace

UnionHull::UnionHull(std::vector<std::shared_ptr<const ConvexSet>> sets)
    : ConvexSet(dimension_of_first(sets)), sets_(std::move(sets)) {
  for (std::size_t i = 1; i < sets_.size(); ++i) {
    const std::string name = "set " + std::to_string(i);
    check_dimension("hull of a union", name, checked_set("hull of a union", name, sets_[i])->dimension(),
                    dimension());
  }
}

double UnionHull::do_support(const double* u, double* point) const {
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

void UnionHull::do_center(double* point) const {
  Scratch one(dimension());
  const auto count = static_cast<double>(sets_.size());
  std::fill_n(point, dimension(), 0.0);
  for (const auto& set : sets_) {
    set->center_unchecked(one.data());
    for (int k = 0; k < dimension(); ++k) point[k] += one.data()[k] / count;
  }
}

void UnionHull::do_magnitude(double* magnitude) const {
  Scratch one(dimension());
  std::fill_n(magnitude, dimension(), 0.0);
  for (const auto& set : sets_) {
    set->magnitude_unchecked(one.data());
    for (int k = 0; k < dimension(); ++k) magnitude[k] = std::max(magnitude[k], one.data()[k]);
  }
}

double UnionHull::do_inner_radius(const double* c) const {
  double radius = 0;
  for (const auto& set : sets_) radius = std::max(radius, set->inner_radius_unchecked(c));
  return radius;
}

SupportStructure UnionHull::do_structure() const noexcept {
  SupportStructure hull = sets_.front()->structure();
  for (const auto& set : sets_) hull = structure_of_sum(hull, set->structure());
  return hull == SupportStructure::point ? SupportStructure::polytope : hull;
}

template <class Real>
void UnionHull::list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const {
  for (const auto& set : sets_) {
    const int before = pieces.count;
    BasicSupportPieces<Real> more = pieces.rest(before);
    set->support_pieces_unchecked(u, more, SupportPieces::kCapacity - capacity + before);
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

void UnionHull::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

void UnionHull::do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

}  // namespace raygauge
