// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/scene.h"

#include <algorithm>
#include <cmath>

#include "raygauge/exceptions.h"
#include "raygauge/meshes/mesh.h"
#include "raygauge/sets/half_space.h"

namespace raygauge {
namespace {

[[noreturn]] void refuse(const std::string& message) { throw InvalidParameterError(message); }

void check_bodies(const Scene& scene) {
  if (scene.bodies.empty()) refuse("a scene needs a body");
  const int n = scene.dimension();
  if (n > kMostSceneDimensions) {
    refuse("a scene has at most " + std::to_string(kMostSceneDimensions) + " dimensions");
  }
  for (const Body& body : scene.bodies) {
    if (body.dimension() != n) {
      throw DimensionMismatchError("body '" + body.name + "' lives in R^" + std::to_string(body.dimension()) +
                                   ", body '" + scene.bodies.front().name + "' in R^" + std::to_string(n));
    }
  }
}

void check_instants(const Scene& scene) {
  if (scene.instants.empty()) refuse("a scene needs an instant");
  for (std::size_t k = 0; k < scene.instants.size(); ++k) {
    if (!std::isfinite(scene.instants[k])) throw NonFiniteError("an instant is not finite");
    if (k > 0 && !(scene.instants[k - 1] < scene.instants[k])) refuse("instants must rise");
  }
  for (const Body& body : scene.bodies) {
    if (scene.instants.front() >= body.motion->start() && scene.instants.back() <= body.motion->stop()) {
      if (std::isfinite(body.motion->error_at(scene.instants.back()).place)) continue;
      refuse("body '" + body.name + "' moves farther than can be computed with: its place at time " +
             std::to_string(scene.instants.back()) + " has numbers above 1e150");
    }
    refuse("body '" + body.name + "' moves from time " + std::to_string(body.motion->start()) + " to " +
           std::to_string(body.motion->stop()) + ", but the scene asks from " +
           std::to_string(scene.instants.front()) + " to " + std::to_string(scene.instants.back()));
  }
}

void check_effects(const SceneQuery& query, const std::string& place) {
  const bool instants = has_effect(query.effects, kInstantEffects);
  const bool continuous = has_effect(query.effects, kContinuousEffects);
  if (!instants && !continuous) refuse(place + ": no effect is asked for");
  if (continuous && (query.nearest > 0 || std::isfinite(query.within))) {
    refuse(place + ": within and nearest belong to effects at instants, not to time_of_impact or clearance");
  }
}

// What a half-space cannot be asked.
void check_half_spaces(const Scene& scene, const SceneQuery& query, const std::string& place) {
  if (!query.metric.euclidean() && as_half_space(*query.metric.Q) != nullptr)
    refuse(place + ": the metric is a half-space, which is not bounded");
  const bool bounded = std::all_of(scene.bodies.begin(), scene.bodies.end(),
                                   [](const Body& body) { return body.is_bounded(); });
  if (bounded) return;
  for (const BodyPair pair : pairs_of(scene, query)) {
    const Body &a = scene.bodies[static_cast<std::size_t>(pair.a)],
               &b = scene.bodies[static_cast<std::size_t>(pair.b)];
    if (a.is_bounded() && b.is_bounded()) continue;
    const Body& half_space = a.is_bounded() ? b : a;
    const std::string name = "body '" + half_space.name + "' is a half-space";
    if (!a.is_bounded() && !b.is_bounded())
      refuse(place + ": " + name + ", and so is body '" + b.name + "': no effect of such a pair is known");
    if (has_effect(query.effects, SceneEffects::growth))
      refuse(place + ": " + name + ": it has no centre to be scaled about, so that there is no growth");
    if (has_effect(query.effects, kContinuousEffects) &&
        !half_space.motion->keeps_rotation(scene.instants.front(), scene.instants.back())) {
      refuse(place + ": " + name + " that turns: time_of_impact and clearance take those that do not turn");
    }
  }
}

bool has_mesh(const Body& body) {
  return std::any_of(body.parts.begin(), body.parts.end(),
                     [](const BodyPart& part) { return as_mesh(*part.set) != nullptr; });
}

// What a mesh cannot be asked.
void check_meshes(const Scene& scene, const SceneQuery& query, const std::string& place) {
  if (!query.metric.euclidean() && as_mesh(*query.metric.Q) != nullptr)
    refuse(place + ": the metric is a mesh, which is not convex");
  if (std::none_of(scene.bodies.begin(), scene.bodies.end(), has_mesh)) return;
  for (const BodyPair pair : pairs_of(scene, query)) {
    const Body &a = scene.bodies[static_cast<std::size_t>(pair.a)],
               &b = scene.bodies[static_cast<std::size_t>(pair.b)];
    if (!has_mesh(a) && !has_mesh(b)) continue;
    const std::string name = "body '" + (has_mesh(a) ? a : b).name + "' is a mesh as it is";
    if (!query.metric.euclidean()) refuse(place + ": " + name + ": its distances are Euclidean");
    if (has_effect(query.effects, SceneEffects::depth | SceneEffects::growth))
      refuse(place + ": " + name +
             ": depth and growth are those of convex bodies; take its hull (as = \"hull\") or convex parts");
  }
}

void check_query(const Scene& scene, const SceneQuery& query) {
  const std::string place = "query '" + query.name + "'";
  const int bodies = static_cast<int>(scene.bodies.size());
  for (const std::vector<int>* group : {&query.group_1, &query.group_2}) {
    if (group->empty()) refuse(place + ": a group is empty");
    for (const int body : *group) {
      if (body < 0 || body >= bodies) refuse(place + ": there is no body number " + std::to_string(body));
    }
  }
  if (query.metric.body >= bodies) refuse(place + ": the metric follows a body that is not there");
  if (!query.metric.euclidean() && query.metric.Q->dimension() != scene.dimension()) {
    throw DimensionMismatchError(place + ": the metric lives in R^" +
                                 std::to_string(query.metric.Q->dimension()) + ", the scene in R^" +
                                 std::to_string(scene.dimension()));
  }
  if (!(query.tolerance > 0 && query.tolerance < 1)) refuse(place + ": tolerance must lie in (0, 1)");
  if (!(query.clearance_tolerance > 0 && query.clearance_tolerance < 1)) {
    refuse(place + ": clearance_tolerance must lie in (0, 1)");
  }
  if (!(query.contact > 0 && std::isfinite(query.contact))) refuse(place + ": contact must be positive");
  if (!(query.within > 0)) refuse(place + ": within must be positive");
  if (query.nearest < 0) refuse(place + ": nearest must not be negative");
  check_effects(query, place);
  check_half_spaces(scene, query, place);
  check_meshes(scene, query, place);
}

}  // namespace

std::vector<BodyPair> pairs_of(const Scene& scene, const SceneQuery& query) {
  std::vector<BodyPair> pairs, ignored;
  for (const auto& [a, b] : scene.ignored) ignored.push_back({std::min(a, b), std::max(a, b)});
  std::sort(ignored.begin(), ignored.end());
  const bool one_group = query.group_1 == query.group_2;
  for (std::size_t i = 0; i < query.group_1.size(); ++i) {
    for (std::size_t j = one_group ? i + 1 : 0; j < query.group_2.size(); ++j) {
      const int a = query.group_1[i], b = query.group_2[j];
      const BodyPair pair{std::min(a, b), std::max(a, b)};
      if (a != b && !std::binary_search(ignored.begin(), ignored.end(), pair)) pairs.push_back(pair);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

void check_scene(const Scene& scene) {
  check_bodies(scene);
  check_instants(scene);
  for (const SceneQuery& query : scene.queries) check_query(scene, query);
}

}  // namespace raygauge
