// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include "python/sweeps/turn.h"
#include "raygauge/sweep/instance.h"
#include "raygauge/sweep/method.h"

namespace raygauge::python {

// Each adds what @rg.method or @rg.generator has registered: an object of the class Component of
// raygauge/components.py. `interpreter` outlives the registry and what it makes. With the lock held.
void add_python_method(MethodRegistry& registry, Interpreter& interpreter, pybind11::object component,
                       const pybind11::object& answer_of);
void add_python_generator(GeneratorRegistry& registry, Interpreter& interpreter, pybind11::object component);

/// time_solve, which for a method in Python has one turn for the whole sample.
TimedSolve time_in_turn(Interpreter& interpreter, SolveMethod& method, const SolveRequest& request,
                        double min_seconds);

}  // namespace raygauge::python
