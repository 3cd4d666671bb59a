/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "tests/c/check.h"

/* h(u) of a set whose handle is freed here. */
static double support(rg_error made, rg_set* set, const double* u) {
  double value = NAN, again = NAN, point[6] = {0};
  OK(made);
  OK(rg_set_support(set, u, &value, point));
  OK(rg_set_support(set, u, &again, NULL));
  CHECK(value == again);
  double at_point = 0, at_center = 0, center[6] = {0};
  OK(rg_set_center(set, center));
  for (int k = 0; k < rg_set_dimension(set); ++k) {
    at_point += u[k] * point[k];
    at_center += u[k] * center[k];
  }
  CHECK(fabs(at_point - value) <= 1e-12 * (1 + fabs(value)));
  CHECK(at_center <= value + 1e-12);
  rg_set_free(set);
  return value;
}

#define SUPPORT(expected, u, make)                                 \
  do {                                                             \
    rg_set* set = NULL;                                            \
    const rg_error made = make;                                    \
    CHECK(fabs(support(made, set, u) - (expected)) <= 1e-12 * 10); \
  } while (0)

static int32_t unit_ball(void* data, int32_t n, const double* u, double* point) {
  double square = 0;
  for (int k = 0; k < n; ++k) square += u[k] * u[k];
  for (int k = 0; k < n; ++k) point[k] = square > 0 ? u[k] / sqrt(square) : 0;
  ++*(int*)data;
  return 0;
}

static void closed_forms(void) {
  const double o[3] = {0, 0, 0}, one[3] = {1, 1, 1}, x[3] = {1, 0, 0}, y2[3] = {0, 2, 0}, u[3] = {0, 3, 4};
  const double points[6] = {1, 2, 3, -1, 0, 2};
  SUPPORT(18, u, rg_set_points(3, 2, points, &set));
  SUPPORT(18, u, rg_set_prepared_points(3, 2, points, &set));
  SUPPORT(10, u, rg_set_ball(3, o, 2, &set));
  SUPPORT(7, u, rg_set_box(3, o, one, &set));
  const double factor[6] = {0, 1, 0, 0, 0, 2}; /* semi-axes e_2 and 2 e_3 */
  SUPPORT(sqrt(73), u, rg_set_ellipsoid(3, o, 2, factor, &set));
  SUPPORT(4, u, rg_set_p_norm_ball(3, o, one, 1, &set));
  SUPPORT(7, u, rg_set_p_norm_ball(3, o, one, INFINITY, &set));
  SUPPORT(6 + 5, u, rg_set_capsule(3, o, y2, 1, &set));
  SUPPORT(6 + 4, u, rg_set_cylinder(3, o, y2, 1, &set));
  SUPPORT(8, u, rg_set_cone(3, o, 2, y2, 0, &set));
  SUPPORT(4, u, rg_set_simplex(3, o, one, &set));
  SUPPORT(6 + 0, u, rg_set_zonotope(3, o, 1, y2, &set));
  SUPPORT(0, u, rg_set_zonotope(3, o, 0, NULL, &set));
  const double normals[18] = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
  const double offsets[6] = {1, 1, 1, 1, 1, 1};
  SUPPORT(7, u, rg_set_h_polytope(3, 6, normals, offsets, &set));
  const double w[6] = {1, 0, 0, 0, 0, 0};
  SUPPORT(1, w, rg_set_contact_wrenches(o, x, 0.5, 0, &set));
}

static void combinators(void) {
  const double o[3] = {0, 0, 0}, t[3] = {1, 2, 3}, u[3] = {0, 3, 4};
  const double double_it[9] = {2, 0, 0, 0, 2, 0, 0, 0, 2};
  rg_set *one = ball_at(0, 1), *three = ball_at(0, 3), *freed = ball_at(0, 2);
  SUPPORT(5 + 15, u, rg_set_sum(one, three, &set));
  SUPPORT(5 + 15, u, rg_set_difference(one, three, &set));
  SUPPORT(10 + 18, u, rg_set_affine_image(one, double_it, t, &set));
  const rg_set* both[2] = {one, three};
  SUPPORT(15, u, rg_set_union_hull(2, both, &set));

  /* A set keeps what it is made of. */
  rg_set* sum = NULL;
  OK(rg_set_sum(freed, freed, &sum));
  rg_set_free(freed);
  SUPPORT(20, u, (set = sum, RG_OK));

  int calls = 0;
  SUPPORT(5, u, rg_set_support_mapping(3, o, unit_ball, &calls, &set));
  CHECK(calls > 0);
  rg_set_free(one);
  rg_set_free(three);
  rg_set_free(NULL);
  CHECK(rg_set_dimension(NULL) == 0);
}

static void membership(void) {
  rg_set* ball = ball_at(0, 2);
  const double inside[3] = {1, 1, 1}, outside[3] = {0, 3, 4};
  double lower = NAN, upper = NAN;
  int32_t answer = -1;
  OK(rg_gauge(ball, outside, 1e-6, &lower, &upper));
  CHECK(lower <= 2.5 && 2.5 <= upper && upper - lower <= 1e-6 * upper);
  OK(rg_contains(ball, inside, 1e-6, &answer));
  CHECK(answer == RG_INSIDE);
  OK(rg_contains(ball, outside, 1e-6, &answer));
  CHECK(answer == RG_OUTSIDE);
  rg_set_free(ball);
}

void test_sets(void) {
  closed_forms();
  combinators();
  membership();
}
