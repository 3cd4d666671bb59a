// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/planning/link_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "raygauge/meshes/mesh.h"
#include "scene/planning/edge_pair.h"
#include "scene/planning/joint_box.h"
#include "scene/planning/touching_links.h"
#include "scene/queries/part_solver.h"

namespace raygauge {
namespace {

// Configurations tried before boxes are; how many of them are improved, and in how many steps.
constexpr int kSamples = 256, kStarts = 3, kImprovements = 120;

// Of a distance that is compared with how far bodies move: more digits save no box.
constexpr double kTolerance = 1e-3;

// Halving a range 50 times loses at most so much of its ends.
constexpr double kHalvings = 1e-13;

RobotModel model_of(const RobotModel& robot, int a, int b) {
  RobotModel two = robot;
  two.ignored.clear();
  two.bodies = {robot.bodies[static_cast<std::size_t>(a)], robot.bodies[static_cast<std::size_t>(b)]};
  return two;
}

bool later(const JointBox& x, const JointBox& y) { return x.key > y.key; }

class PairSearch {
 public:
  PairSearch(const RobotModel& robot, const std::vector<JointRange>& ranges, int a, int b,
             const CollisionMatrixOptions& options)
      : options_(options),
        model_(model_of(robot, a, b)),
        chain_(model_.tree, model_.joints, model_.base),
        bodies_(edge_bodies(model_, {}, chain_)),
        stage_(chain_, bodies_),
        tests_(chain_, bodies_, stage_),
        between_(model_.tree, chain_, bodies_[0].link, bodies_[1].link),
        placed_(3),
        ranges_(ranges) {
    solver_.set_tolerance(kTolerance);
    for (int i = 1; i < static_cast<int>(bodies_[0].shapes.size()); ++i)
      for (int j = 1; j < static_cast<int>(bodies_[1].shapes.size()); ++j) parts_.emplace_back(i, j);
    memory_.resize(parts_.size());
    for (int k = 0; k < static_cast<int>(parts_.size()); ++k)
      is_mesh_.push_back(is_mesh(0, shape_a(k)) || is_mesh(1, shape_b(k)));
    verdict_.body_a = a;
    verdict_.body_b = b;
    verdict_.joints = static_cast<int>(between_.joints().size());
    for (const JointRange& range : ranges_) q_.push_back(range.lower + (range.upper - range.lower) / 2);
    half_.assign(q_.size(), 0.0);
  }

  LinkVerdict run() {
    JointBox whole = whole_box();
    if (whole.middle.empty()) {
      look_once(whole);
      return verdict_;
    }
    try_samples(whole);
    if (meets_ && !decided() && !has_mesh() && touch_everywhere(model_, ranges_, options_.contact)) {
      verdict_.contact = LinkContact::always;
      return verdict_;
    }
    if (!decided()) search(std::move(whole));
    if (decided()) {
      verdict_.contact = LinkContact::sometimes;
      verdict_.undecided = 0;
    }
    if (verdict_.contact != LinkContact::never) verdict_.least = 0;
    return verdict_;
  }

 private:
  bool decided() const { return !verdict_.contact_at.empty() && !verdict_.free_at.empty(); }

  JointBox whole_box() const {
    JointBox box;
    for (const int joint : between_.joints()) {
      const JointRange& range = ranges_[static_cast<std::size_t>(joint)];
      box.half.push_back((range.upper - range.lower) / 2);
      box.middle.push_back(range.lower + box.half.back());
    }
    return box;
  }

  /// Of bodies between which no joint is.
  void look_once(JointBox& whole) {
    stand(whole.middle);
    ++verdict_.boxes;
    verdict_.least = apart(whole, 0);
    if (verdict_.least > 0) verdict_.contact = LinkContact::never;
    if (!verdict_.contact_at.empty()) verdict_.contact = LinkContact::always;
    verdict_.undecided = verdict_.contact == LinkContact::undecided ? 1 : 0;
  }

  void stand(const std::vector<double>& middle) {
    for (std::size_t k = 0; k < middle.size(); ++k)
      q_[static_cast<std::size_t>(between_.joints()[k])] = middle[k];
    stage_.clear();
    chain_.follow(q_, q_, 0, 1);
    stage_.add(0);
    stage_.place(0, bodies_[0], bodies_[1], placed_);
  }

  /// How far the bodies move in a box, against each other, from where they stand.
  double motion_in(JointBox& box) {
    for (std::size_t k = 0; k < box.half.size(); ++k) {
      const auto joint = static_cast<std::size_t>(between_.joints()[k]);
      const JointRange& range = ranges_[joint];
      const double loss = kHalvings * (1 + std::max(std::fabs(range.lower), std::fabs(range.upper)));
      half_[joint] = box.half[k] > 0 ? box.half[k] + loss : 0;
    }
    between_.stand(&stage_.link(0, 0), bodies_[0], bodies_[1]);
    const double motion = between_.motion(half_);
    box.widest = between_.widest();
    return motion;
  }

  std::size_t shape_a(int parts) const { return static_cast<std::size_t>(parts_[index(parts)].first); }
  std::size_t shape_b(int parts) const { return static_cast<std::size_t>(parts_[index(parts)].second); }
  bool is_mesh(std::size_t body, std::size_t shape) const {
    return as_mesh(*bodies_[body].shapes[shape].part->set) != nullptr;
  }
  bool has_mesh() const { return std::find(is_mesh_.begin(), is_mesh_.end(), true) != is_mesh_.end(); }
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  double slack(int parts) const { return tests_.slack(kPair, shape_a(parts), shape_b(parts), 0); }

  /// Two parts where they stand: certified bounds on their distance, and a plane.
  void look(int parts, bool deep) {
    answer_ = PairAnswer();
    PartMemory& memory = memory_[index(parts)];
    memory.overlapped = false;
    const PartNumbers numbers{static_cast<int>(shape_a(parts)) - 1, static_cast<int>(shape_b(parts)) - 1};
    if (deep) {
      solver_.signed_distance(placed_, numbers, memory, answer_, counters_);
    } else {
      solver_.distance(placed_, numbers, false, memory, answer_, counters_);
    }
    lower_ = std::max(0.0, answer_.lower - slack(parts));
    if (answer_.upper + slack(parts) <= options_.contact) note(verdict_.contact_at);
  }

  void note(std::vector<double>& configuration) const {
    if (configuration.empty()) configuration = q_;
  }

  /// How far the bodies are from one another's origin and from the scene's: what rounding loses goes with it.
  double rounding() const {
    const double size = stage_.at(0, bodies_[0]).t.norm() + stage_.at(0, bodies_[1]).t.norm() +
                        bodies_[0].body.reach + bodies_[1].body.reach;
    return kHalvings * (1 + size);
  }

  /// A lower bound on the distance of the bodies, as good as it has to be to be more than `enough`. The
  /// nearest parts are those of the box from now on, with a plane between them.
  double apart(JointBox& box, double enough) {
    double least = std::numeric_limits<double>::infinity();
    const int first = box.parts;
    const Eigen::Vector3d kept = box.plane;
    for (int k = 0; k < static_cast<int>(parts_.size()); ++k) {
      const int parts = k == 0 ? first : (k <= first ? k - 1 : k);
      double gap = tests_.ball_gap(kPair, shape_a(parts), shape_b(parts), 0) - slack(parts) - rounding();
      if (!(gap > enough) && parts == first && !kept.isZero(0))
        gap = tests_.planes_apart(kPair, shape_a(parts), shape_b(parts), 0, kept);
      const bool looked = !(gap > enough);
      if (looked) {
        look(parts, false);
        gap = lower_;
      }
      if (!(gap < least)) continue;
      least = gap;
      if (!looked) continue;
      box.parts = parts;
      box.plane.setZero();
      if (lower_ > 0 && answer_.normal.size() == 3 && !is_mesh_[index(parts)])
        box.plane = Eigen::Vector3d(answer_.normal).normalized();
    }
    if (least > 0) note(verdict_.free_at);
    return least;
  }

  /// The greatest proven depth of two parts, as far as it is not more than `enough`; 0: none is proven.
  double depth(JointBox& box, double enough) {
    double deepest = 0, nearest = std::numeric_limits<double>::infinity();
    const int first = box.parts;
    for (int k = 0; k < static_cast<int>(parts_.size()) && !(deepest > enough); ++k) {
      const int parts = k == 0 ? first : (k <= first ? k - 1 : k);
      look(parts, !is_mesh_[index(parts)]);
      nearest = std::min(nearest, lower_);
      const double own = is_mesh_[index(parts)] ? depth_of_mesh(parts, enough)
                                                : answer_.depth_lower - slack(parts);  // NaN: none
      if (own > deepest) {
        deepest = own;
        box.parts = parts;
      }
    }
    if (deepest == 0 && nearest > 0) note(verdict_.free_at);
    return deepest;
  }

  /// Of parts that were looked at: more than `enough` if they share a point however both move by so much.
  double depth_of_mesh(int parts, double enough) {
    const double way = enough + slack(parts) + rounding();
    return way < std::numeric_limits<double>::infinity() && solver_.meets_if_moved(way) ? way : 0;
  }

  /// True: all of the box is proven, one way or the other.
  bool is_proven(JointBox& box) {
    ++verdict_.boxes;
    stand(box.middle);
    const double motion = motion_in(box);
    const double value = meets_ ? depth(box, motion) : apart(box, motion);
    box.key = value - motion;
    if (motion <= options_.contact) box.widest = -1;  // smaller boxes would tell nothing new
    if (!(value > motion)) return false;
    if (!meets_) verdict_.least = std::min(verdict_.least, box.key);
    return true;
  }

  /// The value that the search wants to be small: a distance, or minus a depth.
  double value_at(const std::vector<double>& middle, JointBox& box) {
    stand(middle);
    return meets_ ? depth(box, std::numeric_limits<double>::infinity())
                  : apart(box, std::numeric_limits<double>::infinity());
  }

  /// Random configurations, and steps along joints from the best of them: most pairs that meet sometimes are
  /// found out here.
  void try_samples(JointBox& whole) {
    if (whole.middle.empty()) return;
    std::mt19937_64 random(1);
    std::vector<std::pair<double, std::vector<double>>> samples;
    for (int k = 0; k < kSamples && !decided(); ++k) {
      std::vector<double> middle = whole.middle;
      for (std::size_t i = 0; k > 0 && i < middle.size(); ++i) {
        constexpr double kWhole = 9007199254740992.0;  // 2^53
        const double share = static_cast<double>(random() >> 11U) / kWhole;
        middle[i] += (2 * share - 1) * whole.half[i];
      }
      if (k == 0) {
        value_at(middle, whole);
        meets_ = verdict_.free_at.empty() && !verdict_.contact_at.empty();
      }
      const double value = value_at(middle, whole);
      samples.emplace_back(value, std::move(middle));
    }
    std::sort(samples.begin(), samples.end());
    for (int k = 0; k < kStarts && !decided(); ++k) improve(samples[index(k)], whole);
  }

  void improve(std::pair<double, std::vector<double>> best, JointBox& whole) {
    double step = 0.25;
    int tries = 0;
    while (tries < kImprovements && !decided()) {
      bool better = true;
      while (better && tries < kImprovements && !decided()) {
        better = false;
        for (std::size_t i = 0; i < 2 * best.second.size() && !decided(); ++i, ++tries) {
          std::vector<double> other = best.second;
          const std::size_t at = i / 2;
          const JointRange& range = ranges_[index(between_.joints()[at])];
          other[at] += (i % 2 == 0 ? step : -step) * whole.half[at];
          other[at] = std::clamp(other[at], range.lower, range.upper);
          const double value = value_at(other, whole);
          if (!(value < best.first)) continue;
          best = {value, std::move(other)};
          better = true;
        }
      }
      step /= 2;
    }
  }

  /// The most hopeful box for the other answer first; when a quarter of all boxes are used up, the largest.
  void search(JointBox whole) {
    verdict_.least = meets_ ? 0 : std::numeric_limits<double>::infinity();
    std::vector<JointBox> heap;
    if (!is_proven(whole)) heap.push_back(std::move(whole));
    bool by_volume = false;
    double given_up = 0;
    while (!heap.empty() && verdict_.boxes < options_.max_boxes && !decided()) {
      if (!by_volume && verdict_.boxes > options_.max_boxes / 4) {
        by_volume = true;
        for (JointBox& box : heap) box.key = -box.share;
        std::make_heap(heap.begin(), heap.end(), later);
      }
      std::pop_heap(heap.begin(), heap.end(), later);
      JointBox box = std::move(heap.back());
      heap.pop_back();
      if (box.widest < 0 || box.share < 1e-30) {
        given_up += box.share;
        continue;
      }
      for (const bool left : {true, false}) {
        JointBox half = half_of(box, left);
        if (decided() || is_proven(half)) continue;
        if (by_volume) half.key = -half.share;
        heap.push_back(std::move(half));
        std::push_heap(heap.begin(), heap.end(), later);
      }
    }
    for (const JointBox& box : heap) given_up += box.share;
    verdict_.undecided = given_up;
    if (given_up == 0) verdict_.contact = meets_ ? LinkContact::always : LinkContact::never;
  }

  JointBox half_of(const JointBox& box, bool left) const {
    JointBox half = box;
    const auto found = std::find(between_.joints().begin(), between_.joints().end(), box.widest);
    const auto k = static_cast<std::size_t>(found - between_.joints().begin());
    half.half[k] /= 2;
    half.middle[k] += left ? -half.half[k] : half.half[k];
    half.share /= 2;
    return half;
  }

  static constexpr EdgePair kPair{0, 1};

  CollisionMatrixOptions options_;
  RobotModel model_;
  RobotChain chain_;
  std::vector<EdgeBody> bodies_;
  EdgeStage stage_;
  EdgeTests tests_;
  JointsBetween between_;
  PlacedPair placed_;
  const std::vector<JointRange>& ranges_;
  PartSolver solver_;
  SceneCounters counters_;
  PairAnswer answer_;
  double lower_ = 0;  ///< of the last look: certified
  std::vector<std::pair<int, int>> parts_;
  std::vector<PartMemory> memory_;
  std::vector<bool> is_mesh_;  ///< of parts_
  std::vector<double> q_, half_;
  bool meets_ = false;  ///< contact is what is to be proven
  LinkVerdict verdict_;
};

}  // namespace

LinkVerdict prove_link_pair(const RobotModel& robot, const std::vector<JointRange>& ranges, int a, int b,
                            const CollisionMatrixOptions& options) {
  return PairSearch(robot, ranges, a, b, options).run();
}

}  // namespace raygauge
