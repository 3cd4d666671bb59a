// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "raygauge/methods/options.h"
#include "raygauge/queries/solver.h"

namespace raygauge::python {

/// The method of that name. Throws UnknownNameError.
DistanceMethod method_of(std::string_view name);

/// Options of every query. Throws UnknownNameError; ranges are the solver's to
/// check.
DistanceOptions options_of(std::string_view method, double tolerance, double time_limit);

/// A solver of this thread, for the time of one call: a set of the user's own may call back into raygauge
/// while it is being solved for, and then gets another.
template <class Solver>
class Lease {
 public:
  Lease() {
    std::vector<std::unique_ptr<Solver>>& idle = idle_solvers();
    if (idle.empty()) {
      solver_ = std::make_unique<Solver>();
    } else {
      solver_ = std::move(idle.back());
      idle.pop_back();
    }
  }
  ~Lease() { idle_solvers().push_back(std::move(solver_)); }
  Lease(const Lease&) = delete;
  Lease& operator=(const Lease&) = delete;

  Solver* operator->() const noexcept { return solver_.get(); }
  Solver& operator*() const noexcept { return *solver_; }

 private:
  static std::vector<std::unique_ptr<Solver>>& idle_solvers() {
    thread_local std::vector<std::unique_ptr<Solver>> idle;
    return idle;
  }

  std::unique_ptr<Solver> solver_;
};

}  // namespace raygauge::python
