// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "raygauge/sweep/record.h"

namespace raygauge {

/// A method as the records have it: its label, and what they say of it.
struct MethodFacts {
  std::string label;
  std::string name;        ///< registered name
  std::string parameters;  ///< those of the label's first record
  Role role = Role::engine;

  /// Whether it is a competitor: a baseline or an oracle.
  bool is_competitor() const noexcept { return role != Role::engine; }
};

MethodFacts facts_of(const Record& record);

/// Methods in a fixed order, that of the first record of each. As a range it is that of their labels.
class MethodList {
 public:
  MethodList() = default;

  /// Appends a method, unless its label is there already.
  void add(MethodFacts method);

  /// A label that is not in the list is of a method of raygauge, as far as looks go.
  bool is_competitor(const std::string& label) const;
  const MethodFacts* find(const std::string& label) const;

  const std::vector<std::string>& labels() const noexcept { return labels_; }
  // NOLINTNEXTLINE(google-explicit-constructor): a list is its labels
  operator const std::vector<std::string>&() const noexcept { return labels_; }

  auto begin() const noexcept { return labels_.begin(); }
  auto end() const noexcept { return labels_.end(); }
  const std::string& front() const { return labels_.front(); }
  std::size_t size() const noexcept { return labels_.size(); }
  bool empty() const noexcept { return labels_.empty(); }

 private:
  std::vector<std::string> labels_;
  std::vector<MethodFacts> methods_;
};

/// The methods of `records`.
MethodList methods_of(const std::vector<Record>& records);

}  // namespace raygauge
