// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "bench/workload.h"

#include <algorithm>
#include <cstdint>

#include "baselines/registry.h"
#include "generators/registry.h"

namespace raygauge::bench {
namespace {

const GeneratorRegistry& generators() {
  static const GeneratorRegistry registry = [] {
    GeneratorRegistry all("generator");
    register_generators(all);
    return all;
  }();
  return registry;
}

const MethodRegistry& methods() {
  static const MethodRegistry registry = [] {
    MethodRegistry all("method");
    register_engine_methods(all);
    register_baselines(all);
    return all;
  }();
  return registry;
}

}  // namespace

const std::vector<Variant>& variants() {
  static const std::vector<Variant> all = {{"random", "example2", {}},
                                           {"clustered", "clustered", {}},
                                           {"needle", "needle", {{"aspect", 1e4}}},
                                           {"far", "example2", {{"separation", 50.0}}},
                                           {"near", "example2", {{"separation", 1 + 1e-6}}}};
  return all;
}

const std::vector<Variant>& planted_variants() {
  const Parameters few = {{"ties", 0.05}};
  const Parameters none = {{"ties", 0.05}, {"entry", std::int64_t{1}}};
  const Parameters sheared = {{"ties", 0.05}, {"entry", std::int64_t{1000}}};
  const auto inside = [](Parameters parameters) {
    parameters["place"] = std::string("interior");
    return parameters;
  };
  static const std::vector<Variant> kAll = {{"ties", "hard_planted_ties", few},
                                            {"ties sheared", "hard_planted_unimodular", sheared},
                                            {"origin on a face", "hard_planted_origin", none},
                                            {"on a face sheared", "hard_planted_origin", sheared},
                                            {"origin inside", "hard_planted_origin", inside(none)},
                                            {"inside sheared", "hard_planted_origin", inside(sheared)},
                                            {"unreachable", "hard_planted_unreachable", none},
                                            {"unreachable sheared", "hard_planted_unreachable", sheared}};
  return kAll;
}

const Variant& find_variant(const std::string& name) {
  std::vector<std::string> known;
  for (const auto* some : {&variants(), &planted_variants()}) {
    for (const Variant& variant : *some) {
      if (variant.name == name) return variant;
      known.push_back(variant.name);
    }
  }
  throw UnknownNameError("variant", name, known);
}

Instance make_instance(const Variant& variant, int n, int N, int repetition) {
  return generators().make(variant.generator, variant.parameters)->generate({1, n, N, repetition});
}

const PointSet& points_A(const Instance& instance) { return dynamic_cast<const PointSet&>(*instance.A); }
const PointSet& points_Q(const Instance& instance) { return dynamic_cast<const PointSet&>(*instance.Q); }

std::unique_ptr<SolveMethod> make_method(const std::string& name, const Parameters& parameters) {
  return methods().make(name, parameters);
}

bool has_method(const std::string& name) {
  const std::vector<std::string> known = methods().names();
  return std::find(known.begin(), known.end(), name) != known.end();
}

std::vector<std::string> lp_methods() {
  std::vector<std::string> present;
  for (const char* name : {"glpk_primal", "glpk_dual", "clp_primal", "clp_dual"}) {
    if (has_method(name)) present.emplace_back(name);
  }
  return present;
}

}  // namespace raygauge::bench
