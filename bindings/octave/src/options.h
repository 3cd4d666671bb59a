/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT */
#ifndef RAYGAUGE_OCTAVE_OPTIONS_H
#define RAYGAUGE_OCTAVE_OPTIONS_H

#include "sets.h"

/* Options of queries, given as names and values. Those of the solver and the poses are kept in the call. */
typedef struct Options {
  const rg_set* metric;
  double tolerance;
  int32_t threads;
  int warm;
} Options;

/* Which of them a query has; others are refused. */
enum {
  HAS_SOLVER = 1, /* tolerance, time_limit, max_iterations, method, stop */
  HAS_POSE_1 = 2,
  HAS_POSE_2 = 4,
  HAS_METRIC = 8,
  HAS_WARM = 16,
  HAS_THREADS = 32, /* and tolerance */
};

/* Reads `count` names and values. */
Options read_options(Call* call, int count, const mxArray* const* values, int has);

/* R and t of a homogeneous matrix of n + 1 rows: n * n + n numbers, from T to R_and_t. */
void split_pose(Call* call, size_t n, const double* T, double* R_and_t);

/* Pose `which` (0 or 1) of the call, from a homogeneous matrix. */
void set_pose(Call* call, int which, const mxArray* value);

#endif
