// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/set_source.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "cli/input/point_source.h"
#include "cli/input/set_file.h"
#include "engine/exceptions.h"
#include "engine/sets/point_set.h"

namespace raygauge::cli {
namespace {

namespace fs = std::filesystem;

/// `open` are the set files that are being read: each names the next one.
SetPointer read_inside(const std::string& source, const PointFormat& format,
                       const std::vector<fs::path>& open) {
  if (!is_set_file(source)) return std::make_shared<PointSet>(read_point_source(source, format));
  std::error_code ignored;
  std::vector<fs::path> now_open = open;
  now_open.push_back(fs::weakly_canonical(source, ignored));
  if (std::find(open.begin(), open.end(), now_open.back()) != open.end())
    throw InvalidParameterError(source + ": this set file names itself");
  return read_set_file(source,
                       [&](const std::string& named) { return read_inside(named, format, now_open); });
}

}  // namespace

SetPointer read_set_source(const std::string& source, const PointFormat& format) {
  return read_inside(source, format, {});
}

}  // namespace raygauge::cli
