// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/random_meshes.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "engine/numerics/number_text.h"
#include "raygauge/meshes/mesh.h"
#include "tests/mesh_truth.h"
#include "tests/soak/random_set.h"

namespace raygauge::soak {

struct DrawnMesh {
  testing::MeshShape shape;
  MeshKind kind;
  Mesh mesh;
  std::string label;
};

namespace {

using Eigen::Vector3d;
using testing::BruteForce;
using testing::MeshShape;
using Outcome = ImpactResult::Outcome;

constexpr double kTolerance = 1e-6;  // of the solver, by default
constexpr double kClear = 1e-12;     // relative: what the rounding of a place at a moment cannot do

double between(RandomStream& stream, double low, double high) {
  return low + (high - low) * stream.uniform();
}

Vector3d draw_half(RandomStream& stream) {
  const auto side = [&] { return 0.25 * static_cast<double>(stream.integer(1, 6)); };
  return {side(), side(), side()};
}

// A sphere of k × l quadrangles whose points are nearer or farther by up to a third.
MeshShape rough_sphere(RandomStream& stream, int k, int l) {
  MeshShape mesh = testing::torus_shape(1, 0.5, k, l);  // for its triangles
  mesh.vertices.resize(3, k * (l - 1) + 2);
  for (int i = 0; i < k; ++i) {
    for (int j = 1; j < l; ++j) {
      const double s = 2 * std::numbers::pi * i / k, t = std::numbers::pi * j / l;
      mesh.vertices.col(i * (l - 1) + j - 1) =
          between(stream, 0.67, 1.33) *
          Vector3d(std::cos(s) * std::sin(t), std::sin(s) * std::sin(t), std::cos(t));
    }
  }
  mesh.vertices.rightCols(2) << 0, 0, 0, 0, 1, -1;
  mesh.triangles.clear();
  const auto at = [&](int i, int j) {
    if (j == 0) return k * (l - 1);
    return j == l ? k * (l - 1) + 1 : (i % k) * (l - 1) + j - 1;
  };
  for (int i = 0; i < k; ++i) {
    for (int j = 0; j < l; ++j) {
      if (j > 0) mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
      if (j + 1 < l) mesh.triangles.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
    }
  }
  return mesh;
}

// Steps that share faces, which lie inside.
MeshShape stairs(RandomStream& stream) {
  MeshShape mesh = testing::box_shape({0, -1, -0.5}, {0.5, 1, 0});
  const auto steps = stream.integer(1, 3);
  for (int k = 1; k <= steps; ++k)
    mesh = testing::joined(mesh, testing::box_shape({0.5 * k, -1, -0.5}, {0.5 * (k + 1), 1, 0.25 * k}));
  return mesh;
}

MeshShape loose_triangles(RandomStream& stream) {
  MeshShape mesh;
  const auto triangles = static_cast<std::int32_t>(stream.integer(3, 30));
  const bool coarse = stream.uniform() < 0.5;
  mesh.vertices = Eigen::Matrix3Xd::NullaryExpr(3, 3 * triangles, [&](Eigen::Index, Eigen::Index) {
    return coarse ? 0.5 * static_cast<double>(stream.integer(-3, 3)) : stream.normal();
  });
  for (std::int32_t i = 0; i < triangles; ++i) mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  return mesh;
}

// Thin in `thin` directions.
MeshShape thin_box(RandomStream& stream, int thin) {
  Vector3d half = draw_half(stream);
  const double small = std::exp2(-static_cast<double>(stream.integer(1, 31)));
  for (int k = 0; k < thin; ++k) half[k] = small;
  return testing::box_shape(-half, half, static_cast<int>(stream.integer(1, 3)));
}

// One in four is small enough for the inside of another.
DrawnMesh made(RandomStream& stream, MeshShape shape, MeshKind kind, std::string label) {
  if (stream.uniform() < 0.25) shape.vertices *= 0.0625;
  Mesh mesh(shape.vertices, shape.triangles, kind);
  return {std::move(shape), kind, std::move(mesh), std::move(label)};
}

DrawnMesh draw_mesh(RandomStream& stream) {
  const MeshKind kind = stream.uniform() < 0.5 ? MeshKind::surface : MeshKind::solid;
  const auto count = [&](int low, int high) { return static_cast<int>(stream.integer(low, high)); };
  switch (stream.integer(0, 7)) {
    case 0:
      return made(stream, thin_box(stream, 1), kind, "plate");
    case 1:
      return made(stream, thin_box(stream, 2), kind, "needle");
    case 2:
      return made(stream, thin_box(stream, 0), kind, "box");
    case 3: {
      const Vector3d out = draw_half(stream), in = 0.75 * out;
      return made(stream,
                  testing::joined(testing::box_shape(-out, out), testing::box_shape(-in, in, 1, true)), kind,
                  "shell");
    }
    case 4:
      return made(stream, testing::torus_shape(1, between(stream, 0.1, 0.6), count(5, 14), count(3, 8)), kind,
                  "torus");
    case 5:
      return made(stream, rough_sphere(stream, count(4, 10), count(3, 7)), kind, "rough sphere");
    case 6:
      return made(stream, stairs(stream), MeshKind::surface, "stairs");
    default:
      return made(stream, loose_triangles(stream), MeshKind::surface, "loose triangles");
  }
}

Eigen::Matrix3d draw_rotation(RandomStream& stream) {
  const double kind = stream.uniform();
  if (kind < 0.4) {
    return testing::right_turns(static_cast<int>(stream.integer(0, 3)),
                                [&stream] { return static_cast<int>(stream.integer(0, 2)); });
  }
  const Vector3d axis = draw_direction(stream, 3);
  const double angle = kind < 0.5 ? std::pow(10.0, -between(stream, 1, 15)) : between(stream, 0, 6);
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

Pose draw_pose(RandomStream& stream) {
  const double far = stream.uniform() < 0.3 ? 0.1 : stream.uniform() < 0.6 ? 1 : 4;
  const bool coarse = stream.uniform() < 0.5;
  const Vector3d t = Vector3d::NullaryExpr([&](Eigen::Index) {
    return coarse ? 0.25 * std::round(4 * far * stream.normal()) : far * stream.normal();
  });
  return {draw_rotation(stream), t};
}

// Of surfaces that do not meet: a point of each part tells where it is.
bool is_inside(const DrawnMesh& one, const Pose& at_1, const DrawnMesh& two, const Pose& at_2) {
  if (two.kind != MeshKind::solid) return false;
  return std::ranges::any_of(one.mesh.part_points(), [&](const Vector3d& point) {
    return testing::winds_about(two.shape, at_2, at_1.apply(point));
  });
}

MotionPointer draw_way(RandomStream& stream) {
  Placement start = Placement::identity(3);
  start.R = draw_rotation(stream);
  start.t = SmallVector(draw_direction(stream, 3).normalized() * between(stream, 1, 5));
  TwistMotion::Rates rates;
  rates.velocity = SmallVector(-start.t * between(stream, 0.5, 2)) +
                   SmallVector(draw_direction(stream, 3) * stream.uniform());
  rates.acceleration = SmallVector(draw_direction(stream, 3) * stream.uniform());
  rates.spin = draw_direction(stream, 3) * between(stream, 0, 6);
  return std::make_shared<TwistMotion>(start, rates, 0.0);
}

Pose pose_at(const Body& body, double t) {
  const Placement where = body.motion->at(t);
  return {where.R, where.t};
}

}  // namespace

std::string RandomMeshes::pose_error(RandomStream& stream, const DrawnMesh& one, const DrawnMesh& two,
                                     MeshWarmStart& warm) {
  const Pose at_1 = draw_pose(stream), at_2 = draw_pose(stream);
  const BruteForce truth = testing::brute_force(one.shape, at_1, two.shape, at_2);
  const bool clear = truth.lower > 0;
  const bool inside = clear && (is_inside(one, at_1, two, at_2) || is_inside(two, at_2, one, at_1));
  ++tally_.poses;
  tally_.meeting += truth.meet ? 1 : 0;
  tally_.inside += inside ? 1 : 0;
  tally_.touching += truth.meet && !truth.cross ? 1 : 0;
  MeshWarmStart* const start = stream.uniform() < 0.5 ? &warm : nullptr;
  const Separation apart = solver_.separation({one.mesh, at_1}, {two.mesh, at_2}, start);
  const DistanceResult& found =
      solver_.solve({one.mesh, at_1}, {two.mesh, at_2}, ObjectEffects::none, start).distance;
  const bool common = found.status == DistanceStatus::contains_origin;
  const bool closed =
      found.status == DistanceStatus::optimal && found.upper - found.lower <= kTolerance * found.upper;
  tally_.certified += common || closed ? 1 : 0;
  if (inside || truth.meet) {
    if (found.lower > 0 || apart == Separation::separated) return "apart, but they meet";
    return inside && !(common && apart == Separation::intersecting) ? "one inside the other is undecided"
                                                                    : "";
  }
  if (found.lower > truth.upper)
    return "lower " + shortest_text(found.lower) + " > " + shortest_text(truth.upper);
  if (found.upper < truth.lower)
    return "upper " + shortest_text(found.upper) + " < " + shortest_text(truth.lower);
  if (clear && (common || apart == Separation::intersecting)) return "common points of bodies that are apart";
  return found.status == DistanceStatus::optimal && !closed ? "optimal, but wide" : "";
}

std::string RandomMeshes::motion_error(RandomStream& stream, const DrawnMesh& one, const DrawnMesh& two) {
  const Body a = make_body("a", {std::make_shared<MeshObject>(one.mesh)}, draw_way(stream)),
             b = make_body("b", {std::make_shared<MeshObject>(two.mesh)}, draw_way(stream));
  const double slack = kClear * (a.reach + b.reach + 10);
  ContinuousOptions over;
  over.to = 1;
  const ImpactResult impact = continuous_.time_of_impact(a, b, over);
  const ClearanceResult clear = continuous_.clearance(a, b, SceneMetric{}, nullptr, over);
  ++tally_.motions;
  tally_.contacts += impact.outcome == Outcome::contact ? 1 : 0;
  tally_.free += impact.outcome == Outcome::free ? 1 : 0;
  tally_.undecided += impact.outcome == Outcome::undecided ? 1 : 0;
  const auto look = [&](double t) {
    ++tally_.moments;
    const Pose at_1 = pose_at(a, t), at_2 = pose_at(b, t);
    BruteForce truth = testing::rough_force(one.shape, at_1, two.shape, at_2);
    if (truth.lower > slack && (is_inside(one, at_1, two, at_2) || is_inside(two, at_2, one, at_1)))
      truth = {0, 0, true};
    return truth;
  };
  if (impact.outcome == Outcome::contact && look(impact.upper).lower > over.contact + slack)
    return "no contact at " + shortest_text(impact.upper);
  const double last = impact.outcome == Outcome::free ? 1 : impact.lower;
  for (int k = 0; k <= kMoments; ++k) {
    const double t = (k + 0.3 * stream.uniform()) / (kMoments + 1.0);
    const BruteForce truth = look(t);
    if (t < last && truth.meet) return "contact at " + shortest_text(t) + ", before " + shortest_text(last);
    if (t < clear.no_contact_before && truth.meet)
      return "contact at " + shortest_text(t) + " by the clearance";
    if (clear.lower > truth.upper + slack) return "nearer than the clearance at " + shortest_text(t);
  }
  if (!clear.touches && look(clear.time).lower > clear.upper + slack) return "the clearance is not attained";
  return "";
}

std::optional<std::string> RandomMeshes::check(std::int64_t number) {
  RandomStream stream({seed_, 3, static_cast<int>(number >> 31), static_cast<int>(number & 0x7fffffff)},
                      "random_meshes", RandomPurpose::shape);
  const DrawnMesh one = draw_mesh(stream), two = draw_mesh(stream);
  ++tally_.pairs;
  MeshWarmStart warm;
  std::string wrong;
  int pose = 0;
  for (; pose < kPoses && wrong.empty(); ++pose) wrong = pose_error(stream, one, two, warm);
  if (!wrong.empty()) wrong = "pose " + std::to_string(pose - 1) + ": " + wrong;
  for (int k = 0; k < kMotions && wrong.empty(); ++k) wrong = motion_error(stream, one, two);
  if (wrong.empty()) return std::nullopt;
  return one.label + " and " + two.label + ", pair " + std::to_string(number) + ": " + wrong;
}

std::string to_string(const MeshSoakTally& tally) {
  const auto text = [](std::int64_t count) { return std::to_string(count); };
  return text(tally.pairs) + " pairs of meshes, " + text(tally.poses) + " poses (" + text(tally.meeting) +
         " meet, " + text(tally.touching) + " touch, " + text(tally.inside) + " with one inside), " +
         text(tally.certified) + " certified; " + text(tally.motions) + " motions: " + text(tally.contacts) +
         " contacts, " + text(tally.free) + " free, " + text(tally.undecided) + " undecided; " +
         text(tally.moments) + " moments\n";
}

}  // namespace raygauge::soak
