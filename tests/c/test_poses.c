/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT */
#include "tests/c/check.h"

static double distance_of(rg_solver* solver, const rg_pair* pair) {
  rg_answer answer = {0};
  OK(rg_object_distance(solver, pair, NULL, 0, NULL, &answer));
  return answer.distance;
}

void test_poses(void) {
  const double o[3] = {0, 0, 0}, up[3] = {0, 0, 2}, away[3] = {5, 0, 0}, near[3] = {4, 0, 0};
  const double turn[9] = {0, 0, -1, 0, 1, 0, 1, 0, 0}; /* by columns: e_1 to -e_3, e_3 to e_1 */
  const double half_turn[4] = {0, 0, 1, 0};            /* about e_2 */
  rg_set *ball = ball_at(0, 1), *rod = NULL;
  rg_solver* solver = NULL;
  rg_pose *pose = NULL, *place = NULL;
  OK(rg_set_capsule(3, o, up, 0.5, &rod));
  OK(rg_solver_create(&solver));
  OK(rg_pose_create(3, NULL, NULL, &pose));
  OK(rg_pose_create(3, NULL, away, &place));
  rg_pair pair = {rod, pose, ball, place};
  CHECK(fabs(distance_of(solver, &pair) - 3.5) < 1e-5);
  OK(rg_pose_assign(pose, turn, o)); /* the rod now points to the ball */
  CHECK(fabs(distance_of(solver, &pair) - 1.5) < 1e-5);
  OK(rg_pose_assign(place, (const double[9]){1, 0, 0, 0, 1, 0, 0, 0, 1}, near));
  CHECK(fabs(distance_of(solver, &pair) - 0.5) < 1e-5);
  OK(rg_pose_assign_quaternion(pose, half_turn, o)); /* and now down */
  CHECK(fabs(distance_of(solver, &pair) - 2.5) < 1e-5);

  /* A refused assignment leaves the pose as it was. */
  const double shear[9] = {1, 1, 0, 0, 1, 0, 0, 0, 1}, lost[3] = {0, NAN, 0}, none[4] = {0, 0, 0, 0};
  REFUSED(rg_pose_assign(pose, shear, o), RG_INVALID_PARAMETER, "R");
  REFUSED(rg_pose_assign(pose, turn, lost), RG_NON_FINITE, "t");
  REFUSED(rg_pose_assign(pose, NULL, o), RG_INVALID_PARAMETER, "R is a null pointer");
  REFUSED(rg_pose_assign_quaternion(pose, none, o), RG_INVALID_PARAMETER, "q");
  CHECK(fabs(distance_of(solver, &pair) - 2.5) < 1e-5);
  REFUSED(rg_pose_create(0, NULL, NULL, &pose), RG_INVALID_PARAMETER, "n must lie in");
  REFUSED(rg_pose_create(3, NULL, NULL, NULL), RG_INVALID_PARAMETER, "pose is a null pointer");
  REFUSED(rg_pose_create(3, shear, NULL, &pose), RG_INVALID_PARAMETER, "R");

  rg_pose* plane = NULL;
  OK(rg_pose_create(2, NULL, NULL, &plane));
  REFUSED(rg_pose_assign_quaternion(plane, half_turn, o), RG_DIMENSION_MISMATCH, "the pose is of R^2");
  rg_answer answer = {0};
  rg_pair misfit = {rod, plane, ball, NULL};
  REFUSED(rg_object_distance(solver, &misfit, NULL, 0, NULL, &answer), RG_DIMENSION_MISMATCH,
          "the pose is of R^2");

  /* Beyond R^3 the same. */
  double turn_5[25] = {0}, t_5[5] = {0, 0, 0, 0, 3}, zero_5[5] = {0};
  for (int k = 0; k < 5; ++k) turn_5[5 * k + (k + 1) % 5] = 1;
  rg_pose* five = NULL;
  rg_set* ball_5 = NULL;
  OK(rg_pose_create(5, turn_5, t_5, &five));
  OK(rg_set_ball(5, zero_5, 1, &ball_5));
  const rg_pair pair_5 = {ball_5, NULL, ball_5, five};
  CHECK(fabs(distance_of(solver, &pair_5) - 1) < 1e-5);

  rg_pose_free(NULL);
  rg_pose_free(five);
  rg_pose_free(plane);
  rg_pose_free(place);
  rg_pose_free(pose);
  rg_set_free(ball_5);
  rg_set_free(ball);
  rg_set_free(rod);
  rg_solver_free(solver);
}
