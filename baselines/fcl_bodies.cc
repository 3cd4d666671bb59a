// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/fcl_bodies.h"

#include <fcl/fcl.h>

#include <utility>
#include <vector>

#include "baselines/rigid_body.h"

namespace raygauge {

struct FclBody::Shape {
  std::shared_ptr<fcl::ShapeBase<double>> geometry;
  Eigen::Isometry3d frame;  ///< FCL's own frame of the shape in the set's
};

namespace {

using Kind = RigidBody::Kind;
using Geometry = std::shared_ptr<fcl::ShapeBase<double>>;

Geometry hull_of(const RigidBody& body) {
  auto faces = std::make_shared<std::vector<int>>();
  for (std::size_t i = 0; i < body.triangles.size(); ++i) {
    if (i % 3 == 0) faces->push_back(3);
    faces->push_back(body.triangles[i]);
  }
  return std::make_shared<fcl::Convexd>(std::make_shared<std::vector<Eigen::Vector3d>>(body.vertices),
                                        static_cast<int>(body.triangles.size() / 3), faces);
}

Geometry geometry_of(const RigidBody& body) {
  switch (body.kind) {
    case Kind::ball:
      return std::make_shared<fcl::Sphered>(body.radius);
    case Kind::capsule:
      return std::make_shared<fcl::Capsuled>(body.radius, body.height);
    case Kind::box:
      return std::make_shared<fcl::Boxd>(Eigen::Vector3d(2 * body.half));
    case Kind::ellipsoid:
      return std::make_shared<fcl::Ellipsoidd>(body.half);
    case Kind::cylinder:
      return std::make_shared<fcl::Cylinderd>(body.radius, body.height);
    case Kind::cone:
      return std::make_shared<fcl::Coned>(body.radius, body.height);
    case Kind::frustum:
    case Kind::hull:
      break;
  }
  return hull_of(body);
}

}  // namespace

std::optional<FclBody> FclBody::of(const ConvexSet& S) {
  const auto body = RigidBody::of(S);
  if (!body) return std::nullopt;
  return FclBody(std::make_shared<Shape>(Shape{geometry_of(*body), body->frame}));
}

struct FclQuery::State {
  FclBody first, second;
  Eigen::Isometry3d at_1, at_2;
  fcl::DistanceRequestd distance;
  fcl::CollisionRequestd collision;
  Eigen::Vector3d between = Eigen::Vector3d::Zero();
};

FclQuery::FclQuery(FclBody first, FclBody second, FclSolver solver, double tolerance)
    : state_(std::make_unique<State>(State{std::move(first), std::move(second), Eigen::Isometry3d::Identity(),
                                           Eigen::Isometry3d::Identity(), fcl::DistanceRequestd(),
                                           fcl::CollisionRequestd()})) {
  const auto type = solver == FclSolver::libccd ? fcl::GST_LIBCCD : fcl::GST_INDEP;
  state_->distance.gjk_solver_type = type;
  state_->distance.distance_tolerance = tolerance;
  state_->collision.gjk_solver_type = type;
  state_->collision.gjk_tolerance = tolerance;
  place(Eigen::Isometry3d::Identity(), Eigen::Isometry3d::Identity());
}

FclQuery::~FclQuery() = default;
FclQuery::FclQuery(FclQuery&&) noexcept = default;

void FclQuery::place(const Eigen::Isometry3d& first, const Eigen::Isometry3d& second) {
  state_->at_1 = first * state_->first.shape_->frame;
  state_->at_2 = second * state_->second.shape_->frame;
}

double FclQuery::distance(bool closest_points) {
  State& state = *state_;
  state.distance.enable_nearest_points = closest_points;
  fcl::DistanceResultd result;
  fcl::distance(state.first.shape_->geometry.get(), state.at_1, state.second.shape_->geometry.get(),
                state.at_2, state.distance, result);
  if (closest_points) state.between = result.nearest_points[1] - result.nearest_points[0];
  return result.min_distance;
}

Eigen::Vector3d FclQuery::between_closest_points() const { return state_->between; }

bool FclQuery::collide() {
  const State& state = *state_;
  fcl::CollisionResultd result;
  return fcl::collide(state.first.shape_->geometry.get(), state.at_1, state.second.shape_->geometry.get(),
                      state.at_2, state.collision, result) > 0;
}

double FclQuery::penetration() {
  const State& state = *state_;
  fcl::CollisionRequestd request = state.collision;
  request.enable_contact = true;
  request.num_max_contacts = 1;
  fcl::CollisionResultd result;
  fcl::collide(state.first.shape_->geometry.get(), state.at_1, state.second.shape_->geometry.get(),
               state.at_2, request, result);
  return result.numContacts() == 0 ? 0 : result.getContact(0).penetration_depth;
}

std::string fcl_library_version() { return FCL_VERSION; }

}  // namespace raygauge
