/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT */
#include "options.h"

#include <stdio.h>
#include <string.h>

void split_pose(Call* call, size_t n, const double* T, double* R_and_t) {
  for (size_t k = 0; k <= n; ++k) {
    memcpy(R_and_t + n * k, T + (n + 1) * k, n * sizeof *T);
    if (T[(n + 1) * k + n] != (k == n))
      refuse(call, RG_INVALID_PARAMETER, "pose: its last row must be 0 ... 0 1");
  }
}

void set_pose(Call* call, int which, const mxArray* value) {
  const double* T = numbers_of(call, value, "pose");
  const size_t m = mxGetM(value), n = m - 1;
  if (m < 2 || mxGetN(value) != m) refuse(call, RG_DIMENSION_MISMATCH, "pose: a square matrix is needed");
  double* R = mxCalloc(n * m, sizeof *R);
  split_pose(call, n, T, R);
  rg_pose_free(call->poses[which]);
  call->poses[which] = NULL;
  check(call, rg_pose_create((int32_t)n, R, R + n * n, &call->poses[which]));
}

/* The function of the option 'stop', asked by feval. An error of it ends the call. */
static int32_t ask_to_stop(void* data) {
  Call* call = data;
  mxArray *answer = NULL, *handle = (mxArray*)call->stop;
  mxArray* error = mexCallMATLABWithTrap(1, &answer, 1, &handle, "feval");
  const int fits = error == NULL && answer != NULL && mxGetNumberOfElements(answer) == 1 &&
                   (mxIsLogical(answer) || mxIsNumeric(answer));
  const int stops = fits && mxGetScalar(answer) != 0;
  if (answer != NULL) mxDestroyArray(answer);
  call->stop_failed = call->stop_failed || !fits;
  return stops || !fits;
}

typedef void (*Reader)(Call* call, Options* options, const mxArray* value);

static void tolerance(Call* call, Options* options, const mxArray* value) {
  options->tolerance = number_of(call, value, "tolerance");
  check(call, rg_solver_set_tolerance(call->solver, options->tolerance));
}

static void time_limit(Call* call, Options* options, const mxArray* value) {
  (void)options;
  check(call, rg_solver_set_time_limit(call->solver, number_of(call, value, "time_limit")));
}

static void max_iterations(Call* call, Options* options, const mxArray* value) {
  (void)options;
  check(call, rg_solver_set_max_iterations(call->solver, whole(call, value, "max_iterations")));
}

static void method(Call* call, Options* options, const mxArray* value) {
  char text[64];
  (void)options;
  if (mxGetString(value, text, sizeof text) != 0)
    refuse(call, RG_INVALID_PARAMETER, "method: a name is needed");
  check(call, rg_solver_set_method(call->solver, text));
}

static void stop(Call* call, Options* options, const mxArray* value) {
  (void)options;
  if (!mxIsClass(value, "function_handle"))
    refuse(call, RG_INVALID_PARAMETER, "stop: a function handle is needed");
  call->stop = value;
  check(call, rg_solver_set_stop(call->solver, ask_to_stop, call));
}

static void pose_1(Call* call, Options* options, const mxArray* value) {
  (void)options;
  set_pose(call, 0, value);
}

static void pose_2(Call* call, Options* options, const mxArray* value) {
  (void)options;
  set_pose(call, 1, value);
}

static void metric(Call* call, Options* options, const mxArray* value) {
  options->metric = set_of(call, value);
}

static void warm(Call* call, Options* options, const mxArray* value) {
  if (!mxIsLogicalScalar(value)) refuse(call, RG_INVALID_PARAMETER, "warm: true or false is needed");
  options->warm = mxIsLogicalScalarTrue(value);
}

static void threads(Call* call, Options* options, const mxArray* value) {
  options->threads = whole(call, value, "threads");
}

static const struct {
  const char* name;
  int part; /* of which HAS_... any */
  Reader read;
} kOptions[] = {
    {"tolerance", HAS_SOLVER | HAS_THREADS, tolerance},
    {"time_limit", HAS_SOLVER, time_limit},
    {"max_iterations", HAS_SOLVER, max_iterations},
    {"method", HAS_SOLVER, method},
    {"stop", HAS_SOLVER, stop},
    {"pose_1", HAS_POSE_1, pose_1},
    {"pose_2", HAS_POSE_2, pose_2},
    {"metric", HAS_METRIC, metric},
    {"warm", HAS_WARM, warm},
    {"threads", HAS_THREADS, threads},
};

static void read_option(Call* call, Options* options, const char* name, const mxArray* value, int has) {
  char text[128];
  for (size_t i = 0; i < sizeof kOptions / sizeof *kOptions; ++i) {
    if (strcmp(name, kOptions[i].name) != 0) continue;
    if ((kOptions[i].part & has) == 0) {
      snprintf(text, sizeof text, "%s: this query has no such option", name);
      refuse(call, RG_INVALID_PARAMETER, text);
    }
    kOptions[i].read(call, options, value);
    return;
  }
  snprintf(text, sizeof text, "there is no option '%s'", name);
  refuse(call, RG_UNKNOWN_NAME, text);
}

Options read_options(Call* call, int count, const mxArray* const* values, int has) {
  Options options = {NULL, 1e-6, 1, 1};
  char name[32];
  for (int i = 0; i < count; i += 2) {
    if (mxGetString(values[i], name, sizeof name) != 0 || i + 1 == count) {
      refuse(call, RG_INVALID_PARAMETER, "options are names, each followed by its value");
    }
    read_option(call, &options, name, values[i + 1], has);
  }
  return options;
}
