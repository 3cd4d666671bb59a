// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Which pairs of many moving bodies come within a distance, and at which instants? A scene beside FCL's
// dynamic AABB tree with libccd's distance, which does the same at every instant.
#include <fcl/fcl.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "bench/fcl_geometry.h"
#include "bench/program.h"
#include "bench/timed_medians.h"
#include "raygauge/scene/scene_run.h"

namespace raygauge::bench {
namespace {

using Pairs = std::map<std::array<int, 3>, double>;  // instant, a < b: the distance

struct Settings {
  int bodies = 200;
  int instants = 1000;
  double room = 6;
  double way = 6;
  double within = 0.1;
  int threads = 1;
  int rounds = 3;
};

constexpr std::array kKinds = {GeometryKind::box, GeometryKind::capsule, GeometryKind::cylinder,
                               GeometryKind::ellipsoid};

struct Crowd {
  Scene scene;
  std::vector<std::shared_ptr<fcl::CollisionGeometryd>> fcl;
};

// Every body flies straight through the room, spinning.
Crowd make_crowd(const Settings& settings) {
  Random random(1);
  Crowd crowd;
  for (int i = 0; i < settings.bodies; ++i) {
    const Geometry geometry =
        make_geometry(kKinds[static_cast<std::size_t>(i) % kKinds.size()], 0.1, 0.4, random);
    TwistMotion::Rates rates;
    rates.velocity = uniform_vector(random, settings.way);
    rates.acceleration = SmallVector::Zero(3);
    rates.spin = uniform_vector(random, 3.0);
    Placement first = Placement::identity(3);
    first.R = rotation_about(uniform_vector(random, 3.0));
    first.t = uniform_vector(random, settings.room) - 0.5 * rates.velocity;
    crowd.scene.bodies.push_back(make_body("body " + std::to_string(i), {geometry.set},
                                           std::make_shared<TwistMotion>(first, rates, 0.0)));
    crowd.fcl.push_back(geometry.fcl);
  }
  for (int k = 0; k < settings.instants; ++k) {
    crowd.scene.instants.push_back(k / static_cast<double>(settings.instants - 1));
  }
  SceneQuery query;
  query.name = "near";
  query.within = settings.within;
  for (int i = 0; i < settings.bodies; ++i) query.group_1.push_back(i);
  query.group_2 = query.group_1;
  crowd.scene.queries.push_back(query);
  return crowd;
}

class Collector final : public SceneSink {
 public:
  void store(const SceneCellResult& cell) override {
    const std::lock_guard lock(mutex_);
    for (const SceneRecord& row : cell.records) {
      pairs[{static_cast<int>(row.instant), row.body_a, row.body_b}] = row.distance;
    }
    counters += cell.counters;
  }
  Pairs pairs;
  SceneCounters counters;

 private:
  std::mutex mutex_;
};

struct TreeState {
  double within = 0;
  int instant = 0;
  std::int64_t distances = 0;
  Pairs pairs;
  fcl::DistanceRequestd request;
};

// The tree skips what is farther than `least`, which is always what is asked for.
bool on_pair(fcl::CollisionObjectd* one, fcl::CollisionObjectd* other, void* data, double& least) {
  auto& state = *static_cast<TreeState*>(data);
  fcl::DistanceResultd result;
  const double d = fcl::distance(one, other, state.request, result);
  ++state.distances;
  if (d <= state.within) {
    const auto a = static_cast<int>(reinterpret_cast<std::intptr_t>(one->getUserData()));
    const auto b = static_cast<int>(reinterpret_cast<std::intptr_t>(other->getUserData()));
    state.pairs[{state.instant, std::min(a, b), std::max(a, b)}] = std::max(d, 0.0);
  }
  least = state.within;
  return false;
}

void run_tree(const Crowd& crowd, TreeState& state) {
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects;
  fcl::DynamicAABBTreeCollisionManagerd tree;
  for (std::size_t i = 0; i < crowd.fcl.size(); ++i) {
    objects.push_back(std::make_unique<fcl::CollisionObjectd>(crowd.fcl[i]));
    objects.back()->setUserData(reinterpret_cast<void*>(static_cast<std::intptr_t>(i)));
    tree.registerObject(objects.back().get());
  }
  for (std::size_t k = 0; k < crowd.scene.instants.size(); ++k) {
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const Placement at = crowd.scene.bodies[i].motion->at(crowd.scene.instants[k]);
      objects[i]->setTransform(Eigen::Matrix3d(at.R), Eigen::Vector3d(at.t));
      objects[i]->computeAABB();
    }
    if (k == 0) tree.setup();
    tree.update();
    state.instant = static_cast<int>(k);
    tree.distance(&state, on_pair);
  }
}

void compare(const Pairs& ours, const Pairs& theirs) {
  std::size_t missing = 0, more = 0;
  double worst = 0;
  for (const auto& [key, d] : ours) {
    const auto found = theirs.find(key);
    missing += found == theirs.end() ? 1 : 0;
    if (found != theirs.end()) worst = std::max(worst, std::abs(found->second - d));
  }
  for (const auto& [key, d] : theirs) more += ours.count(key) == 0 ? 1 : 0;
  std::printf("pairs found %zu; FCL misses %zu, has %zu more, differs by %.1e at most\n", ours.size(),
              missing, more, worst);
}

void run(const Settings& settings) {
  const Crowd crowd = make_crowd(settings);
  std::vector<double> ours, theirs;
  for (int round = 0; round < settings.rounds; ++round) {
    Collector collector;
    TreeState state;
    state.within = settings.within;
    ours.push_back(seconds_of(
        [&] { run_scene(crowd.scene, plan_scene(crowd.scene), settings.threads, {}, collector); }));
    theirs.push_back(seconds_of([&] { run_tree(crowd, state); }));
    if (round > 0) continue;
    const double looks = 0.5 * settings.bodies * (settings.bodies - 1.0) * settings.instants;
    compare(collector.pairs, state.pairs);
    std::printf("solves %lld, %.3f %% of brute force; FCL distances %lld\n",
                static_cast<long long>(collector.counters.solves()),
                100.0 * static_cast<double>(collector.counters.solves()) / looks,
                static_cast<long long>(state.distances));
  }
  std::sort(ours.begin(), ours.end());
  std::sort(theirs.begin(), theirs.end());
  const auto middle = static_cast<std::size_t>(settings.rounds / 2);
  std::printf("scene %.3f s on %d threads, FCL's tree %.3f s on one, ratio %.3f\n", ours[middle],
              settings.threads, theirs[middle], ours[middle] / theirs[middle]);
}

void add_options(CLI::App& app, Settings& settings) {
  app.add_option("--bodies", settings.bodies)->check(CLI::Range(2, 5000));
  app.add_option("--instants", settings.instants)->check(CLI::Range(2, 100000));
  app.add_option("--room", settings.room, "half edge of the room")->check(CLI::PositiveNumber);
  app.add_option("--way", settings.way, "greatest way of a body along each axis")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--within", settings.within)->check(CLI::PositiveNumber);
  app.add_option("--threads", settings.threads)->check(CLI::Range(1, 1024));
  app.add_option("--rounds", settings.rounds)->check(CLI::Range(1, 100));
}

}  // namespace
}  // namespace raygauge::bench

int main(int argc, char** argv) {
  return raygauge::bench::run_with_options(
      "raygauge_scene_tree",
      "Pairs of many moving bodies within a distance, by a scene and by FCL's dynamic AABB tree.",
      raygauge::bench::add_options, raygauge::bench::run, argc, argv);
}
