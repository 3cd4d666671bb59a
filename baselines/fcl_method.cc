// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/fcl_method.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "baselines/fcl_bodies.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/minkowski_difference.h"

namespace raygauge::fcl_baseline {
namespace {

class FclMethod final : public SolveMethod {
 public:
  FclMethod(std::string name, FclSolver solver, double own_tolerance)
      : name_(std::move(name)), solver_(solver), own_tolerance_(own_tolerance) {}

  void load(const Instance& instance) override {
    const auto* metric = dynamic_cast<const Ball*>(instance.Q.get());
    if (metric == nullptr || metric->dimension() != 3 || metric->center() != Vector::Zero(3)) {
      throw InvalidParameterError("method '" + name_ + "' takes a ball of R^3 about the origin as Q");
    }
    radius_ = metric->radius();
    A_ = instance.A;
    query_.reset();
    const auto* difference = dynamic_cast<const MinkowskiDifference*>(A_.get());
    const Ball origin(Vector::Zero(3), 0.0);
    first_ = body(difference == nullptr ? origin : *difference->A1());
    second_ = body(difference == nullptr ? *A_ : *difference->A2());
  }

  void solve(const SolveRequest& request) override {
    if (A_ == nullptr) throw Error("method '" + name_ + "': solve before load");
    if (!query_ || tolerance_ != request.tolerance) {
      query_.emplace(*first_, *second_, solver_, own_tolerance_ > 0 ? own_tolerance_ : request.tolerance);
      tolerance_ = request.tolerance;
    }
    status_ = DistanceStatus::precision_limit;
    distance_ = DistanceResult::kUnset;
    between_.setZero();
    try {
      distance_ = query_->distance(true);
      between_ = query_->between_closest_points();
      status_ = distance_ > 0 ? DistanceStatus::optimal : DistanceStatus::contains_origin;
    } catch (const std::exception&) {
      return;  // FCL gives up: unsolved
    }
  }

  DistanceResult result() override {
    if (A_ == nullptr) throw Error("method '" + name_ + "': result before solve");
    DistanceResult result;
    result.status = status_;
    result.distance = std::max(distance_, 0.0) / radius_;
    result.lower = certified_lower();
    return result;
  }

 private:
  std::optional<FclBody> body(const ConvexSet& S) const {
    auto made = FclBody::of(S);
    if (!made) {
      throw InvalidParameterError(
          "method '" + name_ +
          "' takes balls, capsules, boxes, ellipsoids, cylinders, cones and hulls that "
          "are not flat, of R^3");
    }
    return made;
  }

  // Weak duality (10) at u, which points from A to the origin: -h_A(u)/(r |u|), rounding errors included.
  double certified_lower() const {
    constexpr double kDown = 1 - 0x1p-48;
    const Eigen::Vector3d u = -between_;
    if (!u.allFinite() || u.norm() == 0) return 0;
    Eigen::Vector3d point, magnitude;
    const double h = A_->support_unchecked(u.data(), point.data());
    A_->magnitude_unchecked(magnitude.data());
    const double error = ConvexSet::rounding_error(3) * u.cwiseAbs().dot(magnitude);
    return std::max(0.0, -(h + error) / (radius_ * u.norm()) * kDown);
  }

  std::string name_;
  FclSolver solver_;
  double own_tolerance_;  ///< 0: that of the solve
  std::shared_ptr<const ConvexSet> A_;
  std::optional<FclBody> first_, second_;
  std::optional<FclQuery> query_;
  double radius_ = 1;
  double tolerance_ = 0;
  double distance_ = DistanceResult::kUnset;
  Eigen::Vector3d between_ = Eigen::Vector3d::Zero();
  DistanceStatus status_ = DistanceStatus::precision_limit;
};

Component<SolveMethod> component(const std::string& name, const std::string& by, FclSolver solver) {
  return {name,
          "the Euclidean distance of two bodies of R^3 by " + by + " of FCL " + fcl_library_version(),
          {{"distance_tolerance",
            0.0,
            0.0,
            1.0,
            "FCL's distance_tolerance, absolute; 0: the tolerance of the solve",
            {}}},
          [name, solver](const Parameters& parameters) -> std::unique_ptr<SolveMethod> {
            return std::make_unique<FclMethod>(name, solver,
                                               real_parameter(parameters, "distance_tolerance"));
          },
          false,  // Q is a ball
          Role::baseline};
}

}  // namespace
}  // namespace raygauge::fcl_baseline

namespace raygauge {

void register_fcl_methods(MethodRegistry& registry) {
  registry.add(fcl_baseline::component("fcl_libccd", "libccd's GJK and EPA", FclSolver::libccd));
  registry.add(fcl_baseline::component("fcl_indep", "the own solver", FclSolver::indep));
}

}  // namespace raygauge
