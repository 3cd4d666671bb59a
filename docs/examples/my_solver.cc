// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A solver for the line: A lies on one side of 0, Q around it. c++ -O2 my_solver.cc -o my_solver
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

int main() {
  std::vector<double> A, Q;
  for (std::string word; std::cin >> word;) {
    if (word == "points") {
      std::size_t n_A = 0, n_Q = 0, n = 0;
      std::cin >> n_A >> n_Q >> n;
      A.resize(n_A * n);
      Q.resize(n_Q * n);
      for (double& x : A) std::cin >> x;
      for (double& x : Q) std::cin >> x;
      std::cout << "ready" << std::endl;
    } else {
      std::cin >> word >> word;  // tolerance and time limit
      const double nearest = *std::min_element(A.begin(), A.end());
      const double reach = *std::max_element(Q.begin(), Q.end());
      std::cout << std::setprecision(17) << nearest / reach << " u " << -1 / reach << std::endl;
    }
  }
}
