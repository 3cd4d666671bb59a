// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "raygauge/scene/edge_checker.h"
#include "scene/planning/edge_pair.h"
#include "scene/planning/mesh_sweep.h"
#include "scene/queries/part_solver.h"

namespace raygauge {

/// The work of an EdgeChecker, which documents it.
class EdgeSearch {
 public:
  EdgeSearch(const RobotModel& robot, const std::vector<Body>& obstacles, const EdgeOptions& options);
  EdgeSearch(const EdgeSearch&) = delete;
  EdgeSearch& operator=(const EdgeSearch&) = delete;

  const EdgeResult& edge(std::span<const double> q0, std::span<const double> q1, double from, double to);
  const EdgeResult& configuration(std::span<const double> q, double time);
  const EdgeResult& path(const JointTrajectory& trajectory);
  void forget();

  int joints() const noexcept { return chain_.joints(); }
  const std::vector<EdgeBody>& bodies() const noexcept { return bodies_; }
  const EdgeOptions& options() const noexcept { return options_; }

 private:
  /// Two parts, and what is kept of them from one edge to the next.
  struct Parts {
    int pair = 0;
    std::size_t shape_a = 0, shape_b = 0;
    bool is_mesh = false;  ///< one of them
    bool is_solid = false;
    PartMemory memory;
    Eigen::Vector3d plane = Eigen::Vector3d::Zero();  ///< of the carrier; 0: none
  };

  /// From one moment to a later one; of a configuration both are the same.
  struct Interval {
    int first = 0, last = 0;
    int middle = -1, left = -1, right = -1;  ///< -1: not made yet
  };

  /// Two parts that are not proven apart over an interval.
  struct Item {
    int parts = 0, interval = 0;
    double key = 0;         ///< an estimate of their distance in its middle; the least first
    bool is_first = false;  ///< not halved yet: a kept plane or a sweep may prove them apart
  };

  struct NodePair {
    int a = 0, b = 0;
  };

  void take_pairs(const RobotModel& robot);
  void take_parts();
  void check(std::span<const double> q) const;
  void check_times(double from, double to) const;
  void begin();
  void cut_at_breaks(double from, double to);
  int add_interval(int first, int last);
  const EdgeResult& search();
  int middle_of(std::size_t interval);
  int half_of(std::size_t interval, bool is_left);
  bool look_at_hint();
  static bool later(const Item& x, const Item& y);
  void add_item(const Item& item);
  void take_first_items();
  void take_parts_of(std::size_t pair, int interval);
  void take_item(int parts, int interval);
  bool is_free_at_once(Parts& parts, int interval);
  bool is_free_by_kept_plane(const Parts& parts, const Interval& over);
  bool handle(const Item& item);
  void take_kind(Parts& parts) const;
  bool is_free_by_sweep(Parts& parts, int interval);
  bool surfaces_apart(const Parts& parts, int interval);
  void go_on_with_mesh(const Item& item, bool known);
  static PartNumbers numbers_of(const Parts& parts);
  void place(const Parts& parts, int moment);
  void look(Parts& parts, int moment);
  bool is_contact(Parts& parts, int moment);
  void take_witness(const Parts& parts);
  void take_mesh_witness(const Parts& parts);
  void give_up(const Parts& parts, int moment);
  void go_on(const Item& item, const Eigen::Vector3d& plane);

  EdgeOptions options_;
  RobotChain chain_;
  std::vector<EdgeBody> bodies_;
  EdgeStage stage_;
  EdgeTests tests_;
  std::vector<EdgePair> pairs_;
  std::vector<int> first_parts_;  ///< of each pair, in parts_; and the end
  std::vector<Parts> parts_;
  PlacedPair placed_;
  PartSolver solver_;
  MeshSweep sweep_;
  PairAnswer answer_;
  SceneCounters counters_;
  std::vector<Interval> intervals_;
  std::vector<Item> items_;      ///< a heap
  std::vector<NodePair> nodes_;  ///< of trees, that are to be looked at
  ObjectDistanceSolver witness_;
  EdgeResult result_;
  int hint_ = -1;  ///< the parts in contact of the last edge that had some
};

}  // namespace raygauge
