/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT

   A program of its own: the memory of a process stays where it is over 10^6 queries, and over many sets,
   poses, warm starts and refusals. */
#include <stdlib.h>

#include "tests/c/check.h"

int failed_checks = 0;

rg_set* ball_at(double x, double radius) {
  const double center[3] = {x, 0, 0};
  rg_set* ball = NULL;
  OK(rg_set_ball(3, center, radius, &ball));
  return ball;
}

static long resident_pages(void) {
  long all = 0, resident = 0;
  FILE* numbers = fopen("/proc/self/statm", "r");
  CHECK(numbers != NULL && fscanf(numbers, "%ld %ld", &all, &resident) == 2);
  if (numbers != NULL) fclose(numbers);
  return resident;
}

static void query(long calls) {
  static rg_solver* solver = NULL;
  static rg_set *one = NULL, *two = NULL;
  if (solver == NULL) {
    OK(rg_solver_create(&solver));
    one = ball_at(0, 1);
    two = ball_at(5, 2);
  }
  const rg_pair pair = {one, NULL, two, NULL};
  rg_answer answer = {0};
  for (long i = 0; i < calls; ++i)
    OK(rg_object_distance(solver, &pair, NULL, RG_CLOSEST_POINTS, NULL, &answer));
}

/* A link that turns with a ball, past another one. */
static void prove_edge(const rg_set* ball) {
  const rg_link link = {-1, RG_REVOLUTE, 0, NULL, {0, 0, 1}, 1, 0};
  const double line[2] = {0, 1};
  rg_robot* robot = NULL;
  rg_checker* checker = NULL;
  rg_verdict verdict;
  OK(rg_robot_create(1, &robot));
  OK(rg_robot_add_link(robot, &link, NULL));
  OK(rg_robot_add_body(robot, 0, 1, &ball, NULL, NULL));
  OK(rg_robot_add_obstacle(robot, 1, &ball, NULL, NULL));
  CHECK(rg_robot_ignore(robot, 0, 2) != RG_OK);
  OK(rg_checker_create(robot, NULL, &checker));
  rg_robot_free(robot);
  OK(rg_checker_prove(checker, 2, line, &verdict));
  rg_checker_free(checker);
}

static void make_and_free(long calls) {
  const double lost[4] = {0, NAN, 0, 0};
  for (long i = 0; i < calls; ++i) {
    rg_set *ball = ball_at((double)i, 1), *sum = NULL, *never = NULL;
    rg_pose* pose = NULL;
    rg_warm* warm = NULL;
    rg_batch* batch = NULL;
    rg_solver* solver = NULL;
    OK(rg_set_sum(ball, ball, &sum));
    if (i % 10 == 0) prove_edge(ball);
    rg_set_free(ball);
    OK(rg_pose_create(3, NULL, NULL, &pose));
    OK(rg_warm_create(2, &warm));
    OK(rg_batch_create(1, 1e-6, &batch));
    OK(rg_solver_create(&solver));
    CHECK(rg_pose_assign_quaternion(pose, lost, lost) != RG_OK);
    CHECK(rg_set_points(3, 1, lost, &never) == RG_NON_FINITE);
    rg_solver_free(solver);
    rg_batch_free(batch);
    rg_warm_free(warm);
    rg_pose_free(pose);
    rg_set_free(sum);
  }
}

static void stays(void (*work)(long), long calls, int is_measured) {
  work(calls / 10);
  const long before = resident_pages();
  work(calls);
  const double grown = 4096.0 * (double)(resident_pages() - before);
  CHECK(!is_measured || grown < 2e6); /* a leaked double a call of 10^6 would be 8e6 */
}

/* usage: test_c_memory [DIVISOR]: so many times fewer calls, for sanitizers, which find leaks themselves and
   whose allocator keeps what is freed. */
int main(int argc, char** argv) {
  const long divisor = argc > 1 ? strtol(argv[1], NULL, 10) : 1;
  stays(query, 1000000 / divisor, divisor == 1);
  stays(make_and_free, 100000 / divisor, divisor == 1);
  printf("%d checks failed\n", failed_checks);
  return failed_checks == 0 ? 0 : 1;
}
