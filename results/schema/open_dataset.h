// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <H5Cpp.h>

#include <string>

namespace raygauge {

/// A dataset of numbers. Throws ResultsError, which begins with `place`, where there is none.
H5::DataSet open_numeric(const H5::Group& root, const std::string& dataset, const std::string& place);

}  // namespace raygauge
