// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/poses.h"
#include "python/bindings/solving.h"
#include "raygauge/exceptions.h"
#include "raygauge/methods/result.h"
#include "raygauge/queries/pair_batch.h"

namespace raygauge::python {

/// One operand of a batch: a set that all problems share, or one for each problem.
class BatchOperand {
 public:
  BatchOperand(py::handle object, const char* name) : name_(name) {
    if (is_list_of_sets(object)) {
      read_list(object);
    } else if (py::isinstance<ConvexSet>(object)) {
      shared_ = as_set(object, name);
      dimension_ = shared_->dimension();
    } else {
      read_array(object);
    }
  }

  /// The number of problems it is of; 0 where all share it.
  std::ptrdiff_t count() const noexcept { return count_; }
  bool is_shared() const noexcept { return shared_ != nullptr; }
  int dimension() const noexcept { return dimension_; }

  /// K numbers for each coordinate, one problem after the other, where each has one point; else nullptr.
  const double* single_points() const noexcept { return size_ == 1 ? points_ : nullptr; }

  /// The set of problem k; without the interpreter's lock.
  SetPointer set(std::ptrdiff_t k) const {
    if (shared_) return shared_;
    if (!sets_.empty()) return sets_[static_cast<std::size_t>(k)];
    return point_set_of_rows(points_ + k * size_ * dimension_, size_, dimension_);
  }

 private:
  static bool is_list_of_sets(py::handle object) {
    if (!PyList_Check(object.ptr()) && !PyTuple_Check(object.ptr())) return false;
    for (const py::handle member : object) {
      if (py::isinstance<ConvexSet>(member) || py::isinstance<py::array>(member)) return true;
    }
    return false;
  }

  void read_list(py::handle object) {
    for (const py::handle member : object) {
      const std::string name = std::string(name_) + "[" + std::to_string(sets_.size()) + "]";
      sets_.push_back(as_set(member, name.c_str()));
    }
    count_ = static_cast<std::ptrdiff_t>(sets_.size());
    dimension_ = sets_.front()->dimension();
  }

  void read_array(py::handle object) {
    array_ = as_doubles(object, name_);
    if (array_->ndim() != 3) {
      shared_ = as_set(*array_, name_);
      dimension_ = shared_->dimension();
      return;
    }
    count_ = array_->shape(0);
    size_ = array_->shape(1);
    dimension_ = as_dimension(array_->shape(2), name_);
    points_ = array_->data();
  }

  const char* name_;
  SetPointer shared_;
  std::vector<SetPointer> sets_;
  std::optional<py::array_t<double, py::array::c_style>> array_;
  const double* points_ = nullptr;
  std::ptrdiff_t count_ = 0;
  std::ptrdiff_t size_ = 0;
  int dimension_ = 0;
};

/// Poses of a batch, one for each problem, or none at all.
class BatchPoses {
 public:
  BatchPoses(py::handle object, int n, const char* name) : name_(name), n_(n) {
    if (object.is_none()) return;
    matrices_ = as_doubles(object, name);
    const bool fits = matrices_->ndim() == 3 && matrices_->shape(1) == n + 1 && matrices_->shape(2) == n + 1;
    if (!fits) {
      const std::string size = std::to_string(n + 1);
      throw DimensionMismatchError(std::string(name) + ": homogeneous matrices of shape (K, " + size + ", " +
                                   size + ") are needed, got " + described(object));
    }
    data_ = matrices_->data();
  }

  bool given() const noexcept { return matrices_.has_value(); }
  std::ptrdiff_t count() const noexcept { return given() ? matrices_->shape(0) : 0; }

  /// The pose of problem k; without the interpreter's lock.
  std::optional<Pose> pose(std::ptrdiff_t k) const {
    if (!given()) return std::nullopt;
    return pose_of_rows(data_ + k * (n_ + 1) * (n_ + 1), n_, name_);
  }

 private:
  const char* name_;
  int n_;
  std::optional<py::array_t<double, py::array::c_style>> matrices_;
  const double* data_ = nullptr;
};

/// One side of a batch: sets and their poses.
struct BatchSide {
  BatchSide(py::handle sets, const char* sets_name, py::handle matrices, const char* poses_name)
      : operand(sets, sets_name),
        poses(matrices, operand.dimension(), poses_name),
        name(sets_name),
        pose_name(poses_name) {}

  BatchOperand operand;
  BatchPoses poses;
  const char* name;
  const char* pose_name;
};

/// K, on which everything that has an axis of problems must agree; `single` is the function for one problem.
inline std::ptrdiff_t problem_count(const BatchSide& A, const BatchSide& Q, const char* single) {
  std::optional<std::ptrdiff_t> count;
  std::string first;
  const auto agree = [&](bool has_axis, std::ptrdiff_t problems, const char* name) {
    if (!has_axis) return;
    if (count && *count != problems) {
      throw DimensionMismatchError(first + " holds " + std::to_string(*count) + " problems, " + name + " " +
                                   std::to_string(problems));
    }
    count = problems;
    first = name;
  };
  for (const BatchSide* side : {&A, &Q}) {
    agree(!side->operand.is_shared(), side->operand.count(), side->name);
    agree(side->poses.given(), side->poses.count(), side->pose_name);
  }
  if (!count) {
    throw InvalidParameterError(
        std::string(A.name) + ", " + Q.name +
        ": one of them is to have an axis of problems, as an array of shape (K, N, n), a list of sets or "
        "poses; " +
        single + " answers a single problem");
  }
  return *count;
}

/// The pairs of a batch for PairBatch, whose threads ask for them without the interpreter's lock. What is
/// made for a pair, a set of rows of an array or a pose, has one place a thread.
class BatchPairs {
 public:
  BatchPairs(const BatchSide& first, const BatchSide& second, int threads)
      : first_(first), second_(second), places_(static_cast<std::size_t>(threads)) {}

  /// To be called while this object lives.
  PairSource source() {
    return [this](std::size_t k, int thread) {
      Place& place = places_[static_cast<std::size_t>(thread)];
      place.first.set.reset();  // both before either is made: its memory, still in the cache, serves again
      place.second.set.reset();
      return PosedPair{place.first.posed(first_, k, replaced_), place.second.posed(second_, k, replaced_)};
    };
  }

  /// Whether a rotation was replaced by the nearest one.
  bool replaced() const noexcept { return replaced_; }

 private:
  struct Body {
    SetPointer set;
    std::optional<Pose> pose;

    Posed posed(const BatchSide& side, std::size_t k, std::atomic<bool>& replaced) {
      const auto problem = static_cast<std::ptrdiff_t>(k);
      set = side.operand.set(problem);
      pose = side.poses.pose(problem);
      if (pose && pose->replaced() > 0) replaced.store(true, std::memory_order_relaxed);
      return python::posed(*set, pose);
    }
  };
  struct alignas(64) Place {
    Body first, second;
  };

  const BatchSide& first_;
  const BatchSide& second_;
  std::vector<Place> places_;
  std::atomic<bool> replaced_ = false;
};

/// The memory of an array of int8, as the statuses whose numbers it is to hold.
inline std::span<DistanceStatus> statuses(py::array_t<std::int8_t>& numbers) {
  static_assert(sizeof(DistanceStatus) == 1);
  return {reinterpret_cast<DistanceStatus*>(numbers.mutable_data()),
          static_cast<std::size_t>(numbers.size())};
}

/// All numbers of an array.
template <class T>
std::span<T> numbers_of(py::array_t<T>& array) {
  return {array.mutable_data(), static_cast<std::size_t>(array.size())};
}

}  // namespace raygauge::python
