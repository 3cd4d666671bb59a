// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/sections.h"

namespace raygauge::report {

const std::vector<SectionMaker>& section_makers() {
  static const std::vector<SectionMaker> kMakers = {
      summary_section,        wrong_answers_section, stability_section,  ratios_section,    scaling_section,
      work_precision_section, profiles_section,      iterations_section, crossover_section, accuracy_section,
      example1_section,       machines_section,      provenance_section, records_section,
  };
  return kMakers;
}

}  // namespace raygauge::report
