// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/hdf5/global_heap.h"

#include <cstddef>
#include <cstdint>

namespace raygauge::hdf5 {
namespace {

constexpr std::string_view kHeapSignature{"GCOL\1\0\0\0", 8};  // with the version and what is reserved
constexpr std::uint64_t kHeapHeader = 16;                      // of a heap, and of an object

std::uint64_t little_endian(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = size; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

/// The bytes that the object at `at` takes. Number 0 is what is free, its header included.
std::uint64_t extent_of_object(std::string_view heap, std::size_t at) {
  const std::uint64_t number = little_endian(heap, at, 2), size = little_endian(heap, at + 8, 8);
  if (number == 0 || size > heap.size()) return size;
  return kHeapHeader + (size + 7) / 8 * 8;
}

bool is_damaged_heap(std::string_view heap) {
  for (std::size_t at = kHeapHeader; at + kHeapHeader <= heap.size();) {
    const std::uint64_t extent = extent_of_object(heap, at);
    if (extent == 0 || extent > heap.size() - at) return true;
    at += extent;
  }
  return false;
}

}  // namespace

bool has_damaged_global_heap(std::string_view bytes) {
  for (std::size_t at = bytes.find(kHeapSignature); at != std::string_view::npos;
       at = bytes.find(kHeapSignature, at + 1)) {
    if (bytes.size() - at < kHeapHeader) return false;
    const std::uint64_t size = little_endian(bytes, at + 8, 8);
    // HDF5 itself refuses a heap that the end of the file cuts off.
    if (size <= bytes.size() - at && is_damaged_heap(bytes.substr(at, size))) return true;
  }
  return false;
}

}  // namespace raygauge::hdf5
