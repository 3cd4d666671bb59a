// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/hard/homothets.h"

#include <algorithm>
#include <cmath>

#include "generators/hard/maps.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {
namespace {

constexpr const char* kHomothet = "homothet";
constexpr const char* kPoint = "point";
constexpr const char* kAroundOrigin = "around_origin";

}  // namespace

ParameterInfo object_parameter() {
  return {"object", std::string(kHomothet), {}, {}, "what A is", {kHomothet, kPoint, kAroundOrigin}};
}

Instance homothets(RandomStream& stream, const Parameters& parameters, const Homothet& K, const Vector& p,
                   long double gauge) {
  const double t = random_integer(stream, 8, 16);
  const double scale = std::ldexp(1.0, static_cast<int>(stream.integer(-2, 2)));
  const long double reach = t * gauge;
  const double share = 0.125 * random_integer(stream, 1, 6);
  const Vector center = t * p;
  const std::string object = string_parameter(parameters, "object");
  const std::shared_ptr<const ConvexSet> Q = K(Vector::Zero(p.size()), scale);
  if (object == kPoint) return {std::make_shared<PointSet>(center), Q, static_cast<double>(reach / scale)};
  if (object == kAroundOrigin)
    return {K(center, -std::ceil((1 + share) * static_cast<double>(reach))), Q, 0.0};
  const double radius = std::max(1.0, std::floor(share * static_cast<double>(reach)));
  return {K(center, -radius), Q, static_cast<double>((reach - radius) / scale)};
}

}  // namespace raygauge
