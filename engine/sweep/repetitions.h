// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "raygauge/sweep/experiment.h"
#include "raygauge/sweep/record.h"

namespace raygauge {

/// Repetitions after which a cell that has `done` of them is looked at next: Experiment::repetitions, or with
/// Experiment::stop_when_within > 0 at first min_repetitions and then a quarter more each time, rounded up.
/// Few looks, because every one is another chance to stop too early.
int next_look(const Experiment& experiment, int done);

/// Whether the median time of every method is known to within the fraction `within`. `records` are whole
/// repetitions of one cell in the order (repetition, method), `methods` records each, agreement marked. For
/// the times of each method, records that disagree left out and unsolved ones counting as +∞,
///
///     x_(m-d+1) - x_(d)  <=  within * median(x),
///
/// [x_(d), x_(m-d+1)] being the 95 % order_statistic_interval(). Where both ends are +∞ the median is known:
/// the method does not solve these instances. Too few times for an interval: not known.
bool medians_known(std::span<const Record> records, std::size_t methods, double within);

}  // namespace raygauge
