/* Copyright (c) 2026 The raygauge authors
   SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <string.h>

#include "answers.h"
#include "options.h"

/* Field i of a struct array; NULL where it is not there or empty. */
static const mxArray* field_of(const mxArray* value, size_t i, const char* name) {
  const mxArray* field = mxGetField(value, (mwIndex)i, name);
  return field == NULL || mxIsEmpty(field) ? NULL : field;
}

/* A whole number there; `otherwise` where there is none. */
static int32_t whole_or(Call* call, const mxArray* value, size_t i, const char* name, int32_t otherwise) {
  const mxArray* field = field_of(value, i, name);
  return field == NULL ? otherwise : whole(call, field, name);
}

static double field_or(Call* call, const mxArray* value, size_t i, const char* name, double otherwise) {
  const mxArray* field = field_of(value, i, name);
  return field == NULL ? otherwise : number_of(call, field, name);
}

/* The field `pose` of an entry; NULL where it has none. */
static const rg_pose* pose_field(Call* call, const mxArray* value, size_t i) {
  const mxArray* field = field_of(value, i, "pose");
  if (field == NULL) return NULL;
  set_pose(call, 0, field);
  return call->poses[0];
}

/* Refuses a field that nothing reads. `known` has the names of the others, each after a blank. */
static void refuse_unknown_fields(Call* call, const mxArray* value, const char* known) {
  for (int k = 0; k < mxGetNumberOfFields(value); ++k) {
    const char *name = mxGetFieldNameByNumber(value, k), *found = strstr(known, name);
    const size_t length = strlen(name);
    if (found != NULL && found[-1] == ' ' && (found[length] == ' ' || found[length] == 0)) continue;
    char text[256];
    snprintf(text, sizeof text, "robot: there is no field '%s' beside%s", name, known);
    refuse(call, RG_UNKNOWN_NAME, text);
  }
}

/* The entries of a field that holds a struct array; NULL and none where it is not there. */
static const mxArray* list_of(Call* call, const mxArray* robot, const char* name, const char* known,
                              size_t* count) {
  const mxArray* list = field_of(robot, 0, name);
  *count = list == NULL ? 0 : mxGetNumberOfElements(list);
  if (list != NULL && !mxIsStruct(list))
    refuse(call, RG_INVALID_PARAMETER, "robot: links, bodies and obstacles are struct arrays");
  if (list != NULL) refuse_unknown_fields(call, list, known);
  return list;
}

static void add_link(Call* call, const mxArray* links, size_t i) {
  static const char* const kKinds[] = {"fixed", "revolute", "prismatic"};
  char kind[16] = "";
  const mxArray *name = field_of(links, i, "kind"), *axis = field_of(links, i, "axis");
  rg_link link = {whole_or(call, links, i, "parent", 0) - 1,
                  -1,
                  whole_or(call, links, i, "joint", 0) - 1,
                  pose_field(call, links, i),
                  {0, 0, 1},
                  field_or(call, links, i, "scale", 1),
                  field_or(call, links, i, "offset", 0)};
  if (name != NULL) mxGetString(name, kind, sizeof kind);
  for (int32_t k = 0; k < 3; ++k) link.kind = strcmp(kind, kKinds[k]) == 0 ? k : link.kind;
  if (link.kind < 0) refuse(call, RG_UNKNOWN_NAME, "link: its kind is 'fixed', 'revolute' or 'prismatic'");
  if (axis != NULL) memcpy(link.axis, vector_of(call, axis, 3, "axis"), sizeof link.axis);
  check(call, rg_robot_add_link(call->robot, &link, NULL));
}

/* A body of a robot or, without links, an obstacle. */
static void add_body(Call* call, const mxArray* bodies, size_t i, int is_obstacle) {
  const mxArray* value = field_of(bodies, i, "set");
  if (value == NULL) refuse(call, RG_INVALID_PARAMETER, "body: its field 'set' is needed");
  const rg_set* part = set_of(call, value);
  const rg_pose* pose = pose_field(call, bodies, i);
  if (is_obstacle) {
    check(call, rg_robot_add_obstacle(call->robot, 1, &part, pose, NULL));
  } else {
    const int32_t link = whole_or(call, bodies, i, "link", 0) - 1;
    check(call, rg_robot_add_body(call->robot, link, 1, &part, pose, NULL));
  }
}

static void make_robot(Call* call, const mxArray* robot) {
  size_t count = 0;
  if (!mxIsStruct(robot)) refuse(call, RG_INVALID_PARAMETER, "robot: a struct is needed");
  refuse_unknown_fields(call, robot, " joints links bodies obstacles ignored");
  check(call, rg_robot_create(whole_or(call, robot, 0, "joints", 0), &call->robot));
  const mxArray* list = list_of(call, robot, "links", " parent kind joint axis pose scale offset", &count);
  for (size_t i = 0; i < count; ++i) add_link(call, list, i);
  list = list_of(call, robot, "bodies", " link set pose", &count);
  for (size_t i = 0; i < count; ++i) add_body(call, list, i, 0);
  check(call, rg_robot_ignore_joined(call->robot));
  list = list_of(call, robot, "obstacles", " set pose", &count);
  for (size_t i = 0; i < count; ++i) add_body(call, list, i, 1);
  const mxArray* ignored = field_of(robot, 0, "ignored");
  if (ignored == NULL) return;
  const double* pairs = numbers_of(call, ignored, "ignored");
  if (mxGetM(ignored) != 2)
    refuse(call, RG_DIMENSION_MISMATCH, "ignored: two rows are needed, a pair a column");
  for (size_t i = 0; i < mxGetNumberOfElements(ignored); i += 2)
    check(call, rg_robot_ignore(call->robot, whole_number(call, pairs[i], "ignored") - 1,
                                whole_number(call, pairs[i + 1], "ignored") - 1));
}

mxArray* prove_motion(Call* call, int count, const mxArray* const* values) {
  static const char* const kOutcomes[] = {"free", "contact", "undecided"};
  rg_verdict v = {0};
  if (count < 2 || count > 4) refuse(call, RG_INVALID_PARAMETER, "a robot and its configurations are needed");
  make_robot(call, values[0]);
  const rg_checker_options options = {count > 2 ? number_of(call, values[2], "margin") : 0,
                                      count > 3 ? number_of(call, values[3], "contact") : 0, 0, 1};
  check(call, rg_checker_create(call->robot, &options, &call->checker));
  const double* configurations = numbers_of(call, values[1], "configurations");
  if ((double)mxGetM(values[1]) != whole_or(call, values[0], 0, "joints", 0))
    refuse(call, RG_DIMENSION_MISMATCH, "configurations: as many rows as joints are needed");
  check(call, rg_checker_forget(call->checker));
  check(call, rg_checker_prove(call->checker, (int64_t)mxGetN(values[1]), configurations, &v));
  mxArray *result = mxCreateStructMatrix(1, 1, 0, NULL), *bodies = mxCreateDoubleMatrix(1, 2, mxREAL);
  mxGetPr(bodies)[0] = v.body_1 + 1;
  mxGetPr(bodies)[1] = v.body_2 + 1;
  put(result, "outcome", mxCreateString(kOutcomes[v.outcome]));
  put(result, "time", mxCreateDoubleScalar(v.time));
  put(result, "bodies", bodies);
  put(result, "lower", mxCreateDoubleScalar(v.lower));
  put(result, "upper", mxCreateDoubleScalar(v.upper));
  put(result, "depth", mxCreateDoubleScalar(v.depth));
  put(result, "point_1", column(v.point_1, 3));
  put(result, "point_2", column(v.point_2, 3));
  return result;
}
