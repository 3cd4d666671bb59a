/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT

   raygauge_mex(QUERY, ...): what the functions rg_... of Octave and MATLAB call. Sets are made of their
   values, asked and freed in one call, so that no handle can be left behind. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "sets.h"

static mxArray* column(const double* values, size_t n) {
  mxArray* array = mxCreateDoubleMatrix(n, 1, mxREAL);
  if (n > 0) memcpy(mxGetPr(array), values, n * sizeof *values);
  return array;
}

/* The vector of the last query, or [] where there is none. */
static mxArray* vector_or_empty(Call* call, int32_t which, int32_t n) {
  double* values = mxCalloc((size_t)n, sizeof *values);
  check(call, rg_solver_vector(call->solver, which, n, values));
  return isnan(values[0]) ? mxCreateDoubleMatrix(0, 0, mxREAL) : column(values, (size_t)n);
}

/* Options that every query may have, given as names and values. */
typedef struct Options {
  const rg_set* metric;
  double tolerance;
  int32_t threads;
} Options;

static void set_pose(Call* call, int which, const mxArray* value) {
  const double* T = numbers_of(call, value, "pose");
  const size_t m = mxGetM(value), n = m - 1;
  if (m < 2 || mxGetN(value) != m) refuse(call, RG_DIMENSION_MISMATCH, "pose: a square matrix is needed");
  double *R = mxCalloc(n * n + n, sizeof *R), *t = R + n * n;
  for (size_t k = 0; k < n; ++k) {
    memcpy(R + n * k, T + m * k, n * sizeof *R);
    if (T[m * k + n] != 0) refuse(call, RG_INVALID_PARAMETER, "pose: its last row must be 0 ... 0 1");
  }
  memcpy(t, T + m * n, n * sizeof *t);
  if (T[m * n + n] != 1) refuse(call, RG_INVALID_PARAMETER, "pose: its last row must be 0 ... 0 1");
  rg_pose_free(call->poses[which]);
  call->poses[which] = NULL;
  check(call, rg_pose_create((int32_t)n, R, t, &call->poses[which]));
}

static void set_option(Call* call, Options* options, const char* name, const mxArray* value) {
  char text[128] = "";
  if (strcmp(name, "tolerance") == 0) {
    options->tolerance = number_of(call, value, name);
    check(call, rg_solver_set_tolerance(call->solver, options->tolerance));
  } else if (strcmp(name, "time_limit") == 0) {
    check(call, rg_solver_set_time_limit(call->solver, number_of(call, value, name)));
  } else if (strcmp(name, "max_iterations") == 0) {
    check(call, rg_solver_set_max_iterations(call->solver, (int64_t)number_of(call, value, name)));
  } else if (strcmp(name, "method") == 0) {
    if (mxGetString(value, text, sizeof text) != 0)
      refuse(call, RG_INVALID_PARAMETER, "method: a name is needed");
    check(call, rg_solver_set_method(call->solver, text));
  } else if (strcmp(name, "metric") == 0) {
    options->metric = set_of(call, value);
  } else if (strcmp(name, "pose_1") == 0 || strcmp(name, "pose_2") == 0) {
    set_pose(call, name[5] - '1', value);
  } else if (strcmp(name, "threads") == 0) {
    options->threads = (int32_t)number_of(call, value, name);
  } else {
    snprintf(text, sizeof text, "there is no option '%s'", name);
    refuse(call, RG_UNKNOWN_NAME, text);
  }
}

static Options read_options(Call* call, int count, const mxArray* const* values) {
  Options options = {NULL, 1e-6, 1};
  char name[32];
  for (int i = 0; i < count; i += 2) {
    if (mxGetString(values[i], name, sizeof name) != 0 || i + 1 == count) {
      refuse(call, RG_INVALID_PARAMETER, "options are names, each followed by its value");
    }
    set_option(call, &options, name, values[i + 1]);
  }
  return options;
}

static void put(mxArray* result, const char* name, mxArray* value) {
  mxAddField(result, name);
  mxSetField(result, 0, name, value);
}

static mxArray* struct_of(const rg_answer* answer) {
  mxArray* result = mxCreateStructMatrix(1, 1, 0, NULL);
  put(result, "distance", mxCreateDoubleScalar(answer->distance));
  put(result, "lower", mxCreateDoubleScalar(answer->lower));
  put(result, "upper", mxCreateDoubleScalar(answer->upper));
  put(result, "status", mxCreateString(rg_status_name(answer->status)));
  return result;
}

/* Two sets and options: what single queries are asked of. */
static rg_pair pair_of(Call* call, int count, const mxArray* const* values, Options* options) {
  if (count < 2) refuse(call, RG_INVALID_PARAMETER, "two sets are needed");
  const rg_set *first = set_of(call, values[0]), *second = set_of(call, values[1]);
  *options = read_options(call, count - 2, values + 2);
  const rg_pair pair = {first, call->poses[0], second, call->poses[1]};
  return pair;
}

static void no_metric(Call* call, const Options* options) {
  if (options->metric != NULL) refuse(call, RG_INVALID_PARAMETER, "metric: this query has none");
}

static mxArray* distance(Call* call, int count, const mxArray* const* values) {
  Options options;
  rg_answer answer;
  const rg_pair pair = pair_of(call, count, values, &options);
  const int32_t n = rg_set_dimension(pair.first);
  no_metric(call, &options);
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
  const rg_pair pair = pair_of(call, count, values, &options);
  check(call, rg_object_distance(call->solver, &pair, options.metric, RG_CLOSEST_POINTS | RG_GRADIENT, NULL,
                                 &answer));
  return object_result(call, &answer, rg_set_dimension(pair.first));
}

static mxArray* signed_distance(Call* call, int count, const mxArray* const* values) {
  Options options;
  rg_answer answer;
  const rg_pair pair = pair_of(call, count, values, &options);
  check(call, rg_signed_distance(call->solver, &pair, options.metric, RG_CLOSEST_POINTS | RG_GRADIENT, NULL,
                                 &answer));
  return object_result(call, &answer, rg_set_dimension(pair.first));
}

static mxArray* growth_distance(Call* call, int count, const mxArray* const* values) {
  Options options;
  rg_answer answer;
  const rg_pair pair = pair_of(call, count, values, &options);
  no_metric(call, &options);
  check(call, rg_growth_distance(call->solver, &pair, NULL, &answer));
  mxArray* result = struct_of(&answer);
  put(result, "normal", vector_or_empty(call, RG_NORMAL, rg_set_dimension(pair.first)));
  return result;
}

static mxArray* separation(Call* call, int count, const mxArray* const* values) {
  static const char* const kOutcomes[] = {"separated", "intersecting", "undecided"};
  Options options;
  int32_t outcome = RG_UNDECIDED;
  const rg_pair pair = pair_of(call, count, values, &options);
  no_metric(call, &options);
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
  const Options options = read_options(call, count - 1, values + 1);
  if (growth) no_metric(call, &options);
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

/* Field i of a struct array; NULL where it is not there or empty. */
static const mxArray* field_of(const mxArray* value, size_t i, const char* name) {
  const mxArray* field = mxGetField(value, (mwIndex)i, name);
  return field == NULL || mxIsEmpty(field) ? NULL : field;
}

static double field_or(Call* call, const mxArray* value, size_t i, const char* name, double otherwise) {
  const mxArray* field = field_of(value, i, name);
  return field == NULL ? otherwise : number_of(call, field, name);
}

/* The field `pose` of an entry; NULL where it has none. */
static const rg_pose* pose_field(Call* call, const mxArray* value, size_t i) {
  const mxArray* field = field_of(value, i, "pose");
  if (field == NULL) return NULL;
  set_pose(call, 0, field);
  return call->poses[0];
}

/* The entries of a field that holds a struct array; NULL and none where it is not there. */
static const mxArray* list_of(Call* call, const mxArray* robot, const char* name, size_t* count) {
  const mxArray* list = field_of(robot, 0, name);
  *count = list == NULL ? 0 : mxGetNumberOfElements(list);
  if (list != NULL && !mxIsStruct(list))
    refuse(call, RG_INVALID_PARAMETER, "robot: links, bodies and obstacles are struct arrays");
  return list;
}

static void add_link(Call* call, const mxArray* links, size_t i) {
  static const char* const kKinds[] = {"fixed", "revolute", "prismatic"};
  char kind[16] = "";
  const mxArray *name = field_of(links, i, "kind"), *axis = field_of(links, i, "axis");
  rg_link link = {(int32_t)field_or(call, links, i, "parent", 0) - 1,
                  -1,
                  (int32_t)field_or(call, links, i, "joint", 0) - 1,
                  pose_field(call, links, i),
                  {0, 0, 1},
                  field_or(call, links, i, "scale", 1),
                  field_or(call, links, i, "offset", 0)};
  if (name != NULL) mxGetString(name, kind, sizeof kind);
  for (int32_t k = 0; k < 3; ++k) link.kind = strcmp(kind, kKinds[k]) == 0 ? k : link.kind;
  if (link.kind < 0) refuse(call, RG_UNKNOWN_NAME, "link: its kind is 'fixed', 'revolute' or 'prismatic'");
  if (axis != NULL) memcpy(link.axis, vector_of(call, axis, 3, "axis"), sizeof link.axis);
  check(call, rg_robot_add_link(call->robot, &link, NULL));
}

/* A body of a robot or, without links, an obstacle. */
static void add_body(Call* call, const mxArray* bodies, size_t i, int is_obstacle) {
  const mxArray* value = field_of(bodies, i, "set");
  if (value == NULL) refuse(call, RG_INVALID_PARAMETER, "body: its field 'set' is needed");
  const rg_set* part = set_of(call, value);
  const rg_pose* pose = pose_field(call, bodies, i);
  if (is_obstacle) {
    check(call, rg_robot_add_obstacle(call->robot, 1, &part, pose, NULL));
  } else {
    const int32_t link = (int32_t)field_or(call, bodies, i, "link", 0) - 1;
    check(call, rg_robot_add_body(call->robot, link, 1, &part, pose, NULL));
  }
}

static void make_robot(Call* call, const mxArray* robot) {
  size_t count = 0;
  if (!mxIsStruct(robot)) refuse(call, RG_INVALID_PARAMETER, "robot: a struct is needed");
  check(call, rg_robot_create((int32_t)field_or(call, robot, 0, "joints", 0), &call->robot));
  const mxArray* list = list_of(call, robot, "links", &count);
  for (size_t i = 0; i < count; ++i) add_link(call, list, i);
  list = list_of(call, robot, "bodies", &count);
  for (size_t i = 0; i < count; ++i) add_body(call, list, i, 0);
  check(call, rg_robot_ignore_joined(call->robot));
  list = list_of(call, robot, "obstacles", &count);
  for (size_t i = 0; i < count; ++i) add_body(call, list, i, 1);
  const mxArray* ignored = field_of(robot, 0, "ignored");
  if (ignored == NULL) return;
  const double* pairs = numbers_of(call, ignored, "ignored");
  for (size_t i = 0; i + 1 < mxGetNumberOfElements(ignored); i += 2)
    check(call, rg_robot_ignore(call->robot, (int32_t)pairs[i] - 1, (int32_t)pairs[i + 1] - 1));
}

static mxArray* prove_motion(Call* call, int count, const mxArray* const* values) {
  static const char* const kOutcomes[] = {"free", "contact", "undecided"};
  rg_verdict v = {0};
  if (count < 2 || count > 4) refuse(call, RG_INVALID_PARAMETER, "a robot and its configurations are needed");
  make_robot(call, values[0]);
  const rg_checker_options options = {count > 2 ? number_of(call, values[2], "margin") : 0,
                                      count > 3 ? number_of(call, values[3], "contact") : 0, 0, 1};
  check(call, rg_checker_create(call->robot, &options, &call->checker));
  const double* configurations = numbers_of(call, values[1], "configurations");
  if ((double)mxGetM(values[1]) != field_or(call, values[0], 0, "joints", 0))
    refuse(call, RG_DIMENSION_MISMATCH, "configurations: as many rows as joints are needed");
  check(call, rg_checker_forget(call->checker));
  check(call, rg_checker_prove(call->checker, (int64_t)mxGetN(values[1]), configurations, &v));
  mxArray *result = mxCreateStructMatrix(1, 1, 0, NULL), *bodies = mxCreateDoubleMatrix(1, 2, mxREAL);
  mxGetPr(bodies)[0] = v.body_1 + 1;
  mxGetPr(bodies)[1] = v.body_2 + 1;
  put(result, "outcome", mxCreateString(kOutcomes[v.outcome]));
  put(result, "time", mxCreateDoubleScalar(v.time));
  put(result, "bodies", bodies);
  put(result, "lower", mxCreateDoubleScalar(v.lower));
  put(result, "upper", mxCreateDoubleScalar(v.upper));
  put(result, "depth", mxCreateDoubleScalar(v.depth));
  put(result, "point_1", column(v.point_1, 3));
  put(result, "point_2", column(v.point_2, 3));
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
