// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/mesh_distance.h"

#include <string>
#include <utility>

#include "engine/queries/mesh_search.h"
#include "raygauge/exceptions.h"
#include "raygauge/methods/options.h"

namespace raygauge {
namespace {

void check_pose(const Pose* pose) {
  if (pose != nullptr && pose->dimension() != 3)
    throw DimensionMismatchError("a mesh lives in R^3, its pose in R^" + std::to_string(pose->dimension()));
}

void check_set(const Posed& set) {
  if (set.dimension() != 3)
    throw DimensionMismatchError("a mesh lives in R^3, the other object in R^" +
                                 std::to_string(set.dimension()));
  if (set.pose != nullptr && set.pose->dimension() != 3)
    throw DimensionMismatchError("the pose of a set of R^3 is of R^" + std::to_string(set.pose->dimension()));
}

void check_effects(ObjectEffects effects) {
  if (has_effect(effects, ObjectEffects::depth))
    throw InvalidParameterError(
        "the depth of a mesh is not defined: it is that of convex objects; ask for it of convex parts");
  if (has_effect(effects, ObjectEffects::pose_gradient))
    throw InvalidParameterError(
        "gradients by pose are those of convex objects; ask for them of the convex parts of a mesh");
}

[[noreturn]] void refuse_convex() {
  throw InvalidParameterError("neither object is a mesh: ObjectDistanceSolver has their distance");
}

PosedMesh posed(const Mesh& mesh, const Pose* pose) {
  return pose == nullptr ? PosedMesh(mesh) : PosedMesh(mesh, *pose);
}

/// A warm start turned about, for the time of a search whose first object is the second one of the caller.
class InOrder {
 public:
  explicit InOrder(MeshWarmStart* warm) : warm_(warm) { turn(); }
  ~InOrder() { turn(); }
  InOrder(const InOrder&) = delete;
  InOrder& operator=(const InOrder&) = delete;

 private:
  void turn() noexcept {
    if (warm_ != nullptr) std::swap(warm_->triangle_1, warm_->triangle_2);
  }
  MeshWarmStart* warm_;
};

}  // namespace

MeshDistanceSolver::MeshDistanceSolver(const DistanceOptions& options) {
  std::string problem = validate(options);
  if (problem.empty() && options.method != DistanceMethod::automatic)
    problem = "method must be automatic: meshes have one method";
  if (!problem.empty()) throw InvalidParameterError(problem);
  search_ = std::make_unique<MeshSearch>(options);
}

MeshDistanceSolver::~MeshDistanceSolver() = default;
MeshDistanceSolver::MeshDistanceSolver(MeshDistanceSolver&&) noexcept = default;
MeshDistanceSolver& MeshDistanceSolver::operator=(MeshDistanceSolver&&) noexcept = default;

void MeshDistanceSolver::set_stop(std::function<bool()> stop) { search_->set_stop(std::move(stop)); }

const ObjectDistance& MeshDistanceSolver::solve(const PosedMesh& A1, const PosedMesh& A2,
                                                ObjectEffects effects, MeshWarmStart* warm) {
  check_pose(A1.pose);
  check_pose(A2.pose);
  check_effects(effects);
  return search_->distance(MeshPair(A1, A2), effects, warm);
}

const ObjectDistance& MeshDistanceSolver::solve(const PosedMesh& A1, const Posed& A2, ObjectEffects effects,
                                                MeshWarmStart* warm) {
  if (const Mesh* other = as_mesh(A2.set)) return solve(A1, posed(*other, A2.pose), effects, warm);
  check_pose(A1.pose);
  check_set(A2);
  check_effects(effects);
  return search_->distance(MeshPair(A1, A2), effects, warm);
}

const ObjectDistance& MeshDistanceSolver::solve(const Posed& A1, const Posed& A2, ObjectEffects effects,
                                                MeshWarmStart* warm) {
  const Mesh *one = as_mesh(A1.set), *two = as_mesh(A2.set);
  if (one != nullptr && two != nullptr)
    return solve(posed(*one, A1.pose), posed(*two, A2.pose), effects, warm);
  if (one != nullptr) return solve(posed(*one, A1.pose), A2, effects, warm);
  if (two == nullptr) refuse_convex();
  const InOrder order(warm);
  solve(posed(*two, A2.pose), A1, effects, warm);
  return search_->turn_answer();
}

Separation MeshDistanceSolver::separation(const Posed& A1, const Posed& A2, MeshWarmStart* warm) {
  const Mesh *one = as_mesh(A1.set), *two = as_mesh(A2.set);
  if (one != nullptr && two != nullptr) return separation(posed(*one, A1.pose), posed(*two, A2.pose), warm);
  if (one != nullptr) return separation(posed(*one, A1.pose), A2, warm);
  if (two == nullptr) refuse_convex();
  const InOrder order(warm);
  return separation(posed(*two, A2.pose), A1, warm);
}

Separation MeshDistanceSolver::separation(const PosedMesh& A1, const PosedMesh& A2, MeshWarmStart* warm) {
  check_pose(A1.pose);
  check_pose(A2.pose);
  return search_->separation(MeshPair(A1, A2), warm);
}

Separation MeshDistanceSolver::separation(const PosedMesh& A1, const Posed& A2, MeshWarmStart* warm) {
  if (const Mesh* other = as_mesh(A2.set)) return separation(A1, posed(*other, A2.pose), warm);
  check_pose(A1.pose);
  check_set(A2);
  return search_->separation(MeshPair(A1, A2), warm);
}

bool MeshDistanceSolver::meets_if_moved(double way) { return search_->meets_if_moved(way); }

const MeshCounters& MeshDistanceSolver::counters() const noexcept { return search_->counters(); }

}  // namespace raygauge
