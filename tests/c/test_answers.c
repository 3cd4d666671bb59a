/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT */
#include "tests/c/check.h"

static rg_solver* solver = NULL;

/* Example: a triangle at a distance of 2 in the gauge of a square, as in the README. */
static void gauge_distances(void) {
  const double triangle[6] = {2, 0, 4, -1, 4, 1}, square[8] = {1, 0, -1, 0, 0, 1, 0, -1};
  const double half_plane[6] = {-1, 0, -1, 1, -1, -1}, around[6] = {-1, -1, 1, -1, 0, 1};
  rg_set *A = NULL, *Q = NULL, *behind = NULL, *origin = NULL;
  OK(rg_set_points(2, 3, triangle, &A));
  OK(rg_set_points(2, 4, square, &Q));
  OK(rg_set_points(2, 3, half_plane, &behind));
  OK(rg_set_points(2, 3, around, &origin));
  rg_pair pair = {A, NULL, Q, NULL};
  rg_answer answer = {0};
  double normal[2], contact[2];
  OK(rg_distance(solver, &pair, RG_WITNESS, NULL, &answer));
  ANSWERS(answer, 2.0, 1e-6);
  CHECK(answer.status == RG_OPTIMAL && answer.meet == -1);
  OK(rg_solver_vector(solver, RG_NORMAL, 2, normal));
  CHECK(fabs(normal[0] + 1) < 1e-6); /* h_Q(-normal) = 1 */
  OK(rg_solver_vector(solver, RG_CONTACT_POINT, 2, contact));
  CHECK(fabs(contact[0] - 2) < 1e-6 && fabs(contact[1]) < 1e-6);
  OK(rg_distance(solver, &pair, 0, NULL, &answer));
  OK(rg_solver_vector(solver, RG_CONTACT_POINT, 2, contact));
  CHECK(isnan(contact[0]) && isnan(contact[1])); /* it was not asked for */
  OK(rg_solver_vector(solver, RG_POINT_1, 2, contact));
  CHECK(isnan(contact[0]));

  pair.second = behind;
  OK(rg_distance(solver, &pair, 0, NULL, &answer));
  CHECK(answer.status == RG_UNREACHABLE && isinf(answer.distance));
  pair.first = origin;
  pair.second = Q;
  OK(rg_distance(solver, &pair, 0, NULL, &answer));
  CHECK(answer.status == RG_CONTAINS_ORIGIN && answer.distance == 0);
  rg_set_free(A);
  rg_set_free(Q);
  rg_set_free(behind);
  rg_set_free(origin);
}

static void object_distances(void) {
  rg_set *left = ball_at(0, 1), *right = ball_at(5, 2), *inside = ball_at(2.5, 2), *wide = ball_at(0, 2);
  rg_pair pair = {left, NULL, right, NULL};
  rg_answer answer = {0};
  double first[3], second[3], gradient[3];
  OK(rg_object_distance(solver, &pair, NULL, RG_CLOSEST_POINTS | RG_GRADIENT, NULL, &answer));
  ANSWERS(answer, 2.0, 1e-6);
  CHECK(answer.meet == 0);
  OK(rg_solver_vector(solver, RG_POINT_1, 3, first));
  OK(rg_solver_vector(solver, RG_POINT_2, 3, second));
  CHECK(fabs(first[0] - 1) < 1e-6 && fabs(second[0] - 3) < 1e-6);
  OK(rg_solver_vector(solver, RG_GRADIENT_1, 3, gradient));
  CHECK(fabs(gradient[0] + 1) < 1e-3);
  OK(rg_solver_vector(solver, RG_GRADIENT_2, 3, gradient));
  CHECK(fabs(gradient[0] - 1) < 1e-3);
  OK(rg_object_distance(solver, &pair, wide, 0, NULL, &answer)); /* lengths count half in this metric */
  ANSWERS(answer, 1.0, 1e-6);

  OK(rg_signed_distance(solver, &pair, NULL, 0, NULL, &answer));
  ANSWERS(answer, 2.0, 1e-6);
  pair.second = inside;
  OK(rg_object_distance(solver, &pair, NULL, 0, NULL, &answer));
  CHECK(answer.distance == 0 && answer.meet == 1 && answer.status == RG_CONTAINS_ORIGIN);
  OK(rg_signed_distance(solver, &pair, NULL, RG_CLOSEST_POINTS, NULL, &answer));
  ANSWERS(answer, -0.5, 1e-6);
  CHECK(answer.meet == 1 && answer.status == RG_OPTIMAL);
  OK(rg_solver_vector(solver, RG_NORMAL, 3, gradient));
  CHECK(fabs(gradient[0] + 1) < 1e-6); /* the way out for the first */
  OK(rg_solver_vector(solver, RG_POINT_1, 3, first));
  OK(rg_solver_vector(solver, RG_POINT_2, 3, second));
  CHECK(fabs(first[0] - 1) < 1e-6 && fabs(second[0] - 0.5) < 1e-6);
  rg_set_free(left);
  rg_set_free(right);
  rg_set_free(inside);
  rg_set_free(wide);
}

static void growth_and_separation(void) {
  rg_set *left = ball_at(0, 1), *right = ball_at(6, 2), *near = ball_at(2, 2);
  rg_pair pair = {left, NULL, right, NULL};
  rg_answer answer = {0};
  rg_warm* warm = NULL;
  int32_t outcome = -1;
  double normal[3];
  OK(rg_warm_create(1, &warm));
  for (int i = 0; i < 3; ++i) {
    OK(rg_growth_distance(solver, &pair, warm, &answer));
    ANSWERS(answer, 2.0, 1e-6); /* the radii grow to 2 and 4 */
  }
  OK(rg_warm_clear(warm));
  OK(rg_separation(solver, &pair, warm, &outcome));
  CHECK(outcome == RG_SEPARATED);
  OK(rg_solver_vector(solver, RG_NORMAL, 3, normal));
  CHECK(fabs(normal[0]) > 0);
  OK(rg_solver_vector(solver, RG_GRADIENT_1, 3, normal));
  CHECK(isnan(normal[0]));
  pair.second = near;
  OK(rg_separation(solver, &pair, NULL, &outcome));
  CHECK(outcome == RG_INTERSECTING);
  rg_warm_free(warm);
  rg_warm_free(NULL);
  rg_set_free(left);
  rg_set_free(right);
  rg_set_free(near);
}

void test_answers(void) {
  OK(rg_solver_create(&solver));
  gauge_distances();
  object_distances();
  growth_and_separation();
  rg_solver_free(solver);
  rg_solver_free(NULL);
}
