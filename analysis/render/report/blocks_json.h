// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "analysis/render/report/blocks.h"

namespace raygauge::report {

/// An object whose members keep the order in which they were set.
using Json = nlohmann::ordered_json;

/// The block as page/*.js reads it. Numbers that JSON has no word for are null.
Json to_json(const Block& block);

}  // namespace raygauge::report
