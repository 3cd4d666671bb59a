// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "raygauge/exceptions.h"

namespace raygauge::fuzz {

/// The fuzz targets: each takes any bytes; what escapes it is a finding.
void check_point_file(std::string_view input);
void check_mesh_file(std::string_view input);
void check_experiment_file(std::string_view input);
void check_set_file(std::string_view input);
void check_set_pair(std::string_view text);
void check_override(std::string_view input);
void check_results_file(std::string_view input);
void check_cell_journal(std::string_view input);
void check_csv_rows(std::string_view input);
void check_dataset(std::string_view input);
void check_filter(std::string_view input);
void check_scene_file(std::string_view input);
void check_robot_file(std::string_view input);
void check_pair_list(std::string_view input);
void check_motion_file(std::string_view input);
void check_cloud_file(std::string_view input);
void check_height_field(std::string_view input);
void check_parts_file(std::string_view input);
void check_semantics_file(std::string_view input);
void check_planning_message(std::string_view input);
void check_solver(std::string_view input);

/// A promise of the library that an input broke.
class BrokenPromise : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

inline void require(bool holds, const std::string& promise) {
  if (!holds) throw BrokenPromise(promise);
}

/// Runs `call`. It may succeed or throw Error with a message; everything else is a finding.
template <class Call>
void expect_success_or_error(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    require(!std::string_view(error.what()).empty(), "an error says why");
  }
}

}  // namespace raygauge::fuzz
