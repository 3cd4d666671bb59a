// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <mutex>
#include <string>

namespace raygauge::python {

/// What the threads of a sweep share of the interpreter: whose turn it is, and the first exception of a
/// user's function.
///
/// Functions of the user are called by one thread at a time. The interpreter's lock alone would not do: it
/// changes hands every 5 ms, in the middle of a sample, and a time would hold another function's work.
class Interpreter {
 public:
  /// `describe(component, exception)` gives the one line of an error. With the lock held.
  explicit Interpreter(pybind11::object describe) : describe_(std::move(describe)) {}

  /// This thread's turn, with the interpreter's lock; to be taken without it. Turns of a thread nest.
  class Turn {
   public:
    explicit Turn(Interpreter& interpreter) : turn_(interpreter.mutex_) {}

   private:
    std::unique_lock<std::recursive_mutex> turn_;
    pybind11::gil_scoped_acquire lock_;
  };

  /// Calls `function` in its turn. What Python raises becomes an Error that names `component`.
  void call(const pybind11::object& component, const std::function<void()>& function);

  /// The first exception that Python raised, or None. With the lock held.
  pybind11::object first_exception() const { return first_exception_; }

 private:
  std::recursive_mutex mutex_;
  pybind11::object describe_;
  pybind11::object first_exception_ = pybind11::none();
};

/// A Python object that any thread may drop.
class SharedObject {
 public:
  explicit SharedObject(pybind11::object object) : object_(std::move(object)) {}
  ~SharedObject() {
    const pybind11::gil_scoped_acquire lock;
    object_.release().dec_ref();
  }
  SharedObject(const SharedObject& other) {
    const pybind11::gil_scoped_acquire lock;
    object_ = other.object_;
  }
  SharedObject& operator=(const SharedObject&) = delete;

  const pybind11::object& operator*() const noexcept { return object_; }
  const pybind11::object* operator->() const noexcept { return &object_; }

 private:
  pybind11::object object_;
};

}  // namespace raygauge::python
