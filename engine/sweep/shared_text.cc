// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <functional>
#include <mutex>
#include <unordered_set>

#include "raygauge/sweep/record.h"

namespace raygauge {
namespace {

struct Hash {
  using is_transparent = void;
  std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
};

}  // namespace

const std::string& SharedText::kept(std::string_view text) {
  static const std::string kEmpty;
  if (text.empty()) return kEmpty;
  static std::mutex mutex;
  static auto& texts = *new std::unordered_set<std::string, Hash, std::equal_to<>>();  // outlives all records
  const std::lock_guard lock(mutex);
  const auto found = texts.find(text);
  return found != texts.end() ? *found : *texts.emplace(text).first;
}

}  // namespace raygauge
