// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "engine/numerics/threshold.h"

namespace raygauge::bench {

/// A threshold of the engine that can be changed, while nothing solves.
class TunedThreshold {
 public:
  template <class Value>
  TunedThreshold(std::string name, const Threshold<Value>& threshold)
      : name_(std::move(name)),
        measured_(static_cast<double>(threshold.value_)),
        change_([&threshold](double value) { threshold.value_ = static_cast<Value>(value); }) {}

  const std::string& name() const noexcept { return name_; }
  double measured() const noexcept { return measured_; }  ///< what stands in tuning.h
  void change(double value) const { change_(value); }
  void restore() const { change_(measured_); }

 private:
  std::string name_;
  double measured_ = 0;
  std::function<void(double)> change_;
};

}  // namespace raygauge::bench
