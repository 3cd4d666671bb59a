// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>

#include "raygauge/methods/result.h"
#include "raygauge/scene/scene.h"
#include "raygauge/scene/scene_run.h"

namespace raygauge {

/// What is known of the distance of two bodies. Bounds are certified.
struct PairAnswer {
  double lower = 0;
  double upper = std::numeric_limits<double>::infinity();
  double value = 0;  ///< within [lower, upper]
  DistanceStatus status = DistanceStatus::optimal;
  int part_a = -1, part_b = -1;  ///< the nearest parts; -1: not looked for
  SmallVector normal;            ///< empty: none
  SmallVector point_a, point_b;  ///< closest points, or those in contact; empty: none, or not asked for
  SmallVector gradient;          ///< of the distance, or of minus the depth, when body a is translated
  double depth_lower = SceneRecord::kNone;  ///< of the depth; NaN: not asked for
  double depth_upper = SceneRecord::kNone;  ///< that `gradient` proves
  double rate = 0;  ///< the lower bound falls by at most rate × (distance that points of both bodies move)

  /// Common points are proven.
  bool intersecting() const noexcept { return status == DistanceStatus::contains_origin; }

  /// The distance; minus the depth of bodies that meet, where it is known.
  double signed_value() const noexcept { return depth_upper > 0 && intersecting() ? -depth_upper : value; }
};

/// The first contact of two bodies over an interval of time, proven between the instants too.
struct ImpactResult {
  enum class Outcome : std::uint8_t {
    free,       ///< no contact in the interval, proven
    contact,    ///< no contact before `lower`; at `upper` a distance of at most the contact distance
    undecided,  ///< no contact before `lower`; then steps or precision ran out
  };
  Outcome outcome = Outcome::undecided;
  double lower = 0;
  double upper = 0;
  PairAnswer at_upper;  ///< of contact: the distance at `upper`; closest points where there are some
  std::int64_t steps = 0;
};

/// The least distance of two bodies over an interval of time: at every moment it is at least `lower`, proven;
/// at `time` it is at most `upper`. Of bodies that touch, `time` is that of the first contact found: there is
/// none before `no_contact_before`, proven.
struct ClearanceResult {
  double lower = 0;
  double upper = 0;
  double time = 0;
  double no_contact_before = 0;
  bool touches = false;  ///< at `time` the bodies share a point, proven
  PairAnswer at_time;
  std::int64_t steps = 0;
};

/// How a query over an interval of time is answered.
struct ContinuousOptions {
  double from = 0;
  double to = 0;
  double contact = 1e-6;    ///< a distance of at most this is a contact, of the exact motion
  double tolerance = 1e-3;  ///< clearance: upper - lower <= tolerance * upper
  std::int64_t max_steps = 1'000'000;
  std::function<bool()> stop;  ///< asked at every step; true: answer with what is proven by now
};

/// Answers questions about two bodies over an interval of time. Use one for each thread: it owns the
/// workspace.
class ContinuousSolver {
 public:
  explicit ContinuousSolver(int dimension);
  ~ContinuousSolver();
  ContinuousSolver(const ContinuousSolver&) = delete;
  ContinuousSolver& operator=(const ContinuousSolver&) = delete;

  /// Conservative advancement. From a certified distance L with normal u there is no contact for the time
  /// L / v, where v bounds the closing speed along u over the time ahead, rounded up. There is no contact for
  /// a time T either, if planes across u that touch the bodies are apart at both ends of it by more than T²/8
  /// Σ reach |ω||ω × u|. Steps like those of Newton's method use this. Contact means Euclidean
  /// distance, whatever the metric.
  ImpactResult time_of_impact(const Body& a, const Body& b, const ContinuousOptions& options);

  /// Branch and bound on intervals of time. Between two moments the distance is at least the distance at
  /// either of them, less the speed times the time from there. For the Euclidean distance, planes like those
  /// of time_of_impact() are used as well. Two links of one robot are seen from the link that carries both.
  /// `metric_body` is the body that the metric follows, or nullptr.
  ClearanceResult clearance(const Body& a, const Body& b, const SceneMetric& metric, const Body* metric_body,
                            const ContinuousOptions& options);

  const SceneCounters& counters() const noexcept;

 private:
  std::unique_ptr<class PairSolver> solver_;
};

}  // namespace raygauge
