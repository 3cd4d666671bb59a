// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <sstream>

#include "engine/meshes/box_tree.h"
#include "raygauge/meshes/mesh.h"
#include "scene/input/scene_source.h"
#include "scene/queries/timeline.h"

namespace raygauge::cli {
namespace {

/// FNV-1a over the bytes of numbers: two scenes whose bodies are anywhere else differ.
class Checksum {
 public:
  void add(double value) {
    unsigned char bytes[sizeof value];
    std::copy_n(reinterpret_cast<const unsigned char*>(&value), sizeof value, bytes);
    for (const unsigned char byte : bytes) hash_ = (hash_ ^ byte) * 1099511628211ULL;
  }
  void add(const SmallVector& v) {
    for (Eigen::Index k = 0; k < v.size(); ++k) add(v[k]);
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 14695981039346656037ULL;
};

void add_mesh(const Mesh& mesh, Checksum& shapes) {
  shapes.add(mesh.kind() == MeshKind::solid ? 1 : 0);
  if (mesh.kind() == MeshKind::cloud) shapes.add(mesh.radius());
  for (std::int32_t i = 0; i < mesh.size(); ++i) {
    for (const Vector3& p : mesh.tree().triangle(i).corner) {
      for (const double x : {p.x, p.y, p.z}) shapes.add(x);
    }
  }
}

std::string text_of(const std::optional<double>& number) {
  std::ostringstream text;
  text.precision(17);
  if (number) text << *number;
  return number ? text.str() : "none";
}

std::string text_of(const ContactLaw& law) {
  return "friction " + text_of(law.friction) + ", restitution " + text_of(law.restitution);
}

void add_numbers(const Eigen::MatrixXd& numbers, Checksum& checksum) {
  for (const double x : numbers.reshaped()) checksum.add(x);
}

void add_dynamics(const SceneSource& source, std::ostringstream& text) {
  const Dynamics& dynamics = *source.dynamics;
  Checksum reactions, groups;
  for (const BodyDynamics& body : dynamics.bodies) {
    reactions.add(body.mass);
    for (const Eigen::Vector3d* v : {&body.center, &body.velocity, &body.spin}) add_numbers(*v, reactions);
    add_numbers(body.inertia, reactions);
  }
  text << "reactions = " << reactions.value() << "\ngravity =";
  if (dynamics.gravity) text << ' ' << dynamics.gravity->transpose();
  text << "\ncontact = " << (dynamics.contact ? text_of(*dynamics.contact) : "none");
  for (const PairLaw& pair : dynamics.pairs) {
    for (const auto* group : {&pair.group_1, &pair.group_2}) {
      groups.add(static_cast<double>(group->size()));
      for (const int body : *group) groups.add(body);
    }
    text << "; " << text_of(pair.law) << " (" << groups.value() << ')';
  }
  text << "\ndamping =";
  if (dynamics.damping) text << ' ' << dynamics.damping->linear << ' ' << dynamics.damping->angular;
  if (dynamics.overlap_at_start == StartOverlap::resolved) text << "\noverlap_at_start = resolved";
  text << "\naccuracies =";
  for (const SimulationAccuracy& one : source.accuracies) text << ' ' << one.step << '/' << one.tolerance;
  if (source.engines != std::vector<std::string>{kOwnEngine}) {
    text << "\nengines =";
    for (const std::string& engine : source.engines) text << ' ' << engine;
  }
  text << '\n';
}

}  // namespace

std::string scene_identity(const SceneSource& source) {
  const Scene& scene = source.scene;
  const Timeline timeline(scene);
  std::ostringstream text;
  text.precision(17);
  Checksum instants, shapes, places;
  for (const double t : scene.instants) instants.add(t);
  std::string names;
  for (int b = 0; b < static_cast<int>(scene.bodies.size()); ++b) {
    const Body& body = scene.bodies[static_cast<std::size_t>(b)];
    names += (names.empty() ? "" : ", ") + body.name;
    for (const BodyPart& part : body.parts) {
      shapes.add(part.ball.center);
      shapes.add(part.ball.radius);
      shapes.add(part.magnitude);
      if (const Mesh* mesh = as_mesh(*part.set)) add_mesh(*mesh, shapes);
    }
    for (std::size_t k = 0; k < timeline.size(); ++k) {
      places.add(timeline.placement(b, k).t);
      places.add(SmallVector(timeline.placement(b, k).R.col(0)));
    }
  }
  text << "instants = " << scene.instants.size() << " (" << instants.value() << ")\n"
       << "bodies = " << names << "\nshapes = " << shapes.value() << "\nplaces = " << places.value() << '\n';
  if (source.dynamics) add_dynamics(source, text);
  for (std::size_t q = 0; q < scene.queries.size(); ++q) {
    const SceneQuery& query = scene.queries[q];
    text << "query " << q + 1 << " = " << to_string(query.effects) << "; " << source.metrics[q] << "; "
         << pairs_of(scene, query).size() << " pairs; within " << query.within << "; nearest "
         << query.nearest << "; tolerance " << query.tolerance << "; contact " << query.contact
         << "; clearance_tolerance " << query.clearance_tolerance << "; every_instant " << query.every_instant
         << '\n';
  }
  return text.str();
}

}  // namespace raygauge::cli
