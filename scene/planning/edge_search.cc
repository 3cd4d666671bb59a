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

// Distances of a gap that lets the search tell margin and margin + contact apart; more digits than a step
// needs are asked for only where the margin is large.
double tolerance_of(const EdgeOptions& options) {
  constexpr double kStepTolerance = 1e-3;
  return std::clamp(options.contact / (4 * (options.margin + options.contact)), 1e-9, kStepTolerance);
}

EdgeOptions checked(const EdgeOptions& options) {
  if (!(options.margin >= 0) || !std::isfinite(options.margin))
    throw InvalidParameterError("margin must be a number of at least 0");
  if (!(options.contact > 0) || !std::isfinite(options.contact))
    throw InvalidParameterError("contact must be a number above 0");
  if (options.max_looks < 1) throw InvalidParameterError("max_looks must be at least 1");
  return options;
}

void check_pair(const std::pair<int, int>& pair, int bodies) {
  for (const int i : {pair.first, pair.second}) {
    if (i < 0 || i >= bodies) throw InvalidParameterError("there is no body number " + std::to_string(i));
  }
}

}  // namespace

EdgeSearch::EdgeSearch(const RobotModel& robot, const std::vector<Body>& obstacles,
                       const EdgeOptions& options)
    : options_(checked(options)),
      chain_(robot.tree, robot.joints, robot.base),
      bodies_(edge_bodies(robot, obstacles, chain_)),
      stage_(chain_, bodies_),
      tests_(chain_, bodies_, stage_),
      placed_(3) {
  solver_.set_tolerance(tolerance_of(options_));
  take_pairs(robot);
  take_parts();
}

void EdgeSearch::take_pairs(const RobotModel& robot) {
  const auto count = static_cast<int>(bodies_.size());
  std::vector<std::pair<int, int>> ignored;
  for (const std::pair<int, int>& pair : robot.ignored) {
    check_pair(pair, count);
    ignored.emplace_back(std::minmax(pair.first, pair.second));
  }
  std::sort(ignored.begin(), ignored.end());
  for (int a = 0; a < static_cast<int>(robot.bodies.size()); ++a) {
    for (int b = a + 1; b < count; ++b) {
      if (std::binary_search(ignored.begin(), ignored.end(), std::pair(a, b))) continue;
      EdgePair pair{a, b};
      const EdgeBody& other = bodies_[static_cast<std::size_t>(b)];
      if (!other.is_obstacle()) {
        const std::vector<int>& one = chain_.path(bodies_[static_cast<std::size_t>(a)].link);
        const std::vector<int>& two = chain_.path(other.link);
        std::size_t common = 0;
        while (common < std::min(one.size(), two.size()) && one[common] == two[common]) ++common;
        if (common > 0) pair.carrier = one[common - 1];
        pair.left_out_a = pair.left_out_b = common;
      }
      pairs_.push_back(pair);
    }
  }
}

void EdgeSearch::take_parts() {
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    first_parts_.push_back(static_cast<int>(parts_.size()));
    const std::size_t parts_a = bodies_[static_cast<std::size_t>(pairs_[i].a)].body.parts.size();
    const std::size_t parts_b = bodies_[static_cast<std::size_t>(pairs_[i].b)].body.parts.size();
    for (std::size_t a = 1; a <= parts_a; ++a) {
      for (std::size_t b = 1; b <= parts_b; ++b) {
        Parts parts;
        parts.pair = static_cast<int>(i);
        parts.shape_a = a;
        parts.shape_b = b;
        take_kind(parts);
        parts_.push_back(std::move(parts));
      }
    }
  }
  first_parts_.push_back(static_cast<int>(parts_.size()));
}

void EdgeSearch::forget() {
  for (Parts& parts : parts_) {
    parts.memory = PartMemory();
    parts.plane.setZero();
  }
  solver_.forget();
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

int EdgeSearch::add_interval(int first, int last) {
  intervals_.push_back({first, last});
  return static_cast<int>(intervals_.size()) - 1;
}

// Where the motion of an obstacle breaks an interval ends: bounds hold within pieces.
void EdgeSearch::cut_at_breaks(double from, double to) {
  int first = stage_.add(from);
  for (double t = from; t < to;) {
    double end = to;
    for (const EdgeBody& body : bodies_) {
      if (!body.stands) end = std::min(end, body.body.motion->next_break(t));
    }
    const int last = stage_.add(end);
    add_interval(first, last);
    first = last;
    t = end;
  }
}

const EdgeResult& EdgeSearch::edge(std::span<const double> q0, std::span<const double> q1, double from,
                                   double to) {
  check(q0);
  check(q1);
  check_times(from, to);
  if (!(from < to)) throw InvalidParameterError("an edge must end after it begins");
  begin();
  chain_.follow(q0, q1, from, to);
  cut_at_breaks(from, to);
  return search();
}

const EdgeResult& EdgeSearch::configuration(std::span<const double> q, double time) {
  check(q);
  check_times(time, time);
  begin();
  chain_.follow(q, q, time, time + std::max(1.0, std::fabs(time)));
  const int moment = stage_.add(time);
  add_interval(moment, moment);
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

// Made where it is not there yet.
int EdgeSearch::middle_of(std::size_t interval) {
  Interval& over = intervals_[interval];
  if (over.first == over.last) over.middle = over.first;
  if (over.middle < 0) {
    const double from = stage_.time(over.first), to = stage_.time(over.last);
    over.middle = stage_.add(from + (to - from) / 2);
  }
  return over.middle;
}

bool EdgeSearch::look_at_hint() {
  if (hint_ < 0) return false;
  for (std::size_t i = 0; i < intervals_.size(); ++i) {
    if (is_contact(parts_[static_cast<std::size_t>(hint_)], middle_of(i))) return true;
  }
  return false;
}

// A body of one part is its part, and tested once.
void EdgeSearch::take_first_items() {
  for (int interval = 0; interval < static_cast<int>(intervals_.size()); ++interval) {
    const Interval over = intervals_[static_cast<std::size_t>(interval)];
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (first_parts_[i + 1] - first_parts_[i] > 1) {
        ++result_.ball_tests;
        if (tests_.balls_apart(pairs_[i], 0, 0, over.first, over.last, options_.margin)) continue;
      }
      take_parts_of(i, interval);
    }
  }
}

// All, or those in nodes of trees that are not apart.
void EdgeSearch::take_parts_of(std::size_t number, int interval) {
  const EdgePair& pair = pairs_[number];
  const EdgeBody& a = bodies_[static_cast<std::size_t>(pair.a)];
  const EdgeBody& b = bodies_[static_cast<std::size_t>(pair.b)];
  if (a.shape_of_node.empty() && b.shape_of_node.empty()) {
    for (int parts = first_parts_[number]; parts < first_parts_[number + 1]; ++parts)
      take_item(parts, interval);
    return;
  }
  const Interval over = intervals_[static_cast<std::size_t>(interval)];
  const auto parts_b = static_cast<int>(b.body.parts.size());
  nodes_.assign(1, {0, 0});
  while (!nodes_.empty()) {
    const NodePair nodes = nodes_.back();
    nodes_.pop_back();
    const PartNode one = part_node(a.body, nodes.a), other = part_node(b.body, nodes.b);
    if (one.part >= 0 && other.part >= 0) {
      take_item(first_parts_[number] + one.part * parts_b + other.part, interval);
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

void EdgeSearch::take_item(int number, int interval) {
  const Parts& parts = parts_[static_cast<std::size_t>(number)];
  const EdgePair& pair = pairs_[static_cast<std::size_t>(parts.pair)];
  const Interval over = intervals_[static_cast<std::size_t>(interval)];
  ++result_.ball_tests;
  if (tests_.balls_apart(pair, parts.shape_a, parts.shape_b, over.first, over.last, options_.margin)) return;
  const int middle = middle_of(static_cast<std::size_t>(interval));
  add_item({number, interval, tests_.likely_gap(pair, parts.shape_a, parts.shape_b, middle), true});
}

bool EdgeSearch::is_free_at_once(Parts& parts, int interval) {
  if (parts.is_mesh) return is_free_by_sweep(parts, interval);
  return is_free_by_kept_plane(parts, intervals_[static_cast<std::size_t>(interval)]);
}

bool EdgeSearch::is_free_by_kept_plane(const Parts& parts, const Interval& over) {
  if (parts.plane.isZero(0)) return false;
  const EdgePair& pair = pairs_[static_cast<std::size_t>(parts.pair)];
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
  Parts& parts = parts_[static_cast<std::size_t>(item.parts)];
  const auto number = static_cast<std::size_t>(item.interval);
  const int middle = middle_of(number);
  if (item.is_first && is_free_at_once(parts, item.interval)) return true;
  if (result_.looks >= options_.max_looks) {
    give_up(parts, middle);
    return false;
  }
  if (is_contact(parts, middle)) {
    hint_ = item.parts;
    return false;
  }
  const bool moment_only = intervals_[number].first == intervals_[number].last;
  const double t = stage_.time(middle);
  const double from = stage_.time(intervals_[number].first), to = stage_.time(intervals_[number].last);
  const EdgePair& pair = pairs_[static_cast<std::size_t>(parts.pair)];
  const double slack = tests_.slack(pair, parts.shape_a, parts.shape_b, middle);
  const bool apart = (parts.is_mesh || answer_.normal.size() == 3) && answer_.lower - slack > options_.margin;
  if (moment_only || !(from < t && t < to)) {
    if (!apart || !moment_only) give_up(parts, middle);
    return true;
  }
  if (parts.is_mesh) {
    go_on_with_mesh(item, apart);
    return true;
  }
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();
  if (apart) plane = tests_.to_carrier(pair, middle, Eigen::Vector3d(answer_.normal).normalized());
  if (apart) parts.plane = plane;
  go_on(item, plane);
  return true;
}

// Made where it is not there yet.
int EdgeSearch::half_of(std::size_t interval, bool is_left) {
  const Interval over = intervals_[interval];
  int half = is_left ? over.left : over.right;
  if (half >= 0) return half;
  half = is_left ? add_interval(over.first, over.middle) : add_interval(over.middle, over.last);
  (is_left ? intervals_[interval].left : intervals_[interval].right) = half;
  return half;
}

// Both halves of an interval, as the plane of its middle leaves them; 0: there is none.
void EdgeSearch::go_on(const Item& item, const Eigen::Vector3d& plane) {
  const Parts& parts = parts_[static_cast<std::size_t>(item.parts)];
  const EdgePair& pair = pairs_[static_cast<std::size_t>(parts.pair)];
  const auto number = static_cast<std::size_t>(item.interval);
  const int middle = intervals_[number].middle;
  const bool known = !plane.isZero(0);
  const auto apart = [&](int moment) {
    return tests_.planes_apart(pair, parts.shape_a, parts.shape_b, moment, plane);
  };
  const double now = known ? apart(middle) : 0;
  for (const bool is_left : {true, false}) {
    const int first = is_left ? intervals_[number].first : middle;
    const int last = is_left ? middle : intervals_[number].last;
    double there = 0;
    if (known) {
      there = apart(is_left ? first : last);
      const Sagging sagging = tests_.sagging(pair, parts.shape_a, parts.shape_b, first, last);
      if (least_between(now, there, sagging) > options_.margin) continue;
    }
    ++result_.ball_tests;
    if (tests_.balls_apart(pair, parts.shape_a, parts.shape_b, first, last, options_.margin)) continue;
    add_item({item.parts, half_of(number, is_left), (now + there) / 2});
  }
}

}  // namespace raygauge
