/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "tests/c/check.h"

static int32_t fails_at_3(void* data, int32_t n, const double* u, double* point) {
  for (int k = 0; k < n; ++k) point[k] = u[k] > 0 ? 1 : -1;
  return ++*(int*)data > 3 ? 42 : 0;
}

static int32_t not_a_number(void* data, int32_t n, const double* u, double* point) {
  (void)data, (void)u;
  for (int k = 0; k < n; ++k) point[k] = NAN;
  return 0;
}

static int32_t box_for_a_while(void* data, int32_t n, const double* u, double* point) {
  for (int k = 0; k < n; ++k) point[k] = u[k] > 0 ? 1 : -1;
  return --*(int*)data < 0 ? 5 : 0;
}

static const double o[3] = {0, 0, 0}, x[3] = {1, 0, 0}, lost[3] = {0, NAN, 0}, m[3] = {-1, -1, -1};

static void sets(void) {
  static char place;
  rg_set *const nothing = (rg_set*)(void*)&place, *set = nothing;
  REFUSED(rg_set_points(3, 0, o, &set), RG_EMPTY_SET, "");
  REFUSED(rg_set_points(0, 1, o, &set), RG_INVALID_PARAMETER, "n must lie in [1, ");
  REFUSED(rg_set_points(-4, 1, o, &set), RG_INVALID_PARAMETER, "n must lie in [1, ");
  REFUSED(rg_set_points(3, INT64_MAX / 2, o, &set), RG_INVALID_PARAMETER, "count");
  REFUSED(rg_set_points(3, -1, o, &set), RG_INVALID_PARAMETER, "count");
  REFUSED(rg_set_points(3, 1, NULL, &set), RG_INVALID_PARAMETER, "points is a null pointer");
  REFUSED(rg_set_points(3, 1, o, NULL), RG_INVALID_PARAMETER, "set is a null pointer");
  REFUSED(rg_set_points(3, 1, lost, &set), RG_NON_FINITE, "coordinate 1");
  REFUSED(rg_set_prepared_points(3, 1, lost, &set), RG_NON_FINITE, "coordinate 1");
  REFUSED(rg_set_ball(3, o, -1, &set), RG_INVALID_PARAMETER, "radius");
  REFUSED(rg_set_ball(3, NULL, 1, &set), RG_INVALID_PARAMETER, "center is a null pointer");
  REFUSED(rg_set_box(3, x, o, &set), RG_INVALID_PARAMETER, "box");
  REFUSED(rg_set_ellipsoid(3, o, 0, NULL, &set), RG_INVALID_PARAMETER, "ellipsoid");
  REFUSED(rg_set_ellipsoid(3, o, 1, lost, &set), RG_NON_FINITE, "factor");
  REFUSED(rg_set_p_norm_ball(3, o, x, 0.5, &set), RG_INVALID_PARAMETER, "p");
  REFUSED(rg_set_p_norm_ball(3, o, m, 2, &set), RG_INVALID_PARAMETER, "semi_axes");
  REFUSED(rg_set_capsule(3, o, lost, 1, &set), RG_NON_FINITE, "q");
  REFUSED(rg_set_cylinder(3, o, o, 1, &set), RG_INVALID_PARAMETER, "cylinder");
  REFUSED(rg_set_cone(3, o, 1, x, -1, &set), RG_INVALID_PARAMETER, "radius");
  REFUSED(rg_set_simplex(3, o, NULL, &set), RG_INVALID_PARAMETER, "legs is a null pointer");
  REFUSED(rg_set_zonotope(3, o, -1, x, &set), RG_INVALID_PARAMETER, "count");
  REFUSED(rg_set_zonotope(3, o, 1, lost, &set), RG_NON_FINITE, "generators");
  REFUSED(rg_set_h_polytope(3, 1, x, x, &set), RG_INVALID_PARAMETER, "bounded");
  REFUSED(rg_set_h_polytope(3, 1, x, NULL, &set), RG_INVALID_PARAMETER, "offsets is a null pointer");
  REFUSED(rg_set_contact_wrenches(o, o, 0.5, 0, &set), RG_INVALID_PARAMETER, "normal");
  REFUSED(rg_set_contact_wrenches(o, x, 0.5, 2, &set), RG_INVALID_PARAMETER, "facets");
  CHECK(set == nothing); /* an error writes nothing */
}

static void combinators(void) {
  const double singular[9] = {0};
  rg_set *ball = ball_at(0, 1), *flat = NULL, *made = NULL;
  const rg_set *hole[2] = {ball, NULL}, *mixed[2] = {ball, NULL};
  OK(rg_set_ball(2, o, 1, &flat));
  mixed[1] = flat;
  REFUSED(rg_set_affine_image(ball, singular, o, &made), RG_INVALID_PARAMETER, "singular");
  REFUSED(rg_set_affine_image(NULL, singular, o, &made), RG_INVALID_PARAMETER, "S is a null pointer");
  REFUSED(rg_set_sum(ball, flat, &made), RG_DIMENSION_MISMATCH, "");
  REFUSED(rg_set_sum(ball, NULL, &made), RG_INVALID_PARAMETER, "B is a null pointer");
  REFUSED(rg_set_difference(NULL, ball, &made), RG_INVALID_PARAMETER, "A2 is a null pointer");
  REFUSED(rg_set_union_hull(2, hole, &made), RG_INVALID_PARAMETER, "an entry of sets is a null pointer");
  REFUSED(rg_set_union_hull(2, mixed, &made), RG_DIMENSION_MISMATCH, "");
  REFUSED(rg_set_union_hull(0, NULL, &made), RG_EMPTY_SET, "");
  REFUSED(rg_set_union_hull(1, NULL, &made), RG_INVALID_PARAMETER, "sets is a null pointer");
  CHECK(made == NULL);
  rg_set_free(ball);
  rg_set_free(flat);
}

static void mappings(void) {
  rg_set* set = NULL;
  int calls = 0;
  REFUSED(rg_set_support_mapping(3, o, fails_at_3, &calls, &set), RG_CALLBACK_FAILED, "returned 42");
  REFUSED(rg_set_support_mapping(3, o, not_a_number, NULL, &set), RG_NON_FINITE, "coordinate 0");
  REFUSED(rg_set_support_mapping(3, o, NULL, NULL, &set), RG_INVALID_PARAMETER, "mapping is a null pointer");
  int calls_left = 1000;
  OK(rg_set_support_mapping(3, o, box_for_a_while, &calls_left, &set));
  rg_set* far = ball_at(9, 1);
  rg_solver* solver = NULL;
  rg_answer answer = {7, 7, 7, 7, 7};
  const rg_pair pair = {set, NULL, far, NULL};
  double vector[3];
  OK(rg_solver_create(&solver));
  calls_left = 2;
  REFUSED(rg_object_distance(solver, &pair, NULL, 0, NULL, &answer), RG_CALLBACK_FAILED, "returned 5");
  CHECK(answer.distance == 7 && answer.status == 7);
  REFUSED(rg_solver_vector(solver, RG_NORMAL, 3, vector), RG_INVALID_PARAMETER, "it has no result");
  calls_left = 1000000; /* the solver is as good as new */
  OK(rg_object_distance(solver, &pair, NULL, 0, NULL, &answer));
  ANSWERS(answer, 7.0, 1e-5);
  rg_batch* batch = NULL;
  double distance[1];
  const rg_batch_answers answers = {distance, NULL, NULL, NULL, NULL, NULL, NULL};
  OK(rg_batch_create(2, 1e-6, &batch));
  calls_left = 2;
  REFUSED(rg_batch_object_distances(batch, 1, &pair, NULL, NULL, &answers), RG_CALLBACK_FAILED, "returned 5");
  rg_batch_free(batch);
  rg_solver_free(solver);
  rg_set_free(far);
  rg_set_free(set);
}

static void queries(void) {
  rg_set *ball = ball_at(0, 1), *flat = NULL;
  rg_solver* solver = NULL;
  rg_answer answer = {0};
  int32_t outcome = 0;
  double bound = 0, vector[3];
  OK(rg_set_ball(2, o, 1, &flat));
  OK(rg_solver_create(&solver));
  const rg_pair hole = {ball, NULL, NULL, NULL}, mixed = {ball, NULL, flat, NULL},
                good = {ball, NULL, ball, NULL};
  REFUSED(rg_solver_create(NULL), RG_INVALID_PARAMETER, "solver is a null pointer");
  REFUSED(rg_distance(NULL, &good, 0, NULL, &answer), RG_INVALID_PARAMETER, "solver is a null pointer");
  REFUSED(rg_distance(solver, NULL, 0, NULL, &answer), RG_INVALID_PARAMETER, "pair is a null pointer");
  REFUSED(rg_distance(solver, &good, 0, NULL, NULL), RG_INVALID_PARAMETER, "answer is a null pointer");
  REFUSED(rg_distance(solver, &hole, 0, NULL, &answer), RG_INVALID_PARAMETER,
          "pair->second is a null pointer");
  REFUSED(rg_distance(solver, &mixed, 0, NULL, &answer), RG_DIMENSION_MISMATCH, "");
  REFUSED(rg_distance(solver, &good, RG_GRADIENT, NULL, &answer), RG_INVALID_PARAMETER, "effects");
  REFUSED(rg_object_distance(solver, &good, NULL, RG_WITNESS, NULL, &answer), RG_INVALID_PARAMETER,
          "effects");
  REFUSED(rg_object_distance(solver, &mixed, NULL, 0, NULL, &answer), RG_DIMENSION_MISMATCH, "");
  REFUSED(rg_object_distance(solver, &good, flat, 0, NULL, &answer), RG_DIMENSION_MISMATCH, "");
  REFUSED(rg_signed_distance(solver, &hole, NULL, 0, NULL, &answer), RG_INVALID_PARAMETER, "null pointer");
  REFUSED(rg_growth_distance(solver, &mixed, NULL, &answer), RG_DIMENSION_MISMATCH, "");
  REFUSED(rg_separation(solver, &good, NULL, NULL), RG_INVALID_PARAMETER, "outcome is a null pointer");
  REFUSED(rg_solver_vector(solver, RG_NORMAL, 3, vector), RG_INVALID_PARAMETER, "it has no result");
  OK(rg_distance(solver, &good, 0, NULL, &answer));
  REFUSED(rg_solver_vector(solver, 17, 3, vector), RG_INVALID_PARAMETER, "which");
  REFUSED(rg_solver_vector(solver, RG_NORMAL, 2, vector), RG_DIMENSION_MISMATCH, "R^3, got 2");
  REFUSED(rg_solver_vector(solver, RG_NORMAL, 3, NULL), RG_INVALID_PARAMETER, "values is a null pointer");
  REFUSED(rg_set_center(ball, NULL), RG_INVALID_PARAMETER, "center is a null pointer");
  REFUSED(rg_set_support(ball, lost, &bound, NULL), RG_NON_FINITE, "");
  REFUSED(rg_set_support(NULL, x, &bound, NULL), RG_INVALID_PARAMETER, "set is a null pointer");
  REFUSED(rg_gauge(ball, lost, 1e-6, &bound, &bound), RG_NON_FINITE, "");
  REFUSED(rg_gauge(ball, x, 0, &bound, &bound), RG_INVALID_PARAMETER, "tolerance");
  REFUSED(rg_gauge(ball, x, 1e-6, NULL, &bound), RG_INVALID_PARAMETER, "lower is a null pointer");
  REFUSED(rg_contains(ball, x, 1e-6, NULL), RG_INVALID_PARAMETER, "membership is a null pointer");
  REFUSED(rg_contains(ball, NULL, 1e-6, &outcome), RG_INVALID_PARAMETER, "x is a null pointer");
  rg_solver_free(solver);
  rg_set_free(ball);
  rg_set_free(flat);
}

static void names(void) {
  CHECK(strcmp(rg_error_name(RG_OK), "RG_OK") == 0);
  CHECK(strcmp(rg_error_name(RG_INTERNAL), "RG_INTERNAL") == 0);
  CHECK(strcmp(rg_error_name(-1), "unknown") == 0 && strcmp(rg_error_name(99), "unknown") == 0);
  CHECK(strcmp(rg_status_name(RG_OPTIMAL), "optimal") == 0);
  CHECK(strcmp(rg_status_name(RG_TIME_LIMIT), "time_limit") == 0);
  CHECK(strcmp(rg_status_name(77), "unknown") == 0);
}

void test_refusals(void) {
  sets();
  combinators();
  mappings();
  queries();
  names();
}
