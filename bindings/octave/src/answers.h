/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT */
#ifndef RAYGAUGE_OCTAVE_ANSWERS_H
#define RAYGAUGE_OCTAVE_ANSWERS_H

#include "sets.h"

/* What a query answers, as values of Octave's. */
mxArray* column(const double* values, size_t n);

/* The vector of the last query, or [] where there is none. */
mxArray* vector_or_empty(Call* call, int32_t which, int32_t n);

/* A struct of distance, lower, upper and status. */
mxArray* struct_of(const rg_answer* answer);

/* Adds a field to a struct. */
void put(mxArray* result, const char* name, mxArray* value);

/* Queries of files of their own: arguments as Octave gave them. */
mxArray* object_distance_along(Call* call, int count, const mxArray* const* values);
mxArray* prove_motion(Call* call, int count, const mxArray* const* values);

#endif
