// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/pair_method.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/operations.h"

namespace raygauge {
namespace {

class PairMethod final : public SolveMethod {
 public:
  PairMethod(std::shared_ptr<const PairLibrary> library, Parameters parameters)
      : library_(std::move(library)), parameters_(std::move(parameters)) {}

  bool answers(Quantity quantity) const override {
    const auto& all = library_->quantities;
    return std::find(all.begin(), all.end(), quantity) != all.end();
  }

  void load(const Instance& instance) override {
    quantity_ = instance.quantity;
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
      answer_ = pair_->answer(quantity_, request.tolerance);
    } catch (const std::exception&) {
      answer_ = PairAnswer();  // it gives up: unsolved
    }
  }

  DistanceResult result() override {
    if (pair_ == nullptr) throw Error("method '" + library_->name + "': result before solve");
    DistanceResult result;
    put_bound(result);
    if (std::isnan(answer_.value)) return result;
    const bool apart = answer_.value > 0;
    const double unit = quantity_ == Quantity::growth ? 1 : radius_;
    result.distance =
        quantity_ == Quantity::separated ? (apart ? 1 : 0) : std::max(answer_.value, 0.0) / unit;
    const bool of_gap = quantity_ == Quantity::distance || quantity_ == Quantity::separated;
    result.status = of_gap && !apart ? DistanceStatus::contains_origin : DistanceStatus::optimal;
    return result;
  }

 private:
  // At least h_A(u)/(r |u|) for u from A to the origin, rounding errors included: weak duality (10). NaN
  // where there is no direction.
  double reach() const {
    constexpr double kOutwards = 0x1p-48;
    const Eigen::Vector3d u = -answer_.direction;
    if (!u.allFinite() || u.norm() == 0) return DistanceResult::kUnset;
    Eigen::Vector3d point, magnitude;
    const double h = A_->support_unchecked(u.data(), point.data());
    A_->magnitude_unchecked(magnitude.data());
    const double above =
        (h + ConvexSet::rounding_error(3) * u.cwiseAbs().dot(magnitude)) / (radius_ * u.norm());
    return above * (above > 0 ? 1 + kOutwards : 1 - kOutwards);
  }

  void put_bound(DistanceResult& result) const {
    const double above = quantity_ == Quantity::growth ? DistanceResult::kUnset : reach();
    result.lower = 0;
    if (quantity_ == Quantity::depth) {
      result.upper = std::max(above, 0.0);
      if (std::isnan(above)) result.upper = DistanceResult::kUnset;
    } else if (above < 0) {
      result.lower = quantity_ == Quantity::separated ? 1 : -above;
    }
  }

  std::shared_ptr<const PairLibrary> library_;
  Parameters parameters_;
  Ball origin_ = Ball(Vector::Zero(3), 0.0);  // a pair may refer to its sets
  std::shared_ptr<const ConvexSet> A_;
  std::unique_ptr<BodyPair> pair_;
  PairAnswer answer_;
  double radius_ = 1;
  Quantity quantity_ = Quantity::distance;
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
