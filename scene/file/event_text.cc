// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/file/event_text.h"

#include <cmath>
#include <cstdio>

namespace raygauge {
namespace {

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

std::string clearance_text(const SceneRecord& record) {
  if (record.status == SceneStatus::intersecting) {
    if (std::isnan(record.time_lower))
      return "they meet at " + number(record.time) + " s";  // files before 0.2
    return "they meet, first in [" + number(record.time_lower) + ", " + number(record.time) + "] s";
  }
  const std::string least = number(record.upper) + " at " + number(record.time) + " s";
  if (!(record.lower > 0)) return "meet, or nearly: undecided; " + least;
  return "never closer than " + number(record.lower) + "; " + least;
}

}  // namespace

std::string event_text(const SceneRecord& record) {
  if (record.kind == SceneRowKind::clearance) return clearance_text(record);
  if (record.status == SceneStatus::free) return "no contact, proven";
  if (record.status == SceneStatus::contact)
    return "first contact in [" + number(record.time_lower) + ", " + number(record.time_upper) + "] s";
  return "no contact before " + number(record.time_lower) + " s, proven; after that undecided";
}

}  // namespace raygauge
