// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// An OBJ file whose objects are convex parts: what is accepted has two or more, of vertices of the file.
#include "cli/input/mesh_object_file.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz {

void check_parts_file(std::string_view input) {
  static const ScratchFile file(".parts.obj");
  file.write(input);
  expect_success_or_error([&] {
    cli::Notes notes;
    const auto parts = cli::read_parts({file.path()}, notes);
    require(parts.size() >= 2 && parts.size() <= input.size(), "parts take bytes");
    for (const auto& part : parts) require(part->center().allFinite(), "accepted parts are finite");
  });
}

}  // namespace raygauge::fuzz
