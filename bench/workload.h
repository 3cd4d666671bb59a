// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "raygauge/sets/point_set.h"
#include "raygauge/sweep/instance.h"
#include "raygauge/sweep/method.h"

namespace raygauge::bench {

/// A kind of instance: a generator with its parameters.
struct Variant {
  std::string name;
  std::string generator;
  Parameters parameters;
};

/// "random", "clustered", "needle" (aspect 1e4), "far" (separation 50) and "near" (1 + 1e-6).
const std::vector<Variant>& variants();

/// Integer instances with degenerate optima: "ties", "ties sheared", "origin on a face", "on a face sheared",
/// "origin inside", "inside sheared", "unreachable" and "unreachable sheared".
const std::vector<Variant>& planted_variants();

/// Of both. Throws UnknownNameError.
const Variant& find_variant(const std::string& name);

Instance make_instance(const Variant& variant, int n, int N, int repetition);

/// The instance's sets as point sets, which those of every variant are.
const PointSet& points_A(const Instance& instance);
const PointSet& points_Q(const Instance& instance);

/// "column_generation", "zheng_yamane" and the linear-programming solvers of this build.
std::unique_ptr<SolveMethod> make_method(const std::string& name, const Parameters& parameters = {});

/// Whether this build has a method of that name.
bool has_method(const std::string& name);

/// Those of glpk_primal, glpk_dual, clp_primal and clp_dual that this build has.
std::vector<std::string> lp_methods();

}  // namespace raygauge::bench
