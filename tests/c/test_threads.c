/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT */
#include <pthread.h>
#include <stddef.h>

#include "tests/c/check.h"

typedef struct Work {
  const rg_set *set, *far;
  const rg_pose* pose;
  int index;
  int wrong;
} Work;

/* Sets and poses are shared, a solver is the thread's own, and so is the message. */
static void* solve(void* argument) {
  Work* work = argument;
  rg_solver* solver = NULL;
  rg_answer answer = {0};
  const rg_pair pair = {work->set, work->pose, work->far, NULL};
  char expected[32];
  snprintf(expected, sizeof expected, "got %d", -work->index);
  work->wrong += strcmp(rg_last_message(), "") != 0;
  work->wrong += rg_solver_create(&solver) != RG_OK;
  for (int i = 0; i < 500; ++i) {
    work->wrong += rg_object_distance(solver, &pair, NULL, 0, NULL, &answer) != RG_OK;
    work->wrong += !(answer.lower <= 4 && 4 <= answer.upper);
    rg_set* never = NULL;
    work->wrong += rg_set_points(-work->index, 1, NULL, &never) != RG_INVALID_PARAMETER;
    work->wrong += strstr(rg_last_message(), expected) == NULL;
  }
  rg_solver_free(solver);
  return NULL;
}

void test_threads(void) {
  enum { kThreads = 4 };
  rg_set *set = ball_at(0, 1), *far = ball_at(10, 2);
  rg_pose* pose = NULL;
  const double t[3] = {3, 0, 0};
  OK(rg_pose_create(3, NULL, t, &pose));
  pthread_t threads[kThreads];
  Work work[kThreads];
  for (int i = 0; i < kThreads; ++i) {
    work[i] = (Work){set, far, pose, i + 1, 0};
    CHECK(pthread_create(&threads[i], NULL, solve, &work[i]) == 0);
  }
  for (int i = 0; i < kThreads; ++i) {
    pthread_join(threads[i], NULL);
    CHECK(work[i].wrong == 0);
  }
  rg_pose_free(pose);
  rg_set_free(set);
  rg_set_free(far);
}
