// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/method.h"

namespace raygauge {

/// Adds `command`, which unlike other baselines cannot run without a parameter: a program of the user's as a
/// competitor. It is started once for each thread, reads points and requests from its standard input and
/// writes answers to its standard output, line by line (docs/baselines.md):
///
///     points N_A N_Q n        then N_A + N_Q lines of n coordinates   →   ready
///     solve TOLERANCE LIMIT                                           →   DISTANCE [u u_1 … u_n] [a I …] [q
///     J …]
///
/// Bounds are certified from what follows the distance: the lower one from u, the upper one from the points
/// of A and Q (numbered from 0) that meet. A program that does not answer in time is ended and started anew.
void register_command_method(MethodRegistry& registry);

}  // namespace raygauge
