// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/separation_bins.h"

#include <typeinfo>
#include <utility>

#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"

namespace raygauge {
namespace {

enum class Kind : unsigned char { other, box, ball, capsule };

// The classes are final. A class that a second copy of the library knows by another address is an `other`.
Kind kind_of(const ConvexSet& set) noexcept {
  const std::type_info* const type = &typeid(set);
  if (type == &typeid(Box)) return Kind::box;
  if (type == &typeid(Capsule)) return Kind::capsule;
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
  const double* R = body.pose != nullptr ? body.pose->rotation_data() : kNoPose.data();
  for (std::size_t k = 0; k < 9; ++k) lanes.rotation[which][k][lane] = R[k];
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

void SeparationBins::begin(const SeparationAnswers& answers) {
  answers_ = answers;
  bins_[0].separate = &Kernels::separate_capsules;
  bins_[1].separate = &Kernels::separate_box_from_capsule;
  bins_[2].separate = &Kernels::separate_boxes;
  for (Bin& bin : bins_) {
    bin.count = 0;
    bin.lanes.with_normals = !answers.normal.empty();
  }
}

void SeparationBins::add(const PosedPair& pair, std::size_t i) {
  const Kind kind_1 = kind_of(pair.first), kind_2 = kind_of(pair.second);
  if (kind_1 == Kind::other || kind_2 == Kind::other) return;
  const bool box_1 = kind_1 == Kind::box, box_2 = kind_2 == Kind::box, swap = box_2 && !box_1;
  Bin& bin = bins_[static_cast<std::size_t>(box_1) + static_cast<std::size_t>(box_2)];
  const Posed &one = swap ? pair.second : pair.first, &two = swap ? pair.first : pair.second;
  const auto lane = static_cast<std::size_t>(bin.count);
  const double radius_1 = put(one, swap ? kind_2 : kind_1, bin.lanes, 0, lane);
  const double radius_2 = put(two, swap ? kind_1 : kind_2, bin.lanes, 1, lane);
  bin.lanes.radius[lane] = radius_1 + radius_2;
  const double *t_1 = translation(one), *t_2 = translation(two);
  for (std::size_t k = 0; k < 3; ++k) bin.lanes.apart[k][lane] = t_2[k] - t_1[k];
  bin.pair[lane] = i;
  bin.swapped[lane] = swap;
  if (++bin.count == SeparationLanes::kCount) decide(bin);
}

// Lanes that are not filled hold what they held before.
void SeparationBins::decide(Bin& bin) {
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
void SeparationBins::put_normal(const Bin& bin, std::size_t lane) {
  const double sign = bin.swapped[lane] ? 1 : -1;
  for (std::size_t k = 0; k < 3; ++k)
    answers_.normal[3 * bin.pair[lane] + k] = sign * bin.lanes.normal[k][lane];
}

void SeparationBins::finish() {
  for (Bin& bin : bins_) {
    if (bin.count > 0) decide(bin);
  }
}

}  // namespace raygauge
