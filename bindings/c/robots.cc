// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "bindings/c/handles.h"
#include "raygauge/exceptions.h"
#include "raygauge/scene/edge_checker.h"

struct rg_robot {
  raygauge::RobotModel model;
  std::vector<raygauge::Body> obstacles;

  int bodies() const noexcept { return static_cast<int>(model.bodies.size() + obstacles.size()); }
};

struct rg_checker {
  raygauge::EdgeChecker checker;
};

namespace {

using namespace raygauge;     // NOLINT(google-build-using-namespace)
using namespace raygauge::c;  // NOLINT(google-build-using-namespace)

constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();

Placement placement_of(const rg_pose* pose, const char* name) {
  if (pose == nullptr) return Placement::identity(3);
  if (const int n = pose->pose.dimension(); n != 3) {
    throw DimensionMismatchError(std::string(name) + ": a pose of R^3 is needed, got one of R^" +
                                 std::to_string(n));
  }
  return make_placement(pose->pose.rotation(), pose->pose.translation());
}

/// The caller's sets, one at least, as parts of a body of that name.
std::vector<std::shared_ptr<const ConvexSet>> parts_of(const std::string& name, std::int64_t count,
                                                       const rg_set* const* parts) {
  in_range("count", count, 1, kMost);
  const std::span<const rg_set* const> sets(&needed(parts, "parts"), static_cast<std::size_t>(count));
  std::vector<std::shared_ptr<const ConvexSet>> shared;
  shared.reserve(sets.size());
  for (const rg_set* const set : sets) {
    shared.push_back(needed(set, "a part").set);
    if (const int n = shared.back()->dimension(); n != 3) {
      throw DimensionMismatchError(name + ": a robot lives in R^3, a part in R^" + std::to_string(n));
    }
  }
  return shared;
}

void tell(int32_t* number, std::size_t value) {
  if (number != nullptr) *number = static_cast<int32_t>(value);
}

TreeLink tree_link(const rg_link& link, const RobotModel& model) {
  static_assert(RG_FIXED == static_cast<int>(JointKind::fixed) &&
                RG_REVOLUTE == static_cast<int>(JointKind::revolute) &&
                RG_PRISMATIC == static_cast<int>(JointKind::prismatic));
  const auto links = static_cast<std::int64_t>(model.tree.links.size());
  TreeLink made;
  made.parent = static_cast<int>(in_range("link->parent", link.parent, -1, links - 1));
  made.kind = static_cast<JointKind>(in_range("link->kind", link.kind, RG_FIXED, RG_PRISMATIC));
  made.origin = placement_of(link.origin, "link->origin");
  if (made.kind == JointKind::fixed) return made;
  made.joint = static_cast<int>(in_range("link->joint", link.joint, 0, model.joints - 1));
  made.axis = Eigen::Vector3d::Map(std::data(link.axis));
  made.scale = link.scale;
  made.offset = link.offset;
  if (!made.axis.allFinite() || !std::isfinite(link.scale) || !std::isfinite(link.offset)) {
    throw NonFiniteError("link: axis, scale and offset must be finite");
  }
  if (!(std::fabs(made.axis.norm() - 1) <= 1e-12))
    throw InvalidParameterError("link->axis must be of length 1");
  if (link.scale == 0) throw InvalidParameterError("link->scale must not be 0; 1 is usual");
  return made;
}

EdgeOptions options_of(const rg_checker_options& options) {
  EdgeOptions made;
  made.margin = options.margin;
  if (options.contact != 0) made.contact = options.contact;
  if (options.max_looks != 0) made.max_looks = options.max_looks;
  made.witness = options.witness != 0;
  return made;
}

/// The edges one after the other up to the first that is not free; of one configuration alone, itself.
const EdgeResult& prove(EdgeChecker& checker, std::span<const double> configurations) {
  const auto joints = static_cast<std::size_t>(checker.joints());
  if (configurations.size() == joints) return checker.configuration(configurations);
  const EdgeResult* result = nullptr;
  for (std::size_t i = 0; (i + 2) * joints <= configurations.size(); ++i) {
    const auto time = static_cast<double>(i);
    result = &checker.edge(configurations.subspan(i * joints, joints),
                           configurations.subspan((i + 1) * joints, joints), time, time + 1);
    if (result->outcome != EdgeOutcome::free) break;
  }
  return *result;
}

void write_point(const SmallVector& point, std::span<double, 3> out) {
  std::fill(out.begin(), out.end(), std::numeric_limits<double>::quiet_NaN());
  if (point.size() == 3) std::copy_n(point.data(), 3, out.begin());
}

rg_verdict verdict_of(const EdgeResult& r) {
  static_assert(RG_EDGE_FREE == static_cast<int>(EdgeOutcome::free) &&
                RG_EDGE_CONTACT == static_cast<int>(EdgeOutcome::contact) &&
                RG_EDGE_UNDECIDED == static_cast<int>(EdgeOutcome::undecided));
  rg_verdict verdict{};
  verdict.outcome = static_cast<int32_t>(r.outcome);
  verdict.body_1 = r.body_a;
  verdict.body_2 = r.body_b;
  verdict.part_1 = r.part_a;
  verdict.part_2 = r.part_b;
  verdict.time = r.time;
  verdict.lower = r.lower;
  verdict.upper = r.upper;
  verdict.depth = r.depth;
  write_point(r.point_a, std::span<double, 3>(verdict.point_1));
  write_point(r.point_b, std::span<double, 3>(verdict.point_2));
  return verdict;
}

}  // namespace

rg_error rg_robot_create(int32_t joints, rg_robot** robot) {
  return guarded([&] {
    rg_robot*& out = needed(robot, "robot");
    auto made = std::make_unique<rg_robot>();
    made->model.joints = static_cast<int>(in_range("joints", joints, 1, kMost));
    out = made.release();
  });
}

void rg_robot_free(rg_robot* robot) { delete robot; }

rg_error rg_robot_add_link(rg_robot* robot, const rg_link* link, int32_t* number) {
  return guarded([&] {
    RobotModel& model = needed(robot, "robot").model;
    model.tree.links.push_back(tree_link(needed(link, "link"), model));
    tell(number, model.tree.links.size() - 1);
  });
}

rg_error rg_robot_add_body(rg_robot* robot, int32_t link, int64_t count, const rg_set* const* parts,
                           const rg_pose* origin, int32_t* number) {
  return guarded([&] {
    RobotModel& model = needed(robot, "robot").model;
    if (!robot->obstacles.empty()) {
      throw InvalidParameterError("robot: its bodies are added before the first obstacle");
    }
    RobotBody body;
    body.name = "body " + std::to_string(model.bodies.size());
    body.link =
        static_cast<int>(in_range("link", link, 0, static_cast<std::int64_t>(model.tree.links.size()) - 1));
    body.parts = parts_of(body.name, count, parts);
    body.origin = placement_of(origin, "origin");
    model.bodies.push_back(std::move(body));
    tell(number, model.bodies.size() - 1);
  });
}

rg_error rg_robot_add_obstacle(rg_robot* robot, int64_t count, const rg_set* const* parts,
                               const rg_pose* pose, int32_t* number) {
  return guarded([&] {
    rg_robot& changed = needed(robot, "robot");
    const std::string name = "body " + std::to_string(changed.bodies());
    changed.obstacles.push_back(make_body(name, parts_of(name, count, parts),
                                          std::make_shared<StaticMotion>(placement_of(pose, "pose"))));
    tell(number, static_cast<std::size_t>(changed.bodies()) - 1);
  });
}

rg_error rg_robot_ignore(rg_robot* robot, int32_t body_1, int32_t body_2) {
  return guarded([&] {
    rg_robot& changed = needed(robot, "robot");
    const std::int64_t last = changed.bodies() - 1;
    in_range("body_1", body_1, 0, last);
    in_range("body_2", body_2, 0, last);
    changed.model.ignored.emplace_back(body_1, body_2);
  });
}

rg_error rg_robot_ignore_joined(rg_robot* robot) {
  return guarded([&] {
    RobotModel& model = needed(robot, "robot").model;
    const std::vector<std::pair<int, int>> joined = joined_bodies(model);
    model.ignored.insert(model.ignored.end(), joined.begin(), joined.end());
  });
}

rg_error rg_checker_create(const rg_robot* robot, const rg_checker_options* options, rg_checker** checker) {
  return guarded([&] {
    const rg_robot& of = needed(robot, "robot");
    rg_checker*& out = needed(checker, "checker");
    const EdgeOptions chosen = options == nullptr ? EdgeOptions() : options_of(*options);
    out = new rg_checker{EdgeChecker(of.model, of.obstacles, chosen)};
  });
}

void rg_checker_free(rg_checker* checker) { delete checker; }

rg_error rg_checker_prove(rg_checker* checker, int64_t count, const double* configurations,
                          rg_verdict* verdict) {
  return guarded([&] {
    EdgeChecker& used = needed(checker, "checker").checker;
    rg_verdict& out = needed(verdict, "verdict");
    const auto size = in_range("count", count, 1, kMost) * used.joints();
    out =
        verdict_of(prove(used, {&needed(configurations, "configurations"), static_cast<std::size_t>(size)}));
  });
}

rg_error rg_checker_forget(rg_checker* checker) {
  return guarded([&] { needed(checker, "checker").checker.forget(); });
}
