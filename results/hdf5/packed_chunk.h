// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace raygauge::hdf5 {

/// How zlib looks for repetitions. Bytes of numbers, shuffled, repeat as runs if at all: looking for runs
/// alone takes a third of the time and packs as well.
enum class Packing : std::uint8_t { texts, numbers };

/// The chunk of a packed column as HDF5's filters shuffle, deflate and fletcher32 store it, made without
/// HDF5, which lets no two threads work at once. Replaces `packed`.
void pack_chunk(std::span<const char> bytes, std::size_t entry_bytes, Packing packing,
                std::vector<char>& packed);

/// The inverse: fills `bytes`; false if `packed` is damaged or of another size.
[[nodiscard]] bool unpack_chunk(std::span<const char> packed, std::size_t entry_bytes, std::span<char> bytes);

}  // namespace raygauge::hdf5
