/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT */
#include "answers.h"

#include <math.h>
#include <string.h>

mxArray* column(const double* values, size_t n) {
  mxArray* array = mxCreateDoubleMatrix(n, 1, mxREAL);
  if (n > 0) memcpy(mxGetPr(array), values, n * sizeof *values);
  return array;
}

mxArray* vector_or_empty(Call* call, int32_t which, int32_t n) {
  double* values = mxCalloc((size_t)n, sizeof *values);
  check(call, rg_solver_vector(call->solver, which, n, values));
  return isnan(values[0]) ? mxCreateDoubleMatrix(0, 0, mxREAL) : column(values, (size_t)n);
}

void put(mxArray* result, const char* name, mxArray* value) {
  mxAddField(result, name);
  mxSetField(result, 0, name, value);
}

mxArray* struct_of(const rg_answer* answer) {
  mxArray* result = mxCreateStructMatrix(1, 1, 0, NULL);
  put(result, "distance", mxCreateDoubleScalar(answer->distance));
  put(result, "lower", mxCreateDoubleScalar(answer->lower));
  put(result, "upper", mxCreateDoubleScalar(answer->upper));
  put(result, "status", mxCreateString(rg_status_name(answer->status)));
  return result;
}
