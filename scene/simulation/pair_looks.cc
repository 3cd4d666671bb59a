// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include "scene/simulation/pair_looks.h"

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

void PairLooks::look(const CandidatePair& candidate, const Placement& at_a, const Placement& at_b,
                     double band, PartContact& contact, PairTools& tools) const {
  ++tools.counters.contact_queries;
  const ConvexSet& a = *parts_[static_cast<std::size_t>(candidate.part_a)].body.parts.front().set;
  const ConvexSet& b = *parts_[static_cast<std::size_t>(candidate.part_b)].body.parts.front().set;
  tools.pose_a.assign(at_a.R.data(), at_a.t.data());
  tools.pose_b.assign(at_b.R.data(), at_b.t.data());
  tools.finder.find({a, tools.pose_a}, {b, tools.pose_b}, band, candidate.normal, contact);
}

Placement PairLooks::place_of(int number) const {
  return placement_of(bodies_[static_cast<std::size_t>(part(number).owner)], n_);
}

// Whether it is known from before, or by planes across the normal that was found last, that the parts are
// farther apart than `beyond`.
bool PairLooks::is_known_beyond(const CandidatePair& candidate, const Placement& at_a, const Placement& at_b,
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
const PartContact* PairLooks::now(CandidatePair& candidate, double band, double beyond,
                                  PairTools& tools) const {
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

// Of where they are now.
bool PairLooks::is_known_now(const CandidatePair& candidate) const {
  return candidate.known && candidate.known->is_of(place_of(candidate.part_a), place_of(candidate.part_b));
}

bool PairLooks::is_known_apart(const CandidatePair& candidate, double beyond) const {
  return is_known_now(candidate) && candidate.known->contact.lower > beyond;
}

bool PairLooks::stays(const CandidatePair& candidate, double least) const {
  const auto is_still = [this](int number) {
    return bodies_[static_cast<std::size_t>(part(number).owner)].still;
  };
  return is_still(candidate.part_a) && is_still(candidate.part_b) && is_known_now(candidate) &&
         candidate.known->contact.lower >= least;
}

PartContact PairLooks::at(const CandidatePair& candidate, double t, double band, PairTools& tools) const {
  PartContact contact;
  const auto then = [this, t](int number) {
    return bodies_[static_cast<std::size_t>(part(number).owner)].motion->at(t);
  };
  look(candidate, then(candidate.part_a), then(candidate.part_b), band, contact, tools);
  return contact;
}

double PairLooks::between_planes(int part_a, int part_b, const Eigen::Vector3d& normal, const Placement& at_a,
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

double PairLooks::between_planes_at(const NearPair& pair, double t) const {
  const SimulatedBody &a = bodies_[static_cast<std::size_t>(pair.a)],
                      &b = bodies_[static_cast<std::size_t>(pair.b)];
  const Placement at_a = a.motion->at(t), at_b = b.motion->at(t);
  const Eigen::Vector3d& normal = pair.contact.normal;
  double distance = between_planes(pair.part_a, pair.part_b, normal, at_a, at_b);
  for (const auto& [body, at] : {std::pair{&a, &at_a}, std::pair{&b, &at_b}}) {
    const Eigen::Vector3d turned = in_space(at->R) * (body->R.transpose() * normal);
    distance = std::max(distance, between_planes(pair.part_a, pair.part_b, turned, at_a, at_b));
  }
  return distance;
}

}  // namespace raygauge
