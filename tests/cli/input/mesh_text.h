// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <sstream>
#include <string>

#include "tests/engine/meshes/mesh_shapes.h"

/// Meshes as the text of a file, for tests.
namespace raygauge::testing {

inline std::string obj_text(const MeshShape& mesh) {
  std::ostringstream text;
  for (const auto& p : mesh.vertices.colwise()) text << "v " << p.transpose() << '\n';
  for (const auto& t : mesh.triangles) text << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  return text.str();
}

/// A box with a cavity: not convex, closed, of volume 26; its hull has 27.
inline MeshShape hollow() { return joined(box_shape(kZero, 3 * kOne), box_shape(kOne, 2 * kOne, 1, true)); }

}  // namespace raygauge::testing
