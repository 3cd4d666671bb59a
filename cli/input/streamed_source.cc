// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/streamed_source.h"

#include <memory>
#include <optional>
#include <string_view>

#include "engine/queries/streamed_hull.h"
#include "generators/random.h"
#include "results/schema/row_stream.h"

namespace raygauge::cli {

SetPointer open_streamed(const std::string& source, double from_bytes) {
  const auto reference = parse_dataset_reference(source);
  if (!reference) return nullptr;
  const std::optional<StoredRows> rows = find_stored_rows(*reference);
  if (!rows || static_cast<double>(rows->rows) * rows->columns * sizeof(double) < from_bytes) return nullptr;
  return std::make_shared<StreamedHull>([rows = *rows] { return std::make_unique<RowStream>(rows); });
}

std::uint64_t digest_of_streamed(const ConvexSet& set) {
  const StreamedHull& hull = *as_streamed_hull(set);
  const auto n = static_cast<std::size_t>(hull.dimension());
  std::string digests = std::to_string(n);
  hull.stream()->pass([&](const StreamedPoints& part) {
    const bool doubles = part.doubles != nullptr;
    const auto* bytes =
        doubles ? reinterpret_cast<const char*>(part.doubles) : reinterpret_cast<const char*>(part.floats);
    const std::size_t size =
        static_cast<std::size_t>(part.count) * n * (doubles ? sizeof(double) : sizeof(float));
    digests += " " + std::to_string(stable_hash({bytes, size}));
    return true;
  });
  return stable_hash(digests);
}

}  // namespace raygauge::cli
