// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "bench/loaded_library.h"

#include <dlfcn.h>

#include <filesystem>
#include <stdexcept>

#include "baselines/rigid_body.h"

namespace raygauge::bench {
namespace {

raygauge_body_kind kind_of(RigidBody::Kind kind) {
  using Kind = RigidBody::Kind;
  switch (kind) {
    case Kind::ball:
      return RAYGAUGE_BALL;
    case Kind::capsule:
      return RAYGAUGE_CAPSULE;
    case Kind::box:
      return RAYGAUGE_BOX;
    case Kind::ellipsoid:
      return RAYGAUGE_ELLIPSOID;
    case Kind::cylinder:
      return RAYGAUGE_CYLINDER;
    case Kind::cone:
      return RAYGAUGE_CONE;
    case Kind::frustum:
      return RAYGAUGE_FRUSTUM;
    case Kind::hull:
      break;
  }
  return RAYGAUGE_HULL;
}

// A hull's own frame is that of its set: its points are moved until 0 is the set's centre.
RigidBody centred_body(const ConvexSet& S) {
  auto body = RigidBody::of(S, RigidBody::Frusta::taken);
  if (!body) throw std::runtime_error("a body that no library has, or a build without Qhull");
  if (body->kind != RigidBody::Kind::hull) return *std::move(body);
  Eigen::Vector3d center;
  S.center_unchecked(center.data());
  for (Eigen::Vector3d& vertex : body->vertices) vertex -= center;
  body->frame.translation() += body->frame.linear() * center;
  return *std::move(body);
}

raygauge_body plain(const RigidBody& body) {
  raygauge_body made{};
  made.kind = kind_of(body.kind);
  made.radius = body.radius;
  made.top_radius = body.top_radius;
  made.height = body.height;
  Eigen::Map<Eigen::Vector3d>(made.half) = body.half;
  if (!body.vertices.empty()) made.vertices = body.vertices.front().data();
  made.vertex_count = body.vertices.size();
  made.triangles = body.triangles.data();
  made.triangle_count = body.triangles.size() / 3;
  return made;
}

raygauge_placement placement(const Pose& pose, const Pose& frame) {
  raygauge_placement made{};
  using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  Eigen::Map<Rows>(made.rotation) = pose.rotation() * frame.rotation();
  Eigen::Map<Eigen::Vector3d>(made.translation) = pose.rotation() * frame.translation() + pose.translation();
  return made;
}

}  // namespace

LibraryPair::LibraryPair(const raygauge_pair_library& library, const PosedPair& pair,
                         raygauge_pair_query query, double tolerance)
    : library_(library),
      pair_(nullptr, library.destroy),
      memory_(library.memory_size),
      next_(library.memory_size) {
  const RigidBody body[2] = {centred_body(*pair.first), centred_body(*pair.second)};
  for (int i = 0; i < 2; ++i) frame_[i] = Pose(body[i].frame.linear(), body[i].frame.translation());
  const raygauge_body first = plain(body[0]), second = plain(body[1]);
  pair_.reset(library.make(&first, &second, query, tolerance));
}

void LibraryPair::place(const Pose& first, const Pose& second) {
  const raygauge_placement at[2] = {placement(first, frame_[0]), placement(second, frame_[1])};
  library_.place(pair_.get(), &at[0], &at[1]);
}

bool LibraryPair::solve_and_remember(raygauge_pair_answer& answer) {
  return library_.solve(pair_.get(), nullptr, memory_.data(), &answer) == 1;
}

LoadedLibrary::LoadedLibrary(const std::string& path) : object_(nullptr, ::dlclose) {
  const std::string full = std::filesystem::absolute(path).string();  // never one of the system's folders
  object_.reset(::dlopen(full.c_str(), RTLD_NOW | RTLD_LOCAL));
  if (object_ == nullptr) throw std::runtime_error(path + ": " + ::dlerror());
  using Entry = const raygauge_pair_library* (*)();
  const auto entry = reinterpret_cast<Entry>(::dlsym(object_.get(), "raygauge_pair_library_entry"));
  if (entry == nullptr) throw std::runtime_error(path + ": no function raygauge_pair_library_entry");
  functions_ = entry();
  if (functions_ == nullptr || functions_->version != RAYGAUGE_PAIR_LIBRARY_VERSION)
    throw std::runtime_error(path + ": an adapter of another version of bench/pair_library.h");
}

}  // namespace raygauge::bench
