/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT */
#include "tests/c/check.h"

static int32_t count_down(void* data) { return --*(int*)data <= 0; }

static rg_set* cloud(int32_t n, int64_t count, double shift) {
  static double points[60 * 3000];
  uint32_t state = 7;
  for (int64_t i = 0; i < n * count; ++i) {
    state = state * 1664525u + 1013904223u;
    points[i] = (double)state / 4294967296.0 - 0.5 + (i % n == 0 ? shift : 0);
  }
  rg_set* set = NULL;
  OK(rg_set_points(n, count, points, &set));
  return set;
}

void test_options(void) {
  rg_set *left = ball_at(0, 1), *far = ball_at(5, 2), *A = cloud(60, 3000, 3), *Q = cloud(60, 3000, 0);
  const rg_pair balls = {left, NULL, far, NULL}, clouds = {A, NULL, Q, NULL};
  rg_solver* solver = NULL;
  rg_answer answer = {0}, other = {0};
  OK(rg_solver_create(&solver));
  OK(rg_solver_set_tolerance(solver, 1e-10));
  OK(rg_object_distance(solver, &balls, NULL, 0, NULL, &answer));
  ANSWERS(answer, 2.0, 1e-10);

  OK(rg_solver_set_tolerance(solver, 1e-6));
  OK(rg_distance(solver, &clouds, 0, NULL, &answer));
  CHECK(answer.status == RG_OPTIMAL);
  OK(rg_solver_set_method(solver, "zheng_yamane"));
  OK(rg_solver_set_max_iterations(solver, 3));
  OK(rg_distance(solver, &clouds, 0, NULL, &other));
  CHECK(other.status == RG_ITERATION_LIMIT && other.lower <= answer.upper && other.upper >= answer.lower);
  OK(rg_solver_set_max_iterations(solver, 0));
  OK(rg_solver_set_method(solver, "automatic"));
  OK(rg_solver_set_time_limit(solver, 1e-9));
  OK(rg_distance(solver, &clouds, 0, NULL, &other));
  CHECK(other.status == RG_TIME_LIMIT && other.lower <= answer.upper && other.upper >= answer.lower);
  OK(rg_solver_set_time_limit(solver, INFINITY));
  int calls_left = 1;
  OK(rg_solver_set_stop(solver, count_down, &calls_left));
  OK(rg_distance(solver, &clouds, 0, NULL, &other));
  CHECK(other.status == RG_TIME_LIMIT && calls_left <= 0);
  OK(rg_solver_set_stop(solver, NULL, NULL));
  OK(rg_distance(solver, &clouds, 0, NULL, &other));
  CHECK(other.status == RG_OPTIMAL &&
        other.distance == answer.distance); /* the same bits as a fresh solver */

  REFUSED(rg_solver_set_tolerance(solver, 0), RG_INVALID_PARAMETER, "tolerance must lie in (0, 1), got 0");
  REFUSED(rg_solver_set_tolerance(solver, NAN), RG_INVALID_PARAMETER, "tolerance");
  REFUSED(rg_solver_set_time_limit(solver, -1), RG_INVALID_PARAMETER, "time_limit");
  REFUSED(rg_solver_set_max_iterations(solver, -1), RG_INVALID_PARAMETER, "max_iterations");
  REFUSED(rg_solver_set_method(solver, "newtom"), RG_UNKNOWN_NAME, "newton");
  REFUSED(rg_solver_set_method(solver, NULL), RG_INVALID_PARAMETER, "method is a null pointer");
  REFUSED(rg_solver_set_stop(NULL, count_down, &calls_left), RG_INVALID_PARAMETER,
          "solver is a null pointer");
  OK(rg_distance(solver, &clouds, 0, NULL, &other)); /* with the options as they were */
  CHECK(other.distance == answer.distance);
  rg_solver_free(solver);
  rg_set_free(left);
  rg_set_free(far);
  rg_set_free(A);
  rg_set_free(Q);
}
