// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "bench/tuning_workloads.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <utility>

#include "bench/pair_bodies.h"
#include "bench/torus.h"
#include "engine/queries/streamed_hull.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/membership.h"
#include "raygauge/queries/mesh_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/prepared_set.h"

namespace raygauge::bench {
namespace {

constexpr int kInstances = 4;  // of a cell
constexpr int kPairs = 60;     // of two kinds
constexpr int kDirections = 256;

using Random = std::mt19937_64;
using Set = std::shared_ptr<const ConvexSet>;

Eigen::MatrixXd sphere(int n, int count, Random& random) {
  std::normal_distribution<double> normal;
  Eigen::MatrixXd points(n, count);
  for (double& x : points.reshaped()) x = normal(random);
  points.colwise().normalize();
  return points;
}

Call all_of(std::vector<Call> calls) {
  return [calls = std::move(calls)] {
    for (const Call& call : calls) call();
  };
}

Call solve_of(const std::string& method, Instance instance, int threads) {
  Parameters parameters;
  if (threads > 1) parameters["threads"] = static_cast<std::int64_t>(threads);
  const std::shared_ptr<SolveMethod> solver = make_method(method, parameters);
  solver->load(instance);
  return [solver, instance = std::move(instance)] { solver->solve({}); };
}

Set cross_polytope(int n, const Vector& at) {
  Eigen::MatrixXd points(n, 2 * n);
  points << Eigen::MatrixXd::Identity(n, n), -Eigen::MatrixXd::Identity(n, n);
  points.colwise() += at;
  return std::make_shared<PointSet>(points);
}

Set shape(Shapes shapes, int n, const Vector& at, Random& random) {
  if (shapes == Shapes::cross_polytopes) return cross_polytope(n, at);
  std::uniform_real_distribution<double> axis(0.5, 2);
  Vector axes(n);
  for (double& each : axes) each = axis(random);
  if (shapes == Shapes::p_norm_balls) return std::make_shared<PNormBall>(at, axes, 3);
  const Eigen::MatrixXd factor = std::sqrt(n) * sphere(n, n, random) / std::sqrt(n);
  return std::make_shared<Ellipsoid>(
      at, factor * Eigen::MatrixXd(axes.asDiagonal()) + Eigen::MatrixXd::Identity(n, n));
}

// The columns of a matrix, some at a time.
class MatrixStream final : public PointStream {
 public:
  explicit MatrixStream(std::shared_ptr<const Eigen::MatrixXd> points) : points_(std::move(points)) {}
  int dimension() const noexcept override { return static_cast<int>(points_->rows()); }
  std::ptrdiff_t size() const noexcept override { return points_->cols(); }
  void pass(const std::function<bool(const StreamedPoints&)>& visit) override {
    constexpr std::ptrdiff_t kTogether = 4096;
    for (std::ptrdiff_t first = 0; first < size(); first += kTogether) {
      const std::ptrdiff_t count = std::min(kTogether, size() - first);
      if (!visit({points_->data() + first * points_->rows(), nullptr, first, count})) return;
    }
  }

 private:
  std::shared_ptr<const Eigen::MatrixXd> points_;
};

std::shared_ptr<const StreamedHull> streamed(Eigen::MatrixXd points) {
  const auto held = std::make_shared<const Eigen::MatrixXd>(std::move(points));
  return std::make_shared<const StreamedHull>([held] { return std::make_unique<MatrixStream>(held); });
}

// Poses of the second body on a way of `steps` motions, there and back.
std::vector<Pose> way_of(const PosedPair& pair, int steps) {
  const Eigen::MatrixXd turn = pair.moved_2.rotation() * pair.pose_2.rotation().transpose();
  const Vector step = pair.moved_2.translation() - pair.pose_2.translation();
  std::vector<Pose> way{pair.pose_2};
  for (int i = 0; i < steps; ++i) {
    const Eigen::Quaterniond next(Eigen::Matrix3d(turn * way.back().rotation()));
    way.emplace_back(next.normalized(), way.back().translation() + step);
  }
  for (int i = steps - 1; i > 0; --i) way.push_back(way[static_cast<std::size_t>(i)]);
  return way;
}

// One pair, cold; or on a way, of depths a longer one, each from the memory of the last.
Call ask_pair(std::shared_ptr<const PosedPair> pair, PairAsk ask) {
  if (ask == PairAsk::growth) {
    const auto solver = std::make_shared<GrowthDistanceSolver>();
    return [=] { solver->solve_about_centers({*pair->first, pair->pose_1}, {*pair->second, pair->pose_2}); };
  }
  const auto metric = std::make_shared<Ball>(Vector::Zero(3), 1.0);
  const auto solver = std::make_shared<ObjectDistanceSolver>();
  const bool deep = ask != PairAsk::distance && ask != PairAsk::warm;
  const ObjectEffects effects =
      deep ? ObjectEffects::closest_points | ObjectEffects::depth : ObjectEffects::closest_points;
  const auto solve = [=](const Pose& second, WarmStart* warm) {
    solver->solve({*pair->first, pair->pose_1}, {*pair->second, second}, *metric, effects, warm);
  };
  if (ask == PairAsk::distance || ask == PairAsk::depth) return [=] { solve(pair->pose_2, nullptr); };
  const auto warm = std::make_shared<WarmStart>();
  const int steps = deep ? 24 : 1, asks = ask == PairAsk::depth_at_rest ? 10 : 1;
  return [=, way = way_of(*pair, steps)] {
    for (const Pose& pose : way) {
      for (int i = 0; i < asks; ++i) solve(pose, warm.get());
    }
  };
}

}  // namespace

Workload solves(const std::string& method, const std::vector<Cell>& cells, const std::string& variant,
                int threads) {
  return [=] {
    std::vector<Call> calls;
    for (const Cell& cell : cells) {
      for (int i = 0; i < kInstances; ++i)
        calls.push_back(solve_of(method, make_instance(find_variant(variant), cell.n, cell.N, i), threads));
    }
    return all_of(std::move(calls));
  };
}

Workload solves_of(Shapes shapes, const std::vector<int>& dimensions) {
  return [=] {
    Random random(1);
    std::vector<Call> calls;
    for (const int n : dimensions) {
      for (int i = 0; i < kInstances; ++i) {
        Instance instance;
        instance.A = shape(shapes, n, 9 * sphere(n, 1, random).col(0), random);
        instance.Q = shape(shapes, n, Vector::Zero(n), random);
        const bool points = shapes == Shapes::cross_polytopes;
        calls.push_back(solve_of(points ? "column_generation" : "newton", instance, 1));
      }
    }
    return all_of(std::move(calls));
  };
}

Workload euclidean(const std::vector<Cell>& cells) {
  return [=] {
    std::vector<Call> calls;
    for (const Cell& cell : cells) {
      for (int i = 0; i < kInstances; ++i) {
        const auto sets =
            std::make_shared<Instance>(make_instance(find_variant("random"), cell.n, cell.N, i));
        const auto ball = std::make_shared<Ball>(Vector::Zero(cell.n), 1.0);
        const auto solver = std::make_shared<ObjectDistanceSolver>();
        calls.emplace_back([=] { solver->solve(*sets->A, *sets->Q, *ball); });
      }
    }
    return all_of(std::move(calls));
  };
}

Workload depths(const std::vector<Cell>& cells) {
  return [=] {
    Random random(1);
    std::vector<Call> calls;
    for (const Cell& cell : cells) {
      Eigen::MatrixXd moved = sphere(cell.n, cell.N, random);
      moved.colwise() += 0.3 * sphere(cell.n, 1, random).col(0);
      const auto one = std::make_shared<PointSet>(sphere(cell.n, cell.N, random));
      const auto other = std::make_shared<PointSet>(std::move(moved));
      const auto ball = std::make_shared<Ball>(Vector::Zero(cell.n), 1.0);
      const auto solver = std::make_shared<ObjectDistanceSolver>();
      calls.emplace_back([=] { solver->solve(*one, *other, *ball, ObjectEffects::depth); });
    }
    return all_of(std::move(calls));
  };
}

Workload supports(Cell cell, bool needle) {
  return [=]() -> Call {
    Random random(1);
    Eigen::MatrixXd points = sphere(cell.n, cell.N, random);
    if (needle) points.row(cell.n - 1) *= 1e4;
    const auto set = std::make_shared<PreparedSet>(points);
    const auto directions = std::make_shared<Eigen::MatrixXd>(sphere(cell.n, kDirections, random));
    if (needle) directions->row(cell.n - 1) *= 1e-4;
    return [=, point = Vector(cell.n)]() mutable {
      for (int i = 0; i < kDirections; ++i) set->support_unchecked(directions->col(i).data(), point.data());
    };
  };
}

Workload gauges_in(Cell cell, int K) {
  return [=]() -> Call {
    Random random(1);
    const auto hull = std::make_shared<PointSet>(sphere(cell.n, cell.N, random));
    const auto points = std::make_shared<Eigen::MatrixXd>(sphere(cell.n, K, random));
    return [=] { gauges(*hull, *points); };
  };
}

Workload streams(Cell cell) {
  return [=]() -> Call {
    Random random(1);
    Eigen::MatrixXd A = sphere(cell.n, cell.N, random);
    A.row(0).array() += 3;
    const auto one = streamed(std::move(A)), other = streamed(sphere(cell.n, cell.N, random));
    const auto solver = std::make_shared<DistanceSolver>();
    return [=] { solver->solve(*one, *other); };
  };
}

Workload origins(const std::vector<Cell>& cells) {
  return [=] {
    Random random(1);
    std::vector<Call> calls;
    for (const Cell& cell : cells) {
      const auto hull = std::make_shared<PointSet>(sphere(cell.n, cell.N, random));
      calls.emplace_back([=] { origin_in_interior(*hull); });
    }
    return all_of(std::move(calls));
  };
}

Workload tori(int triangles) {
  return [=]() -> Call {
    constexpr int kPoses = 16;
    const TriangleSource source = torus(triangles);
    const auto mesh = std::make_shared<const Mesh>(source.vertices, source.triangles);
    const auto solver = std::make_shared<MeshDistanceSolver>();
    const auto poses = std::make_shared<std::vector<Pose>>();
    for (int i = 0; i < kPoses; ++i)
      poses->emplace_back(Eigen::Matrix3d(Eigen::AngleAxisd(0.4 * i, Eigen::Vector3d(1, 2, 3).normalized())),
                          Eigen::Vector3d(5.5, 0.1 * i, -0.2 * i));
    return [=] {
      for (const Pose& pose : *poses) solver->solve(PosedMesh(*mesh), PosedMesh(*mesh, pose));
    };
  };
}

Workload torus_trees(int triangles) {
  return [=]() -> Call {
    const auto source = std::make_shared<const TriangleSource>(torus(triangles));
    return [=] { Mesh(source->vertices, source->triangles); };
  };
}

Workload pairs(const std::vector<std::pair<std::string, std::string>>& kinds, const std::string& place,
               PairAsk ask) {
  return [=] {
    std::vector<Call> calls;
    for (const auto& [one, other] : kinds) {
      for (int seed = 0; seed < kPairs; ++seed)
        calls.push_back(ask_pair(std::make_shared<PosedPair>(make_pair(one, other, place, seed)), ask));
    }
    return all_of(std::move(calls));
  };
}

}  // namespace raygauge::bench
