/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT */
#include "sets.h"

#include <stdio.h>
#include <string.h>

void end_call(Call* call) {
  rg_batch_free(call->batch);
  rg_checker_free(call->checker);
  rg_robot_free(call->robot);
  rg_solver_free(call->solver);
  rg_warm_free(call->warm);
  rg_pose_free(call->poses[0]);
  rg_pose_free(call->poses[1]);
  for (size_t i = call->count; i > 0; --i) rg_set_free(call->sets[i - 1]);
  call->count = 0;
}

void refuse(Call* call, rg_error error, const char* message) {
  char text[1200], identifier[64];
  snprintf(text, sizeof text, "%s", message);
  snprintf(identifier, sizeof identifier, "raygauge:%s", rg_error_name(error));
  end_call(call);
  mexErrMsgIdAndTxt(identifier, "%s", text);
}

void check(Call* call, rg_error error) {
  if (call->stop_failed)
    refuse(call, RG_CALLBACK_FAILED, "stop: the function must return true or false, without an error");
  if (error != RG_OK) refuse(call, error, rg_last_message());
}

static void refuse_value(Call* call, const char* name, const char* needed) {
  char text[256];
  snprintf(text, sizeof text, "%s: %s is needed", name, needed);
  refuse(call, RG_INVALID_PARAMETER, text);
}

const double* numbers_of(Call* call, const mxArray* array, const char* name) {
  if (!mxIsDouble(array) || mxIsComplex(array) || mxIsSparse(array) || mxGetNumberOfDimensions(array) != 2) {
    refuse_value(call, name, "a real full matrix of doubles");
  }
  return mxGetPr(array);
}

double number_of(Call* call, const mxArray* array, const char* name) {
  const double* numbers = numbers_of(call, array, name);
  if (mxGetNumberOfElements(array) != 1) refuse_value(call, name, "one number");
  return numbers[0];
}

const double* vector_of(Call* call, const mxArray* array, size_t n, const char* name) {
  const double* numbers = numbers_of(call, array, name);
  if (mxGetNumberOfElements(array) == n) return numbers;
  char text[256];
  snprintf(text, sizeof text, "%s: %lu numbers are needed, got %lu", name, (unsigned long)n,
           (unsigned long)mxGetNumberOfElements(array));
  refuse(call, RG_DIMENSION_MISMATCH, text);
  return NULL;
}

int32_t whole(Call* call, const mxArray* array, const char* name) {
  return whole_number(call, number_of(call, array, name), name);
}

int32_t whole_number(Call* call, double value, const char* name) {
  if (!(value >= 0 && value <= 1e9) || value != (double)(int32_t)value)
    refuse_value(call, name, "a whole number");
  return (int32_t)value;
}

static int32_t length_of(const mxArray* array) { return (int32_t)mxGetNumberOfElements(array); }

/* Keeps a set until the end of the call. Room is made first, so that nothing is lost if there is none. */
static rg_set** room_for_set(Call* call) {
  if (call->count == call->capacity) {
    call->capacity = 2 * call->capacity + 16;
    call->sets = mxRealloc(call->sets, call->capacity * sizeof *call->sets);
  }
  call->sets[call->count] = NULL;
  return &call->sets[call->count];
}

static const rg_set* kept(Call* call, rg_error error) {
  check(call, error);
  return call->sets[call->count++];
}

/* The function handle of a set of the user's own, asked by feval. */
static int32_t ask_handle(void* data, int32_t n, const double* u, double* point) {
  mxArray *direction = mxCreateDoubleMatrix(n, 1, mxREAL), *answer = NULL;
  memcpy(mxGetPr(direction), u, (size_t)n * sizeof *u);
  mxArray* arguments[2] = {data, direction};
  mxArray* error = mexCallMATLABWithTrap(1, &answer, 2, arguments, "feval");
  mxDestroyArray(direction);
  if (error != NULL) return 1;
  const int fits = answer != NULL && mxIsDouble(answer) && !mxIsComplex(answer) && !mxIsSparse(answer) &&
                   mxGetNumberOfElements(answer) == (size_t)n;
  if (fits) memcpy(point, mxGetPr(answer), (size_t)n * sizeof *point);
  if (answer != NULL) mxDestroyArray(answer);
  return fits ? 0 : 2;
}

/* One kind of set: how many arguments it takes, and how it is made of them. */
typedef struct Kind {
  const char* name;
  int arguments; /* -1: any number */
  const rg_set* (*make)(Call* call, const mxArray* const* arguments, int count);
} Kind;

typedef const mxArray* const* Arguments;

static const rg_set* points(Call* call, Arguments a, int count) {
  (void)count;
  const double* numbers = numbers_of(call, a[0], "points");
  return kept(call, rg_set_points((int32_t)mxGetM(a[0]), (int64_t)mxGetN(a[0]), numbers, room_for_set(call)));
}

static const rg_set* prepared_points(Call* call, Arguments a, int count) {
  (void)count;
  const double* numbers = numbers_of(call, a[0], "points");
  return kept(call, rg_set_prepared_points((int32_t)mxGetM(a[0]), (int64_t)mxGetN(a[0]), numbers,
                                           room_for_set(call)));
}

static const rg_set* ball(Call* call, Arguments a, int count) {
  (void)count;
  const double* center = numbers_of(call, a[0], "center");
  return kept(call,
              rg_set_ball(length_of(a[0]), center, number_of(call, a[1], "radius"), room_for_set(call)));
}

static const rg_set* box(Call* call, Arguments a, int count) {
  (void)count;
  const double* lower = numbers_of(call, a[0], "lower");
  const double* upper = vector_of(call, a[1], mxGetNumberOfElements(a[0]), "upper");
  return kept(call, rg_set_box(length_of(a[0]), lower, upper, room_for_set(call)));
}

/* A matrix of vectors of n numbers, one a column. */
static const double* columns_of(Call* call, const mxArray* array, const mxArray* center, const char* name) {
  const double* numbers = numbers_of(call, array, name);
  if (mxGetM(array) != mxGetNumberOfElements(center)) {
    refuse(call, RG_DIMENSION_MISMATCH, "a matrix needs as many rows as the center has numbers");
  }
  return numbers;
}

static const rg_set* ellipsoid(Call* call, Arguments a, int count) {
  (void)count;
  const double *center = numbers_of(call, a[0], "center"), *factor = columns_of(call, a[1], a[0], "factor");
  return kept(call,
              rg_set_ellipsoid(length_of(a[0]), center, (int32_t)mxGetN(a[1]), factor, room_for_set(call)));
}

static const rg_set* p_norm_ball(Call* call, Arguments a, int count) {
  (void)count;
  const double* center = numbers_of(call, a[0], "center");
  const double* axes = vector_of(call, a[1], mxGetNumberOfElements(a[0]), "semi_axes");
  return kept(call, rg_set_p_norm_ball(length_of(a[0]), center, axes, number_of(call, a[2], "p"),
                                       room_for_set(call)));
}

static const rg_set* capsule(Call* call, Arguments a, int count) {
  (void)count;
  const double *p = numbers_of(call, a[0], "p"), *q = vector_of(call, a[1], mxGetNumberOfElements(a[0]), "q");
  return kept(call,
              rg_set_capsule(length_of(a[0]), p, q, number_of(call, a[2], "radius"), room_for_set(call)));
}

static const rg_set* cylinder(Call* call, Arguments a, int count) {
  (void)count;
  const double *p = numbers_of(call, a[0], "p"), *q = vector_of(call, a[1], mxGetNumberOfElements(a[0]), "q");
  return kept(call,
              rg_set_cylinder(length_of(a[0]), p, q, number_of(call, a[2], "radius"), room_for_set(call)));
}

static const rg_set* cone(Call* call, Arguments a, int count) {
  (void)count;
  const double* base = numbers_of(call, a[0], "base");
  const double* top = vector_of(call, a[2], mxGetNumberOfElements(a[0]), "top");
  return kept(call, rg_set_cone(length_of(a[0]), base, number_of(call, a[1], "base_radius"), top,
                                number_of(call, a[3], "top_radius"), room_for_set(call)));
}

static const rg_set* simplex(Call* call, Arguments a, int count) {
  (void)count;
  const double* corner = numbers_of(call, a[0], "corner");
  const double* legs = vector_of(call, a[1], mxGetNumberOfElements(a[0]), "legs");
  return kept(call, rg_set_simplex(length_of(a[0]), corner, legs, room_for_set(call)));
}

static const rg_set* zonotope(Call* call, Arguments a, int count) {
  (void)count;
  const double *center = numbers_of(call, a[0], "center"),
               *columns = columns_of(call, a[1], a[0], "generators");
  return kept(call,
              rg_set_zonotope(length_of(a[0]), center, (int32_t)mxGetN(a[1]), columns, room_for_set(call)));
}

/* {x : G x <= g}: C takes the rows of G one after the other. */
static const rg_set* h_polytope(Call* call, Arguments a, int count) {
  (void)count;
  const double* G = numbers_of(call, a[0], "G");
  const size_t m = mxGetM(a[0]), n = mxGetN(a[0]);
  const double* g = vector_of(call, a[1], m, "g");
  double* rows = mxCalloc(m * n + 1, sizeof *rows);
  for (size_t i = 0; i < m; ++i) {
    for (size_t k = 0; k < n; ++k) rows[n * i + k] = G[m * k + i];
  }
  return kept(call, rg_set_h_polytope((int32_t)n, (int64_t)m, rows, g, room_for_set(call)));
}

static const rg_set* contact_wrenches(Call* call, Arguments a, int count) {
  (void)count;
  const double *point = vector_of(call, a[0], 3, "point"), *normal = vector_of(call, a[1], 3, "normal");
  return kept(call, rg_set_contact_wrenches(point, normal, number_of(call, a[2], "friction"),
                                            whole(call, a[3], "facets"), room_for_set(call)));
}

static const rg_set* support_mapping(Call* call, Arguments a, int count) {
  (void)count;
  const double* center = numbers_of(call, a[0], "center");
  if (!mxIsClass(a[1], "function_handle")) refuse_value(call, "mapping", "a function handle");
  return kept(call,
              rg_set_support_mapping(length_of(a[0]), center, ask_handle, (void*)a[1], room_for_set(call)));
}

static const rg_set* affine_image(Call* call, Arguments a, int count) {
  (void)count;
  const rg_set* S = set_of(call, a[0]);
  const size_t n = (size_t)rg_set_dimension(S);
  const double *M = vector_of(call, a[1], n * n, "M"), *t = vector_of(call, a[2], n, "t");
  return kept(call, rg_set_affine_image(S, M, t, room_for_set(call)));
}

static const rg_set* sum(Call* call, Arguments a, int count) {
  (void)count;
  const rg_set *A = set_of(call, a[0]), *B = set_of(call, a[1]);
  return kept(call, rg_set_sum(A, B, room_for_set(call)));
}

static const rg_set* difference(Call* call, Arguments a, int count) {
  (void)count;
  const rg_set *A2 = set_of(call, a[0]), *A1 = set_of(call, a[1]);
  return kept(call, rg_set_difference(A2, A1, room_for_set(call)));
}

static const rg_set* union_hull(Call* call, Arguments a, int count) {
  const rg_set** members = mxCalloc((size_t)count + 1, sizeof *members);
  for (int i = 0; i < count; ++i) members[i] = set_of(call, a[i]);
  return kept(call, rg_set_union_hull(count, members, room_for_set(call)));
}

static const Kind kKinds[] = {
    {"points", 1, points},
    {"prepared_points", 1, prepared_points},
    {"ball", 2, ball},
    {"box", 2, box},
    {"ellipsoid", 2, ellipsoid},
    {"p_norm_ball", 3, p_norm_ball},
    {"capsule", 3, capsule},
    {"cylinder", 3, cylinder},
    {"cone", 4, cone},
    {"simplex", 2, simplex},
    {"zonotope", 2, zonotope},
    {"h_polytope", 2, h_polytope},
    {"sum", 2, sum},
    {"contact_wrenches", 4, contact_wrenches},
    {"difference", 2, difference},
    {"support_mapping", 2, support_mapping},
    {"union_hull", -1, union_hull},
    {"affine_image", 3, affine_image},
};

static const rg_set* made_of(Call* call, const Kind* kind, const mxArray* cell) {
  const int count = length_of(cell);
  if (kind->arguments >= 0 && count != kind->arguments) {
    char text[128];
    snprintf(text, sizeof text, "%s: %d arguments are needed, got %d", kind->name, kind->arguments, count);
    refuse(call, RG_INVALID_PARAMETER, text);
  }
  const mxArray** arguments = mxCalloc((size_t)count + 1, sizeof *arguments);
  for (int i = 0; i < count; ++i) arguments[i] = mxGetCell(cell, i);
  return kind->make(call, arguments, count);
}

const rg_set* set_of(Call* call, const mxArray* value) {
  if (mxIsDouble(value)) return points(call, &value, 1);
  const mxArray* kind = mxIsStruct(value) ? mxGetField(value, 0, "kind") : NULL;
  const mxArray* cell = mxIsStruct(value) ? mxGetField(value, 0, "arguments") : NULL;
  char name[32] = "", text[128];
  if (kind == NULL || cell == NULL || !mxIsCell(cell) || mxGetString(kind, name, sizeof name) != 0) {
    refuse(call, RG_INVALID_PARAMETER, "a set is what rg_set returns, or a matrix of points, one a column");
  }
  for (size_t i = 0; i < sizeof kKinds / sizeof *kKinds; ++i) {
    if (strcmp(name, kKinds[i].name) == 0) return made_of(call, &kKinds[i], cell);
  }
  snprintf(text, sizeof text, "there is no kind of set '%s': help rg_set lists them", name);
  refuse(call, RG_UNKNOWN_NAME, text);
  return NULL;
}
