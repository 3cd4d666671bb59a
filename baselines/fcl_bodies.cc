// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/fcl_bodies.h"

#include <fcl/fcl.h>

#include <Eigen/SVD>
#include <utility>
#include <vector>

#include "engine/sets/hull_3d.h"
#include "engine/sets/spatial_shape.h"
#include "raygauge/sets/affine_image.h"
#include "raygauge/sets/prepared_set.h"

namespace raygauge {

struct FclBody::Shape {
  std::shared_ptr<fcl::ShapeBase<double>> geometry;
  Eigen::Isometry3d frame;  ///< FCL's own frame of the shape in the set's
};

namespace {

using Kind = SpatialShape::Kind;
using Geometry = std::shared_ptr<fcl::ShapeBase<double>>;

Eigen::Vector3d eigen(const Vector3& v) { return {v.x, v.y, v.z}; }

Eigen::Isometry3d frame_at(const Eigen::Vector3d& center, const Eigen::Matrix3d& R) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear() = R;
  frame.translation() = center;
  return frame;
}

// FCL's capsules, cylinders and cones stand along z.
Eigen::Isometry3d frame_along(const Eigen::Vector3d& center, const Eigen::Vector3d& axis) {
  return frame_at(center,
                  Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis).toRotationMatrix());
}

Geometry hull_of(const Eigen::MatrixXd& points) {
  const Hull3 hull = hull_3d(points, points.rowwise().mean());
  if (!hull.found) return nullptr;
  std::vector<int> place(static_cast<std::size_t>(points.cols()), -1);
  auto vertices = std::make_shared<std::vector<Eigen::Vector3d>>();
  auto faces = std::make_shared<std::vector<int>>();
  for (std::size_t i = 0; i < hull.triangles.size(); ++i) {
    const int corner = hull.triangles[i];
    int& index = place[static_cast<std::size_t>(corner)];
    if (index < 0) {
      index = static_cast<int>(vertices->size());
      vertices->emplace_back(points.col(corner));
    }
    if (i % 3 == 0) faces->push_back(3);
    faces->push_back(index);
  }
  return std::make_shared<fcl::Convexd>(vertices, static_cast<int>(hull.triangles.size() / 3), faces);
}

Geometry round_body(const SpatialShape& shape, Eigen::Isometry3d& frame) {
  const Eigen::Vector3d base = eigen(shape.base), top = eigen(shape.top);
  const double height = (top - base).norm();
  const bool is_cylinder = shape.base_radius == shape.top_radius;
  if (!is_cylinder && shape.base_radius != 0 && shape.top_radius != 0) return nullptr;
  const double sign = shape.top_radius > 0 ? -1 : 1;  // the tip of a cone is above
  frame = frame_along(0.5 * (base + top), (is_cylinder ? 1 : sign) * (top - base));
  if (is_cylinder) return std::make_shared<fcl::Cylinderd>(shape.base_radius, height);
  return std::make_shared<fcl::Coned>(shape.base_radius + shape.top_radius, height);
}

Geometry ellipsoid(const SpatialShape& shape, Eigen::Isometry3d& frame) {
  Eigen::Matrix3d L;
  for (int j = 0; j < 3; ++j) L.col(j) = eigen(shape.axis.column[j]);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(L, Eigen::ComputeFullU);
  Eigen::Matrix3d R = svd.matrixU();
  if (R.determinant() < 0) R.col(2) = -R.col(2);
  frame = frame_at(eigen(shape.center), R);
  return std::make_shared<fcl::Ellipsoidd>(Eigen::Vector3d(svd.singularValues()));
}

Geometry geometry_of(const ConvexSet& S, const SpatialShape& shape, Eigen::Isometry3d& frame) {
  if (shape.kind != Kind::point && shape.kind != Kind::segment && shape.radius > 0) return nullptr;
  switch (shape.kind) {
    case Kind::point:
      frame.translation() = eigen(shape.center);
      return std::make_shared<fcl::Sphered>(shape.radius);
    case Kind::segment:
      frame = frame_along(eigen(shape.center), eigen(shape.axis.column[0]));
      return std::make_shared<fcl::Capsuled>(shape.radius, 2 * length(shape.axis.column[0]));
    case Kind::box:
      frame.translation() = eigen(shape.center);
      return std::make_shared<fcl::Boxd>(Eigen::Vector3d(2 * eigen(shape.axis.column[0])));
    case Kind::ellipsoid:
      return ellipsoid(shape, frame);
    case Kind::frustum:
      return round_body(shape, frame);
    case Kind::points:
      break;
  }
  const PointSet* points = as_point_set(S);
  return points == nullptr ? nullptr : hull_of(points->points());
}

}  // namespace

std::optional<FclBody> FclBody::of(const ConvexSet& S) {
  if (const auto* image = dynamic_cast<const AffineImage*>(&S); image != nullptr && S.dimension() == 3) {
    constexpr double kRigid = 1e-12;
    const Eigen::Matrix3d R = image->M();
    if (!(R.transpose() * R).isIdentity(kRigid) || R.determinant() < 0) return std::nullopt;
    auto body = of(*image->S());
    if (body)
      body = FclBody(std::make_shared<Shape>(
          Shape{body->shape_->geometry, frame_at(image->t(), R) * body->shape_->frame}));
    return body;
  }
  SpatialShape shape;
  if (S.dimension() != 3 || !S.spatial_shape_unchecked(shape)) return std::nullopt;
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  Geometry geometry = geometry_of(S, shape, frame);
  if (geometry == nullptr) return std::nullopt;
  return FclBody(std::make_shared<Shape>(Shape{std::move(geometry), frame}));
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
