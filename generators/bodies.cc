// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/bodies.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "generators/random.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::bodies {
namespace {

constexpr const char* kName = "bodies";
constexpr const char* kKind1 = "kind_1";
constexpr const char* kKind2 = "kind_2";
constexpr const char* kAny = "any";
constexpr double kOverlap =
    0.2;  // from centre to centre; every body but a hull and a needle holds a ball of radius 0.3
constexpr double kThin = 1e-3;         // a needle's half width
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
      {"needle",
       [](const Shape& s, const Vector& t) -> Body {
         Vector half = Vector::Constant(s.R.cols(), kThin * s.size);
         half[0] = 0.6 * s.size;
         return AffineImage::rigid(std::make_shared<Box>(-half, half), s.R, t);
       }},
  };
  return kAll;
}

Body body_at(const Shape& shape, const Vector& t) { return kinds().at(shape.kind)(shape, t); }

Vector support_point(const ConvexSet& S, const Vector& u) {
  Vector point(u.size());
  S.support_unchecked(u.data(), point.data());
  return point;
}

/// The radius of a ball, in sizes, that rolls about inside of a body and touches all of its boundary: the
/// least radius of curvature, of an ellipsoid b²/a; 0 where there are edges.
double rolling_radius(const std::string& kind) {
  static const std::map<std::string, double> kRounded = {
      {"ball", 0.5}, {"capsule", 0.3}, {"ellipsoid", 0.35 * 0.35 / 0.7}};
  const auto found = kRounded.find(kind);
  return found == kRounded.end() ? 0 : found->second;
}

/// Where the bodies are. Lengths in sizes.
struct Place {
  double growth = 0;       ///< the growth distance, where that is asked for
  double gap = 0;          ///< between bodies that are apart; 0 where they overlap
  double into = 0;         ///< of bodies that overlap slightly: how far body 2 is moved into body 1
  double between = 0;      ///< of others that overlap: from centre to centre
  double from_origin = 1;  ///< of body 1
  bool parallel = false;   ///< turned alike, apart along their common axis
};

const std::map<std::string, Place>& places() {
  constexpr double kNear = 1e-3, kGrazing = 1e-6, kFar = 1e6;
  static const std::map<std::string, Place> kAll = {
      {"apart", {2, 1, 0, 0}},
      {"near", {1 + kNear, kNear, 0, 0}},
      {"grazing", {1 + kGrazing, kGrazing, 0, 0}},
      {"parallel", {1 + kNear, kNear, 0, 0, 1, true}},
      {"far", {1 + kNear, kNear, 0, 0, kFar}},
      {"slight", {1 - kNear, 0, kNear, 0}},
      {"overlap", {0.5, 0, 0, kOverlap}},
      {"deep", {kNear, 0, 0, 0}},
  };
  return kAll;
}

/// Two shapes and where they are.
struct Pair {
  Shape one, two;
  Place place;
  Vector c;  ///< centre of body 1
  Vector u;  ///< the direction to body 2
  double size = 1;
  Quantity quantity = Quantity::distance;

  /// The instance, with the distance or the depth of the bodies where it is known: 0 on the other side of 0.
  Instance of(const Body& first, const Body& second, double distance, std::optional<double> depth) const {
    Instance instance{std::make_shared<MinkowskiDifference>(second, first),
                      std::make_shared<Ball>(Vector::Zero(u.size()), 1.0), distance};
    instance.quantity = quantity;
    if (quantity == Quantity::separated) instance.exact_distance = distance > 0 ? 1 : 0;
    if (quantity == Quantity::depth) instance.exact_distance = depth;
    const double planted = instance.exact_distance.value_or(0);
    if (quantity != Quantity::separated && planted > 0)
      instance.exact_distance_rounding = kRounding * (1 + place.from_origin) * size / planted;
    return instance;
  }
};

/// Where body 2 touches body 1: its support point at -u is that of body 1 at u.
Vector touching(const Pair& pair, const Body& first) {
  const Body second = body_at(pair.two, Vector::Zero(pair.u.size()));
  return support_point(*first, pair.u) - support_point(*second, -pair.u);
}

/// Body 2 moved from there by gap·u.
Instance apart(const Pair& pair) {
  const Body first = body_at(pair.one, pair.c);
  const double gap = pair.place.gap * pair.size;
  return pair.of(first, body_at(pair.two, touching(pair, first) + gap * pair.u), gap, 0.0);
}

/// Body 2 moved from there into body 1: by -δ u where a ball of radius δ or more rolls about inside of one of
/// the bodies, and so inside of their difference. That is then the depth: the ball touches the boundary of
/// the difference where the origin was. Other bodies are moved towards the centre of body 1, which then holds
/// the point of body 2 that touched it.
Instance slightly_overlapping(const Pair& pair) {
  const Body first = body_at(pair.one, pair.c);
  const double into = pair.place.into * pair.size;
  const bool planted = pair.quantity == Quantity::depth &&
                       rolling_radius(pair.one.kind) + rolling_radius(pair.two.kind) > pair.place.into;
  Vector inwards = -pair.u;
  if (!planted) inwards = (first->center() - support_point(*first, pair.u)).normalized();
  return pair.of(first, body_at(pair.two, touching(pair, first) + into * inwards), 0,
                 planted ? std::optional(into) : std::nullopt);
}

/// Body 2 about an inner point of body 1. The centre of a hull is the mean of its points; two hulls share it.
/// The depth of two balls is the sum of their radii less what is between their centres.
Instance overlapping(const Pair& pair) {
  const auto mean = [](const Shape& shape) {
    return shape.kind == "hull" ? Vector(shape.points.rowwise().mean())
                                : Vector(Vector::Zero(shape.R.rows()));
  };
  const auto holds_a_ball = [](const Shape& shape) { return shape.kind != "hull" && shape.kind != "needle"; };
  const bool moved = holds_a_ball(pair.one) || holds_a_ball(pair.two);
  const double between = moved ? pair.place.between * std::min(pair.one.size, pair.two.size) : 0;
  const Vector t = pair.c + mean(pair.one) - mean(pair.two) + between * pair.u;
  std::optional<double> depth;
  if (pair.one.kind == "ball" && pair.two.kind == "ball")
    depth = 0.5 * (pair.one.size + pair.two.size) - between;
  return pair.of(body_at(pair.one, pair.c), body_at(pair.two, t), 0, depth);
}

/// Body 2 where both touch once they are scaled by σ about their centres: then the planes through the points
/// that touch separate the scaled bodies.
Instance at_growth(const Pair& pair) {
  const Body first = body_at(pair.one, pair.c), second = body_at(pair.two, Vector::Zero(pair.u.size()));
  const double growth = pair.place.growth;
  const Vector center = second->center();
  const Vector reach =
      (support_point(*first, pair.u) - first->center()) - (support_point(*second, -pair.u) - center);
  Instance instance =
      pair.of(first, body_at(pair.two, first->center() + growth * reach - center), growth, {});
  instance.exact_distance_rounding =
      kRounding * (1 + pair.place.from_origin) * pair.size / (growth * reach.dot(pair.u));
  return instance;
}

/// The kind asked for; of "any", each by turns, that of body 2 for all of body 1 before the next.
std::string kind_of(const Parameters& parameters, const std::string& name, int repetition) {
  const std::string& kind = string_parameter(parameters, name);
  if (kind != kAny) return kind;
  const auto all = static_cast<int>(kinds().size());
  const bool slower = name == kKind2 && string_parameter(parameters, kKind1) == kAny;
  return std::next(kinds().begin(), (slower ? repetition / all : repetition) % all)->first;
}

Pair pair_of(const InstanceKey& key, const Parameters& parameters) {
  const double size = real_parameter(parameters, "scale");
  RandomStream of_1(key, kName, RandomPurpose::points_of_A), of_2(key, kName, RandomPurpose::points_of_Q);
  Pair pair;
  pair.size = size;
  pair.quantity = quantity_from_string(string_parameter(parameters, "quantity"));
  pair.place = places().at(string_parameter(parameters, "place"));
  pair.one = random_shape(of_1, kind_of(parameters, kKind1, key.repetition), size, key.n, key.N);
  pair.two = random_shape(of_2, kind_of(parameters, kKind2, key.repetition), size, key.n, key.N);
  RandomStream placement(key, kName, RandomPurpose::placement);
  pair.u = placement.unit_vector(key.n);
  pair.c = pair.place.from_origin * size * placement.unit_vector(key.n);
  if (pair.place.parallel) {
    pair.two.R = pair.one.R;
    pair.u = pair.one.R.col(0);
  }
  return pair;
}

Instance generate(const InstanceKey& key, const Parameters& parameters) {
  const Pair pair = pair_of(key, parameters);
  if (pair.quantity == Quantity::growth) return at_growth(pair);
  if (pair.place.gap > 0) return apart(pair);
  return pair.place.into > 0 ? slightly_overlapping(pair) : overlapping(pair);
}

template <class T>
std::vector<std::string> names_of(const std::map<std::string, T>& entries) {
  std::vector<std::string> names;
  for (const auto& entry : entries) names.push_back(entry.first);
  return names;
}

std::vector<std::string> quantities() {
  std::vector<std::string> names;
  for (const Quantity each : {Quantity::distance, Quantity::depth, Quantity::separated, Quantity::growth})
    names.emplace_back(to_string(each));
  return names;
}

std::vector<ParameterInfo> parameters() {
  std::vector<std::string> all_kinds = names_of(kinds());
  all_kinds.emplace_back(kAny);
  return {{kKind1,
           std::string("box"),
           {},
           {},
           "kind of the first body; a hull has N points; any: each by turns",
           all_kinds},
          {kKind2, std::string("box"), {}, {}, "kind of the second body", all_kinds},
          {"place",
           std::string("apart"),
           {},
           {},
           "a size, a thousandth or a millionth of it apart, or overlapping; docs/generators.md",
           names_of(places())},
          {"quantity",
           std::string("distance"),
           {},
           {},
           "what is asked: the distance, the depth, whether they are separated, the growth distance",
           quantities()},
          {"scale", 1.0, 1e-100, 1e100, "size of both bodies", {}}};
}

}  // namespace
}  // namespace raygauge::bodies

namespace raygauge {

Component<Generator> bodies_generator() {
  return generator_component(bodies::kName, "two bodies at a planted Euclidean distance, or overlapping",
                             bodies::parameters(), bodies::generate, 2);
}

}  // namespace raygauge
