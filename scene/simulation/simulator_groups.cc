// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "scene/simulation/islands.h"
#include "scene/simulation/simulator.h"
#include "scene/simulation/tuning.h"

// Bodies that cannot meet within a step take it by themselves: in groups, each cut where it must be, on any
// thread. What a group finds does not depend on where or when it is asked.
namespace raygauge {
namespace {

constexpr double kFaster = 1.1;  // than now, bodies may become within a step before it is taken anew
constexpr int kMostTrials = 12;  // of one step; then all bodies are one group

/// One solver for many threads.
class InTurn final : public FrictionSolver {
 public:
  explicit InTurn(FrictionSolver& solver) : solver_(solver) {}

  void solve(const FrictionProblem& problem, Eigen::VectorXd& r) override {
    const std::lock_guard lock(mutex_);
    solver_.solve(problem, r);
  }

 private:
  FrictionSolver& solver_;
  std::mutex mutex_;
};

// At least as far as any point of the body has moved.
double way_of(const std::vector<MotionPiece>& pieces, double reach, double end) {
  double way = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const MotionPiece& piece = pieces[k];
    const double time = (k + 1 < pieces.size() ? pieces[k + 1].start : end) - piece.start;
    way += (piece.velocity.norm() + reach * piece.spin.norm()) * time;
    way += piece.acceleration.norm() * time * time / 2;
  }
  return way;
}

// The steps of groups that are still the same.
std::vector<GroupStep> kept(const std::vector<BodyGroup>& before, std::vector<GroupStep>& steps,
                            const std::vector<BodyGroup>& groups) {
  std::map<std::vector<int>, std::size_t> known;
  for (std::size_t k = 0; k < steps.size(); ++k) known.emplace(before[k].bodies, k);
  std::vector<GroupStep> all(groups.size());
  for (std::size_t k = 0; k < groups.size(); ++k) {
    const auto found = known.find(groups[k].bodies);
    if (found != known.end()) all[k] = std::move(steps[found->second]);
  }
  return all;
}

}  // namespace

void Simulator::make_steppers() {
  const int threads = std::max(1, hooks_.threads);
  begun_ = std::this_thread::get_id();
  if (friction_ != nullptr && threads > 1) in_turn_ = std::make_unique<InTurn>(*friction_);
  FrictionSolver* const friction = in_turn_ ? in_turn_.get() : friction_;
  const auto stepper = [&] {
    return std::make_unique<GroupStepper>(dynamics_, *pairs_, bodies_, parts_, friction,
                                          [this] { return stop_now(); });
  };
  whole_ = stepper();
  if (threads == 1) return;
  for (int k = 0; k < threads; ++k) steppers_.add(stepper());
  team_.resize(threads);
  pairs_->share_with(team_, threads);
  whole_->share_with(team_, threads);
}

// Asked on the thread that began.
bool Simulator::stop_now() {
  if (std::this_thread::get_id() == begun_ && hooks_.stop && hooks_.stop()) stopped_ = true;
  return stopped_;
}

// That cannot meet each other on their ways.
std::vector<std::vector<int>> Simulator::groups_of(const std::vector<double>& ways, double dt) {
  Islands islands(bodies_.size());
  pairs_->recall(normals_);
  for (const auto& [a, b] : pairs_->meeting(t_, dt, ways))
    islands.join(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
  std::map<std::size_t, std::vector<int>> of_root;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (bodies_[b].reacts()) of_root[islands.root(b)].push_back(static_cast<int>(b));
  }
  std::vector<std::vector<int>> all;
  for (auto& [root, group] : of_root) all.push_back(std::move(group));
  return all;
}

// How far bodies go within dt, if nothing hits them hard.
void Simulator::expect_ways(double dt) {
  const double g = dynamics_.gravity ? dynamics_.gravity->norm() : 0.0;
  double driven = 0;
  for (const SimulatedBody& body : bodies_) {
    if (!body.reacts()) driven = std::max(driven, body.motion->bound(t_, t_ + dt).speed(body.reach));
  }
  ways_.resize(bodies_.size());
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const SimulatedBody& body = bodies_[b];
    ways_[b] = kFaster * (body.v.norm() + g * dt + body.spin.norm() * body.reach + driven) * dt;
  }
}

// What the groups begin with of the step before.
std::vector<BodyGroup> Simulator::with_memory(const std::vector<std::vector<int>>& members) const {
  std::vector<BodyGroup> groups;
  std::vector<std::size_t> group_of(bodies_.size(), 0);
  for (const std::vector<int>& bodies : members) {
    for (const int b : bodies) group_of[static_cast<std::size_t>(b)] = groups.size();
    groups.push_back({bodies, {}, {}});
  }
  const auto of = [&](int a, int b) -> BodyGroup& {
    const bool first = bodies_[static_cast<std::size_t>(a)].reacts();
    return groups[group_of[static_cast<std::size_t>(first ? a : b)]];
  };
  for (const ContactUnknown& one : last_) of(one.a, one.b).last.push_back(one);
  for (const KnownNormal& one : normals_) {
    const auto owner = [this](int part) { return parts_[static_cast<std::size_t>(part)].owner; };
    of(owner(one.part_a), owner(one.part_b)).normals.push_back(one);
  }
  return groups;
}

// Those that are not done. A group of most bodies is shared by all threads; the others are, each by one, the
// largest first.
void Simulator::step_groups(const std::vector<BodyGroup>& groups, double to, std::vector<GroupStep>& steps) {
  const auto number = static_cast<std::int64_t>(log_.steps.size());
  const std::size_t threads = std::max<std::size_t>(1, steppers_.all().size());
  std::size_t bodies = 0;
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < groups.size(); ++k) {
    if (steps[k].done) continue;
    open.push_back(k);
    bodies += groups[k].bodies.size();
  }
  std::stable_sort(open.begin(), open.end(), [&groups](std::size_t one, std::size_t other) {
    return groups[one].bodies.size() > groups[other].bodies.size();
  });
  std::size_t next = 0;  // of the groups that one thread takes
  while (next < open.size() && (threads == 1 || bodies < tuned::kBodiesOfThreads ||
                                groups[open[next]].bodies.size() >
                                    std::max<std::size_t>(tuned::kBodiesOfThreads, bodies / threads)))
    ++next;
  for (std::size_t k = 0; k < next; ++k)
    steps[open[k]] = whole_->step(groups[open[k]], bodies_, t_, to, number);
  share_work(&team_, open.size() - next, 1, true, [&](std::size_t first, std::size_t last) {
    steppers_.lend([&](GroupStepper& stepper) {
      for (std::size_t k = next + first; k < next + last; ++k)
        steps[open[k]] = stepper.step(groups[open[k]], bodies_, t_, to, number);
    });
  });
  log_.counters += whole_->take_counters();
  for (const auto& stepper : steppers_.all()) log_.counters += stepper->take_counters();
}

// Bodies have gone farther than their groups were made for: these are made anew, with room for it.
bool Simulator::went_too_far(const std::vector<BodyGroup>& groups, const std::vector<GroupStep>& steps,
                             double to) {
  bool any = false;
  for (std::size_t k = 0; k < groups.size() && groups.size() > 1; ++k) {
    for (std::size_t i = 0; i < groups[k].bodies.size(); ++i) {
      const auto b = static_cast<std::size_t>(groups[k].bodies[i]);
      const double way = way_of(steps[k].pieces[i], bodies_[b].reach, to);
      if (!(way > ways_[b])) continue;
      ways_[b] = kFaster * way;
      any = true;
    }
  }
  return any;
}

// False: it is to stop, and is not at the end.
bool Simulator::step(double to) {
  while (hooks_.advance && t_ < to) {
    if (stop_now()) return false;
    advance(to);
  }
  if (hooks_.advance) return true;
  std::vector<int> all;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (bodies_[b].reacts()) all.push_back(static_cast<int>(b));
  }
  expect_ways(to - t_);
  std::vector<BodyGroup> groups;
  std::vector<GroupStep> steps;
  for (int trial = 0; trial == 0 || went_too_far(groups, steps, to); ++trial) {
    const bool one = all.size() == 1 || trial >= kMostTrials;
    const std::vector<BodyGroup> next =
        with_memory(one ? std::vector<std::vector<int>>{all} : groups_of(ways_, to - t_));
    steps = kept(groups, steps, next);
    groups = next;
    step_groups(groups, to, steps);
    if (!std::all_of(steps.begin(), steps.end(), [](const GroupStep& step) { return step.done; }))
      return false;
  }
  pairs_->forget(normals_);
  take(groups, steps);
  t_ = to;
  return true;
}

void Simulator::take(const std::vector<BodyGroup>& groups, std::vector<GroupStep>& steps) {
  last_.clear();
  normals_.clear();
  row_.substeps = 1;
  const auto first = static_cast<std::ptrdiff_t>(log_.contacts.size());
  for (std::size_t k = 0; k < groups.size(); ++k) {
    GroupStep& step = steps[k];
    for (std::size_t i = 0; i < groups[k].bodies.size(); ++i) {
      const auto b = static_cast<std::size_t>(groups[k].bodies[i]);
      bodies_[b] = std::move(step.bodies[i]);
      bodies_[b].motion = nullptr;
      log_.pieces[b].insert(log_.pieces[b].end(), step.pieces[i].begin(), step.pieces[i].end());
    }
    log_.contacts.insert(log_.contacts.end(), step.contacts.begin(), step.contacts.end());
    last_.insert(last_.end(), step.last.begin(), step.last.end());
    normals_.insert(normals_.end(), step.normals.begin(), step.normals.end());
    row_.substeps += step.row.substeps - 1;
    row_.impacts += step.row.impacts;
    row_.contacts += step.row.contacts;
    row_.residual = std::max(row_.residual, step.row.residual);
    row_.least_distance = std::min(row_.least_distance, step.row.least_distance);
  }
  std::stable_sort(
      log_.contacts.begin() + first, log_.contacts.end(),
      [](const ContactRecord& one, const ContactRecord& other) { return one.time < other.time; });
}

}  // namespace raygauge
