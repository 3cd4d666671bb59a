// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace raygauge::hdf5 {

/// Whether the bytes of an HDF5 file hold a global heap, where texts of variable length are, with an object
/// that ends beyond the heap or has no extent at all. HDF5 1.10 reads beyond its memory at the first and for
/// ever at the second. No such file was ever written by HDF5.
bool has_damaged_global_heap(std::string_view bytes);

}  // namespace raygauge::hdf5
