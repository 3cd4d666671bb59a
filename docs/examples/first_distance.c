/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT

   A rod and a crate, in C: how far apart, by which points, and how deep in each other after a motion.

       cc first_distance.c $(pkg-config --cflags --libs raygauge_c) -o first_distance */
#include <raygauge/raygauge_c.h>
#include <stdio.h>
#include <stdlib.h>

/* Ends the program with the library's message if a call failed. */
static void check(rg_error error) {
  if (error == RG_OK) return;
  fprintf(stderr, "%s: %s\n", rg_error_name(error), rg_last_message());
  exit(1);
}

int main(void) {
  const double p[3] = {0, 1, 1}, q[3] = {0, 2, 3}, lower[3] = {1, 0, 0}, upper[3] = {3, 3, 4};
  rg_set *rod = NULL, *crate = NULL;
  check(rg_set_capsule(3, p, q, 0.25, &rod));
  check(rg_set_box(3, lower, upper, &crate));

  rg_solver* solver = NULL; /* one a thread: it keeps its workspace */
  check(rg_solver_create(&solver));
  check(rg_solver_set_tolerance(solver, 1e-9));

  rg_pair pair = {rod, NULL, crate, NULL}; /* no poses: both where they are */
  rg_answer answer;
  double point[3];
  check(rg_object_distance(solver, &pair, NULL, RG_CLOSEST_POINTS, NULL, &answer));
  check(rg_solver_vector(solver, RG_POINT_2, 3, point));
  printf("distance %.6f, certified to lie in [%.9f, %.9f], at x = %.3f\n", answer.distance, answer.lower,
         answer.upper, point[0]);

  const double t[3] = {1.5, 0, 0}; /* the rod moves into the crate */
  rg_pose* pose = NULL;
  check(rg_pose_create(3, NULL, t, &pose));
  pair.pose_first = pose;
  check(rg_signed_distance(solver, &pair, NULL, 0, NULL, &answer));
  check(rg_solver_vector(solver, RG_NORMAL, 3, point));
  printf("signed distance %.6f, the way out is %.3g %.3g %.3g\n", answer.distance, point[0] + 0.0,
         point[1] + 0.0, point[2] + 0.0); /* -0 + 0 is 0 */

  rg_set* never = NULL; /* what cannot be is refused */
  if (rg_set_ball(3, p, -1, &never) != RG_OK) printf("refused: %s\n", rg_last_message());

  rg_pose_free(pose);
  rg_solver_free(solver);
  rg_set_free(crate);
  rg_set_free(rod);
  return 0;
}
