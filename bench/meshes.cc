// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// How long do trees of triangles take to build, and distances of two meshes, compared with FCL's trees of
// oriented boxes and swept rectangles? Random poses that keep the meshes about as far apart as they are
// large.
#include <fcl/fcl.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "bench/program.h"
#include "bench/timed_medians.h"
#include "bench/torus.h"
#include "cli/input/mesh_file.h"
#include "raygauge/queries/mesh_distance.h"

namespace raygauge::bench {
namespace {

using FclMesh = fcl::BVHModel<fcl::OBBRSSd>;

struct Settings {
  std::string first, second;  ///< mesh files; empty: tori
  int poses = 200;
  double reach = 0.6;  ///< of the offsets, in sums of the meshes' radii
  std::int64_t triangles = 1'000'000;
};

TriangleSource source_of(const std::string& path) {
  if (path.empty()) return torus(20'000);
  const cli::MeshFile file = cli::read_mesh(path);
  return {file.vertices, file.triangles};
}

/// Moves the mesh to the middle of its box; its radius about that.
double center(TriangleSource& mesh) {
  mesh.vertices.colwise() -= (mesh.vertices.rowwise().minCoeff() + mesh.vertices.rowwise().maxCoeff()) / 2;
  return mesh.vertices.colwise().norm().maxCoeff();
}

std::unique_ptr<FclMesh> fcl_mesh(const TriangleSource& mesh) {
  auto model = std::make_unique<FclMesh>();
  std::vector<fcl::Vector3d> vertices;
  std::vector<fcl::Triangle> triangles;
  for (const auto& p : mesh.vertices.colwise()) vertices.emplace_back(p);
  for (const MeshTriangle& t : mesh.triangles)
    triangles.emplace_back(static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]),
                           static_cast<std::size_t>(t[2]));
  model->beginModel();
  model->addSubModel(vertices, triangles);
  model->endModel();
  return model;
}

void time_build(const TriangleSource& mesh) {
  for (const int threads : {1, 2}) {
    std::unique_ptr<Mesh> ours;
    const double seconds = seconds_of(
        [&] { ours = std::make_unique<Mesh>(mesh.vertices, mesh.triangles, MeshKind::solid, threads); });
    std::printf("build     %td triangles, solid, %d thread%s  %.3f s  %.0f bytes a triangle\n", ours->size(),
                threads, threads == 1 ? " " : "s", seconds,
                static_cast<double>(ours->memory()) / static_cast<double>(ours->size()));
  }
  const double seconds = seconds_of([&] { fcl_mesh(mesh); });
  std::printf("build     FCL, OBBRSS                         %.3f s\n", seconds);
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + std::ssize(values) / 2, values.end());
  return values[values.size() / 2];
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value / static_cast<double>(values.size());
  return sum;
}

void print(const char* name, const std::vector<double>& seconds) {
  std::printf("%-34s mean %9.2f us  median %9.2f us\n", name, mean(seconds) * 1e6, median(seconds) * 1e6);
}

class Queries {
 public:
  Queries(const TriangleSource& one, const TriangleSource& two)
      : one_(one.vertices, one.triangles),
        two_(two.vertices, two.triangles),
        fcl_one_(fcl_mesh(one)),
        fcl_two_(fcl_mesh(two)) {}

  void run(const std::vector<Pose>& poses) {
    for (const Pose& pose : poses) {
      query(pose);
    }
    print("distance, cold", cold_);
    print("distance, warm (1e-3 moved)", warm_);
    print("separation, cold", apart_);
    print("FCL distance, OBBRSS", fcl_distance_);
    print("FCL collision, OBBRSS", fcl_collision_);
    std::printf("FCL differs by more than 1e-6: %d of %zu; meet: %d; undecided: %d\n", wrong_, poses.size(),
                meet_, undecided_);
    std::printf("box pairs %.0f, triangle pairs %.0f a cold distance\n", mean(boxes_), mean(pairs_));
  }

 private:
  void query(const Pose& pose) {
    const PosedMesh first(one_);
    MeshWarmStart warm;
    const Eigen::Matrix3d R = pose.rotation();
    const Pose moved(R, pose.translation() * (1 + 1e-3));
    solver_.solve(first, {two_, moved}, ObjectEffects::closest_points, &warm);
    DistanceResult answer;
    cold_.push_back(best([&] {
      answer = solver_.solve(first, {two_, pose}, ObjectEffects::closest_points).distance;
    }));
    boxes_.push_back(static_cast<double>(solver_.counters().box_pairs));
    pairs_.push_back(static_cast<double>(solver_.counters().triangle_pairs));
    warm_.push_back(best([&] {
      MeshWarmStart state = warm;
      solver_.solve(first, {two_, pose}, ObjectEffects::closest_points, &state);
    }));
    Separation separation = Separation::undecided;
    apart_.push_back(best([&] { separation = solver_.separation(first, {two_, pose}); }));
    meet_ += separation == Separation::intersecting ? 1 : 0;
    undecided_ += separation == Separation::undecided ? 1 : 0;
    fcl::Transform3d at = fcl::Transform3d::Identity();
    at.linear() = R;
    at.translation() = pose.translation();
    const fcl::Transform3d identity = fcl::Transform3d::Identity();
    double distance = 0;
    fcl_distance_.push_back(best([&] {
      fcl::DistanceRequestd request(true);
      fcl::DistanceResultd result;
      distance = std::max(0.0, fcl::distance(fcl_one_.get(), identity, fcl_two_.get(), at, request, result));
    }));
    fcl_collision_.push_back(best([&] {
      fcl::CollisionRequestd request(1, false);
      fcl::CollisionResultd result;
      fcl::collide(fcl_one_.get(), identity, fcl_two_.get(), at, request, result);
    }));
    const double slack = 1e-6 * (1 + answer.upper);
    wrong_ += distance < answer.lower - slack || distance > answer.upper + slack ? 1 : 0;
  }

  template <class Call>
  static double best(const Call& call) {
    double seconds = seconds_of(call);
    for (int i = 0; i < 2; ++i) seconds = std::min(seconds, seconds_of(call));
    return seconds;
  }

  Mesh one_, two_;
  std::unique_ptr<FclMesh> fcl_one_, fcl_two_;
  MeshDistanceSolver solver_;
  std::vector<double> cold_, warm_, apart_, fcl_distance_, fcl_collision_, boxes_, pairs_;
  int wrong_ = 0, meet_ = 0, undecided_ = 0;
};

std::vector<Pose> random_poses(int count, double reach) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<Pose> poses;
  for (int i = 0; i < count; ++i) {
    const Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
    const Eigen::Vector3d way(normal(random), normal(random), normal(random));
    poses.emplace_back(q.normalized(), reach * way);
  }
  return poses;
}

void options(CLI::App& app, Settings& settings) {
  app.add_option("--first", settings.first, "A mesh file; without it a torus of 20 000 triangles");
  app.add_option("--second", settings.second, "Likewise");
  app.add_option("--poses", settings.poses, "Random poses of the second mesh");
  app.add_option("--reach", settings.reach, "Size of random offsets, in sums of the radii of both");
  app.add_option("--triangles", settings.triangles, "Of the mesh that is built");
}

void run(const Settings& settings) {
  if (settings.triangles > 0) time_build(torus(settings.triangles));
  TriangleSource one = source_of(settings.first), two = source_of(settings.second);
  const double size = center(one) + center(two);
  std::printf("meshes of %zu and %zu triangles\n", one.triangles.size(), two.triangles.size());
  Queries(one, two).run(random_poses(settings.poses, settings.reach * size));
}

}  // namespace
}  // namespace raygauge::bench

int main(int argc, char** argv) {
  return raygauge::bench::run_with_options<raygauge::bench::Settings>(
      "raygauge_mesh_times", "Trees of triangles: times to build and of distances, beside FCL",
      raygauge::bench::options, raygauge::bench::run, argc, argv);
}
