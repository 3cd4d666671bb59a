// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "raygauge/scene/edge_checker.h"
#include "scene/planning/edge_looks.h"

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
  /// Two parts that are not proven apart over an interval.
  struct Item {
    int parts = 0, interval = 0;
    double key = 0;         ///< an estimate of their distance in its middle; the least first
    bool is_first = false;  ///< not halved yet: a kept plane or a sweep may prove them apart
  };

  struct NodePair {
    int a = 0, b = 0;
  };

  void check(std::span<const double> q) const;
  void check_times(double from, double to) const;
  void begin();
  const EdgeResult& search();
  bool look_at_hint();
  static bool later(const Item& x, const Item& y);
  void add_item(const Item& item);
  void take_first_items();
  void take_parts_of(int pair, int interval);
  void take_item(int parts, int interval);
  bool handle(const Item& item);
  bool is_free_at_once(EdgeParts& parts, int interval);
  bool is_free_by_sweep(EdgeParts& parts, int interval);
  bool is_free_by_kept_plane(const EdgeParts& parts, const EdgeInterval& over);
  bool balls_apart(const EdgeParts& parts, int first, int last);
  void go_on(const Item& item, const Eigen::Vector3d& plane);
  void go_on_with_mesh(const Item& item, bool known);

  EdgeOptions options_;
  RobotChain chain_;
  std::vector<EdgeBody> bodies_;
  EdgePairs pairs_;
  EdgeStage stage_;
  EdgeIntervals intervals_;
  EdgeTests tests_;
  EdgeResult result_;
  EdgeLooks looks_;
  std::vector<Item> items_;      ///< a heap
  std::vector<NodePair> nodes_;  ///< of trees, that are to be looked at
  int hint_ = -1;                ///< the parts in contact of the last edge that had some
};

}  // namespace raygauge
