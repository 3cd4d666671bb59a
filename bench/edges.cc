// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What does it cost to prove that a robot moves along an edge without contact, and to find a contact? Random
// edges of a robot among boxes and cylinders, and against itself.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bench/program.h"
#include "bench/timed_medians.h"
#include "raygauge/meshes/mesh.h"
#include "raygauge/scene/edge_checker.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/truncated_cone.h"
#include "scene/input/robot_file.h"

namespace raygauge::bench {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

struct Settings {
  std::string urdf;
  std::vector<std::string> packages;  ///< NAME=FOLDER
  std::string as = "hull";            ///< of meshes; "": as they are
  int edges = 2000;
  int obstacles = 12;
  double length = 0.5;  ///< greatest change of a joint
  double margin = 0;
  int squares = 0;  ///< along the side of a face: obstacles are one mesh, two triangles a square; 0: boxes
  int balls = 0;    ///< on the surfaces: obstacles are one cloud
};

struct Joints {
  std::vector<double> lower, upper;
};

/// The limits of the joints that take a value, ±π where there are none.
Joints joints_of(const cli::Robot& robot) {
  Joints joints;
  for (const cli::JointLimits& limits : cli::limits_of(robot)) {
    joints.lower.push_back(std::max<double>(limits.lower, -EIGEN_PI));
    joints.upper.push_back(std::min<double>(limits.upper, EIGEN_PI));
  }
  return joints;
}

std::vector<double> random_values(const Joints& joints, Random& random) {
  std::vector<double> q;
  for (std::size_t i = 0; i < joints.lower.size(); ++i)
    q.push_back(uniform(random, joints.lower[i], joints.upper[i]));
  return q;
}

/// Its links; pairs that meet in most of 200 configurations meet by design and are left out.
RobotModel model_of(const cli::Robot& robot, const Joints& joints) {
  RobotModel model;
  model.tree = robot.tree;
  model.joints = static_cast<int>(robot.joints.size());
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (!robot.links[i].shapes.empty()) {
      model.bodies.push_back({robot.links[i].name, static_cast<int>(i), robot.links[i].shapes});
    }
  }
  model.ignored = joined_bodies(model);
  constexpr int kConfigurations = 200;
  Random random(5);
  std::vector<std::vector<double>> samples;
  for (int k = 0; k < kConfigurations; ++k) samples.push_back(random_values(joints, random));
  const auto count = static_cast<int>(model.bodies.size());
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      RobotModel pair = model;
      pair.ignored.clear();
      pair.bodies = {model.bodies[static_cast<std::size_t>(a)], model.bodies[static_cast<std::size_t>(b)]};
      EdgeChecker checker(pair, {});
      const auto contacts = std::count_if(samples.begin(), samples.end(), [&](const std::vector<double>& q) {
        return checker.configuration(q).outcome != EdgeOutcome::free;
      });
      if (contacts > kConfigurations / 2) model.ignored.emplace_back(a, b);
    }
  }
  return model;
}

/// A box or a cylinder in it, where it stands.
struct Obstacle {
  Placement where = Placement::identity(3);
  Eigen::Vector3d half;
  bool is_round = false;
};

std::vector<Obstacle> obstacles_around(int count, Random& random) {
  std::vector<Obstacle> obstacles;
  for (int i = 0; i < count; ++i) {
    Obstacle one;
    const double angle = uniform(random, -EIGEN_PI, EIGEN_PI), away = uniform(random, 0.45, 0.9);
    one.where.t = Eigen::Vector3d(away * std::cos(angle), away * std::sin(angle), uniform(random, 0, 1));
    one.where.R = rotation_about({uniform(random, -3, 3), uniform(random, -3, 3), uniform(random, -3, 3)});
    one.half = Eigen::Vector3d(uniform(random, 0.02, 0.2), uniform(random, 0.02, 0.2), 0.02);
    one.is_round = i % 3 == 0;
    obstacles.push_back(one);
  }
  return obstacles;
}

Body convex_body(const Obstacle& one) {
  std::shared_ptr<const ConvexSet> set = std::make_shared<Box>(-one.half, one.half);
  if (one.is_round) {
    const Vector end = Eigen::Vector3d(0, 0, one.half[0]);
    set = std::make_shared<Cylinder>(-end, end, one.half[1] / 2);
  }
  return make_body("obstacle", {set}, std::make_shared<StaticMotion>(one.where));
}

/// The point of face 0…5 of the box at the shares x and y of its sides.
Eigen::Vector3d on_face(const Obstacle& box, int face, double x, double y) {
  Eigen::Vector3d share;
  share[face / 2] = face % 2;
  share[(face / 2 + 1) % 3] = x;
  share[(face / 2 + 2) % 3] = y;
  return box.where.R * box.half.cwiseProduct(2 * share - Eigen::Vector3d::Ones()) + box.where.t;
}

Mesh surface_of(const std::vector<Obstacle>& boxes, int squares) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<MeshTriangle> triangles;
  const auto count = static_cast<int>(boxes.size()) * 6 * squares * squares;
  for (int k = 0; k < count; ++k) {
    const int i = k % squares, j = k / squares % squares, face = k / (squares * squares);
    const auto first = static_cast<std::int32_t>(vertices.size());
    for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
      vertices.push_back(on_face(boxes[static_cast<std::size_t>(face / 6)], face % 6,
                                 static_cast<double>(i + x) / squares, static_cast<double>(j + y) / squares));
    }
    triangles.push_back({first, first + 1, first + 2});
    triangles.push_back({first, first + 2, first + 3});
  }
  return {Eigen::Matrix3Xd::Map(vertices.front().data(), 3, static_cast<Eigen::Index>(vertices.size())),
          triangles};
}

Mesh cloud_of(const std::vector<Obstacle>& boxes, int balls, Random& random) {
  constexpr double kRadius = 0.005;
  Eigen::Matrix3Xd points(3, balls);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    points.col(i) = on_face(boxes[random() % boxes.size()], static_cast<int>(random() % 6),
                            uniform(random, 0, 1), uniform(random, 0, 1));
  }
  return Mesh::cloud(points, kRadius);
}

std::vector<Body> bodies_of(const std::vector<Obstacle>& obstacles, const Settings& settings,
                            Random& random) {
  std::vector<Body> bodies;
  const auto add = [&](const Mesh& mesh) {
    bodies.push_back(make_body("obstacles", {std::make_shared<MeshObject>(mesh)},
                               std::make_shared<StaticMotion>(Placement::identity(3))));
  };
  if (settings.squares > 0) add(surface_of(obstacles, settings.squares));
  if (settings.balls > 0) add(cloud_of(obstacles, settings.balls, random));
  if (!bodies.empty()) return bodies;
  for (const Obstacle& one : obstacles) bodies.push_back(convex_body(one));
  return bodies;
}

struct Times {
  std::vector<double> seconds;
  std::int64_t looks = 0;

  double at(double share) {
    if (seconds.empty()) return 0;
    std::sort(seconds.begin(), seconds.end());
    return seconds[static_cast<std::size_t>(share * static_cast<double>(seconds.size() - 1))];
  }
};

void print(const char* what, Times& times) {
  const double count = std::max<double>(1, static_cast<double>(times.seconds.size()));
  std::printf("%-10s %6zu edges, median %7.1f us, 90 %% within %7.1f us, %5.1f pairs solved\n", what,
              times.seconds.size(), 1e6 * times.at(0.5), 1e6 * times.at(0.9),
              static_cast<double>(times.looks) / count);
}

cli::Robot robot_of(const Settings& settings) {
  cli::RobotMeshes meshes;
  meshes.as = settings.as;
  for (const std::string& package : settings.packages) {
    const std::size_t equals = package.find('=');
    meshes.packages[package.substr(0, equals)] = package.substr(equals + 1);
  }
  return cli::read_robot(settings.urdf, meshes);
}

std::vector<double> near(const std::vector<double>& q, const Joints& joints, double length, Random& random) {
  std::vector<double> other = q;
  for (std::size_t i = 0; i < q.size(); ++i) {
    other[i] = std::clamp(q[i] + uniform(random, -length, length), joints.lower[i], joints.upper[i]);
  }
  return other;
}

/// By outcome, and of single configurations.
struct Tally {
  Times free, contact, undecided, configurations;

  Times& of(EdgeOutcome outcome) {
    if (outcome == EdgeOutcome::free) return free;
    return outcome == EdgeOutcome::contact ? contact : undecided;
  }
};

void time_edge(EdgeChecker& checker, const std::vector<double>& q0, const std::vector<double>& q1,
               Tally& tally) {
  EdgeOutcome outcome = EdgeOutcome::undecided;
  tally.configurations.seconds.push_back(seconds_of([&] { outcome = checker.configuration(q0).outcome; }));
  if (outcome != EdgeOutcome::free || checker.configuration(q1).outcome != EdgeOutcome::free) return;
  const EdgeResult* result = nullptr;
  const double seconds = seconds_of([&] { result = &checker.edge(q0, q1); });
  Times& times = tally.of(result->outcome);
  times.seconds.push_back(seconds);
  times.looks += result->looks;
}

void run(const Settings& settings) {
  const cli::Robot robot = robot_of(settings);
  const Joints joints = joints_of(robot);
  const RobotModel model = model_of(robot, joints);
  Random random(1);
  EdgeOptions options;
  options.margin = settings.margin;
  const std::vector<Obstacle> obstacles = obstacles_around(settings.obstacles, random);
  Random of_cloud(2);
  EdgeChecker checker(model, bodies_of(obstacles, settings, of_cloud), options);
  std::printf("%s: %zu bodies, %d obstacles\n", robot.name.c_str(), model.bodies.size(), settings.obstacles);
  Tally tally;
  while (static_cast<int>(tally.free.seconds.size() + tally.contact.seconds.size()) < settings.edges) {
    const std::vector<double> q = random_values(joints, random);
    time_edge(checker, q, near(q, joints, settings.length, random), tally);
  }
  print("free", tally.free);
  print("in contact", tally.contact);
  print("undecided", tally.undecided);
  std::printf("%-10s %6zu,       median %7.1f us\n", "places", tally.configurations.seconds.size(),
              1e6 * tally.configurations.at(0.5));
}

void add_options(CLI::App& app, Settings& settings) {
  app.add_option("urdf", settings.urdf, "robot")->required()->check(CLI::ExistingFile);
  app.add_option("--package", settings.packages, "NAME=FOLDER of package:// names");
  app.add_option("--as", settings.as,
                 "what meshes are taken as: hull, surface, solid, parts; '': as they are");
  app.add_option("--edges", settings.edges, "edges whose ends are free")->check(CLI::PositiveNumber);
  app.add_option("--obstacles", settings.obstacles, "boxes and cylinders")->check(CLI::NonNegativeNumber);
  app.add_option("--length", settings.length, "greatest change of a joint")->check(CLI::PositiveNumber);
  app.add_option("--squares", settings.squares, "obstacles as one mesh: boxes of so many squares a side")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--balls", settings.balls, "obstacles as one cloud of so many balls")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--margin", settings.margin, "clearance that is proven")->check(CLI::NonNegativeNumber);
}

}  // namespace
}  // namespace raygauge::bench

int main(int argc, char** argv) {
  return raygauge::bench::run_with_options("raygauge_edges",
                                           "Edges of a robot, proven free or found in contact.",
                                           raygauge::bench::add_options, raygauge::bench::run, argc, argv);
}
