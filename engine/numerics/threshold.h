// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

namespace raygauge {

namespace bench {
class TunedThreshold;
}

/// A number that was found by measurement: it decides which of several ways is the quickest, and nothing that
/// is proven depends on it. Those of a method stand in its tuning.h; raygauge_tuning (bench/tuning_rows.cc)
/// varies each and prints what that takes, which is why it is no constant expression.
template <class Value>
class Threshold {
 public:
  explicit constexpr Threshold(Value value) noexcept : value_(value) {}

  /// It stands for one.
  operator Value() const noexcept { return value_; }  // NOLINT(google-explicit-constructor)

 private:
  friend class bench::TunedThreshold;

  mutable Value value_;
};

}  // namespace raygauge
