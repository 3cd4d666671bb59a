// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "raygauge/sets/convex_set.h"

namespace raygauge::cli {

using SetPointer = std::shared_ptr<const ConvexSet>;

/// The values that a set file gives the parameters of one shape, by name. Each function throws Error, naming
/// file, line and key, for a value that is missing or of another type.
class ShapeValues {
 public:
  virtual ~ShapeValues() = default;
  ShapeValues() = default;
  ShapeValues(const ShapeValues&) = delete;
  ShapeValues& operator=(const ShapeValues&) = delete;

  virtual double number(const std::string& name) const = 0;
  virtual Vector vector(const std::string& name) const = 0;
  virtual Eigen::MatrixXd matrix(const std::string& name) const = 0;
  virtual SetPointer set(const std::string& name) const = 0;
  virtual std::vector<SetPointer> sets(const std::string& name) const = 0;
  virtual SetPointer file(const std::string& name) const = 0;
  virtual std::string text(const std::string& name) const = 0;

  /// The name of a file, with the folder that it starts at.
  virtual std::string path(const std::string& name) const = 0;
};

/// What the table of shapes says of one parameter.
struct ShapeParameter {
  std::string name;                  ///< that of the constructor in engine/sets, and the key in a set file
  std::string type;                  ///< "a number", "a vector", …
  std::string description;           ///< "" where the name says it
  std::optional<double> usual = {};  ///< of a number that need not be given
};

/// A convex set that a set file can describe.
struct Shape {
  std::string name;
  std::string description;
  std::vector<ShapeParameter> parameters;

  /// The parameter of that name, which must be one.
  const ShapeParameter& parameter(const std::string& parameter_name) const;

  /// Reads the values of the parameters, in their order; what it returns then makes the set, and throws Error
  /// where the engine refuses them.
  std::function<std::function<SetPointer()>(const ShapeValues&)> bind;
};

/// Every shape of this program; shapes.cc is the one place to add another.
const std::vector<Shape>& shapes();

/// The shape of that name. Throws UnknownNameError; `place` is where the name stands.
const Shape& find_shape(const std::string& name, const std::string& place);

}  // namespace raygauge::cli
