// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/pair_method.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/minkowski_difference.h"

namespace raygauge {
namespace {

class PairMethod final : public SolveMethod {
 public:
  PairMethod(std::shared_ptr<const PairLibrary> library, Parameters parameters)
      : library_(std::move(library)), parameters_(std::move(parameters)) {}

  void load(const Instance& instance) override {
    const auto* metric = dynamic_cast<const Ball*>(instance.Q.get());
    if (metric == nullptr || metric->dimension() != 3 || metric->center() != Vector::Zero(3))
      throw InvalidParameterError("method '" + library_->name +
                                  "' takes a ball of R^3 about the origin as Q");
    radius_ = metric->radius();
    A_ = instance.A;
    const auto* difference = dynamic_cast<const MinkowskiDifference*>(A_.get());
    pair_ = library_->make(difference == nullptr ? origin_ : *difference->A1(),
                           difference == nullptr ? *A_ : *difference->A2(), parameters_);
    if (pair_ == nullptr)
      throw InvalidParameterError("method '" + library_->name + "' takes " + library_->takes);
  }

  void solve(const SolveRequest& request) override {
    if (pair_ == nullptr) throw Error("method '" + library_->name + "': solve before load");
    answer_ = PairAnswer();
    try {
      answer_ = pair_->distance(request.tolerance);
    } catch (const std::exception&) {
      answer_ = PairAnswer();  // it gives up: unsolved
    }
  }

  DistanceResult result() override {
    if (pair_ == nullptr) throw Error("method '" + library_->name + "': result before solve");
    DistanceResult result;
    result.distance = std::max(answer_.value, 0.0) / radius_;
    result.lower = certified_lower();
    if (std::isnan(answer_.value)) {
      result.distance = DistanceResult::kUnset;
    } else {
      result.status = answer_.value > 0 ? DistanceStatus::optimal : DistanceStatus::contains_origin;
    }
    return result;
  }

 private:
  // Weak duality (10) at u, which points from A to the origin: -h_A(u)/(r |u|), rounding errors included.
  double certified_lower() const {
    constexpr double kDown = 1 - 0x1p-48;
    const Eigen::Vector3d u = -answer_.direction;
    if (!u.allFinite() || u.norm() == 0) return 0;
    Eigen::Vector3d point, magnitude;
    const double h = A_->support_unchecked(u.data(), point.data());
    A_->magnitude_unchecked(magnitude.data());
    const double error = ConvexSet::rounding_error(3) * u.cwiseAbs().dot(magnitude);
    return std::max(0.0, -(h + error) / (radius_ * u.norm()) * kDown);
  }

  std::shared_ptr<const PairLibrary> library_;
  Parameters parameters_;
  Ball origin_ = Ball(Vector::Zero(3), 0.0);  // a pair may refer to its sets
  std::shared_ptr<const ConvexSet> A_;
  std::unique_ptr<BodyPair> pair_;
  PairAnswer answer_;
  double radius_ = 1;
};

}  // namespace

Component<SolveMethod> pair_component(PairLibrary library) {
  const auto shared = std::make_shared<const PairLibrary>(std::move(library));
  return {shared->name,
          shared->description,
          shared->parameters,
          [shared](const Parameters& parameters) -> std::unique_ptr<SolveMethod> {
            return std::make_unique<PairMethod>(shared, parameters);
          },
          false,  // Q is a ball
          Role::baseline};
}

}  // namespace raygauge
