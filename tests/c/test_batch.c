/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT */
#include <stdint.h>

#include "tests/c/check.h"

enum { kPairs = 200 };

static double distance[kPairs], lower[kPairs], upper[kPairs], normal[3 * kPairs], first[3 * kPairs],
    second[3 * kPairs];
static uint8_t status[kPairs];

void test_batches(void) {
  rg_set *balls[kPairs] = {0}, *ball = ball_at(0, 1), *wide = ball_at(0, 2);
  rg_pair pairs[kPairs];
  for (int i = 0; i < kPairs; ++i) {
    balls[i] = ball_at(1 + 0.1 * i, 1);
    pairs[i] = (rg_pair){ball, NULL, balls[i], NULL};
  }
  rg_batch* batch = NULL;
  rg_warm *warm = NULL, *short_warm = NULL;
  rg_solver* solver = NULL;
  OK(rg_batch_create(2, 1e-9, &batch));
  OK(rg_warm_create(kPairs, &warm));
  OK(rg_warm_create(kPairs - 1, &short_warm));
  OK(rg_solver_create(&solver));
  OK(rg_solver_set_tolerance(solver, 1e-9));

  rg_batch_answers answers = {distance, lower, upper, status, normal, first, second};
  OK(rg_batch_object_distances(batch, kPairs, pairs, NULL, NULL, &answers));
  rg_answer alone = {0};
  for (int i = 0; i < kPairs; ++i) {
    OK(rg_object_distance(solver, &pairs[i], NULL, RG_CLOSEST_POINTS, NULL, &alone));
    CHECK(alone.distance == distance[i] && alone.lower == lower[i] && alone.upper == upper[i]);
    CHECK(alone.status == status[i]);
    double point[3];
    OK(rg_solver_vector(solver, RG_POINT_1, 3, point));
    CHECK(memcmp(point, first + 3 * i, sizeof point) == 0 || (isnan(point[0]) && isnan(first[3 * i])));
  }
  CHECK(fabs(distance[100] - 9) < 1e-8);
  const double largest = upper[kPairs - 1];

  const rg_batch_answers some = {NULL, lower, upper, NULL, NULL, NULL, NULL};
  OK(rg_batch_object_distances(batch, kPairs, pairs, wide, warm, &some)); /* lengths count half */
  CHECK(fabs(2 * upper[kPairs - 1] - largest) < 1e-6);
  OK(rg_batch_object_distances(batch, 0, NULL, NULL, NULL, &some));

  answers.closest_points_1 = answers.closest_points_2 = NULL;
  OK(rg_warm_clear(warm));
  OK(rg_batch_growth_distances(batch, kPairs, pairs, warm, &answers));
  for (int i = 0; i < kPairs; ++i) {
    OK(rg_growth_distance(solver, &pairs[i], NULL, &alone));
    CHECK(alone.lower <= upper[i] && lower[i] <= alone.upper &&
          fabs(alone.distance - (1 + 0.1 * i) / 2) < 1e-7);
  }

  REFUSED(rg_batch_create(0, 1e-6, &batch), RG_INVALID_PARAMETER, "threads");
  REFUSED(rg_batch_create(1, 2, &batch), RG_INVALID_PARAMETER, "tolerance");
  REFUSED(rg_batch_create(1, 1e-6, NULL), RG_INVALID_PARAMETER, "batch is a null pointer");
  REFUSED(rg_batch_object_distances(batch, -1, pairs, NULL, NULL, &some), RG_INVALID_PARAMETER, "count");
  REFUSED(rg_batch_object_distances(batch, 1, NULL, NULL, NULL, &some), RG_INVALID_PARAMETER,
          "pairs is a null");
  REFUSED(rg_batch_object_distances(batch, 1, pairs, NULL, NULL, NULL), RG_INVALID_PARAMETER,
          "answers is a null");
  REFUSED(rg_batch_object_distances(batch, kPairs, pairs, NULL, short_warm, &some), RG_INVALID_PARAMETER,
          "warm");
  REFUSED(rg_batch_growth_distances(batch, kPairs, pairs, short_warm, &some), RG_INVALID_PARAMETER, "warm");
  answers.closest_points_1 = first;
  REFUSED(rg_batch_growth_distances(batch, kPairs, pairs, NULL, &answers), RG_INVALID_PARAMETER,
          "closest points");
  pairs[7].second = NULL;
  REFUSED(rg_batch_growth_distances(batch, kPairs, pairs, NULL, &some), RG_INVALID_PARAMETER,
          "second is a null");
  REFUSED(rg_warm_create(0, &warm), RG_INVALID_PARAMETER, "count");
  REFUSED(rg_warm_create(1, NULL), RG_INVALID_PARAMETER, "warm is a null pointer");
  REFUSED(rg_warm_clear(NULL), RG_INVALID_PARAMETER, "warm is a null pointer");

  for (int i = 0; i < kPairs; ++i) rg_set_free(balls[i]);
  rg_set_free(ball);
  rg_set_free(wide);
  rg_warm_free(warm);
  rg_warm_free(short_warm);
  rg_batch_free(batch);
  rg_batch_free(NULL);
  rg_solver_free(solver);
}
