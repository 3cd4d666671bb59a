// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace raygauge {

/// Two-sided p value of Wilcoxon's signed-rank test (1945) that `differences` are symmetric about 0, as those
/// of two measurements of the same thing are. Zeros are left out, equal sizes share their mean rank, infinite
/// ones have the largest ranks. Exact (the distribution of the rank sum over all 2^n choices of signs) up to
/// 50 differences; beyond, the normal approximation with the correction for continuity. Without a difference
/// other than 0 it is 1. Throws NonFiniteError for a NaN.
double signed_rank_p(const std::vector<double>& differences);

/// Two-sided p value of the Wilcoxon–Mann–Whitney test that two independent samples have one distribution:
/// normal approximation with corrections for ties and continuity. 1 where all values are equal. Throws
/// EmptySetError for an empty sample, NonFiniteError for a NaN.
double rank_sum_p(const std::vector<double>& first, const std::vector<double>& second);

/// Holm's (1979) step-down adjustment: p values sorted upwards, p_(i) becomes
/// max over j <= i of min(1, (m - j + 1) p_(j)). Calling those below α significant, the probability of even
/// one false call among the m is at most α, however the tests depend on each other. In the order given.
std::vector<double> holm_adjusted(const std::vector<double>& p_values);

}  // namespace raygauge
