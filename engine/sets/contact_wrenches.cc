// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/grasp_wrenches.h"

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

Eigen::Vector3d checked(const ConstVectorRef& v, const char* what) {
  if (v.size() != 3)
    throw DimensionMismatchError(std::string("contact wrenches: ") + what + " must have 3 numbers");
  if (!v.allFinite()) throw NonFiniteError(std::string("contact wrenches: ") + what + " is not finite");
  return v;
}

}  // namespace

ContactWrenches::ContactWrenches(const ConstVectorRef& p, const ConstVectorRef& n, double mu, double facets)
    : ConvexSet(6), p_(checked(p, "p")), n_(checked(n, "n")), given_(n_), mu_(mu), facets_(0) {
  if (!(n_.norm() > 0)) throw InvalidParameterError("contact wrenches: the normal is zero");
  if (!(mu >= 0) || !std::isfinite(mu))
    throw InvalidParameterError("contact wrenches: friction must not be negative");
  constexpr double kMostFacets = 1e6;
  if (!(facets == 0 || (facets >= 3 && facets <= kMostFacets)) || facets != std::floor(facets)) {
    throw InvalidParameterError("contact wrenches: facets must be 0 or 3 and more, got " +
                                std::to_string(facets));
  }
  facets_ = static_cast<int>(facets);
  n_.normalize();
  first_ = n_.unitOrthogonal();
  second_ = n_.cross(first_);
}

double ContactWrenches::do_support(const double* u, double* point) const {
  const Eigen::Vector3d force = Eigen::Vector3d::Map(u);
  const Eigen::Vector3d w = force + Eigen::Vector3d::Map(u + 3).cross(p_);
  double x = w.dot(first_);
  double y = w.dot(second_);
  if (facets_ > 0) {
    const double step = 2 * EIGEN_PI / facets_;
    const double angle = step * std::round(std::atan2(y, x) / step);
    x = std::cos(angle);
    y = std::sin(angle);
  } else {
    const double length = std::hypot(x, y);
    x = length > 0 ? x / length : 1;
    y = length > 0 ? y / length : 0;
  }
  Eigen::Vector3d f = n_ + mu_ * (x * first_ + y * second_);
  if (!(w.dot(f) > 0)) f.setZero();
  Eigen::Vector3d::Map(point) = f;
  Eigen::Vector3d::Map(point + 3) = p_.cross(f);
  return force.dot(f) + Eigen::Vector3d::Map(u + 3).dot(Eigen::Vector3d::Map(point + 3));
}

void ContactWrenches::do_center(double* point) const {
  const Eigen::Vector3d f = n_ / 2;
  Eigen::Vector3d::Map(point) = f;
  Eigen::Vector3d::Map(point + 3) = p_.cross(f);
}

// A torque is a difference of products, which may be much smaller than they are.
void ContactWrenches::do_magnitude(double* magnitude) const {
  const double force = 1 + 2 * mu_;
  const Eigen::Vector3d p = p_.cwiseAbs();
  Eigen::Vector3d::Map(magnitude).setConstant(force);
  Eigen::Vector3d::Map(magnitude + 3) = force * Eigen::Vector3d(p[1] + p[2], p[2] + p[0], p[0] + p[1]);
}

}  // namespace raygauge
