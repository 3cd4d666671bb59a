// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace raygauge {

/// Calls `work` with 0, …, count - 1, on several threads, which end here: they are to take no processor time
/// while HDF5 works alone. The first exception is thrown again.
void for_all(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace raygauge
