// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "raygauge/sweep/record.h"

namespace raygauge {

/// Relative slack when certified bounds meet each other or an exact distance. Bounds are rounded outwards;
/// the slack covers the rounding of a generator's exact distance and of bounds certified from a competitor's
/// basis.
inline constexpr double kAgreementRounding = 1e-12;

/// The distance that a record says it has found: its `distance` (optimal), 0 (contains_origin) or +∞
/// (unreachable); empty for one that stopped at a limit.
std::optional<double> claim_of(const Record& record);

/// Whether the solve came to an answer: optimal, contains_origin or unreachable. Limits are not answers.
bool is_solved(const Record& record);

/// The record's time in seconds, or +infinity if it is not solved: an order statistic of such values says
/// what a user would have waited at least.
double time_or_infinity(const Record& record);

/// Whether the bounds that two records of one instance have proven have a point in common, up to
/// kAgreementRounding. Unset bounds are 0 and +∞.
bool proofs_meet(const Record& a, const Record& b);

/// Sets `agrees` of `records`: the records of all methods on one instance at one tolerance ε.
///
/// Let I_i = [lower_i, upper_i] be what method i proved (an unset lower is 0, an unset upper +∞), and I* the
/// narrowest of them. A record with a final status claims a distance: its `distance` (optimal), 0
/// (contains_origin) or +∞ (unreachable). Record i agrees when
///   1. I_i meets every I_j:            max(lower_i, lower_j) <= min(upper_i, upper_j),
///   2. I_i meets exact_distance with its rounding, where that is known,
///   3. the distance it claims, if it claims one, lies within the relative tolerance ε of I*; and also of
///   every
///      other claim, unless I* settles the matter by being narrower than ε.
/// 1 and 2 hold up to kAgreementRounding. A record that stopped at a limit claims nothing but its bounds; its
/// status counts it as unsolved. A false claim is thus held against the method that makes it, if another
/// method has a proof; where two proofs or two unproven claims contradict each other, nobody knows which is
/// wrong, and both records disagree.
void mark_agreement(std::span<Record> records);

}  // namespace raygauge
