// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/separation_bins.h"

#include <algorithm>
#include <cmath>
#include <typeinfo>
#include <utility>

#include "engine/sets/capability_queries.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {
namespace {

enum class Kind : unsigned char { other, box, ball, capsule, hull };

// The classes are final. A class that a second copy of the library knows by another address is an `other`.
Kind kind_of(const ConvexSet& set) noexcept {
  const std::type_info* const type = &typeid(set);
  if (type == &typeid(Box)) return Kind::box;
  if (type == &typeid(Capsule)) return Kind::capsule;
  if (const PointSet* points = as_point_set(set))
    return points->size() <= HullLanes::kMost ? Kind::hull : Kind::other;
  return type == &typeid(Ball) ? Kind::ball : Kind::other;
}

Kind kind_of(const Posed& body) noexcept {
  return body.pose == nullptr || body.pose->dimension() == 3 ? kind_of(body.set) : Kind::other;
}

constexpr std::array<double, 12> kNoPose = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};

// The midpoint of l and r and half their difference: each one rounding, as halves are exact.
void put_middle(const double* l, const double* r, SeparationLanes::Row* center, SeparationLanes::Row* half,
                std::size_t lane) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    center[k][lane] = 0.5 * l[k] + 0.5 * r[k];
    half[k][lane] = 0.5 * r[k] - 0.5 * l[k];
  }
}

// Its radius.
double put(const Posed& body, Kind kind, SeparationLanes& lanes, std::size_t which,
           std::size_t lane) noexcept {
  SeparationLanes::Row *center = lanes.center[which], *half = lanes.half[which];
  if (kind == Kind::box) {
    const auto& box = static_cast<const Box&>(body.set);
    put_middle(box.lower().data(), box.upper().data(), center, half, lane);
    return 0;
  }
  if (kind == Kind::capsule) {
    const auto& capsule = static_cast<const Capsule&>(body.set);
    put_middle(capsule.p().data(), capsule.q().data(), center, half, lane);
    return capsule.radius();
  }
  double c[3];
  body.set.center_unchecked(c);
  for (std::size_t k = 0; k < 3; ++k) {
    center[k][lane] = c[k];
    half[k][lane] = 0;
  }
  return static_cast<const Ball&>(body.set).radius();
}

void put_point(const double* x, std::size_t stride, HullLanes::Row* point, std::size_t lane) noexcept {
  for (std::size_t k = 0; k < 3; ++k) point[k][lane] = x[k * stride];
}

// The points of its core and their extent. Their count.
int put_points(const Posed& body, Kind kind, HullLanes& lanes, std::size_t which, std::size_t lane) {
  auto* const point = lanes.point[which];
  double& extent = lanes.extent[which][lane];
  extent = 0;
  if (kind == Kind::hull) {
    const PointSet& points = *as_point_set(body.set);
    const auto count = static_cast<std::size_t>(points.size());
    constexpr std::size_t kBlock = PointSet::kLanes;
    for (std::size_t i = 0; i < count; ++i)
      put_point(points.data() + i / kBlock * 3 * kBlock + i % kBlock, kBlock, point[i], lane);
    for (int k = 0; k < 3; ++k) extent += points.coordinate_magnitude()[k];
    return static_cast<int>(count);
  }
  const auto spread = [&](const double* p, const double* q) {
    for (int k = 0; k < 3; ++k) extent += std::max(std::fabs(p[k]), std::fabs(q[k]));
  };
  if (kind == Kind::box) {
    const auto& box = static_cast<const Box&>(body.set);
    const double* bounds[2] = {box.lower().data(), box.upper().data()};
    for (std::size_t i = 0; i < 8; ++i) {
      for (std::size_t k = 0; k < 3; ++k) point[i][k][lane] = bounds[i >> k & 1][k];
    }
    spread(bounds[0], bounds[1]);
    return 8;
  }
  if (kind == Kind::capsule) {
    const auto& capsule = static_cast<const Capsule&>(body.set);
    put_point(capsule.p().data(), 1, point[0], lane);
    put_point(capsule.q().data(), 1, point[1], lane);
    spread(capsule.p().data(), capsule.q().data());
    return 2;
  }
  double c[3];
  body.set.center_unchecked(c);
  put_point(c, 1, point[0], lane);
  spread(c, c);
  return 1;
}

double radius_of(const ConvexSet& set, Kind kind) noexcept {
  if (kind == Kind::ball) return static_cast<const Ball&>(set).radius();
  return kind == Kind::capsule ? static_cast<const Capsule&>(set).radius() : 0;
}

const double* translation(const Posed& body) noexcept {
  return body.pose != nullptr ? body.pose->translation_data() : kNoPose.data() + 9;
}

void prefetch_body(const Posed& body) noexcept {
  constexpr std::ptrdiff_t kLine = 64;
  const char* set = reinterpret_cast<const char*>(&body.set);
  __builtin_prefetch(set);
  __builtin_prefetch(set + kLine);
  if (body.pose == nullptr) return;
  const char* pose = reinterpret_cast<const char*>(body.pose);
  __builtin_prefetch(pose);
  __builtin_prefetch(pose + kLine);
}

void prefetch_numbers_of(const ConvexSet& set) noexcept {
  const Kind kind = kind_of(set);
  if (kind == Kind::box) {
    __builtin_prefetch(static_cast<const Box&>(set).lower().data());
    __builtin_prefetch(static_cast<const Box&>(set).upper().data());
  } else if (kind == Kind::capsule) {
    __builtin_prefetch(static_cast<const Capsule&>(set).p().data());
    __builtin_prefetch(static_cast<const Capsule&>(set).q().data());
  }
}

}  // namespace

void prefetch_bodies(const PosedPair& pair) noexcept {
  prefetch_body(pair.first);
  prefetch_body(pair.second);
}

void prefetch_numbers(const PosedPair& pair) noexcept {
  prefetch_numbers_of(pair.first.set);
  prefetch_numbers_of(pair.second.set);
}

template <class Lanes>
void SeparationBins::begin(Bin<Lanes>& bin, void (*Kernels::*separate)(Lanes*)) {
  bin.separate = separate;
  bin.count = 0;
  bin.lanes.with_normals = !answers_.normal.empty();
}

void SeparationBins::begin(const SeparationAnswers& answers) {
  answers_ = answers;
  begin(bins_[0], &Kernels::separate_capsules);
  begin(bins_[1], &Kernels::separate_box_from_capsule);
  begin(bins_[2], &Kernels::separate_boxes);
  begin(hulls_, &Kernels::separate_hulls);
}

// What all pairs have in common; the cores are there.
template <class Lanes>
void SeparationBins::place(Bin<Lanes>& bin, const Posed& one, const Posed& two, double radius, bool swapped,
                           std::size_t i) {
  const auto lane = static_cast<std::size_t>(bin.count);
  for (std::size_t body = 0; body < 2; ++body) {
    const Pose* pose = (body == 0 ? one : two).pose;
    const double* R = pose != nullptr ? pose->rotation_data() : kNoPose.data();
    for (std::size_t k = 0; k < 9; ++k) bin.lanes.rotation[body][k][lane] = R[k];
  }
  const double *t_1 = translation(one), *t_2 = translation(two);
  for (std::size_t k = 0; k < 3; ++k) bin.lanes.apart[k][lane] = t_2[k] - t_1[k];
  bin.lanes.radius[lane] = radius;
  bin.pair[lane] = i;
  bin.swapped[lane] = swapped;
  if (++bin.count == PairLanes::kCount) decide(bin);
}

void SeparationBins::add(const PosedPair& pair, std::size_t i) {
  const Kind kind_1 = kind_of(pair.first), kind_2 = kind_of(pair.second);
  if (kind_1 == Kind::other || kind_2 == Kind::other) return;
  if (kind_1 == Kind::hull || kind_2 == Kind::hull) {
    const auto lane = static_cast<std::size_t>(hulls_.count);
    points_[0][lane] = put_points(pair.first, kind_1, hulls_.lanes, 0, lane);
    points_[1][lane] = put_points(pair.second, kind_2, hulls_.lanes, 1, lane);
    if (hulls_.count + 1 == PairLanes::kCount) fill_up();
    const double radius = radius_of(pair.first.set, kind_1) + radius_of(pair.second.set, kind_2);
    return place(hulls_, pair.first, pair.second, radius, false, i);
  }
  const bool box_1 = kind_1 == Kind::box, box_2 = kind_2 == Kind::box, swap = box_2 && !box_1;
  auto& bin = bins_[static_cast<std::size_t>(box_1) + static_cast<std::size_t>(box_2)];
  const Posed &one = swap ? pair.second : pair.first, &two = swap ? pair.first : pair.second;
  const auto lane = static_cast<std::size_t>(bin.count);
  const double radius_1 = put(one, swap ? kind_2 : kind_1, bin.lanes, 0, lane);
  const double radius_2 = put(two, swap ? kind_1 : kind_2, bin.lanes, 1, lane);
  place(bin, one, two, radius_1 + radius_2, swap, i);
}

// Lanes with fewer points than others repeat their first one.
void SeparationBins::fill_up() {
  const auto lanes = static_cast<std::size_t>(PairLanes::kCount);
  for (std::size_t body = 0; body < 2; ++body) {
    const int most = *std::max_element(points_[body].begin(), points_[body].end());
    hulls_.lanes.count[body] = most;
    auto* const point = hulls_.lanes.point[body];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      for (int i = points_[body][lane]; i < most; ++i) {
        for (std::size_t k = 0; k < 3; ++k) point[i][k][lane] = point[0][k][lane];
      }
    }
  }
}

// Lanes that are not filled hold what they held before.
template <class Lanes>
void SeparationBins::decide(Bin<Lanes>& bin) {
  (kernels_->*bin.separate)(&bin.lanes);
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(bin.count); ++lane) {
    const unsigned apart = bin.lanes.are_apart >> lane & 1, meet = bin.lanes.do_meet >> lane & 1;
    answers_.outcome[bin.pair[lane]] = apart != 0  ? Separation::separated
                                       : meet != 0 ? Separation::intersecting
                                                   : Separation::undecided;
    if (apart != 0 && bin.lanes.with_normals) put_normal(bin, lane);
  }
  bin.count = 0;
}

// From the second body of the pair to the first one.
template <class Lanes>
void SeparationBins::put_normal(const Bin<Lanes>& bin, std::size_t lane) {
  const double sign = bin.swapped[lane] ? 1 : -1;
  for (std::size_t k = 0; k < 3; ++k)
    answers_.normal[3 * bin.pair[lane] + k] = sign * bin.lanes.normal[k][lane];
}

void SeparationBins::finish() {
  for (auto& bin : bins_) {
    if (bin.count > 0) decide(bin);
  }
  if (hulls_.count == 0) return;
  fill_up();
  decide(hulls_);
}

}  // namespace raygauge
