// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/libccd_method.h"

#include <ccd/ccd.h>
#include <ccd/vec3.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

#include "baselines/pair_method.h"
#include "baselines/rigid_body.h"

namespace raygauge {
namespace {

using Eigen::Vector3d;

Vector3d eigen(const ccd_vec3_t* v) { return {v->v[0], v->v[1], v->v[2]}; }
void put(const Vector3d& from, ccd_vec3_t* to) { ccdVec3Set(to, from.x(), from.y(), from.z()); }

void support(const void* body, const ccd_vec3_t* u, ccd_vec3_t* point) {
  put(static_cast<const RigidBody*>(body)->support(eigen(u)), point);
}

void center(const void* body, ccd_vec3_t* point) {
  put(static_cast<const RigidBody*>(body)->inner_point(), point);
}

enum class Algorithm : std::uint8_t { gjk, mpr };

/// libccd's tolerances that a caller may set; 0: the tolerance of the solve.
struct Settings {
  Algorithm algorithm = Algorithm::gjk;
  double tolerance = 0;
  unsigned long max_iterations = 0;
};

class CcdPair final : public BodyPair {
 public:
  CcdPair(RigidBody first, RigidBody second, const Settings& settings)
      : first_(std::move(first)), second_(std::move(second)), settings_(settings) {
    CCD_INIT(&ccd_);
    ccd_.support1 = ccd_.support2 = support;
    ccd_.center1 = ccd_.center2 = center;
    ccd_.max_iterations = settings.max_iterations;
  }

  PairAnswer answer(Quantity quantity, double tolerance) override {
    ccd_.epa_tolerance = ccd_.mpr_tolerance = settings_.tolerance > 0 ? settings_.tolerance : tolerance;
    return quantity == Quantity::separated ? separated() : depth();
  }

 private:
  PairAnswer separated() const {
    const auto meet = settings_.algorithm == Algorithm::gjk ? ccdGJKIntersect : ccdMPRIntersect;
    return {meet(&first_, &second_, &ccd_) != 0 ? 0.0 : 1.0};
  }

  PairAnswer depth() const {
    const auto find = settings_.algorithm == Algorithm::gjk ? ccdGJKPenetration : ccdMPRPenetration;
    ccd_real_t depth = 0;
    ccd_vec3_t direction, position;
    const int code = find(&first_, &second_, &ccd_, &depth, &direction, &position);
    constexpr int kApart = -1;
    if (code == kApart) return {0.0};
    if (code != 0) return {};
    return {depth, eigen(&direction)};
  }

  RigidBody first_, second_;
  Settings settings_;
  ccd_t ccd_ = {};
};

Component<SolveMethod> component(const std::string& name, const std::string& by, Algorithm algorithm) {
  PairLibrary library;
  library.name = name;
  library.description = "whether two bodies of R^3 are separated, and their depth, by " + by + " of libccd";
  library.parameters = {
      {"own_tolerance", 0.0, 0.0, 1.0, "libccd's tolerance, absolute; 0: the tolerance of the solve", {}},
      {"max_iterations",
       std::int64_t{500},
       1.0,
       1e9,
       "of one call; libccd's own is endless, and some calls do not end",
       {}}};
  library.takes = kRigidBodies;
  library.quantities = {Quantity::depth, Quantity::separated};
  library.make = [algorithm](const ConvexSet& one, const ConvexSet& two,
                             const Parameters& parameters) -> std::unique_ptr<BodyPair> {
    auto first = RigidBody::of(one), second = RigidBody::of(two);
    if (!first || !second) return nullptr;
    const Settings settings{algorithm, real_parameter(parameters, "own_tolerance"),
                            static_cast<unsigned long>(integer_parameter(parameters, "max_iterations"))};
    return std::make_unique<CcdPair>(std::move(*first), std::move(*second), settings);
  };
  return pair_component(std::move(library));
}

}  // namespace

void register_libccd_methods(MethodRegistry& registry) {
  registry.add(component("libccd_gjk", "GJK and EPA", Algorithm::gjk));
  registry.add(component("libccd_mpr", "Minkowski portal refinement", Algorithm::mpr));
}

}  // namespace raygauge
