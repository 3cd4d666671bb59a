// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A grey picture or a table as a height field: what is accepted reaches from the floor to its greatest
// number, over as many cells as it has numbers.
#include <cmath>

#include "cli/input/height_field.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz {

void check_height_field(std::string_view input) {
  static const ScratchFile files[] = {ScratchFile(".pgm"), ScratchFile(".heights.csv")};
  for (const ScratchFile& file : files) {
    file.write(input);
    expect_success_or_error([&] {
      const auto field = cli::read_height_field(file.path(), 1, 2, -1);
      const double top = field->support_function(Vector::Unit(3, 2));
      require(top > -1, "heights are above the floor");
      require(&file != files || (top <= 2 * 65535 && std::fmod(top, 2) == 0), "heights are of the picture");
      require(field->support_function(-Vector::Unit(3, 2)) == 1, "the bottom is the floor");
      const double columns = field->support_function(Vector::Unit(3, 0)) + 1;
      const double rows = field->support_function(Vector::Unit(3, 1)) + 1;
      require(columns * rows <= static_cast<double>(input.size()), "numbers take bytes");
    });
  }
}

}  // namespace raygauge::fuzz
