// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/method_list.h"

#include <algorithm>
#include <utility>

namespace raygauge {

MethodFacts facts_of(const Record& record) {
  return {record.method, record.method_name, record.method_parameters, record.role};
}

void MethodList::add(MethodFacts method) {
  if (find(method.label) != nullptr) return;
  labels_.push_back(method.label);
  methods_.push_back(std::move(method));
}

const MethodFacts* MethodList::find(const std::string& label) const {
  const auto found = std::find(labels_.begin(), labels_.end(), label);
  return found == labels_.end() ? nullptr : &methods_[static_cast<std::size_t>(found - labels_.begin())];
}

bool MethodList::is_competitor(const std::string& label) const {
  const MethodFacts* method = find(label);
  return method != nullptr && method->is_competitor();
}

MethodList methods_of(const std::vector<Record>& records) {
  MethodList methods;
  for (const Record& record : records) {
    if (methods.find(record.method) == nullptr) methods.add(facts_of(record));
  }
  return methods;
}

}  // namespace raygauge
