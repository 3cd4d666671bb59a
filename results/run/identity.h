// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "raygauge/sweep/experiment.h"

namespace raygauge {

/// What makes two sweeps the same experiment: one line "key = value" for each key that determines the records
/// or what their times mean (seed, repetitions, grid, axes, generators, methods, timing mode, warm-up,
/// limits). Left out is what may change between the sessions of a run: name, description, comments and layout
/// of the text, number and pinning of threads, order of cells.
std::string experiment_identity(const Experiment& experiment);

/// The first key in which two identities differ and how ("seed = 1 there, 2 here"), with the number of
/// further ones; "" if they are equal.
std::string identity_difference(const std::string& there, const std::string& here);

/// The repetitions that a cell of such an experiment has when it is whole; 1 where that depends on the cell,
/// so that what is stored of a cell is all of it.
int repetitions_of_whole_cells(const std::string& identity);

}  // namespace raygauge
