// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A mesh file, its format chosen by the first byte: what is accepted has finite vertices, and no more of them
// than the file has bytes.
#include <string>

#include "cli/input/mesh_file.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz {

void check_mesh_file(std::string_view input) {
  if (input.empty()) return;
  static const ScratchFile files[] = {ScratchFile(".off"), ScratchFile(".ply"), ScratchFile(".stl"),
                                      ScratchFile(".obj")};
  const ScratchFile& file = files[static_cast<unsigned char>(input[0]) % 4];
  file.write(input.substr(1));
  expect_success_or_error([&] {
    const Eigen::MatrixXd vertices = cli::read_mesh_vertices(file.path());
    require(vertices.rows() == 3 && vertices.cols() > 0, "accepted meshes have vertices");
    require(vertices.allFinite(), "accepted vertices are finite");
    require(static_cast<std::size_t>(vertices.cols()) <= input.size(), "vertices take bytes");
  });
}

}  // namespace raygauge::fuzz
