// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/cell_key.h"

namespace raygauge {

CellKey cell_key(const Record& record) {
  return {record.generator, record.generator_parameters, record.n, record.N, record.tolerance};
}

std::string problem_name(const CellKey& cell) {
  const std::string& parameters = cell.generator_parameters;
  return cell.generator + (parameters.empty() ? "" : " (" + parameters + ")");
}

}  // namespace raygauge
