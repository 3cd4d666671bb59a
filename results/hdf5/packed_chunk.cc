// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/hdf5/packed_chunk.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <new>

namespace raygauge::hdf5 {
namespace {

constexpr std::size_t kChecksumBytes = 4;

/// The first bytes of all entries, then the second ones, …
void shuffle(std::span<const char> from, std::size_t entry_bytes, std::vector<char>& to) {
  const std::size_t count = from.size() / entry_bytes;
  to.resize(from.size());
  for (std::size_t byte = 0; byte < entry_bytes; ++byte) {
    for (std::size_t i = 0; i < count; ++i) to[byte * count + i] = from[i * entry_bytes + byte];
  }
}

void unshuffle(const std::vector<char>& from, std::size_t entry_bytes, std::span<char> to) {
  const std::size_t count = to.size() / entry_bytes;
  for (std::size_t byte = 0; byte < entry_bytes; ++byte) {
    for (std::size_t i = 0; i < count; ++i) to[i * entry_bytes + byte] = from[byte * count + i];
  }
}

/// HDF5's checksum: Fletcher's, of words with the high byte first, folded every 360 words.
std::uint32_t fletcher32(std::span<const char> bytes) {
  constexpr std::size_t kWordsAtOnce = 360;
  const auto fold = [](std::uint32_t sum) { return (sum & 0xffff) + (sum >> 16); };
  std::uint32_t sum1 = 0;
  std::uint32_t sum2 = 0;
  const auto add = [&](unsigned char high, unsigned char low) {
    sum1 += static_cast<std::uint32_t>(high << 8 | low);
    sum2 += sum1;
  };
  const std::size_t words = bytes.size() / 2;
  for (std::size_t first = 0; first < words; first += kWordsAtOnce) {
    for (std::size_t i = first; i < std::min(words, first + kWordsAtOnce); ++i) {
      add(static_cast<unsigned char>(bytes[2 * i]), static_cast<unsigned char>(bytes[2 * i + 1]));
    }
    sum1 = fold(sum1);
    sum2 = fold(sum2);
  }
  if (bytes.size() % 2 != 0) {
    add(static_cast<unsigned char>(bytes.back()), 0);
    sum1 = fold(sum1);
    sum2 = fold(sum2);
  }
  return fold(sum2) << 16 | fold(sum1);
}

std::array<char, kChecksumBytes> stored_checksum(std::span<const char> bytes) {
  const std::uint32_t sum = fletcher32(bytes);
  return {static_cast<char>(sum), static_cast<char>(sum >> 8), static_cast<char>(sum >> 16),
          static_cast<char>(sum >> 24)};
}

void deflate_into(std::vector<char>& from, Packing packing, std::vector<char>& to) {
  constexpr int kLevel = 1;
  constexpr int kWindowBits = 15;
  constexpr int kMemoryLevel = 8;
  z_stream stream{};
  const int strategy = packing == Packing::numbers ? Z_RLE : Z_DEFAULT_STRATEGY;
  if (deflateInit2(&stream, kLevel, Z_DEFLATED, kWindowBits, kMemoryLevel, strategy) != Z_OK) {
    throw std::bad_alloc();
  }
  to.resize(deflateBound(&stream, from.size()));
  stream.next_in = reinterpret_cast<Bytef*>(from.data());
  stream.avail_in = static_cast<uInt>(from.size());
  stream.next_out = reinterpret_cast<Bytef*>(to.data());
  stream.avail_out = static_cast<uInt>(to.size());
  deflate(&stream, Z_FINISH);  // whole, as it has room for the bound
  to.resize(stream.total_out);
  deflateEnd(&stream);
}

}  // namespace

void pack_chunk(std::span<const char> bytes, std::size_t entry_bytes, Packing packing,
                std::vector<char>& packed) {
  thread_local std::vector<char> shuffled;
  shuffle(bytes, entry_bytes, shuffled);
  deflate_into(shuffled, packing, packed);
  const auto checksum = stored_checksum(packed);
  packed.insert(packed.end(), checksum.begin(), checksum.end());
}

bool unpack_chunk(std::span<const char> packed, std::size_t entry_bytes, std::span<char> bytes) {
  if (packed.size() < kChecksumBytes) return false;
  const std::span<const char> deflated = packed.first(packed.size() - kChecksumBytes);
  if (!std::ranges::equal(stored_checksum(deflated), packed.last(kChecksumBytes))) return false;
  thread_local std::vector<char> shuffled;
  shuffled.resize(bytes.size());
  uLongf size = shuffled.size();
  const int status = uncompress(reinterpret_cast<Bytef*>(shuffled.data()), &size,
                                reinterpret_cast<const Bytef*>(deflated.data()), deflated.size());
  if (status != Z_OK || size != bytes.size()) return false;
  unshuffle(shuffled, entry_bytes, bytes);
  return true;
}

}  // namespace raygauge::hdf5
