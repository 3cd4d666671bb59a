// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// FCL behind pair_library.h: the example of an adapter. FCL has no warm start, frusta or growth distances.
#include <fcl/fcl.h>

#include <exception>
#include <memory>
#include <vector>

#include "bench/pair_library.h"

namespace {

using Geometry = std::shared_ptr<fcl::ShapeBase<double>>;

Geometry hull_of(const raygauge_body& body) {
  auto vertices = std::make_shared<std::vector<Eigen::Vector3d>>();
  for (size_t i = 0; i < body.vertex_count; ++i) vertices->emplace_back(body.vertices + 3 * i);
  auto faces = std::make_shared<std::vector<int>>();
  for (size_t i = 0; i < 3 * body.triangle_count; ++i) {
    if (i % 3 == 0) faces->push_back(3);
    faces->push_back(body.triangles[i]);
  }
  return std::make_shared<fcl::Convexd>(vertices, static_cast<int>(body.triangle_count), faces);
}

Geometry geometry_of(const raygauge_body& body) {
  switch (body.kind) {
    case RAYGAUGE_BALL:
      return std::make_shared<fcl::Sphered>(body.radius);
    case RAYGAUGE_CAPSULE:
      return std::make_shared<fcl::Capsuled>(body.radius, body.height);
    case RAYGAUGE_BOX:
      return std::make_shared<fcl::Boxd>(2 * body.half[0], 2 * body.half[1], 2 * body.half[2]);
    case RAYGAUGE_ELLIPSOID:
      return std::make_shared<fcl::Ellipsoidd>(body.half[0], body.half[1], body.half[2]);
    case RAYGAUGE_CYLINDER:
      return std::make_shared<fcl::Cylinderd>(body.radius, body.height);
    case RAYGAUGE_CONE:
      return std::make_shared<fcl::Coned>(body.radius, body.height);
    case RAYGAUGE_FRUSTUM:
      return nullptr;
    case RAYGAUGE_HULL:
      break;
  }
  return hull_of(body);
}

struct Pair {
  Geometry first, second;
  Eigen::Isometry3d at_1, at_2;
  bool deep = false;
  fcl::DistanceRequestd distance;
  fcl::CollisionRequestd collision;

  void answer_distance(raygauge_pair_answer& answer) const {
    fcl::DistanceResultd result;
    fcl::distance(first.get(), at_1, second.get(), at_2, distance, result);
    answer.value = result.min_distance;
    Eigen::Map<Eigen::Vector3d>(answer.point_1) = result.nearest_points[0];
    Eigen::Map<Eigen::Vector3d>(answer.point_2) = result.nearest_points[1];
  }
  void answer_depth(raygauge_pair_answer& answer) const {
    fcl::CollisionResultd result;
    fcl::collide(first.get(), at_1, second.get(), at_2, collision, result);
    answer.value = 0;
    if (result.numContacts() == 0) return;
    const fcl::Contactd& contact = result.getContact(0);
    answer.value = contact.penetration_depth;
    const Eigen::Vector3d half = 0.5 * contact.penetration_depth * contact.normal;
    Eigen::Map<Eigen::Vector3d>(answer.point_1) = contact.pos + half;
    Eigen::Map<Eigen::Vector3d>(answer.point_2) = contact.pos - half;
  }
};

void* make(const raygauge_body* first, const raygauge_body* second, raygauge_pair_query query,
           double tolerance) {
  if (query == RAYGAUGE_GROWTH) return nullptr;
  auto pair = std::make_unique<Pair>();
  pair->first = geometry_of(*first);
  pair->second = geometry_of(*second);
  if (pair->first == nullptr || pair->second == nullptr) return nullptr;
  pair->deep = query == RAYGAUGE_DEPTH;
  pair->distance.enable_nearest_points = true;
  pair->distance.distance_tolerance = tolerance;
  pair->collision.enable_contact = true;
  pair->collision.gjk_tolerance = tolerance;
  return pair.release();
}

Eigen::Isometry3d isometry(const raygauge_placement& at) {
  Eigen::Isometry3d made = Eigen::Isometry3d::Identity();
  made.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(at.rotation);
  made.translation() = Eigen::Map<const Eigen::Vector3d>(at.translation);
  return made;
}

void place(void* pair, const raygauge_placement* first, const raygauge_placement* second) {
  static_cast<Pair*>(pair)->at_1 = isometry(*first);
  static_cast<Pair*>(pair)->at_2 = isometry(*second);
}

int solve(void* pair, const void* /*start*/, void* /*memory*/, raygauge_pair_answer* answer) {
  const Pair& asked = *static_cast<const Pair*>(pair);
  try {
    if (asked.deep)
      asked.answer_depth(*answer);
    else
      asked.answer_distance(*answer);
    return 1;
  } catch (const std::exception&) {
    return 0;
  }
}

void destroy(void* pair) { delete static_cast<Pair*>(pair); }

}  // namespace

extern "C" const raygauge_pair_library* raygauge_pair_library_entry() {
  static const raygauge_pair_library kLibrary = {
      RAYGAUGE_PAIR_LIBRARY_VERSION, "FCL " FCL_VERSION, 0, make, place, solve, destroy};
  return &kLibrary;
}
