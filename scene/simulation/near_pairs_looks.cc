// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include "scene/simulation/near_pairs.h"

// How pairs are looked at, and what need not be looked at again.
namespace raygauge {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kOutward = 1 + 1e-9;
constexpr double kRounding = 1e-12;  // of what is added up
constexpr double kSurely = 1.01;     // what is as much farther than a band is so by any way to measure it

Placement placement_of(const SimulatedBody& body, int n) {
  return {SmallMatrix(body.R.topLeftCorner(n, n)), SmallVector(body.x.head(n))};
}

}  // namespace

void NearPairs::look(const Candidate& candidate, const Placement& at_a, const Placement& at_b, double band,
                     PartContact& contact, PairTools& tools) {
  ++tools.counters.contact_queries;
  const ConvexSet& a = *parts_[static_cast<std::size_t>(candidate.part_a)].body.parts.front().set;
  const ConvexSet& b = *parts_[static_cast<std::size_t>(candidate.part_b)].body.parts.front().set;
  tools.pose_a.assign(at_a.R.data(), at_a.t.data());
  tools.pose_b.assign(at_b.R.data(), at_b.t.data());
  tools.finder.find({a, tools.pose_a}, {b, tools.pose_b}, band, candidate.normal, contact);
}

bool NearPairs::KnownLook::is_of(const Placement& a, const Placement& b) const {
  return at_a.t == a.t && at_a.R == a.R && at_b.t == b.t && at_b.R == b.R;
}

Placement NearPairs::place_of(int number) const {
  return placement_of(bodies_[static_cast<std::size_t>(part(number).owner)], n_);
}

// Whether it is known from before, or by planes across the normal that was found last, that the parts are
// farther apart than `beyond`.
bool NearPairs::is_known_beyond(const Candidate& candidate, const Placement& at_a, const Placement& at_b,
                                double beyond) const {
  KnownLook& known = *candidate.known;
  if (known.is_of(at_a, at_b)) return known.contact.lower > beyond;
  const double size = at_a.t.norm() + at_b.t.norm() +
                      part(candidate.part_a).body.parts.front().turned_magnitude +
                      part(candidate.part_b).body.parts.front().turned_magnitude;
  const double apart =
      between_planes(candidate.part_a, candidate.part_b, known.contact.normal, at_a, at_b) - kRounding * size;
  if (!(apart > beyond)) return false;
  known.at_a = at_a;
  known.at_b = at_b;
  known.band = -1;
  known.contact.lower = apart;
  known.contact.points.clear();
  return true;
}

// Of bodies that lie still it is known. None: farther apart than `beyond`, which is more than the band by so
// much that a look would say so too.
const PartContact* NearPairs::contact_now(Candidate& candidate, double band, double beyond,
                                          PairTools& tools) {
  const Placement at_a = place_of(candidate.part_a), at_b = place_of(candidate.part_b);
  if (candidate.known && is_known_beyond(candidate, at_a, at_b, kSurely * beyond)) return nullptr;
  if (!candidate.known) candidate.known = std::make_unique<KnownLook>();
  KnownLook& known = *candidate.known;
  if (known.band == band && known.previous == candidate.normal && known.is_of(at_a, at_b))
    return &known.contact;
  look(candidate, at_a, at_b, band, known.contact, tools);
  known.at_a = at_a;
  known.at_b = at_b;
  known.previous = candidate.normal;
  known.band = band;
  return &known.contact;
}

// Whether the parts were so far apart before this substep, as was just found, that their ways do not lead to
// `arrival`.
bool NearPairs::stays_away(const Candidate& candidate) const {
  if (!candidate.known || !candidate.known->is_of(place_of(candidate.part_a), place_of(candidate.part_b)))
    return false;
  const Swept &a = swept_[static_cast<std::size_t>(candidate.part_a)],
              &b = swept_[static_cast<std::size_t>(candidate.part_b)];
  const double rounding = kRounding * (a.middle.norm() + b.middle.norm());
  return candidate.known->contact.lower > (a.travel + b.travel + scales_.arrival() + rounding) * kOutward;
}

// Whether both parts lie still within this substep, at a signed distance of `least` or more.
bool NearPairs::stays(const Candidate& candidate, double least) const {
  const auto is_still = [this](int number) {
    return bodies_[static_cast<std::size_t>(part(number).owner)].still;
  };
  return candidate.known && is_still(candidate.part_a) && is_still(candidate.part_b) &&
         candidate.known->is_of(place_of(candidate.part_a), place_of(candidate.part_b)) &&
         candidate.known->contact.lower >= least;
}

double NearPairs::distance_at(const NearPair& pair, double end, PairTools& tools) {
  PartContact then;
  look(*candidate_of(pair.part_a, pair.part_b), bodies_[static_cast<std::size_t>(pair.a)].motion->at(end),
       bodies_[static_cast<std::size_t>(pair.b)].motion->at(end), scales_.delta, then, tools);
  return then.lower;
}

double NearPairs::between_planes(int part_a, int part_b, const Eigen::Vector3d& normal, const Placement& at_a,
                                 const Placement& at_b) const {
  // A half-space has one normal, and its plane is found as fast.
  if (!part(part_a).body.is_bounded() || !part(part_b).body.is_bounded()) return -kInfinity;
  const auto height = [this, &normal](int number, const Placement& at, double sign) {
    Eigen::Vector3d point = Eigen::Vector3d::Zero(), along = point;
    along.head(n_) = sign * at.R.transpose() * normal.head(n_);
    return part(number).body.parts.front().set->support_unchecked(along.data(), point.data()) +
           sign * normal.head(n_).dot(at.t);
  };
  return -height(part_a, at_a, -1) - height(part_b, at_b, 1);
}

double NearPairs::plane_distance_at(const NearPair& pair, double end) const {
  const SimulatedBody &a = bodies_[static_cast<std::size_t>(pair.a)],
                      &b = bodies_[static_cast<std::size_t>(pair.b)];
  const Placement at_a = a.motion->at(end), at_b = b.motion->at(end);
  const Eigen::Vector3d& normal = pair.contact.normal;
  double distance = between_planes(pair.part_a, pair.part_b, normal, at_a, at_b);
  for (const auto& [body, at] : {std::pair{&a, &at_a}, std::pair{&b, &at_b}}) {
    const Eigen::Vector3d turned = in_space(at->R) * (body->R.transpose() * normal);
    distance = std::max(distance, between_planes(pair.part_a, pair.part_b, turned, at_a, at_b));
  }
  return distance;
}

}  // namespace raygauge
