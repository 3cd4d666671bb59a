/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT

   A bar of length 1 and radius 0.1 that turns about e_3, and a ball of radius 0.2 at 0.8 e_2: at the angle q
   in [0, pi/2] they are 0.8 cos q - 0.3 apart. */
#include <stdlib.h>

#include "tests/c/check.h"

static const double o[3] = {0, 0, 0}, x[3] = {1, 0, 0};
static const rg_link turning = {-1, RG_REVOLUTE, 0, NULL, {0, 0, 1}, 1, 0};

static rg_set* bar(void) {
  rg_set* set = NULL;
  OK(rg_set_capsule(3, o, x, 0.1, &set));
  return set;
}

static rg_set* ball_ahead(void) {
  const double center[3] = {0, 0.8, 0};
  rg_set* set = NULL;
  OK(rg_set_ball(3, center, 0.2, &set));
  return set;
}

/* The bar and the ball; the handles of the sets are freed before the checker is made. */
static rg_robot* turning_bar(void) {
  rg_set *arm = bar(), *ball = ball_ahead();
  const rg_set *arms[1] = {arm}, *balls[1] = {ball};
  rg_robot* robot = NULL;
  int32_t link = -1, body = -1, obstacle = -1;
  OK(rg_robot_create(1, &robot));
  OK(rg_robot_add_link(robot, &turning, &link));
  OK(rg_robot_add_body(robot, link, 1, arms, NULL, &body));
  OK(rg_robot_add_obstacle(robot, 1, balls, NULL, &obstacle));
  CHECK(link == 0 && body == 0 && obstacle == 1);
  rg_set_free(arm);
  rg_set_free(ball);
  return robot;
}

static void edges(void) {
  const double near[2] = {0, 1.18}, over[2] = {0, 1.19}, way[3] = {-1, 0, 1.5};
  const rg_checker_options witness = {0, 0, 0, 1}, careful = {0.01, 1e-4, 100, 0};
  rg_robot* robot = turning_bar();
  rg_checker *checker = NULL, *other = NULL;
  rg_verdict v = {0}, again = {0};
  OK(rg_checker_create(robot, &witness, &checker));
  OK(rg_checker_create(robot, &careful, &other));
  rg_robot_free(robot);

  OK(rg_checker_prove(checker, 2, near, &v));
  CHECK(v.outcome == RG_EDGE_FREE && v.body_1 == -1 && isnan(v.time) && isnan(v.point_1[0]));
  OK(rg_checker_prove(other, 2, near, &v));
  CHECK(v.outcome == RG_EDGE_CONTACT);
  OK(rg_checker_prove(checker, 1, near + 1, &v));
  CHECK(v.outcome == RG_EDGE_FREE);
  OK(rg_checker_prove(checker, 2, over, &v));
  CHECK(v.outcome == RG_EDGE_CONTACT && v.body_1 == 0 && v.body_2 == 1 && v.part_1 == 0 && v.part_2 == 0);
  const double truth = 0.8 * cos(1.19 * v.time) - 0.3;
  CHECK(v.time > 0.99 && v.time <= 1 && v.upper <= 1e-6 && v.lower <= fmax(truth, 0) + 1e-12);
  CHECK(truth > 0 ? v.depth == 0 : fabs(v.depth + truth) <= 1e-6);
  CHECK(isfinite(v.point_1[0]) && isfinite(v.point_2[1]));
  OK(rg_checker_prove(checker, 3, way, &v));
  CHECK(v.outcome == RG_EDGE_CONTACT && v.time > 1.7 && v.time <= 2);
  OK(rg_checker_forget(checker));
  OK(rg_checker_prove(checker, 3, way, &again));
  OK(rg_checker_forget(checker));
  OK(rg_checker_prove(checker, 3, way, &v));
  CHECK(memcmp(&v, &again, sizeof v) == 0);

  const double never[2] = {0, INFINITY};
  v.outcome = 77;
  REFUSED(rg_checker_prove(checker, 2, never, &v), RG_NON_FINITE, "joint");
  REFUSED(rg_checker_prove(checker, 0, near, &v), RG_INVALID_PARAMETER, "count must lie in [1, ");
  REFUSED(rg_checker_prove(checker, 1, NULL, &v), RG_INVALID_PARAMETER, "configurations is a null pointer");
  REFUSED(rg_checker_prove(checker, 1, near, NULL), RG_INVALID_PARAMETER, "verdict is a null pointer");
  REFUSED(rg_checker_prove(NULL, 1, near, &v), RG_INVALID_PARAMETER, "checker is a null pointer");
  REFUSED(rg_checker_forget(NULL), RG_INVALID_PARAMETER, "checker is a null pointer");
  CHECK(v.outcome == 77);
  rg_checker_free(checker);
  rg_checker_free(other);
  rg_checker_free(NULL);
}

/* Two bars on one axis, which follow one joint there and back: they lie on each other at q = 0, and are
   joined bodies of no third one, so that they count. */
static void pairs(void) {
  const double t[3] = {0, 0, 1}, both[2] = {0.5, -0.5}, apart[2] = {0.5, 0.6};
  const rg_link fixed = {-1, RG_FIXED, 0, NULL, {0, 0, 0}, 0, 0},
                back = {-1, RG_REVOLUTE, 0, NULL, {0, 0, 1}, -1, 0};
  rg_set* arm = bar();
  const rg_set* arms[1] = {arm};
  rg_pose* above = NULL;
  rg_robot* robot = NULL;
  rg_checker* checker = NULL;
  rg_verdict v = {0};
  OK(rg_pose_create(3, NULL, t, &above));
  const rg_link lift = {0, RG_PRISMATIC, 0, above, {1, 0, 0}, 1, 5};
  OK(rg_robot_create(1, &robot));
  OK(rg_robot_add_link(robot, &fixed, NULL));
  OK(rg_robot_add_link(robot, &turning, NULL));
  OK(rg_robot_add_link(robot, &back, NULL));
  OK(rg_robot_add_link(robot, &lift, NULL));
  OK(rg_robot_add_body(robot, 1, 1, arms, NULL, NULL));
  OK(rg_robot_add_body(robot, 2, 1, arms, NULL, NULL));
  OK(rg_robot_add_body(robot, 3, 1, arms, above, NULL));
  OK(rg_robot_ignore_joined(robot));
  OK(rg_checker_create(robot, NULL, &checker));
  OK(rg_checker_prove(checker, 2, both, &v));
  CHECK(v.outcome == RG_EDGE_CONTACT && v.body_1 == 0 && v.body_2 == 1); /* they share the axis */
  rg_checker_free(checker);
  OK(rg_robot_ignore(robot, 1, 0));
  OK(rg_checker_create(robot, NULL, &checker));
  OK(rg_checker_prove(checker, 2, both, &v));
  CHECK(v.outcome == RG_EDGE_FREE); /* the third is 2 above */
  OK(rg_checker_prove(checker, 2, apart, &v));
  CHECK(v.outcome == RG_EDGE_FREE);
  rg_checker_free(checker);
  rg_robot_free(robot);
  rg_pose_free(above);
  rg_set_free(arm);
}

static void refused_links(rg_robot* robot) {
  rg_link link = turning;
  REFUSED(rg_robot_add_link(robot, NULL, NULL), RG_INVALID_PARAMETER, "link is a null pointer");
  REFUSED(rg_robot_add_link(NULL, &turning, NULL), RG_INVALID_PARAMETER, "robot is a null pointer");
  link.parent = 1;
  REFUSED(rg_robot_add_link(robot, &link, NULL), RG_INVALID_PARAMETER, "link->parent");
  link = turning, link.kind = 3;
  REFUSED(rg_robot_add_link(robot, &link, NULL), RG_INVALID_PARAMETER, "link->kind");
  link = turning, link.joint = 1;
  REFUSED(rg_robot_add_link(robot, &link, NULL), RG_INVALID_PARAMETER, "link->joint");
  link = turning, link.axis[0] = 1;
  REFUSED(rg_robot_add_link(robot, &link, NULL), RG_INVALID_PARAMETER, "length 1");
  link = turning, link.offset = NAN;
  REFUSED(rg_robot_add_link(robot, &link, NULL), RG_NON_FINITE, "offset");
  link = turning, link.scale = 0;
  REFUSED(rg_robot_add_link(robot, &link, NULL), RG_INVALID_PARAMETER, "scale");
}

static void refusals(void) {
  rg_robot *robot = NULL, *nothing = NULL;
  rg_checker* checker = NULL;
  rg_pose* flat = NULL;
  rg_set *arm = bar(), *disc = NULL;
  OK(rg_set_ball(2, o, 1, &disc));
  OK(rg_pose_create(2, NULL, NULL, &flat));
  const rg_set *arms[1] = {arm}, *hole[2] = {arm, NULL}, *discs[1] = {disc};
  REFUSED(rg_robot_create(0, &nothing), RG_INVALID_PARAMETER, "joints must lie in [1, ");
  REFUSED(rg_robot_create(1, NULL), RG_INVALID_PARAMETER, "robot is a null pointer");
  OK(rg_robot_create(1, &robot));
  OK(rg_robot_add_link(robot, &turning, NULL));
  refused_links(robot);
  REFUSED(rg_robot_add_body(robot, 1, 1, arms, NULL, NULL), RG_INVALID_PARAMETER, "link must lie in [0, 0]");
  REFUSED(rg_robot_add_body(robot, 0, 0, arms, NULL, NULL), RG_INVALID_PARAMETER, "count");
  REFUSED(rg_robot_add_body(robot, 0, 1, NULL, NULL, NULL), RG_INVALID_PARAMETER, "parts is a null pointer");
  REFUSED(rg_robot_add_body(robot, 0, 2, hole, NULL, NULL), RG_INVALID_PARAMETER, "a part is a null pointer");
  REFUSED(rg_robot_add_body(robot, 0, 1, discs, NULL, NULL), RG_DIMENSION_MISMATCH,
          "body 0: a robot lives in R^3");
  REFUSED(rg_robot_add_body(robot, 0, 1, arms, flat, NULL), RG_DIMENSION_MISMATCH, "origin: a pose of R^3");
  REFUSED(rg_robot_add_obstacle(robot, 1, discs, NULL, NULL), RG_DIMENSION_MISMATCH, "R^2");
  REFUSED(rg_robot_add_obstacle(robot, 1, arms, flat, NULL), RG_DIMENSION_MISMATCH, "pose: a pose of R^3");
  REFUSED(rg_robot_add_obstacle(NULL, 1, arms, NULL, NULL), RG_INVALID_PARAMETER, "robot is a null pointer");
  OK(rg_robot_add_obstacle(robot, 1, arms, NULL, NULL));
  REFUSED(rg_robot_add_body(robot, 0, 1, arms, NULL, NULL), RG_INVALID_PARAMETER,
          "before the first obstacle");
  REFUSED(rg_robot_ignore(robot, 0, 1), RG_INVALID_PARAMETER, "body_2 must lie in [0, 0]");
  REFUSED(rg_robot_ignore(NULL, 0, 0), RG_INVALID_PARAMETER, "robot is a null pointer");
  REFUSED(rg_robot_ignore_joined(NULL), RG_INVALID_PARAMETER, "robot is a null pointer");
  REFUSED(rg_checker_create(NULL, NULL, &checker), RG_INVALID_PARAMETER, "robot is a null pointer");
  REFUSED(rg_checker_create(robot, NULL, NULL), RG_INVALID_PARAMETER, "checker is a null pointer");
  const rg_checker_options negative = {-1, 0, 0, 0}, none = {0, 0, -1, 0}, lost = {0, NAN, 0, 0};
  REFUSED(rg_checker_create(robot, &negative, &checker), RG_INVALID_PARAMETER, "margin");
  REFUSED(rg_checker_create(robot, &none, &checker), RG_INVALID_PARAMETER, "look");
  REFUSED(rg_checker_create(robot, &lost, &checker), RG_INVALID_PARAMETER, "contact");
  CHECK(checker == NULL && nothing == NULL);
  rg_robot_free(robot);
  rg_robot_free(NULL);
  rg_pose_free(flat);
  rg_set_free(disc);
  rg_set_free(arm);
}

void test_robots(void) {
  edges();
  pairs();
  refusals();
}
