// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/bodies.h"

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "generators/random.h"
#include "raygauge/sets/affine_image.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/cylinder.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/minkowski_difference.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::bodies {
namespace {

constexpr const char* kName = "bodies";
constexpr double kApart = 1;  // gaps in sizes of the bodies
constexpr double kNear = 1e-3;
constexpr double kGrazing = 1e-6;
constexpr double kOverlap = 0.2;  // from centre to centre; every body but a hull holds a ball of radius 0.3
constexpr double kRounding = 0x1p-44;  // of the planted gap, relative to the size

using Body = std::shared_ptr<const ConvexSet>;

/// A body about the origin: how it is turned, its size, and the directions of a hull's points.
struct Shape {
  std::string kind;
  Eigen::MatrixXd R;
  double size = 1;
  Eigen::MatrixXd points;
};

Shape random_shape(RandomStream& stream, std::string kind, double size, int n, int N) {
  Shape shape{std::move(kind), stream.rotation(n), size, {}};
  if (shape.kind != "hull") return shape;
  shape.points.resize(n, N);
  for (int i = 0; i < N; ++i) shape.points.col(i) = 0.6 * size * stream.unit_vector(n);
  return shape;
}

/// `count` lengths from the first to the last in even steps.
Vector falling(double first, double last, Eigen::Index count) {
  Vector lengths(count);
  for (Eigen::Index k = 0; k < count; ++k)
    lengths[k] = first - (first - last) * static_cast<double>(k) / static_cast<double>(count - 1);
  return lengths;
}

Body hull_at(const Shape& shape, const Vector& t) {
  Eigen::MatrixXd points = shape.points;
  for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) += t;
  return std::make_shared<PointSet>(points);
}

using MakeBody = Body (*)(const Shape& shape, const Vector& t);

/// One function a kind: the body with its centre at t.
const std::map<std::string, MakeBody>& kinds() {
  static const std::map<std::string, MakeBody> kAll = {
      {"ball",
       [](const Shape& s, const Vector& t) -> Body { return std::make_shared<Ball>(t, 0.5 * s.size); }},
      {"box",
       [](const Shape& s, const Vector& t) -> Body {
         const Vector half = s.size * falling(0.6, 0.4, s.R.cols());
         return AffineImage::rigid(std::make_shared<Box>(-half, half), s.R, t);
       }},
      {"capsule",
       [](const Shape& s, const Vector& t) -> Body {
         const Vector half = 0.5 * s.size * s.R.col(0);
         return std::make_shared<Capsule>(t - half, t + half, 0.3 * s.size);
       }},
      {"cone",
       [](const Shape& s, const Vector& t) -> Body {
         const Vector axis = s.size * s.R.col(0);
         return std::make_shared<TruncatedCone>(t - 0.3 * axis, 0.5 * s.size, t + 0.9 * axis, 0.0);
       }},
      {"cylinder",
       [](const Shape& s, const Vector& t) -> Body {
         const Vector half = 0.5 * s.size * s.R.col(0);
         return std::make_shared<Cylinder>(t - half, t + half, 0.4 * s.size);
       }},
      {"ellipsoid",
       [](const Shape& s, const Vector& t) -> Body {
         Eigen::MatrixXd factor = s.R;
         const Vector semi_axes = s.size * falling(0.7, 0.35, factor.cols());
         for (Eigen::Index k = 0; k < factor.cols(); ++k) factor.col(k) *= semi_axes[k];
         return std::make_shared<Ellipsoid>(t, factor);
       }},
      {"hull", hull_at},
  };
  return kAll;
}

Body body_at(const Shape& shape, const Vector& t) { return kinds().at(shape.kind)(shape, t); }

Vector support_point(const ConvexSet& S, const Vector& u) {
  Vector point(u.size());
  S.support_unchecked(u.data(), point.data());
  return point;
}

/// Body 2 where its support point at -u is that of body 1 at u, and gap·u further.
Instance apart(const Shape& one, const Shape& two, const Vector& c, const Vector& u, double gap) {
  const Body first = body_at(one, c);
  const Vector t =
      support_point(*first, u) - support_point(*body_at(two, Vector::Zero(u.size())), -u) + gap * u;
  const double size = std::max(one.size, two.size);
  return {std::make_shared<MinkowskiDifference>(body_at(two, t), first), nullptr, gap,
          kRounding * size / gap};
}

/// Body 2 about an inner point of body 1: its centre is one, or two hulls share their centres.
Instance overlapping(const Shape& one, const Shape& two, const Vector& c, const Vector& u) {
  const Body first = body_at(one, c);
  const bool hulls = one.kind == "hull" && two.kind == "hull";
  const Vector from = one.kind == "hull" ? Vector(c + one.points.rowwise().mean()) : c;
  const Vector to = two.kind == "hull" ? Vector(two.points.rowwise().mean()) : Vector(Vector::Zero(u.size()));
  const Vector t = from - to + (hulls ? 0.0 : kOverlap * std::min(one.size, two.size)) * u;
  return {std::make_shared<MinkowskiDifference>(body_at(two, t), first), nullptr, 0.0};
}

Instance generate(const InstanceKey& key, const Parameters& parameters) {
  const double size = real_parameter(parameters, "scale");
  RandomStream of_1(key, kName, RandomPurpose::points_of_A), of_2(key, kName, RandomPurpose::points_of_Q);
  const Shape one = random_shape(of_1, string_parameter(parameters, "kind_1"), size, key.n, key.N);
  const Shape two = random_shape(of_2, string_parameter(parameters, "kind_2"), size, key.n, key.N);
  RandomStream placement(key, kName, RandomPurpose::placement);
  const Vector u = placement.unit_vector(key.n);
  const Vector c = size * placement.unit_vector(key.n);
  const std::map<std::string, double> gaps = {{"apart", kApart}, {"near", kNear}, {"grazing", kGrazing}};
  const auto gap = gaps.find(string_parameter(parameters, "place"));
  Instance instance =
      gap == gaps.end() ? overlapping(one, two, c, u) : apart(one, two, c, u, gap->second * size);
  instance.Q = std::make_shared<Ball>(Vector::Zero(key.n), 1.0);
  return instance;
}

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const auto& entry : kinds()) names.push_back(entry.first);
  return names;
}

std::vector<ParameterInfo> parameters() {
  return {{"kind_1", std::string("box"), {}, {}, "kind of the first body; a hull has N points", kind_names()},
          {"kind_2", std::string("box"), {}, {}, "kind of the second body", kind_names()},
          {"place",
           std::string("apart"),
           {},
           {},
           "a size, a thousandth or a millionth of it apart, or overlapping",
           {"apart", "near", "grazing", "overlap"}},
          {"scale", 1.0, 1e-100, 1e100, "size of both bodies", {}}};
}

}  // namespace
}  // namespace raygauge::bodies

namespace raygauge {

Component<Generator> bodies_generator() {
  return with_known_distance(
      generator_component(bodies::kName, "two bodies at a planted Euclidean distance, or overlapping",
                          bodies::parameters(), bodies::generate, 2),
      bodies::kRounding);
}

}  // namespace raygauge
