// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The C++ side of bench/python_calls.py: raygauge_python_calls POINTS N n K. POINTS holds K pairs of sets as
// raw doubles, A then Q, N points of n coordinates each. For every line of standard input it solves what the
// line says and prints the CPU seconds that it took: "call" solves the first pair 2000 times, "batch" every
// pair once. As the package does, it makes the sets from the arrays each time.
#include <ctime>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "raygauge/queries/solver.h"
#include "raygauge/sets/point_set.h"

namespace {

using namespace raygauge;

constexpr int kCalls = 2000;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Problems {
  std::vector<double> points;
  int N = 0;
  int n = 0;
  std::ptrdiff_t count = 0;

  PointSet set(std::ptrdiff_t index) const {
    return PointSet(Eigen::Map<const Eigen::MatrixXd>(points.data() + index * N * n, n, N));
  }
};

/// Solves problem k; what it answers is added up, so that it is not optimised away.
void solve(const Problems& problems, std::ptrdiff_t k, DistanceSolver& solver, double& sum) {
  const PointSet A = problems.set(2 * k);
  const PointSet Q = problems.set(2 * k + 1);
  sum += solver.solve(A, Q).distance;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::cerr << "usage: raygauge_python_calls POINTS N n K\n";
    return 2;
  }
  Problems problems{{}, std::stoi(argv[2]), std::stoi(argv[3]), std::stol(argv[4])};
  problems.points.resize(static_cast<std::size_t>(2 * problems.count * problems.N * problems.n));
  std::ifstream file(argv[1], std::ios::binary);
  file.read(reinterpret_cast<char*>(problems.points.data()),
            static_cast<std::streamsize>(problems.points.size() * sizeof(double)));
  DistanceOptions options;
  options.tolerance = 1e-9;
  DistanceSolver solver(options);
  double sum = 0;
  for (std::string line; std::getline(std::cin, line);) {
    const double start = cpu_seconds();
    if (line == "call") {
      for (int i = 0; i < kCalls; ++i) solve(problems, 0, solver, sum);
    } else {
      for (std::ptrdiff_t k = 0; k < problems.count; ++k) solve(problems, k, solver, sum);
    }
    std::cout << cpu_seconds() - start << ' ' << sum << std::endl;
  }
  return file ? 0 : 1;
}
