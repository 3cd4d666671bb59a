// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/convex_set.h"

#include <string>
#include <utility>

#include "engine/numerics/number_text.h"
#include "engine/numerics/vector_kernels.h"
#include "engine/sets/parameters.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

void check_along_axis(const SupportMappingSet::Mapping& mapping, const Vector& center, int k, double sign) {
  const std::string name = std::string("mapping along ") + (sign > 0 ? "+" : "-") + "e_" + std::to_string(k);
  const Vector u = sign * Vector::Unit(center.size(), k);
  Vector point = Vector::Zero(center.size());
  mapping(u.data(), point.data());
  checked_finite("support mapping set", name, point);
  if (sign * center[k] > sign * point[k]) {
    throw InvalidParameterError("support mapping set: center lies outside the set: its coordinate " +
                                std::to_string(k) + " is " + shortest_text(center[k]) + ", the " + name +
                                " gives " + shortest_text(point[k]));
  }
}

}  // namespace

SupportMappingSet::SupportMappingSet(const ConstVectorRef& center, Mapping mapping)
    : ConvexSet(static_cast<int>(center.size())),
      center_(checked_finite("support mapping set", "center", center)),
      mapping_(std::move(mapping)) {
  if (!mapping_) throw InvalidParameterError("support mapping set: mapping must be callable, it is empty");
  for (int k = 0; k < dimension(); ++k) {
    check_along_axis(mapping_, center_, k, 1.0);
    check_along_axis(mapping_, center_, k, -1.0);
  }
}

double SupportMappingSet::do_support(const double* u, double* point) const {
  mapping_(u, point);
  return dot(u, point, dimension());
}

void SupportMappingSet::do_center(double* point) const { Vector::Map(point, dimension()) = center_; }

}  // namespace raygauge
