// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/record_groups.h"

#include <cstddef>
#include <map>
#include <string_view>
#include <tuple>

namespace raygauge {
namespace {

/// What the records of a group have in common; numbers first, as they are compared first.
auto common_of(const Record& record) {
  return std::tuple(record.tolerance, record.n, record.N, std::string_view(record.method),
                    std::string_view(record.generator_parameters), std::string_view(record.method_parameters),
                    std::string_view(record.generator));
}

using Common = decltype(common_of(std::declval<const Record&>()));

/// Finds the group of one record after another.
class GroupFinder {
 public:
  /// The number of the record's group; that of a new one is how many there were.
  std::size_t find(const Record& record) {
    const Common common = common_of(record);
    // In a file the methods take turns: the group that followed the last one before follows it again.
    if (!groups_.empty() && groups_[next_[last_]] == common) {
      last_ = next_[last_];
      return last_;
    }
    const auto [found, is_new] = by_common_.try_emplace(common, groups_.size());
    if (is_new) {
      groups_.push_back(common);
      next_.push_back(found->second);
    }
    next_[last_] = found->second;
    last_ = found->second;
    return last_;
  }

 private:
  std::vector<Common> groups_;
  std::vector<std::size_t> next_;  ///< which group came after a group the last time
  std::map<Common, std::size_t> by_common_;
  std::size_t last_ = 0;
};

}  // namespace

RecordGroups::RecordGroups(const std::vector<Record>& records) {
  GroupFinder finder;
  for (const Record& record : records) {
    const std::size_t group = finder.find(record);
    if (group == groups_.size()) {
      groups_.push_back({cell_key(record), {}});
      methods_.add(facts_of(record));
    }
    groups_[group].records.push_back(&record);
  }
}

}  // namespace raygauge
