/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT */
#ifndef RAYGAUGE_OCTAVE_SETS_H
#define RAYGAUGE_OCTAVE_SETS_H

#include <mex.h>
#include <raygauge/raygauge_c.h>

/* What one call makes, to be freed at its end: Octave's errors jump over the rest of a function. */
typedef struct Call {
  rg_set** sets;
  size_t count, capacity;
  rg_solver* solver;
  rg_batch* batch;
  rg_pose* poses[2];
  rg_robot* robot;
  rg_checker* checker;
  rg_warm* warm;
  const mxArray* stop; /* the function of the option 'stop' */
  int stop_failed;
} Call;

/* Frees what the call made. */
void end_call(Call* call);

/* Ends the call by an Octave error: identifier "raygauge:RG_..." and a message. Does not return. */
void refuse(Call* call, rg_error error, const char* message);

/* Goes on if there is no error; otherwise ends the call with the library's message. */
void check(Call* call, rg_error error);

/* The numbers of a real full array of doubles. Ends the call for anything else. */
const double* numbers_of(Call* call, const mxArray* array, const char* name);

/* The same for one number. */
double number_of(Call* call, const mxArray* array, const char* name);

/* The same for a whole number of moderate size, as counts and dimensions are. */
int32_t whole(Call* call, const mxArray* array, const char* name);
int32_t whole_number(Call* call, double value, const char* name);

/* n numbers, a row or a column. */
const double* vector_of(Call* call, const mxArray* array, size_t n, const char* name);

/* The set that a value of Octave's stands for: what rg_set returns, or a matrix of points, one a column. */
const rg_set* set_of(Call* call, const mxArray* value);

#endif
