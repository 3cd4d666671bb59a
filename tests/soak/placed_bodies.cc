// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/placed_bodies.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/numerics/number_text.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/prepared_set.h"
#include "tests/soak/result_checks.h"

namespace raygauge::soak {
namespace {

using Real = long double;
using Small = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;
using Long = Eigen::Matrix<Real, Eigen::Dynamic, 1, 0, 3, 1>;

constexpr double kTolerance = 1e-6;
constexpr Real kError =
    1e-14;  // of a height or a point, relative to the size of bodies and of the way between

struct Enclosure {
  Real lower = 0;
  Real upper = std::numeric_limits<Real>::infinity();
};

DistanceOptions options() {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  options.tolerance = kTolerance;
  options.time_limit = 60;  // none takes so long unless the machine stands still
  return options;
}

// Balls of p-norms have no fixed-size code, and the general methods take a hundred times as long.
RandomSet draw_body(RandomStream& stream, int n, double size) {
  if (n == 3 && stream.uniform() < 0.15) {
    const auto N = static_cast<int>(stream.integer(20, 200));
    const Eigen::MatrixXd cloud = Eigen::MatrixXd::NullaryExpr(
        n, N, [&](Eigen::Index, Eigen::Index) { return size * stream.normal(); });
    return {std::make_shared<PreparedSet>(cloud), "prepared hull"};
  }
  for (;;) {
    RandomSet body = draw_set(stream, Vector::Zero(n), size, 0);
    if (body.label != "p-ball" || stream.uniform() < 0.05) return body;
  }
}

Small small_step(RandomStream& stream, int n, double size) {
  return Small::NullaryExpr(n, [&](Eigen::Index) { return size * (2 * stream.uniform() - 1); });
}

// A body and where it is.
struct Body {
  const ConvexSet* set = nullptr;
  SmallMatrix R;
  Small t, center;
  double angle = 0;
  Small axis;
  double size = 0;  // of the numbers that a point is computed from
  Pose pose{3};

  explicit Body(const ConvexSet& S) : set(&S), center(S.dimension()), pose(S.dimension()) {
    const int n = S.dimension();
    t.setZero(n);
    S.center_unchecked(center.data());
    Small magnitude(n);
    S.magnitude_unchecked(magnitude.data());
    size = magnitude.norm() + center.norm();
  }

  int n() const { return set->dimension(); }

  Small support(const Small& v) const {
    Small point(n());
    set->support_unchecked(v.data(), point.data());
    return point;
  }

  // u·x - u·t at its highest, for x = R s + t.
  Real height(const Small& u) const {
    const Long v = R.cast<Real>().transpose() * u.cast<Real>();
    const Small rounded = v.cast<double>();
    return v.dot(support(rounded).cast<Real>());
  }

  Long turned(const Small& point) const { return R.cast<Real>() * point.cast<Real>(); }

  void turn(RandomStream& stream, bool coherent) {
    if (coherent) {
      angle += 0.02 * stream.uniform();
    } else {
      axis = draw_direction(stream, n());
      const double eighth = std::acos(-1.0) / 4;
      angle =
          stream.uniform() < 0.5 ? eighth * static_cast<double>(stream.integer(0, 7)) : 6 * stream.uniform();
    }
    if (n() == 2) {
      R = Eigen::Rotation2Dd(angle).toRotationMatrix();
    } else {
      R = Eigen::AngleAxisd(angle, Eigen::Vector3d(axis)).toRotationMatrix();
    }
  }

  // A point of the face whose normal is the world's u, or near to it.
  Small face_point(RandomStream& stream, const Small& u) const {
    const Small v = R.transpose() * u;
    Small point = support(v);
    if (stream.uniform() < 0.5) return point;
    for (int i = 1; i < 4; ++i) {
      const double share = stream.uniform();
      point = share * point + (1 - share) * support(v + small_step(stream, n(), 1e-11 * v.norm()));
    }
    return point;
  }

  Small inner_point(RandomStream& stream) const {
    Small point = center;
    for (int i = 0; i < 2; ++i) point = 0.5 * point + 0.5 * support(draw_direction(stream, n()));
    return point;
  }

  // The difference of two support points near v: an edge, if v is near the normal of one.
  Small edge(RandomStream& stream, const Small& v, const Small& from) const {
    return support(v + small_step(stream, n(), 0.5)) - from;
  }
};

// In the frame of the body: of a face, of an axis, or v.
Small face_normal(RandomStream& stream, const Body& body) {
  Small v = draw_direction(stream, body.n());
  const Small from = body.support(v);
  const Small e = body.edge(stream, v, from);
  Small normal = v;
  if (body.n() == 2) {
    normal << -e[1], e[0];
  } else {
    const Small f = body.edge(stream, v, from);
    normal = Eigen::Vector3d(e).cross(Eigen::Vector3d(f));
  }
  const double size = normal.norm();
  if (!(size > 1e-150)) return v;
  normal /= normal.dot(v) < 0 ? -size : size;
  return normal;
}

// A direction of length 1 in about, in the world.
Small draw_normal(RandomStream& stream, const Body& first, const Body& second, const Small& before) {
  const int n = first.n();
  const Body& body = stream.uniform() < 0.5 ? first : second;
  switch (stream.integer(0, 4)) {
    case 0:
      return draw_direction(stream, n);
    case 1:
      return body.R * face_normal(stream, body);
    case 2:
      return body.R * draw_direction(stream, n);
    case 3: {
      if (n == 2) return body.R * face_normal(stream, body);
      const Small v = draw_direction(stream, n), w = draw_direction(stream, n);
      const Small e = first.R * first.edge(stream, v, first.support(v)),
                  f = second.R * second.edge(stream, w, second.support(w));
      const Eigen::Vector3d across = Eigen::Vector3d(e).cross(Eigen::Vector3d(f));
      return across.norm() > 1e-150 ? Small(across.normalized()) : v;
    }
    default:
      return (before + small_step(stream, n, 0.01)).normalized();
  }
}

double draw_gap(RandomStream& stream, double size) {
  const double kind = stream.uniform();
  if (kind < 0.02) return 0;
  return kind < 0.3 ? size * std::pow(10.0, -9 * stream.uniform()) : 4 * size * stream.uniform();
}

Real error_of(const Body& first, const Body& second) {
  return kError * (first.size + second.size + first.t.norm() + second.t.norm());
}

// Moves the second body to where its point b is that of the first one, a, plus `apart`.
void meet(const Body& first, const Small& a, Body& second, const Small& b, const Long& apart) {
  second.t = (first.t.cast<Real>() + first.turned(a) + apart - second.turned(b)).cast<double>();
}

Enclosure place_at_distance(RandomStream& stream, const Body& first, Body& second, const Small& u) {
  const bool overlapping = stream.uniform() < 0.05;
  const Small a = overlapping ? first.inner_point(stream) : first.face_point(stream, u);
  const Small b = overlapping ? second.inner_point(stream) : second.face_point(stream, -u);
  const double gap = overlapping ? 0 : draw_gap(stream, std::min(first.size, second.size));
  meet(first, a, second, b, Long(u.cast<Real>() * gap));
  const Long between = second.t.cast<Real>() - first.t.cast<Real>();
  const Long apart = second.turned(b) - first.turned(a) + between;
  const Real error = error_of(first, second), size = u.cast<Real>().norm();
  const Real height = u.cast<Real>().dot(between) - first.height(u) - second.height(-u);
  return {std::max<Real>(0, height / size - error), apart.norm() + error};
}

// What the point lacks to σ times the set may be made up for by a ball inside: gauge(r) <= |r|/ρ.
Enclosure place_at_growth(RandomStream& stream, const Body& first, Body& second, const Small& u) {
  const Small a = first.face_point(stream, u), b = second.face_point(stream, -u);
  const Real sigma = stream.uniform() < 0.3 ? std::pow(10.0, -6 * stream.uniform()) : 8 * stream.uniform();
  const Small from_centers = a - first.center, from_center = b - second.center;
  const Long reach = first.turned(from_centers) - second.turned(from_center);
  meet(first, first.center, second, second.center, sigma * reach);
  const Long between = second.t.cast<Real>() - first.t.cast<Real>();
  const Long v = second.turned(second.center) - first.turned(first.center) + between;
  const Real error = error_of(first, second), size = u.cast<Real>().norm();
  const Real along = u.cast<Real>().dot(v) / size - error;
  const Real top = (first.height(u) - u.cast<Real>().dot(first.turned(first.center)) + second.height(-u) +
                    u.cast<Real>().dot(second.turned(second.center))) /
                       size +
                   error;
  const Real radius = 0.999 * (first.set->inner_radius_unchecked(first.center.data()) +
                               second.set->inner_radius_unchecked(second.center.data()));
  Enclosure known;
  known.lower = along > 0 && top > 0 ? along / top : 0;
  if (radius > 0) known.upper = sigma + ((v - sigma * reach).norm() + (1 + sigma) * error) / radius;
  return known;
}

std::string violation(const DistanceResult& r, const Enclosure& known) {
  std::string what = wrong_status(r, kTolerance);
  if (r.status == DistanceStatus::contains_origin && known.lower > 0) what = "they do not meet";
  if (!(r.lower <= known.upper) || !(r.upper >= known.lower)) what = "the bounds do not hold";
  if (what.empty()) return what;
  return what + ": [" + shortest_text(r.lower) + ", " + shortest_text(r.upper) + "], known [" +
         shortest_text(static_cast<double>(known.lower)) + ", " +
         shortest_text(static_cast<double>(known.upper)) + "]";
}

// Two bodies and the direction in which they were placed last.
struct Pair {
  Pair(RandomStream& stream, int n, double body_size)
      : size(body_size),
        A(draw_body(stream, n, size)),
        B(draw_body(stream, n, size)),
        first(*A.set),
        second(*B.set) {
    first.t = small_step(stream, n, stream.uniform() < 0.5 ? 0.0 : size);
    u = draw_direction(stream, n);
  }

  Enclosure place(RandomStream& stream, bool grows) {
    const bool coherent = placed && stream.uniform() < 0.6;
    const int n = first.n();
    placed = true;
    first.turn(stream, coherent);
    second.turn(stream, coherent);
    u = coherent ? Small((u + small_step(stream, n, 0.01)).normalized())
                 : draw_normal(stream, first, second, u);
    const Enclosure known =
        grows ? place_at_growth(stream, first, second, u) : place_at_distance(stream, first, second, u);
    first.pose.assign(first.R.data(), first.t.data());
    second.pose.assign(second.R.data(), second.t.data());
    return known;
  }

  std::string text() const {
    return A.label + " and " + B.label + " in R^" + std::to_string(first.n()) + ", size " +
           shortest_text(size);
  }

  double size;
  RandomSet A, B;
  Body first, second;
  Small u;
  bool placed = false;
};

}  // namespace

// A pair where it was placed, and what is asked.
struct PlacedBodies::Turn {
  Posed first, second;
  Enclosure known;
  const Ball* metric;
  bool grows, cold;
};

PlacedBodies::PlacedBodies(std::uint64_t seed) : seed_(seed), distance_(options()), growth_(options()) {}

// Bodies that meet when they are scaled by less than 1 have interior points in common, if they have any. What
// a busy machine's clock has ended is undecided honestly.
std::string PlacedBodies::check(Turn& turn) {
  const auto ask_growth = [&]() -> const DistanceResult& {
    return growth_.solve_about_centers(turn.first, turn.second, turn.cold ? nullptr : &warm_growth_);
  };
  const auto ask_distance = [&]() -> const DistanceResult& {
    return distance_
        .solve(turn.first, turn.second, *turn.metric, ObjectEffects::none,
               turn.cold ? nullptr : &warm_distance_)
        .distance;
  };
  const DistanceResult& r = turn.grows ? ask_growth() : ask_distance();
  ++tally_.poses;
  tally_.warm += turn.cold ? 0 : 1;
  tally_.certified += is_final(r) ? 1 : 0;
  std::string what = violation(r, turn.known);
  constexpr Real kClear = 1 - 1e-9;
  if (!what.empty() || !turn.grows || !(turn.known.upper < kClear)) return what;
  ++tally_.overlaps;
  if (turn.cold) {
    const DistanceStatus status = ask_distance().status;
    const bool known = status == DistanceStatus::contains_origin || status == DistanceStatus::time_limit;
    return known ? "" : "an overlap is undecided";
  }
  const Separation outcome = growth_.separation(turn.first, turn.second, &warm_growth_).outcome;
  return outcome == Separation::intersecting ? "" : "an overlap is no intersection";
}

std::optional<std::string> PlacedBodies::check(std::int64_t number) {
  constexpr int kPairs = 5;
  RandomStream stream({seed_, 1, static_cast<int>(number >> 31), static_cast<int>(number & 0x7fffffff)},
                      "placed_bodies", RandomPurpose::shape);
  std::vector<Pair> pairs;
  for (int i = 0; i < kPairs; ++i) {
    const int n = stream.uniform() < 0.8 ? 3 : 2;
    const double size =
        stream.uniform() < 0.7 ? 1.0 : std::ldexp(1.0, static_cast<int>(stream.integer(-40, 40)));
    pairs.emplace_back(stream, n, size);
  }
  const Ball metric_2(Vector::Zero(2), 1.0), metric_3(Vector::Zero(3), 1.0);
  if (stream.uniform() < 0.8) warm_distance_ = warm_growth_ = WarmStart();
  for (int i = 0; i < kPoses; ++i) {
    Pair& pair = pairs[static_cast<std::size_t>(stream.integer(0, kPairs - 1))];
    const bool grows = stream.uniform() < 0.5, cold = stream.uniform() < 0.3;
    const Enclosure known = pair.place(stream, grows);
    Turn turn{{*pair.A.set, pair.first.pose},
              {*pair.B.set, pair.second.pose},
              known,
              pair.first.n() == 2 ? &metric_2 : &metric_3,
              grows,
              cold};
    const std::string what = check(turn);
    if (what.empty()) continue;
    return pair.text() + ", pairs " + std::to_string(number) + ", pose " + std::to_string(i) +
           (grows ? ", growth: " : ", distance: ") + what;
  }
  return std::nullopt;
}

std::string to_string(const PlacedBodyTally& tally) {
  return std::to_string(tally.poses) + " posed pairs, " + std::to_string(tally.warm) + " warm, " +
         std::to_string(tally.certified) + " certified, " + std::to_string(tally.overlaps) + " overlaps\n";
}

}  // namespace raygauge::soak
