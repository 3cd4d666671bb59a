// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/fcl_method.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "baselines/fcl_bodies.h"
#include "baselines/pair_method.h"
#include "baselines/rigid_body.h"

namespace raygauge {
namespace {

class FclPair final : public BodyPair {
 public:
  FclPair(FclBody first, FclBody second, FclSolver solver, double own_tolerance)
      : first_(std::move(first)),
        second_(std::move(second)),
        solver_(solver),
        own_tolerance_(own_tolerance) {}

  PairAnswer answer(Quantity quantity, double tolerance) override {
    if (!query_ || tolerance_ != tolerance) {
      query_.emplace(first_, second_, solver_, own_tolerance_ > 0 ? own_tolerance_ : tolerance);
      tolerance_ = tolerance;
    }
    if (quantity == Quantity::separated) return {query_->collide() ? 0.0 : 1.0};
    if (quantity == Quantity::depth) return {query_->penetration()};
    const double distance = query_->distance(true);
    return {distance, query_->between_closest_points()};
  }

 private:
  FclBody first_, second_;
  FclSolver solver_;
  double own_tolerance_;  ///< 0: that of the solve
  std::optional<FclQuery> query_;
  double tolerance_ = 0;
};

Component<SolveMethod> component(const std::string& name, const std::string& by, FclSolver solver) {
  PairLibrary library;
  library.name = name;
  library.description =
      "distance and depth of two bodies of R^3 by " + by + " of FCL " + fcl_library_version();
  library.parameters = {{"distance_tolerance",
                         0.0,
                         0.0,
                         1.0,
                         "FCL's distance_tolerance, absolute; 0: the tolerance of the solve",
                         {}}};
  library.takes = kRigidBodies;
  library.quantities = {Quantity::distance, Quantity::depth, Quantity::separated};
  library.make = [solver](const ConvexSet& one, const ConvexSet& two,
                          const Parameters& parameters) -> std::unique_ptr<BodyPair> {
    auto first = FclBody::of(one), second = FclBody::of(two);
    if (!first || !second) return nullptr;
    return std::make_unique<FclPair>(std::move(*first), std::move(*second), solver,
                                     real_parameter(parameters, "distance_tolerance"));
  };
  return pair_component(std::move(library));
}

}  // namespace

void register_fcl_methods(MethodRegistry& registry) {
  registry.add(component("fcl_libccd", "libccd's GJK and EPA", FclSolver::libccd));
  registry.add(component("fcl_indep", "the own solver", FclSolver::indep));
}

}  // namespace raygauge
