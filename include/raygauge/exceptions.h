// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace raygauge {

/// Base of every exception that raygauge throws. Exceptions report a caller's mistake; a numerical outcome
/// (unreachable, precision limit, …) is a DistanceStatus instead.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Two objects that must live in the same R^n do not.
class DimensionMismatchError : public Error {
 public:
  using Error::Error;
};

/// A NaN or an infinity where a finite number is required.
class NonFiniteError : public Error {
 public:
  using Error::Error;
};

/// A set without a single point.
class EmptySetError : public Error {
 public:
  using Error::Error;
};

/// A parameter outside its documented range; the message names the parameter, the value and the range.
class InvalidParameterError : public Error {
 public:
  using Error::Error;
};

/// A name (method, generator, parameter, key, …) that nothing is registered under. The message lists the
/// known names and suggests the nearest one.
class UnknownNameError : public Error {
 public:
  /// `kind` is the kind of name ("method"), `place` says where the name stood (may be "").
  UnknownNameError(const std::string& kind, const std::string& name, const std::vector<std::string>& known,
                   const std::string& place = "");
};

/// The known name with the smallest edit distance to `name`; empty if none is close enough.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

}  // namespace raygauge
