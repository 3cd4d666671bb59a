/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT */
#include "tests/c/check.h"

int failed_checks = 0;

rg_set* ball_at(double x, double radius) {
  const double center[3] = {x, 0, 0};
  rg_set* ball = NULL;
  OK(rg_set_ball(3, center, radius, &ball));
  return ball;
}

int main(void) {
  CHECK(strcmp(rg_last_message(), "") == 0);
  CHECK(strcmp(rg_version(), RAYGAUGE_VERSION) == 0);
  test_sets();
  test_poses();
  test_answers();
  test_options();
  test_batches();
  test_refusals();
  test_robots();
  test_threads();
  printf("%d checks failed\n", failed_checks);
  return failed_checks == 0 ? 0 : 1;
}
