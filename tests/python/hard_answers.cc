// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Writes the instances of all generators whose sets are point sets, with the answers of the engine, as text
// of exact numbers (%a): for each instance a line "generator n N_A N_Q distance lower upper status", then the
// points, one a line.
#include <cstdio>
#include <string>

#include "generators/registry.h"
#include "raygauge/exceptions.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/point_set.h"

namespace {

using namespace raygauge;

void write_points(const PointSet& set) {
  for (std::ptrdiff_t i = 0; i < set.size(); ++i) {
    const Vector point = set.point(i);
    for (int k = 0; k < set.dimension(); ++k) std::printf("%a ", point[k]);
    std::printf("\n");
  }
}

void write_instance(const std::string& name, const Instance& instance, DistanceSolver& solver) {
  const PointSet* A = as_point_set(*instance.A);
  const PointSet* Q = as_point_set(*instance.Q);
  if (A == nullptr || Q == nullptr) return;
  const DistanceResult& result = solver.solve(*A, *Q);
  std::printf("%s %d %td %td %a %a %a %s\n", name.c_str(), A->dimension(), A->size(), Q->size(),
              result.distance, result.lower, result.upper, std::string(to_string(result.status)).c_str());
  write_points(*A);
  write_points(*Q);
}

}  // namespace

int main() {
  GeneratorRegistry generators("generator");
  register_generators(generators);
  DistanceOptions options;
  options.tolerance = 1e-9;
  DistanceSolver solver(options);
  for (const std::string& name : generators.names()) {
    const auto generator = generators.make(name, {});
    for (const int n : {2, 3, 6}) {
      try {
        for (int repetition = 0; repetition < 3; ++repetition) {
          write_instance(name, generator->generate({1, n, 40, repetition}), solver);
        }
      } catch (const InvalidParameterError&) {  // the family has no member of that size
      }
    }
  }
}
