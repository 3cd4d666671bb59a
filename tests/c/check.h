/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT */
#ifndef RAYGAUGE_TESTS_C_CHECK_H
#define RAYGAUGE_TESTS_C_CHECK_H

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "raygauge/raygauge_c.h"

/* What the tests of the C interface share. A check that fails is printed with its place and counted. */
extern int failed_checks;

#define CHECK(condition)                                                                \
  do {                                                                                  \
    if (!(condition)) {                                                                 \
      printf("%s:%d: %s; \"%s\"\n", __FILE__, __LINE__, #condition, rg_last_message()); \
      ++failed_checks;                                                                  \
    }                                                                                   \
  } while (0)
#define OK(call) CHECK((call) == RG_OK)
/* The call is refused with that error, and the message has these words. */
#define REFUSED(call, error, words)                    \
  do {                                                 \
    CHECK((call) == (error));                          \
    CHECK(strstr(rg_last_message(), (words)) != NULL); \
  } while (0)
/* The bounds hold the value, and their gap is as asked for. */
#define ANSWERS(answer, value, tolerance)                                                                   \
  do {                                                                                                      \
    CHECK((answer).lower <= (value) + 1e-14 * fabs(value));                                                 \
    CHECK((answer).upper >= (value)-1e-14 * fabs(value));                                                   \
    CHECK((answer).lower <= (answer).distance && (answer).distance <= (answer).upper);                      \
    CHECK((answer).upper - (answer).lower <= (tolerance)*fmax(fabs((answer).upper), fabs((answer).lower))); \
  } while (0)

/* {x : |x| <= radius} of R^3 about a point of the first axis. */
rg_set* ball_at(double x, double radius);

void test_answers(void);
void test_batches(void);
void test_options(void);
void test_poses(void);
void test_refusals(void);
void test_robots(void);
void test_sets(void);
void test_threads(void);

#endif
