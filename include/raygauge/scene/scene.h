// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "raygauge/scene/motion.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// {x : |x - center| <= radius}, proven to contain a part or a body.
struct BoundingBall {
  SmallVector center;
  double radius = 0;
};

/// A ball around S, proven: around the middle of its box, at most 13 % larger than the least one about that
/// point; exact for point sets. 2n support queries, in 3 dimensions 26.
BoundingBall bounding_ball(const ConvexSet& S);

/// One convex part of a body, in the frame of the body. For a half-space, ball and reach are infinite, and
/// the magnitude is its normal.
struct BodyPart {
  std::shared_ptr<const ConvexSet> set;
  BoundingBall ball;
  double reach = 0;             ///< no point of the part is farther from the body's origin
  double core_reach = 0;        ///< the same for its core, without the radius that surrounds it
  SmallVector magnitude;        ///< ConvexSet::magnitude_unchecked
  double turned_magnitude = 0;  ///< bounds it in every rotation of the part
};

/// 2 √n |m|: an upper bound on the magnitude of a set of magnitude m in any rotation.
double turned_magnitude(const SmallVector& magnitude);

class PartTree;

/// A rigid body: the union of convex parts, under a motion.
struct Body {
  std::string name;
  std::vector<BodyPart> parts;
  std::shared_ptr<const PartTree> tree;  ///< of balls around many parts; null: there are few
  MotionPointer motion;
  BoundingBall ball;  ///< around all parts
  double reach = 0;   ///< the greatest of the parts'
  double core_reach = 0;

  int dimension() const noexcept { return motion->dimension(); }

  /// False for a half-space.
  bool is_bounded() const noexcept { return reach < std::numeric_limits<double>::infinity(); }
};

/// The body of these parts; a half-space is the only part of its body. Throws EmptySetError (no part),
/// InvalidParameterError (a null pointer, a half-space beside another part) or DimensionMismatchError.
Body make_body(std::string name, const std::vector<std::shared_ptr<const ConvexSet>>& parts,
               MotionPointer motion);

/// What a query asks for. What no query asks for is not computed.
enum class SceneEffects : std::uint16_t {
  none = 0,
  separated = 1,        ///< yes or no
  distance = 2,         ///< in the metric of the query
  closest_points = 4,   ///< of the distance
  gradient = 8,         ///< of the distance, with respect to a translation of the first body
  growth = 16,          ///< growth distance about the centres: below 1 for bodies that overlap
  time_of_impact = 32,  ///< the first contact, at any moment
  clearance = 64,       ///< the least distance, at any moment
  depth = 128,  ///< the distance with its points and gradient; of bodies that meet, how deep they overlap
};

constexpr SceneEffects operator|(SceneEffects a, SceneEffects b) noexcept {
  return static_cast<SceneEffects>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr SceneEffects operator&(SceneEffects a, SceneEffects b) noexcept {
  return static_cast<SceneEffects>(static_cast<unsigned>(a) & static_cast<unsigned>(b));
}
constexpr bool has_effect(SceneEffects asked, SceneEffects effect) noexcept {
  return (asked & effect) != SceneEffects::none;
}

/// Their names, separated by blanks.
std::string to_string(SceneEffects effects);

/// The effect of a name. Throws UnknownNameError; `place` says where the name stood.
SceneEffects effect_named(const std::string& name, const std::string& place = "");

inline constexpr SceneEffects kInstantEffects = SceneEffects::separated | SceneEffects::distance |
                                                SceneEffects::closest_points | SceneEffects::gradient |
                                                SceneEffects::growth | SceneEffects::depth;
inline constexpr SceneEffects kContinuousEffects = SceneEffects::time_of_impact | SceneEffects::clearance;

/// The unit ball Q of a distance, 0 in its interior; d(a, b) = gauge_Q(b - a).
struct SceneMetric {
  std::shared_ptr<const ConvexSet> Q;  ///< null: the Euclidean ball
  int body = -1;                       ///< the body whose rotation Q follows; -1: none

  bool euclidean() const noexcept { return Q == nullptr; }
  friend bool operator==(const SceneMetric&, const SceneMetric&) = default;
};

/// A question about pairs of bodies, asked at every instant of a scene or, for continuous effects, over the
/// whole of its time.
struct SceneQuery {
  std::string name;
  std::vector<int> group_1, group_2;  ///< bodies; every pair of one of each, except ignored pairs
  SceneMetric metric;
  SceneEffects effects = SceneEffects::distance;

  /// Only pairs at most this far apart are recorded; the others are proven to be farther apart.
  double within = std::numeric_limits<double>::infinity();

  /// Only this many nearest pairs of an instant are recorded; 0: all.
  int nearest = 0;

  /// Distances are certified to upper - lower <= tolerance * upper.
  double tolerance = 1e-6;

  /// Time of impact: a distance of at most this counts as contact (and is stated as such).
  double contact = 1e-6;

  /// Clearance: upper - lower <= clearance_tolerance * upper, or both at most `contact`.
  double clearance_tolerance = 1e-3;

  /// `separated` is recorded at the first instant and where it changes; true: at every instant.
  bool every_instant = false;
};

/// Bodies, the instants at which queries are answered, and the queries.
struct Scene {
  std::string name;
  std::vector<Body> bodies;
  std::vector<double> instants;              ///< rising; the first and the last span the time of the scene
  std::vector<std::pair<int, int>> ignored;  ///< pairs of bodies that no query is about, as links that join
  std::vector<SceneQuery> queries;

  int dimension() const { return bodies.front().dimension(); }
};

/// Two bodies of a scene, a < b.
struct BodyPair {
  int a = 0;
  int b = 0;
  friend auto operator<=>(const BodyPair&, const BodyPair&) = default;
};

/// The pairs that a query is about, sorted.
std::vector<BodyPair> pairs_of(const Scene& scene, const SceneQuery& query);

/// Throws InvalidParameterError, DimensionMismatchError or NonFiniteError for what cannot be answered: no
/// body, dimensions that differ, instants that do not rise or at which a motion is not known. Also for bodies
/// that do not exist, options outside their range, and effects that do not go together.
void check_scene(const Scene& scene);

}  // namespace raygauge
