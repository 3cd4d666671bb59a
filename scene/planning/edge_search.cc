// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/planning/edge_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "raygauge/exceptions.h"
#include "raygauge/sets/pose.h"
#include "scene/model/part_tree.h"

namespace raygauge {
namespace {

EdgeOptions checked(const EdgeOptions& options) {
  if (!(options.margin >= 0) || !std::isfinite(options.margin))
    throw InvalidParameterError("margin must be a number of at least 0");
  if (!(options.contact > 0) || !std::isfinite(options.contact))
    throw InvalidParameterError("contact must be a number above 0");
  if (options.max_looks < 1) throw InvalidParameterError("max_looks must be at least 1");
  return options;
}

}  // namespace

EdgeSearch::EdgeSearch(const RobotModel& robot, const std::vector<Body>& obstacles,
                       const EdgeOptions& options)
    : options_(checked(options)),
      chain_(robot.tree, robot.joints, robot.base),
      bodies_(edge_bodies(robot, obstacles, chain_)),
      pairs_(robot, chain_, bodies_),
      stage_(chain_, bodies_),
      intervals_(stage_),
      tests_(chain_, bodies_, stage_),
      looks_(options_, bodies_, stage_, tests_, pairs_, result_) {}

void EdgeSearch::forget() {
  pairs_.forget();
  looks_.forget();
  hint_ = -1;
}

void EdgeSearch::check(std::span<const double> q) const {
  if (q.size() != static_cast<std::size_t>(joints())) {
    throw DimensionMismatchError("a configuration of " + std::to_string(q.size()) + " numbers for " +
                                 std::to_string(joints()) + " joints");
  }
  for (const double value : q) {
    if (!std::isfinite(value)) throw NonFiniteError("the value of a joint is not finite");
  }
}

void EdgeSearch::check_times(double from, double to) const {
  if (!std::isfinite(from) || !std::isfinite(to)) throw NonFiniteError("a time is not finite");
  for (const EdgeBody& body : bodies_) {
    if (body.stands || (from >= body.body.motion->start() && to <= body.body.motion->stop())) continue;
    throw InvalidParameterError("the motion of '" + body.body.name + "' is not known from " +
                                std::to_string(from) + " to " + std::to_string(to));
  }
}

void EdgeSearch::begin() {
  stage_.clear();
  tests_.begin_edge();
  intervals_.clear();
  items_.clear();
  result_ = EdgeResult();
  result_.outcome = EdgeOutcome::free;
}

const EdgeResult& EdgeSearch::edge(std::span<const double> q0, std::span<const double> q1, double from,
                                   double to) {
  check(q0);
  check(q1);
  check_times(from, to);
  if (!(from < to)) throw InvalidParameterError("an edge must end after it begins");
  begin();
  chain_.follow(q0, q1, from, to);
  intervals_.cut_at_breaks(bodies_, from, to);
  return search();
}

const EdgeResult& EdgeSearch::configuration(std::span<const double> q, double time) {
  check(q);
  check_times(time, time);
  begin();
  chain_.follow(q, q, time, time + std::max(1.0, std::fabs(time)));
  const int moment = stage_.add(time);
  intervals_.add(moment, moment);
  return search();
}

const EdgeResult& EdgeSearch::path(const JointTrajectory& trajectory) {
  const auto count = static_cast<Eigen::Index>(trajectory.times.size());
  if (count < 1 || trajectory.values.cols() != count) {
    throw InvalidParameterError("a path needs a time at least, and the values of its joints at each");
  }
  const auto column = [&](Eigen::Index k) {
    return std::span<const double>(trajectory.values.col(k).data(),
                                   static_cast<std::size_t>(trajectory.values.rows()));
  };
  if (count == 1) return configuration(column(0), trajectory.times[0]);
  std::int64_t looks = 0, planes = 0, balls = 0;
  for (Eigen::Index k = 0; k + 1 < count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    edge(column(k), column(k + 1), trajectory.times[i], trajectory.times[i + 1]);
    looks += result_.looks;
    planes += result_.plane_tests;
    balls += result_.ball_tests;
    if (result_.outcome != EdgeOutcome::free) break;
  }
  result_.looks = looks;
  result_.plane_tests = planes;
  result_.ball_tests = balls;
  return result_;
}

// Those that are likely to be nearest first; a contact ends it.
const EdgeResult& EdgeSearch::search() {
  if (look_at_hint()) return result_;
  take_first_items();
  while (!items_.empty()) {
    std::pop_heap(items_.begin(), items_.end(), later);
    const Item item = items_.back();
    items_.pop_back();
    if (!handle(item)) return result_;
  }
  return result_;
}

bool EdgeSearch::later(const Item& x, const Item& y) {
  if (x.key != y.key) return x.key > y.key;
  return std::pair(x.parts, x.interval) > std::pair(y.parts, y.interval);
}

void EdgeSearch::add_item(const Item& item) {
  items_.push_back(item);
  std::push_heap(items_.begin(), items_.end(), later);
}

bool EdgeSearch::look_at_hint() {
  if (hint_ < 0) return false;
  for (int i = 0; i < intervals_.size(); ++i) {
    if (looks_.is_contact(pairs_.parts(hint_), intervals_.middle_of(i))) return true;
  }
  return false;
}

// A body of one part is its part, and tested once.
void EdgeSearch::take_first_items() {
  for (int interval = 0; interval < intervals_.size(); ++interval) {
    const EdgeInterval over = intervals_[interval];
    for (int i = 0; i < pairs_.size(); ++i) {
      if (pairs_.first_parts(i + 1) - pairs_.first_parts(i) > 1) {
        ++result_.ball_tests;
        if (tests_.balls_apart(pairs_.pair(i), 0, 0, over.first, over.last, options_.margin)) continue;
      }
      take_parts_of(i, interval);
    }
  }
}

// All, or those in nodes of trees that are not apart.
void EdgeSearch::take_parts_of(int number, int interval) {
  const EdgePair& pair = pairs_.pair(number);
  const EdgeBody& a = bodies_[static_cast<std::size_t>(pair.a)];
  const EdgeBody& b = bodies_[static_cast<std::size_t>(pair.b)];
  if (a.shape_of_node.empty() && b.shape_of_node.empty()) {
    for (int parts = pairs_.first_parts(number); parts < pairs_.first_parts(number + 1); ++parts)
      take_item(parts, interval);
    return;
  }
  const EdgeInterval over = intervals_[interval];
  const auto parts_b = static_cast<int>(b.body.parts.size());
  nodes_.assign(1, {0, 0});
  while (!nodes_.empty()) {
    const NodePair nodes = nodes_.back();
    nodes_.pop_back();
    const PartNode one = part_node(a.body, nodes.a), other = part_node(b.body, nodes.b);
    if (one.part >= 0 && other.part >= 0) {
      take_item(pairs_.first_parts(number) + one.part * parts_b + other.part, interval);
      continue;
    }
    const std::size_t shape_a = a.shape_of(nodes.a), shape_b = b.shape_of(nodes.b);
    ++result_.ball_tests;
    if (tests_.balls_apart(pair, shape_a, shape_b, over.first, over.last, options_.margin)) continue;
    if (other.part >= 0 || (one.part < 0 && one.ball.radius > other.ball.radius)) {
      for_each_child(a.body, one, [&](int child) { nodes_.push_back({child, nodes.b}); });
    } else {
      for_each_child(b.body, other, [&](int child) { nodes_.push_back({nodes.a, child}); });
    }
  }
}

bool EdgeSearch::balls_apart(const EdgeParts& parts, int first, int last) {
  ++result_.ball_tests;
  return tests_.balls_apart(pairs_.pair_of(parts), parts.shape_a, parts.shape_b, first, last,
                            options_.margin);
}

void EdgeSearch::take_item(int number, int interval) {
  const EdgeParts& parts = pairs_.parts(number);
  const EdgeInterval over = intervals_[interval];
  if (balls_apart(parts, over.first, over.last)) return;
  const int middle = intervals_.middle_of(interval);
  add_item({number, interval, tests_.likely_gap(pairs_.pair_of(parts), parts.shape_a, parts.shape_b, middle),
            true});
}

bool EdgeSearch::is_free_at_once(EdgeParts& parts, int interval) {
  if (parts.is_mesh) return is_free_by_sweep(parts, interval);
  return is_free_by_kept_plane(parts, intervals_[interval]);
}

// Surfaces that stay apart are one inside the other all the time or at no time.
bool EdgeSearch::is_free_by_sweep(EdgeParts& parts, int interval) {
  const int middle = intervals_.middle_of(interval);
  const EdgeInterval over = intervals_[interval];
  if (!looks_.surfaces_apart(parts, over.first, middle, over.last)) return false;
  return !parts.is_solid || looks_.is_outside(parts, over.first);
}

bool EdgeSearch::is_free_by_kept_plane(const EdgeParts& parts, const EdgeInterval& over) {
  if (parts.plane.isZero(0)) return false;
  const EdgePair& pair = pairs_.pair_of(parts);
  const auto apart = [&](int moment) {
    return tests_.planes_apart(pair, parts.shape_a, parts.shape_b, moment, parts.plane);
  };
  ++result_.plane_tests;
  const double before = apart(over.first);
  if (!(before > options_.margin)) return false;
  const Sagging sagging = tests_.sagging(pair, parts.shape_a, parts.shape_b, over.first, over.last);
  return least_between(before, apart(over.last), sagging) > options_.margin;
}

// False: it is the end.
bool EdgeSearch::handle(const Item& item) {
  EdgeParts& parts = pairs_.parts(item.parts);
  const int middle = intervals_.middle_of(item.interval);
  if (item.is_first && is_free_at_once(parts, item.interval)) return true;
  if (result_.looks >= options_.max_looks) {
    looks_.give_up(parts, middle);
    return false;
  }
  if (looks_.is_contact(parts, middle)) {
    hint_ = item.parts;
    return false;
  }
  const EdgeInterval over = intervals_[item.interval];
  const bool moment_only = over.first == over.last;
  const double t = stage_.time(middle), from = stage_.time(over.first), to = stage_.time(over.last);
  const EdgePair& pair = pairs_.pair_of(parts);
  const double slack = tests_.slack(pair, parts.shape_a, parts.shape_b, middle);
  const PairAnswer& answer = looks_.answer();
  const bool apart = (parts.is_mesh || answer.normal.size() == 3) && answer.lower - slack > options_.margin;
  if (moment_only || !(from < t && t < to)) {
    if (!apart || !moment_only) looks_.give_up(parts, middle);
    return true;
  }
  if (parts.is_mesh) {
    go_on_with_mesh(item, apart);
    return true;
  }
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();
  if (apart) plane = tests_.to_carrier(pair, middle, Eigen::Vector3d(answer.normal).normalized());
  if (apart) parts.plane = plane;
  go_on(item, plane);
  return true;
}

// Both halves of an interval, as the plane of its middle leaves them; 0: there is none.
void EdgeSearch::go_on(const Item& item, const Eigen::Vector3d& plane) {
  const EdgeParts& parts = pairs_.parts(item.parts);
  const EdgePair& pair = pairs_.pair_of(parts);
  const EdgeInterval over = intervals_[item.interval];
  const bool known = !plane.isZero(0);
  const auto apart = [&](int moment) {
    return tests_.planes_apart(pair, parts.shape_a, parts.shape_b, moment, plane);
  };
  const double now = known ? apart(over.middle) : 0;
  for (const bool is_left : {true, false}) {
    const int first = is_left ? over.first : over.middle;
    const int last = is_left ? over.middle : over.last;
    double there = 0;
    if (known) {
      there = apart(is_left ? first : last);
      const Sagging sagging = tests_.sagging(pair, parts.shape_a, parts.shape_b, first, last);
      if (least_between(now, there, sagging) > options_.margin) continue;
    }
    if (balls_apart(parts, first, last)) continue;
    add_item({item.parts, intervals_.half_of(item.interval, is_left), (now + there) / 2});
  }
}

// Both halves of an interval in whose middle they are apart, if that is known.
void EdgeSearch::go_on_with_mesh(const Item& item, bool known) {
  const EdgeParts& parts = pairs_.parts(item.parts);
  const double now = looks_.answer().lower;
  for (const bool is_left : {true, false}) {
    const int half = intervals_.half_of(item.interval, is_left);
    const EdgeInterval over = intervals_[half];
    if (balls_apart(parts, over.first, over.last)) continue;
    if (known && looks_.surfaces_apart(parts, over.first, intervals_.middle_of(half), over.last)) continue;
    add_item({item.parts, half, now});
  }
}

}  // namespace raygauge
