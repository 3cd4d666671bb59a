// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What does linearising friction cones cost a grasp's quality, and how long does the quality take? Random
// contacts on the unit sphere, their normals tilted at random.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "bench/program.h"
#include "bench/timed_medians.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/grasp_wrenches.h"

namespace raygauge::bench {
namespace {

using Contacts = std::vector<GraspContact>;
using Random = std::mt19937_64;

struct Settings {
  std::vector<int> contacts = {3, 4, 5, 6, 8};
  std::vector<int> edges = {4, 8, 16};
  double friction = 0.5, tolerance = 1e-6;
  int grasps = 100;
};

Contacts random_grasp(int count, double friction, Random& random) {
  constexpr double kTilt = 0.3;
  std::normal_distribution<double> normal;
  const auto gaussian = [&] { return Eigen::Vector3d(normal(random), normal(random), normal(random)); };
  Contacts contacts;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d p = gaussian().normalized();
    contacts.push_back({p, -p + kTilt * gaussian(), friction});
  }
  return contacts;
}

// The quality of many grasps, with one number of edges.
struct Column {
  std::vector<double> upper, lower, milliseconds;
  int not_closed = 0;  // of those with force closure
};

Column measure(const std::vector<Contacts>& grasps, int edges, double tolerance) {
  DistanceOptions options;
  options.tolerance = tolerance;
  DepthSolver solver(options);
  const Ball metric(Vector::Zero(6), 1.0);
  Column column;
  for (const Contacts& contacts : grasps) {
    const GraspWrenches wrenches(contacts, GraspForces::sum, edges);
    const ObjectDepth* depth = nullptr;
    column.milliseconds.push_back(1e3 * seconds_of([&] { depth = &solver.solve(wrenches, metric); }));
    column.lower.push_back(depth->lower);
    column.upper.push_back(depth->upper);
    if (depth->lower > 0 && depth->status != DistanceStatus::optimal) ++column.not_closed;
  }
  return column;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return NAN;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void print(int contacts, const char* cones, const Column& column, const Column& exact) {
  std::vector<double> loss;
  for (std::size_t i = 0; i < column.lower.size(); ++i)
    if (exact.lower[i] > 0) loss.push_back(100 * (1 - column.upper[i] / exact.upper[i]));
  std::printf("%8d  %-8s %7zu %10d  %8.3f %8.3f  %7.2f %7.2f\n", contacts, cones, loss.size(),
              column.not_closed, quantile(column.milliseconds, 0.5), quantile(column.milliseconds, 1),
              quantile(loss, 0.5), quantile(loss, 1));
}

void options(CLI::App& app, Settings& settings) {
  app.add_option("--contacts", settings.contacts, "numbers of contacts")
      ->delimiter(',')
      ->check(CLI::Range(2, 100));
  app.add_option("--edges", settings.edges, "of pyramids")->delimiter(',')->check(CLI::Range(3, 1000));
  app.add_option("--friction", settings.friction, "coefficient")->check(CLI::NonNegativeNumber);
  app.add_option("--tolerance", settings.tolerance, "of the gap")->check(CLI::Range(1e-14, 0.5));
  app.add_option("--grasps", settings.grasps, "of each number of contacts")->check(CLI::PositiveNumber);
}

void run(const Settings& settings) {
  std::printf("contacts  cones    closure not proven  ms median      max  loss/%% median   max\n");
  for (const int count : settings.contacts) {
    Random random(static_cast<std::uint64_t>(count));
    std::vector<Contacts> grasps;
    for (int i = 0; i < settings.grasps; ++i)
      grasps.push_back(random_grasp(count, settings.friction, random));
    const Column exact = measure(grasps, 0, settings.tolerance);
    print(count, "exact", exact, exact);
    for (const int edges : settings.edges) {
      const Column column = measure(grasps, edges, settings.tolerance);
      print(count, (std::to_string(edges) + " edges").c_str(), column, exact);
    }
  }
}

}  // namespace
}  // namespace raygauge::bench

int main(int argc, char** argv) {
  return raygauge::bench::run_with_options<raygauge::bench::Settings>(
      "raygauge_grasps",
      "What does linearising friction cones cost, and how long does a grasp's quality take?",
      raygauge::bench::options, raygauge::bench::run, argc, argv);
}
