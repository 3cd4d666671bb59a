// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/hard/axial.h"

#include <cmath>

#include "generators/component.h"
#include "generators/hard/homothets.h"
#include "generators/hard/maps.h"
#include "generators/hard/similarities.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge {
namespace {

/// A truncated cone in its half-plane, lengths in its units.
struct Profile {
  double below = 0;  ///< z_b
  double above = 0;  ///< z_t
  double base_radius = 0;
  double top_radius = 0;
};

Profile random_profile(RandomStream& stream, const std::string& shape) {
  const double below = random_integer(stream, 1, 4);
  const double above = random_integer(stream, 1, 4);
  const double radius = random_integer(stream, 1, 4);
  if (shape == "cone") return {below, above, below + above, 0};
  if (shape == "cylinder") return {below, above, radius, radius};
  if (shape == "inverted") return {below, above, radius, radius + below + above};
  return {below, above, radius + below + above, radius};
}

Vector surface_point(const Profile& profile, const HalfPlane& plane, const std::string& place,
                     RandomStream& stream) {
  const double eighths = random_integer(stream, 1, 7) / 8;
  if (place == "axis") return plane.point(profile.above, 0);
  if (place == "rim") return plane.point(-profile.below, profile.base_radius);
  if (place == "cap") return plane.point(-profile.below, eighths * profile.base_radius);
  const double height = eighths * (profile.below + profile.above);
  return plane.point(height - profile.below,
                     profile.base_radius + eighths * (profile.top_radius - profile.base_radius));
}

Homothet cone_of(const Profile& profile, const HalfPlane& plane) {
  return [=](const Vector& center, double factor) {
    const double scale = std::fabs(factor) * plane.unit;
    return std::make_shared<TruncatedCone>(
        center - factor * profile.below * plane.along, scale * profile.base_radius,
        center + factor * profile.above * plane.along, scale * profile.top_radius);
  };
}

Homothet cylinder_of(double half_length, double radius, const HalfPlane& plane) {
  return [=](const Vector& center, double factor) {
    const Vector end = factor * half_length * plane.along;
    return std::make_shared<Cylinder>(center - end, center + end, std::fabs(factor) * radius * plane.unit);
  };
}

Homothet capsule_of(double half_length, double radius, const HalfPlane& plane) {
  return [=](const Vector& center, double factor) {
    const Vector end = factor * half_length * plane.along;
    return std::make_shared<Capsule>(center - end, center + end, std::fabs(factor) * radius * plane.unit);
  };
}

Instance generate_truncated_cone(const InstanceKey& key, const Parameters& parameters) {
  RandomStream stream(key, "hard_truncated_cone", RandomPurpose::shape);
  const HalfPlane plane = random_half_plane(stream, key.n, 4, 4);
  const Profile profile = random_profile(stream, string_parameter(parameters, "shape"));
  const Vector p = surface_point(profile, plane, string_parameter(parameters, "place"), stream);
  return homothets(stream, parameters, cone_of(profile, plane), p);
}

Instance generate_capsule(const InstanceKey& key, const Parameters& parameters) {
  constexpr double kRadius = 5;
  RandomStream stream(key, "hard_capsule", RandomPurpose::shape);
  const HalfPlane plane = random_half_plane(stream, key.n, 4, 4);
  const double half_length = kRadius * std::round(real_parameter(parameters, "ratio") * 0x1p10) * 0x1p-10;
  const std::string place = string_parameter(parameters, "place");
  Vector p = plane.point(half_length + kRadius, 0);
  if (place == "cap") p = plane.point(half_length + 3, 4);
  if (place == "seam") p = plane.point(half_length, kRadius);
  if (place == "side") p = plane.point(signed_integer(stream, 0, 7) / 8 * half_length, kRadius);
  return homothets(stream, parameters, capsule_of(half_length, kRadius, plane), p);
}

Instance generate_near_axis(const InstanceKey& key, const Parameters& parameters) {
  RandomStream stream(key, "hard_near_axis", RandomPurpose::shape);
  const HalfPlane plane = random_half_plane(stream, key.n, 2, 1);
  const double delta = on_grid(real_parameter(parameters, "delta"));
  const double h = random_integer(stream, 1, 2);
  const std::string body = string_parameter(parameters, "body");
  if (body == "capsule") {
    const long double slope = delta / (2 * h);
    return homothets(stream, parameters, capsule_of(h, h, plane), plane.point(2 * h, delta),
                     1 + slope * slope);
  }
  if (body == "cylinder") {
    return homothets(stream, parameters, cylinder_of(h, 1, plane), plane.point(h, delta));
  }
  const Profile cone{h, h, 2 * h, 0};
  return homothets(stream, parameters, cone_of(cone, plane), plane.point(h, delta),
                   1 + static_cast<long double>(delta) / h);
}

ParameterInfo choice(const char* name, const char* description, const std::vector<std::string>& choices) {
  return {name, choices.front(), {}, {}, description, choices};
}

}  // namespace

Component<Generator> hard_truncated_cone_generator() {
  return generator_component(
      "hard_truncated_cone", "homothetic truncated cones, touched at their side, disc, rim or axis",
      {choice("shape", "what the truncated cone is", {"truncated", "cone", "cylinder", "inverted"}),
       choice("place", "where the ray to A leaves Q", {"side", "cap", "rim", "axis"}), object_parameter()},
      generate_truncated_cone, 2);
}

Component<Generator> hard_capsule_generator() {
  return generator_component("hard_capsule", "homothetic capsules, touched at their side, cap, seam or tip",
                             {{"ratio", 1.0, 0x1p-10, 0x1p10, "half-length / radius", {}},
                              choice("place", "where the ray to A leaves Q", {"side", "cap", "seam", "tip"}),
                              object_parameter()},
                             generate_capsule, 2);
}

Component<Generator> hard_near_axis_generator() {
  return generator_component("hard_near_axis", "homothets touched very near the axis they have in common",
                             {choice("body", "what Q is", {"cone", "cylinder", "capsule"}),
                              {"delta", 1e-8, 0, 0.5, "distance from the axis", {}, "1", {"1/δ", reciprocal}},
                              object_parameter()},
                             generate_near_axis, 2);
}

}  // namespace raygauge
