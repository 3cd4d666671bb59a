// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/method_look.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <tuple>

#include "analysis/render/time_unit.h"

namespace raygauge::test_method_look {
namespace {

TEST(MethodLook, OfTheProgramsOwnMethodsDiffersInGreyToo) {
  std::set<std::tuple<Marker, Dash, bool>> looks;
  std::set<std::string> colors;
  MethodList methods;
  for (const char* name : {"column_generation", "zheng_yamane", "newton"})
    methods.add({name, name, "", Role::engine});
  for (const char* name : {"glpk_primal", "glpk_dual", "clp_primal", "clp_dual", "nlopt_slsqp"})
    methods.add({name, name, "", Role::baseline});
  methods.add({"exact", "exact", "", Role::oracle});
  for (const std::string& method : methods) {
    const MethodLook look = look_of_method(method, methods);
    looks.insert({look.marker, look.dash, look.filled});
    colors.insert(look.color);
    EXPECT_NE(what_method_is(method), "") << method;
  }
  EXPECT_EQ(looks.size(), methods.size());
  EXPECT_EQ(colors.size(), methods.size());
}

bool same(const MethodLook& a, const MethodLook& b) {
  return a.color == b.color && a.dark_color == b.dark_color && a.marker == b.marker && a.dash == b.dash &&
         a.filled == b.filled;
}

TEST(MethodLook, IsThatOfTheRegisteredNameUnderAnyLabel) {
  MethodList plain;
  plain.add({"glpk_dual", "glpk_dual", "presolve=false", Role::baseline});
  plain.add({"newton", "newton", "", Role::engine});
  MethodList labelled;
  labelled.add({"ours", "newton", "", Role::engine});
  labelled.add({"zheng_yamane", "glpk_dual", "presolve=false", Role::baseline});
  EXPECT_TRUE(same(look_of_method("ours", labelled), look_of_method("newton", plain)));
  EXPECT_TRUE(same(look_of_method("zheng_yamane", labelled), look_of_method("glpk_dual", plain)));
  EXPECT_FALSE(look_of_method("zheng_yamane", labelled).filled);
}

TEST(MethodLook, OfOneMethodWithSeveralParametersDiffersWhateverTheirOrder) {
  const MethodFacts plain{"a", "glpk_dual", "presolve=false", Role::baseline};
  const MethodFacts presolved{"b", "glpk_dual", "presolve=true", Role::baseline};
  MethodList first;
  first.add(plain);
  first.add(presolved);
  MethodList last;
  last.add(presolved);
  last.add(plain);
  EXPECT_FALSE(same(look_of_method("a", first), look_of_method("b", first)));
  EXPECT_TRUE(same(look_of_method("a", first), look_of_method("a", last)));
  EXPECT_TRUE(same(look_of_method("b", first), look_of_method("b", last)));
  EXPECT_EQ(look_of_method("a", first).color, look_of_method("glpk_dual", {}).color);
}

TEST(MethodLook, IsAlikeNoOtherInTheList) {
  MethodList methods;
  for (const char* name : {"column_generation", "zheng_yamane", "newton"})
    methods.add({name, name, "", Role::engine});
  methods.add({"zheng_yamane_published", "zheng_yamane", "stop_rule=published_sigma", Role::engine});
  for (const char* name : {"glpk_primal", "glpk_dual", "clp_primal", "clp_dual", "nlopt_slsqp"})
    methods.add({name, name, "", Role::baseline});
  for (const char* label : {"a", "b", "c", "d", "e"})
    methods.add({label, "command", std::string("program=") + label, Role::baseline});
  for (const std::string& one : methods) {
    for (const std::string& other : methods) {
      if (one == other) continue;
      EXPECT_FALSE(alike(look_of_method(one, methods), look_of_method(other, methods)))
          << one << " " << other;
    }
  }
}

TEST(MethodLook, OfOneMethodUnderTwoLabelsDiffers) {
  MethodList methods;
  for (const char* label : {"mine", "yours"}) methods.add({label, "command", "program=x", Role::baseline});
  EXPECT_FALSE(same(look_of_method("mine", methods), look_of_method("yours", methods)));
}

TEST(MethodLook, OfAnUnknownLabelIsAlwaysTheSame) {
  const MethodLook look = look_of_method("my_solver", {});
  EXPECT_EQ(look.color, look_of_method("my_solver", {}).color);
  EXPECT_TRUE(look.filled);
  EXPECT_NE(look.dash, Dash::solid);
  EXPECT_EQ(what_method_is("my_solver"), "");
}

TEST(TimeUnit, FollowsTheSizeOfTheTimes) {
  EXPECT_STREQ(time_unit_for(1e-6, 1e-4).name, "µs");
  EXPECT_STREQ(time_unit_for(1e-4, 1e-1).name, "ms");
  EXPECT_STREQ(time_unit_for(1e-1, 1e2).name, "s");
}

}  // namespace
}  // namespace raygauge::test_method_look
