// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <new>
#include <utility>
#include <vector>

namespace raygauge {

/// A dense vector or matrix of Eigen's type `Plain` whose numbers are in a std::vector. It can be used in
/// every Eigen expression, and converts to `Plain` and to Eigen::Ref. Eigen's own matrices use an allocator
/// that depends on compiler flags (-march=native, -fsanitize=address); with std::vector, library and caller
/// may be compiled with different flags.
template <class Plain>
class Dense : public Eigen::Map<Plain> {
  using View = Eigen::Map<Plain>;

 public:
  using Index = Eigen::Index;

  Dense() : View(nullptr, 0, Plain::ColsAtCompileTime == 1 ? 1 : 0) {}

  /// rows × cols numbers, all zero. Vectors have one column.
  explicit Dense(Index rows, Index cols = 1) : View(nullptr, 0, cols), storage_(rows * cols) {
    point_at(rows, cols);
  }

  /// The values of any expression of Eigen.
  template <class Expression>
  Dense(const Eigen::EigenBase<Expression>& values)  // NOLINT: converts, as Eigen does
      : Dense(rows_of(values), cols_of(values)) {
    View::operator=(values.derived());
  }
  /// Rows of numbers; of a vector, its numbers: Vector({{1, 2, 3}}).
  Dense(const std::initializer_list<std::initializer_list<double>>& values) : Dense(Plain(values)) {}
  Dense(const Dense& other) : View(nullptr, 0, other.cols()), storage_(other.storage_) {
    point_at(other.rows(), other.cols());
  }
  Dense(Dense&& other) noexcept : Dense() { swap(other); }
  ~Dense() = default;

  Dense& operator=(const Dense& other) {
    if (this != &other) {
      resize(other.rows(), other.cols());
      View::operator=(other);
    }
    return *this;
  }
  Dense& operator=(Dense&& other) noexcept {
    swap(other);
    return *this;
  }

  /// An expression of the same size is written in place, by Eigen's rules for aliasing. An expression of
  /// another size may refer to the old values.
  template <class Expression>
  Dense& operator=(const Eigen::EigenBase<Expression>& values) {
    if (rows_of(values) == this->rows() && cols_of(values) == this->cols()) {
      View::operator=(values.derived());
    } else {
      *this = Dense(values);
    }
    return *this;
  }

  /// Keeps no value unless the size stays as it is.
  void resize(Index rows, Index cols = 1) {
    if (rows == this->rows() && cols == this->cols()) return;
    storage_.resize(rows * cols);
    point_at(rows, cols);
  }

  using View::setZero;
  Dense& setZero(Index rows, Index cols = 1) {
    resize(rows, cols);
    View::setZero();
    return *this;
  }

  void swap(Dense& other) noexcept {
    const Index rows = this->rows(), cols = this->cols();
    const Index other_rows = other.rows(), other_cols = other.cols();
    storage_.swap(other.storage_);
    point_at(other_rows, other_cols);
    other.point_at(rows, cols);
  }
  friend void swap(Dense& a, Dense& b) noexcept { a.swap(b); }

  static Eigen::Map<const Plain> Map(const double* values, Index size) { return {values, size}; }
  static Eigen::Map<Plain> Map(double* values, Index size) { return {values, size}; }
  static Eigen::Map<const Plain> Map(const double* values, Index rows, Index cols) {
    return {values, rows, cols};
  }
  static Eigen::Map<Plain> Map(double* values, Index rows, Index cols) { return {values, rows, cols}; }

 private:
  // The shape that values have here: a row becomes a column where this is a vector, as in Eigen.
  static constexpr bool kVector = Plain::ColsAtCompileTime == 1;
  template <class Expression>
  static Index rows_of(const Eigen::EigenBase<Expression>& values) {
    return kVector ? values.size() : values.rows();
  }
  template <class Expression>
  static Index cols_of(const Eigen::EigenBase<Expression>& values) {
    return kVector ? 1 : values.cols();
  }

  // Eigen's documented way to make a Map refer to other memory.
  void point_at(Index rows, Index cols) noexcept {
    ::new (static_cast<View*>(this)) View(storage_.data(), rows, cols);
  }

  std::vector<double> storage_;
};

using Vector = Dense<Eigen::VectorXd>;
using DenseMatrix = Dense<Eigen::MatrixXd>;

}  // namespace raygauge
