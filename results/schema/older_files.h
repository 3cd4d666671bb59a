// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "raygauge/sweep/record.h"

namespace raygauge {

/// Fills in what files of schema version 1 do not say, for records without a method_name:
///
///   method_name              the registered name that `identity` (experiment_identity() of the run) has for
///                            the label; without one, the longest registered name of version 1 that the label
///                            begins with, else the label
///   role                     baseline for names that begin with glpk, clp, nlopt, fcl or command, oracle for
///                            exact, engine for the others
///   exact_distance_rounding  2^-45 for generator example1
///   hardness                 by the first parameter named aspect, delta (1/δ), entry, exponent (2^exponent)
///                            or offset
///
/// and what was called `direct` is column_generation in both names, unless a label of the user's says direct.
///
/// Of any record the numbers among the parameters are written as today, with_current_numbers().
///
/// Here alone does the program go by the spelling of names.
void complete_older_records(std::vector<Record>& records, const std::string& identity);

/// The identity of a run with the names that its methods have today: a run of an older version can be
/// resumed.
std::string current_identity(const std::string& identity);

}  // namespace raygauge
