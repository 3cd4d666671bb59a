// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What does a frame of a moving pair cost inside a scene? Prepared hulls that turn by 0.01 rad and move by
// 0.002 from one instant to the next, beside FCL's distance of the same pairs at the same instants.
#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "baselines/fcl_bodies.h"
#include "bench/pair_bodies.h"
#include "bench/program.h"
#include "bench/timed_medians.h"
#include "raygauge/exceptions.h"
#include "raygauge/scene/scene_run.h"

namespace raygauge::bench {
namespace {

struct Settings {
  std::string body = "hull200";
  std::string effect;  // empty: each in turn
  int pairs = 20;
  int instants = 1001;
  int rounds = 5;
};

// Pair i of the bench of pairs; its second body turns and drifts around the first one.
Scene make_scene(const Settings& settings, SceneEffects effects) {
  constexpr double kTurn = 0.01, kWay = 0.002;  // from one instant to the next
  Scene scene;
  for (int i = 0; i < settings.pairs; ++i) {
    const PosedPair pair = make_pair(settings.body, settings.body, "apart", i);
    const Eigen::Vector3d between = pair.pose_2.translation() - pair.pose_1.translation();
    const Eigen::Vector3d sideways = between.unitOrthogonal();
    TwistMotion::Rates rates;
    rates.velocity = kWay * (settings.instants - 1) * sideways;
    rates.acceleration = SmallVector::Zero(3);
    rates.spin = kTurn * (settings.instants - 1) * (between.normalized() + sideways).normalized();
    const Placement first{pair.pose_1.rotation(), pair.pose_1.translation()};
    const Placement second{pair.pose_2.rotation(), pair.pose_2.translation()};
    const std::string name = std::to_string(i);
    scene.bodies.push_back(make_body("still " + name, {pair.first}, std::make_shared<StaticMotion>(first)));
    scene.bodies.push_back(
        make_body("moving " + name, {pair.second}, std::make_shared<TwistMotion>(second, rates, 0.0)));
    SceneQuery query;
    query.name = "pair " + name;
    query.group_1 = {2 * i};
    query.group_2 = {2 * i + 1};
    query.effects = effects;
    scene.queries.push_back(query);
  }
  for (int k = 0; k < settings.instants; ++k) scene.instants.push_back(k / (settings.instants - 1.0));
  return scene;
}

class Seconds final : public SceneSink {
 public:
  void store(const SceneCellResult& cell) override {
    total += cell.seconds;
    for (const SceneRecord& row : cell.records) solves.push_back(row.seconds);
  }
  std::vector<double> solves;
  double total = 0;
};

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

// FCL's queries of the pairs of a scene.
std::vector<FclQuery> fcl_queries(const Scene& scene) {
  std::vector<FclQuery> queries;
  for (std::size_t i = 0; i + 1 < scene.bodies.size(); i += 2) {
    const auto a = FclBody::of(*scene.bodies[i].parts[0].set),
               b = FclBody::of(*scene.bodies[i + 1].parts[0].set);
    if (!a || !b) throw InvalidParameterError("FCL has no such body");
    queries.emplace_back(*a, *b, FclSolver::libccd);
  }
  return queries;
}

// Seconds of each of FCL's distances, which has no warm start: every frame is a first time.
void time_fcl(const Scene& scene, std::vector<FclQuery>& queries, std::vector<double>& seconds) {
  for (std::size_t i = 0; i < queries.size(); ++i) {
    Eigen::Isometry3d at[2] = {Eigen::Isometry3d::Identity(), Eigen::Isometry3d::Identity()};
    for (const double time : scene.instants) {
      for (std::size_t k = 0; k < 2; ++k) {
        const Placement placed = scene.bodies[2 * i + k].motion->at(time);
        at[k].linear() = placed.R;
        at[k].translation() = placed.t;
      }
      queries[i].place(at[0], at[1]);
      seconds.push_back(seconds_of([&] { queries[i].distance(true); }));
    }
  }
}

// What a measured time has of the clock itself: two readings with nothing between them.
double seconds_of_clock() {
  std::vector<double> seconds;
  for (int i = 0; i < 1001; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return mean_of(seconds);
}

// Medians over the rounds of what holds in one: the clock of the machine wanders, and a round is short. Both
// contenders' times are less those of the clock, but for `whole`.
struct Rounds {
  std::vector<double> median, mean, whole, fcl_median, fcl_mean, ratio, ratio_of_means;

  void add(Seconds& ours, std::vector<double>& theirs) {
    const double clock = seconds_of_clock();
    whole.push_back(1e6 * ours.total / static_cast<double>(ours.solves.size()));
    mean.push_back(1e6 * (mean_of(ours.solves) - clock));
    median.push_back(1e6 * (median_of(ours.solves) - clock));
    fcl_mean.push_back(1e6 * (mean_of(theirs) - clock));
    fcl_median.push_back(1e6 * (median_of(theirs) - clock));
    ratio.push_back(median.back() / fcl_median.back());
    ratio_of_means.push_back(mean.back() / fcl_mean.back());
  }

  void print(const char* name) {
    std::printf("%-16s", name);
    for (auto* column : {&median, &mean, &whole, &fcl_median, &fcl_mean, &ratio, &ratio_of_means}) {
      std::printf(" %9.3f", median_of(*column));
    }
    std::printf("\n");
  }
};

void run(const Settings& settings) {
  struct Row {
    const char* name;
    SceneEffects effects;
  };
  constexpr Row kRows[] = {{"distance", SceneEffects::distance},
                           {"closest points", SceneEffects::distance | SceneEffects::closest_points},
                           {"growth", SceneEffects::growth}};
  std::printf("%-16s %9s %9s %9s %9s %9s %9s %9s\n", "us a frame", "median", "mean", "in all", "FCL", "mean",
              "ratio", "of means");
  for (const Row& row : kRows) {
    if (!settings.effect.empty() && settings.effect != row.name) continue;
    const Scene scene = make_scene(settings, row.effects);
    Rounds rounds;
    std::vector<FclQuery> queries = fcl_queries(scene);
    for (int round = 0; round < settings.rounds; ++round) {
      Seconds ours;
      std::vector<double> theirs;
      run_scene(scene, plan_scene(scene), 1, {}, ours);
      time_fcl(scene, queries, theirs);
      rounds.add(ours, theirs);
    }
    rounds.print(row.name);
  }
}

void add_options(CLI::App& app, Settings& settings) {
  app.add_option("--body", settings.body, "kind of both bodies")->check(CLI::IsMember(body_kinds()));
  app.add_option("--effect", settings.effect, "only this one")
      ->check(CLI::IsMember({"distance", "closest points", "growth"}));
  app.add_option("--pairs", settings.pairs)->check(CLI::Range(1, 1000));
  app.add_option("--instants", settings.instants)->check(CLI::Range(2, 100000));
  app.add_option("--rounds", settings.rounds)->check(CLI::Range(1, 100));
}

}  // namespace
}  // namespace raygauge::bench

int main(int argc, char** argv) {
  return raygauge::bench::run_with_options(
      "raygauge_scene_frames", "The cost of a frame of a moving pair inside a scene, beside FCL's distance.",
      raygauge::bench::add_options, raygauge::bench::run, argc, argv);
}
