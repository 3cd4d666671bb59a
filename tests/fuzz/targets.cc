// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/fuzz/targets.h"

#include "tests/fuzz/harness.h"

namespace raygauge::fuzz {

const std::vector<Target>& targets() {
  static const std::vector<Target> all = {
      {"point_file", check_point_file},
      {"mesh_file", check_mesh_file},
      {"experiment_file", check_experiment_file},
      {"set_file", check_set_file},
      {"set_pair", check_set_pair, false},
      {"override", check_override},
      {"results_file", check_results_file},
      {"cell_journal", check_cell_journal},
      {"csv_rows", check_csv_rows},
      {"dataset", check_dataset},
      {"filter", check_filter},
      {"scene_file", check_scene_file},
      {"robot_file", check_robot_file},
      {"pair_list", check_pair_list},
      {"motion_file", check_motion_file},
      {"cloud_file", check_cloud_file},
      {"height_field", check_height_field},
      {"parts_file", check_parts_file},
      {"semantics_file", check_semantics_file},
#ifdef RAYGAUGE_HAS_YAML
      {"planning_message", check_planning_message},
#endif
#ifdef RAYGAUGE_HAS_EXACT
      {"solver", check_solver, false},
#endif
  };
  return all;
}

}  // namespace raygauge::fuzz
