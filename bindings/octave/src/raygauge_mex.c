/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT

   raygauge_mex(QUERY, ...): what the functions rg_... of Octave and MATLAB call. Sets are made of their
   values, asked and freed in one call, so that no handle can be left behind. */
#include <string.h>

#include "answers.h"
#include "options.h"

/* Two sets and options: what single queries are asked of. */
static rg_pair pair_of(Call* call, int count, const mxArray* const* values, int has, Options* options) {
  if (count < 2) refuse(call, RG_INVALID_PARAMETER, "two sets are needed");
  const rg_set *first = set_of(call, values[0]), *second = set_of(call, values[1]);
  *options = read_options(call, count - 2, values + 2, HAS_SOLVER | HAS_POSE_1 | HAS_POSE_2 | has);
  const rg_pair pair = {first, call->poses[0], second, call->poses[1]};
  return pair;
}

static mxArray* distance(Call* call, int count, const mxArray* const* values) {
  Options options;
  rg_answer answer;
  const rg_pair pair = pair_of(call, count, values, 0, &options);
  const int32_t n = rg_set_dimension(pair.first);
  check(call, rg_distance(call->solver, &pair, RG_WITNESS, NULL, &answer));
  mxArray* result = struct_of(&answer);
  put(result, "normal", vector_or_empty(call, RG_NORMAL, n));
  put(result, "contact_point", vector_or_empty(call, RG_CONTACT_POINT, n));
  return result;
}

static mxArray* object_result(Call* call, const rg_answer* answer, int32_t n) {
  mxArray* result = struct_of(answer);
  put(result, "meet",
      answer->meet < 0 ? mxCreateDoubleMatrix(0, 0, mxREAL) : mxCreateLogicalScalar(answer->meet == 1));
  put(result, "normal", vector_or_empty(call, RG_NORMAL, n));
  put(result, "point_1", vector_or_empty(call, RG_POINT_1, n));
  put(result, "point_2", vector_or_empty(call, RG_POINT_2, n));
  put(result, "gradient_1", vector_or_empty(call, RG_GRADIENT_1, n));
  put(result, "gradient_2", vector_or_empty(call, RG_GRADIENT_2, n));
  return result;
}

static mxArray* object_distance(Call* call, int count, const mxArray* const* values) {
  Options options;
  rg_answer answer;
  const rg_pair pair = pair_of(call, count, values, HAS_METRIC, &options);
  check(call, rg_object_distance(call->solver, &pair, options.metric, RG_CLOSEST_POINTS | RG_GRADIENT, NULL,
                                 &answer));
  return object_result(call, &answer, rg_set_dimension(pair.first));
}

static mxArray* signed_distance(Call* call, int count, const mxArray* const* values) {
  Options options;
  rg_answer answer;
  const rg_pair pair = pair_of(call, count, values, HAS_METRIC, &options);
  check(call, rg_signed_distance(call->solver, &pair, options.metric, RG_CLOSEST_POINTS | RG_GRADIENT, NULL,
                                 &answer));
  return object_result(call, &answer, rg_set_dimension(pair.first));
}

static mxArray* growth_distance(Call* call, int count, const mxArray* const* values) {
  Options options;
  rg_answer answer;
  const rg_pair pair = pair_of(call, count, values, 0, &options);
  check(call, rg_growth_distance(call->solver, &pair, NULL, &answer));
  mxArray* result = struct_of(&answer);
  put(result, "normal", vector_or_empty(call, RG_NORMAL, rg_set_dimension(pair.first)));
  return result;
}

static mxArray* separation(Call* call, int count, const mxArray* const* values) {
  static const char* const kOutcomes[] = {"separated", "intersecting", "undecided"};
  Options options;
  int32_t outcome = RG_UNDECIDED;
  const rg_pair pair = pair_of(call, count, values, 0, &options);
  check(call, rg_separation(call->solver, &pair, NULL, &outcome));
  mxArray* result = mxCreateStructMatrix(1, 1, 0, NULL);
  put(result, "outcome", mxCreateString(kOutcomes[outcome]));
  put(result, "normal", vector_or_empty(call, RG_NORMAL, rg_set_dimension(pair.first)));
  return result;
}

/* Whether asking a set of that kind calls back into Octave, which one thread at a time may do. */
static int calls_back(const mxArray* value) {
  if (mxIsClass(value, "function_handle")) return 1;
  if (!mxIsStruct(value) || mxGetField(value, 0, "arguments") == NULL) return 0;
  const mxArray* cell = mxGetField(value, 0, "arguments");
  for (size_t i = 0; mxIsCell(cell) && i < mxGetNumberOfElements(cell); ++i) {
    if (calls_back(mxGetCell(cell, (mwIndex)i))) return 1;
  }
  return 0;
}

/* A K x 2 cell of sets, and options: arrays of K answers. */
static mxArray* many(Call* call, int count, const mxArray* const* values, int growth) {
  if (count < 1 || !mxIsCell(values[0]) || mxGetN(values[0]) != 2) {
    refuse(call, RG_INVALID_PARAMETER, "pairs: a cell array of two columns is needed, a set an entry");
  }
  const size_t pairs = mxGetM(values[0]);
  rg_pair* list = mxCalloc(pairs + 1, sizeof *list);
  const Options options = read_options(call, count - 1, values + 1, HAS_THREADS | (growth ? 0 : HAS_METRIC));
  for (size_t i = 0; i < 2 * pairs; ++i) {
    const mxArray* value = mxGetCell(values[0], (mwIndex)i);
    if (value == NULL) refuse(call, RG_INVALID_PARAMETER, "pairs: an entry is empty");
    if (options.threads > 1 && calls_back(value)) {
      refuse(call, RG_INVALID_PARAMETER, "threads: a set with a function of Octave's needs threads = 1");
    }
    *(i < pairs ? &list[i].first : &list[i - pairs].second) = set_of(call, value);
  }
  mxArray* numbers[3];
  uint8_t* status = mxCalloc(pairs + 1, 1);
  for (int k = 0; k < 3; ++k) numbers[k] = mxCreateDoubleMatrix(pairs, 1, mxREAL);
  const rg_batch_answers answers = {
      mxGetPr(numbers[0]), mxGetPr(numbers[1]), mxGetPr(numbers[2]), status, NULL, NULL, NULL};
  check(call, rg_batch_create(options.threads, options.tolerance, &call->batch));
  check(call, growth ? rg_batch_growth_distances(call->batch, (int64_t)pairs, list, NULL, &answers)
                     : rg_batch_object_distances(call->batch, (int64_t)pairs, list, options.metric, NULL,
                                                 &answers));
  mxArray *names = mxCreateCellMatrix(pairs, 1), *result = mxCreateStructMatrix(1, 1, 0, NULL);
  for (size_t i = 0; i < pairs; ++i) mxSetCell(names, (mwIndex)i, mxCreateString(rg_status_name(status[i])));
  put(result, "distance", numbers[0]);
  put(result, "lower", numbers[1]);
  put(result, "upper", numbers[2]);
  put(result, "status", names);
  return result;
}

static mxArray* object_distances(Call* call, int count, const mxArray* const* values) {
  return many(call, count, values, 0);
}

static mxArray* growth_distances(Call* call, int count, const mxArray* const* values) {
  return many(call, count, values, 1);
}

/* A set, a point or direction of its space, and perhaps a tolerance. */
static const rg_set* set_and_vector(Call* call, int count, const mxArray* const* values, const double** x,
                                    double* tolerance) {
  if (count < 2 || count > 3) refuse(call, RG_INVALID_PARAMETER, "a set and a vector are needed");
  const rg_set* set = set_of(call, values[0]);
  *x = vector_of(call, values[1], (size_t)rg_set_dimension(set), "x");
  *tolerance = count == 3 ? number_of(call, values[2], "tolerance") : 1e-6;
  return set;
}

static mxArray* gauge(Call* call, int count, const mxArray* const* values) {
  const double* x = NULL;
  double tolerance = 0, bounds[2];
  const rg_set* set = set_and_vector(call, count, values, &x, &tolerance);
  check(call, rg_gauge(set, x, tolerance, &bounds[0], &bounds[1]));
  return column(bounds, 2);
}

static mxArray* contains(Call* call, int count, const mxArray* const* values) {
  const double* x = NULL;
  double tolerance = 0;
  int32_t membership = RG_MEMBERSHIP_UNDECIDED;
  const rg_set* set = set_and_vector(call, count, values, &x, &tolerance);
  check(call, rg_contains(set, x, tolerance, &membership));
  if (membership == RG_MEMBERSHIP_UNDECIDED) return mxCreateDoubleMatrix(0, 0, mxREAL);
  return mxCreateLogicalScalar(membership == RG_INSIDE);
}

static mxArray* support(Call* call, int count, const mxArray* const* values) {
  const double* u = NULL;
  double tolerance = 0, value = 0;
  const rg_set* set = set_and_vector(call, count, values, &u, &tolerance);
  const size_t n = (size_t)rg_set_dimension(set);
  double* point = mxCalloc(n, sizeof *point);
  check(call, rg_set_support(set, u, &value, point));
  mxArray* result = mxCreateStructMatrix(1, 1, 0, NULL);
  put(result, "value", mxCreateDoubleScalar(value));
  put(result, "point", column(point, n));
  check(call, rg_set_center(set, point));
  put(result, "center", column(point, n));
  return result;
}

static mxArray* version(Call* call, int count, const mxArray* const* values) {
  (void)call, (void)count, (void)values;
  return mxCreateString(rg_version());
}

typedef struct Query {
  const char* name;
  mxArray* (*answer)(Call* call, int count, const mxArray* const* values);
} Query;

static const Query kQueries[] = {
    {"distance", distance},
    {"object_distance", object_distance},
    {"signed_distance", signed_distance},
    {"growth_distance", growth_distance},
    {"separation", separation},
    {"object_distances", object_distances},
    {"growth_distances", growth_distances},
    {"gauge", gauge},
    {"contains", contains},
    {"support", support},
    {"object_distance_along", object_distance_along},
    {"prove_motion", prove_motion},
    {"version", version},
};

void mexFunction(int outputs, mxArray* out[], int count, const mxArray* values[]) {
  Call call = {0};
  char name[32] = "";
  (void)outputs;
  if (count < 1 || mxGetString(values[0], name, sizeof name) != 0) {
    refuse(&call, RG_INVALID_PARAMETER, "the name of a query is needed");
  }
  check(&call, rg_solver_create(&call.solver));
  for (size_t i = 0; i < sizeof kQueries / sizeof *kQueries; ++i) {
    if (strcmp(name, kQueries[i].name) != 0) continue;
    out[0] = kQueries[i].answer(&call, count - 1, values + 1);
    end_call(&call);
    return;
  }
  refuse(&call, RG_UNKNOWN_NAME, "there is no query of that name");
}
