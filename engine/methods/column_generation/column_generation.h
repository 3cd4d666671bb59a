// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/lp/scaling.h"
#include "engine/methods/column_generation/sifting.h"
#include "engine/methods/column_generation/support_column_generation.h"
#include "engine/methods/column_generation/support_oracle.h"
#include "engine/methods/method.h"

namespace raygauge {

/// The method `column_generation`: by Sifting for two point sets, by SupportColumnGeneration for all others.
class ColumnGeneration : public Method {
 public:
  /// Always leaves bounds in `result`: true. They may be apart by more than the tolerance, as the status
  /// says.
  bool solve(const Problem& problem, DistanceResult& result) override;
  DistanceCounters counters() const override { return counters_; }

  /// Writes the contact point of the last solve, if the problem asks for it and `solve` has not written it;
  /// true if it did. To be called once it is certain whose answer counts: room that is taken and given back
  /// would be allocated at every solve.
  bool report_contact(const Problem& problem, DistanceResult& result) const;

  /// The points of A whose combination proves the upper bound; none where both are point sets.
  void contact_combination(WeightedPoints& combination) const override;

 private:
  void bind_oracles(const Problem& problem);
  void solve_by_support(const Problem& problem, DistanceResult& result);

  Sifting sifting_;
  SupportColumnGeneration by_support_;
  SupportOracle oracle_A_;
  SupportOracle oracle_Q_;
  Scaling scaling_;  // of the oracles
  bool are_point_sets_ = false;
  DistanceCounters counters_;
};

}  // namespace raygauge
