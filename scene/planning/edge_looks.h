// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/scene/edge_checker.h"
#include "scene/planning/edge_intervals.h"
#include "scene/planning/edge_parts.h"
#include "scene/planning/mesh_sweep.h"
#include "scene/queries/part_solver.h"

namespace raygauge {

/// What is asked of two parts at one moment, and of meshes over an interval. What is found goes into the
/// result of an edge.
class EdgeLooks {
 public:
  EdgeLooks(const EdgeOptions& options, const std::vector<EdgeBody>& bodies, const EdgeStage& stage,
            EdgeTests& tests, const EdgePairs& pairs, EdgeResult& result);

  /// Whether they are closer than the margin and a little: the answer of the edge.
  bool is_contact(EdgeParts& parts, int moment);

  /// Of the last look: a lower bound of the distance, and its normal, if it has one.
  const PairAnswer& answer() const noexcept { return answer_; }

  /// Whether they are proven apart by the margin all the time, one of them being a mesh.
  bool surfaces_apart(const EdgeParts& parts, int first, int middle, int last);

  /// Whether no part is inside the other one, at one moment.
  bool is_outside(EdgeParts& parts, int moment);

  /// Undecided, unless something else was before.
  void give_up(const EdgeParts& parts, int moment);

  void forget() { solver_.forget(); }

 private:
  void place(const EdgeParts& parts, int moment);
  void look(EdgeParts& parts, int moment);
  void take_witness(const EdgeParts& parts);

  const EdgeOptions& options_;
  const std::vector<EdgeBody>& bodies_;
  const EdgeStage& stage_;
  EdgeTests& tests_;
  const EdgePairs& pairs_;
  EdgeResult& result_;
  PlacedPair placed_;
  PartSolver solver_;
  MeshSweep sweep_;
  PairAnswer answer_;
  SceneCounters counters_;
  ObjectDistanceSolver witness_;
};

}  // namespace raygauge
