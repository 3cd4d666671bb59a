/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT

   Two objects, the second of them on its way: one query a frame, each started from the one before. */
#include <string.h>

#include "answers.h"
#include "options.h"

/* Poses of the second object: homogeneous matrices (n + 1) x (n + 1) x K, or in R^3 a quaternion and a
   translation a column, 7 x K. */
typedef struct Frames {
  const double* numbers;
  size_t n, count, stride;
  int quaternions;
  double* R; /* room for R and t */
} Frames;

static Frames frames_of(Call* call, const mxArray* value, size_t n) {
  const mwSize* sizes = mxGetDimensions(value);
  const mwSize dimensions = mxGetNumberOfDimensions(value);
  Frames frames = {NULL, n, 0, (n + 1) * (n + 1), 0, mxCalloc(n * (n + 1), sizeof(double))};
  if (!mxIsDouble(value) || mxIsComplex(value) || mxIsSparse(value) || dimensions > 3)
    refuse(call, RG_INVALID_PARAMETER, "poses: a real full array of doubles is needed");
  frames.numbers = mxGetPr(value);
  if (n == 3 && dimensions == 2 && sizes[0] == 7) {
    frames.quaternions = 1;
    frames.stride = 7;
  } else if ((size_t)sizes[0] != n + 1 || (size_t)sizes[1] != n + 1) {
    refuse(call, RG_DIMENSION_MISMATCH,
           "poses: homogeneous matrices (n + 1) x (n + 1) x K are needed, or in R^3 columns of a quaternion "
           "w, x, y, z and a translation");
  }
  frames.count = mxGetNumberOfElements(value) / frames.stride;
  return frames;
}

static void go_to(Call* call, const Frames* frames, size_t i) {
  const double* numbers = frames->numbers + frames->stride * i;
  if (frames->quaternions) {
    check(call, rg_pose_assign_quaternion(call->poses[1], numbers, numbers + 4));
  } else {
    split_pose(call, frames->n, numbers, frames->R);
    check(call, rg_pose_assign(call->poses[1], frames->R, frames->R + frames->n * frames->n));
  }
}

mxArray* object_distance_along(Call* call, int count, const mxArray* const* values) {
  if (count < 3) refuse(call, RG_INVALID_PARAMETER, "two sets and poses of the second are needed");
  const rg_set *first = set_of(call, values[0]), *second = set_of(call, values[1]);
  const size_t n = (size_t)rg_set_dimension(second);
  const Frames frames = frames_of(call, values[2], n);
  const Options options =
      read_options(call, count - 3, values + 3, HAS_SOLVER | HAS_POSE_1 | HAS_METRIC | HAS_WARM);
  check(call, rg_pose_create((int32_t)n, NULL, NULL, &call->poses[1]));
  check(call, rg_warm_create(1, &call->warm));
  mxArray *bounds[3], *points[2], *status = mxCreateCellMatrix(frames.count, 1);
  for (int k = 0; k < 3; ++k) bounds[k] = mxCreateDoubleMatrix(frames.count, 1, mxREAL);
  for (int k = 0; k < 2; ++k) points[k] = mxCreateDoubleMatrix(n, frames.count, mxREAL);
  for (size_t i = 0; i < frames.count; ++i) {
    rg_answer answer;
    go_to(call, &frames, i);
    if (!options.warm) check(call, rg_warm_clear(call->warm));
    const rg_pair pair = {first, call->poses[0], second, call->poses[1]};
    check(call,
          rg_object_distance(call->solver, &pair, options.metric, RG_CLOSEST_POINTS, call->warm, &answer));
    mxGetPr(bounds[0])[i] = answer.distance;
    mxGetPr(bounds[1])[i] = answer.lower;
    mxGetPr(bounds[2])[i] = answer.upper;
    mxSetCell(status, (mwIndex)i, mxCreateString(rg_status_name(answer.status)));
    for (int k = 0; k < 2; ++k)
      check(call, rg_solver_vector(call->solver, RG_POINT_1 + k, (int32_t)n, mxGetPr(points[k]) + n * i));
  }
  mxArray* result = mxCreateStructMatrix(1, 1, 0, NULL);
  put(result, "distance", bounds[0]);
  put(result, "lower", bounds[1]);
  put(result, "upper", bounds[2]);
  put(result, "status", status);
  put(result, "point_1", points[0]);
  put(result, "point_2", points[1]);
  return result;
}
