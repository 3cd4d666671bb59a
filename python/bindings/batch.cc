// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <atomic>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "python/bindings/arrays.h"
#include "python/bindings/batch_docs.h"
#include "python/bindings/bindings.h"
#include "python/bindings/distance_batch.h"
#include "python/bindings/interrupt.h"
#include "python/bindings/poses.h"
#include "python/bindings/solving.h"
#include "python/bindings/workers.h"
#include "raygauge/exceptions.h"
#include "raygauge/queries/solver.h"

namespace raygauge::python {
namespace {

using py::literals::operator""_a;

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

/// Where the threads of a batch write: the arrays' memory.
struct BatchOutput {
  double* distance;
  double* lower;
  double* upper;
  std::int8_t* status;
  double* normal;
  double* contact;
  std::int64_t* pivots;
  int n;

  BatchOutput(DistanceBatch& batch, int dimension)
      : distance(batch.distance.mutable_data()),
        lower(batch.lower.mutable_data()),
        upper(batch.upper.mutable_data()),
        status(batch.status_code.mutable_data()),
        normal(batch.normal.mutable_data()),
        contact(batch.contact_data),
        pivots(batch.pivots.mutable_data()),
        n(dimension) {}

  void store(std::ptrdiff_t k, const DistanceResult& result) const {
    distance[k] = result.distance;
    lower[k] = result.lower;
    upper[k] = result.upper;
    status[k] = static_cast<std::int8_t>(result.status);
    pivots[k] = result.counters.pivots;
    store_vector(result.normal, normal + k * n);
    if (contact != nullptr) store_vector(result.contact_point, contact + k * n);
  }

 private:
  void store_vector(const Vector& vector, double* row) const {
    Eigen::Map<Eigen::VectorXd> target(row, n);
    if (vector.size() == n) {
      target = vector;
    } else {
      target.setConstant(DistanceResult::kUnset);
    }
  }
};

/// Throws the same kind of error, which says in which problem it arose.
template <class Function>
void naming_problem(std::ptrdiff_t k, const Function& function) {
  const auto text = [k](const Error& error) { return "problem " + std::to_string(k) + ": " + error.what(); };
  try {
    function();
  } catch (const DimensionMismatchError& error) {
    throw DimensionMismatchError(text(error));
  } catch (const NonFiniteError& error) {
    throw NonFiniteError(text(error));
  } catch (const EmptySetError& error) {
    throw EmptySetError(text(error));
  } catch (const InvalidParameterError& error) {
    throw InvalidParameterError(text(error));
  }
}

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

/// K, on which everything that has an axis of problems must agree.
std::ptrdiff_t problem_count(const BatchSide& A, const BatchSide& Q) {
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
        "A, Q: one of them is to have an axis of problems, as an array of shape (K, N, n), a list of sets or "
        "poses; distance() answers a single problem");
  }
  return *count;
}

/// What all threads of a batch read.
struct BatchTask {
  const BatchSide& A;
  const BatchSide& Q;
  const DistanceOptions& options;
  const BatchOutput& output;
  const std::atomic<bool>& stop;
  std::atomic<bool>& replaced;  ///< whether a rotation was
  Effects effects = Effects::none;
  bool along_path = false;
};

/// Problem k, without the interpreter's lock. `warm` is what the problem before it left, or nullptr.
void solve_problem(const BatchTask& task, std::ptrdiff_t k, DistanceSolver& solver, WarmStart* warm) {
  const SetPointer object = task.A.operand.set(k);
  const SetPointer gauge = task.Q.operand.set(k);
  if (!task.A.poses.given() && !task.Q.poses.given() && warm == nullptr) {
    task.output.store(k, solver.solve(*object, *gauge, task.effects));
    return;
  }
  const std::optional<Pose> object_pose = task.A.poses.pose(k);
  const std::optional<Pose> gauge_pose = task.Q.poses.pose(k);
  for (const auto* pose : {&object_pose, &gauge_pose}) {
    if (*pose && (*pose)->replaced() > 0) task.replaced.store(true, std::memory_order_relaxed);
  }
  task.output.store(k,
                    solver.solve(posed(*object, object_pose), posed(*gauge, gauge_pose), task.effects, warm));
}

/// The work of one thread. Along a path the first of each row of items starts cold: which thread has it does
/// not change an answer.
void work_on(const BatchTask& task, const std::function<std::ptrdiff_t()>& next) {
  DistanceSolver solver(task.options);
  solver.set_stop([&task] { return task.stop.load(std::memory_order_relaxed); });
  WarmStart warm;
  for (std::ptrdiff_t k = next(); k >= 0; k = next()) {
    if (k % kItemsAtOnce == 0) warm.clear();
    naming_problem(k, [&] { solve_problem(task, k, solver, task.along_path ? &warm : nullptr); });
  }
}

DistanceBatch distances(const SetsLike& A, const SetsLike& Q, double tolerance, const std::string& method,
                        const PoseLike& poses_A, const PoseLike& poses_Q, bool witness, bool along_path,
                        double time_limit, int threads) {
  const BatchSide a(A, "A", poses_A, "poses_A");
  const BatchSide q(Q, "Q", poses_Q, "poses_Q");
  const DistanceOptions options = options_of(method, tolerance, time_limit);
  const std::ptrdiff_t count = problem_count(a, q);
  const int team = batch_threads(threads, count);
  const int n = a.operand.dimension();
  if (n != q.operand.dimension()) {
    throw DimensionMismatchError("A has n = " + std::to_string(n) +
                                 ", Q has n = " + std::to_string(q.operand.dimension()));
  }
  DistanceBatch batch(count, n, witness);
  const BatchOutput output(batch, n);
  std::atomic<bool> stop = false, replaced = false;
  const Effects effects = witness ? Effects::witness : Effects::none;
  const BatchTask task{a, q, options, output, stop, replaced, effects, along_path};
  run_interruptibly(
      stop, [&] { share_items(count, team, stop, [&task](const auto& next) { work_on(task, next); }); });
  if (replaced) warn_of_replaced_rotation();
  return batch;
}

}  // namespace

void bind_batches(py::module_& module) {
  bind_distance_batch(module);
  module.def("distances", &distances, kDistancesDoc, "A"_a, "Q"_a,
             "tolerance"_a = DistanceOptions().tolerance, "method"_a = "automatic", py::kw_only(),
             "poses_A"_a = py::none(), "poses_Q"_a = py::none(), "witness"_a = false, "along_path"_a = false,
             "time_limit"_a = std::numeric_limits<double>::infinity(), "threads"_a = 0);
}

}  // namespace raygauge::python
