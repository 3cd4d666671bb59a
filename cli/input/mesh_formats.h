// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace raygauge::cli {

using Vertex = std::array<double, 3>;

/// Polygons one after the other: indices of vertices from 0 on.
struct Polygons {
  std::vector<std::uint32_t> corners;
  std::vector<std::size_t> ends;  ///< of each polygon, in `corners`

  void add(std::uint32_t corner) { corners.push_back(corner); }
  void close() { ends.push_back(corners.size()); }

  /// Turns polygons from number `first` on about, as a mirror does.
  void turn_about(std::size_t first) {
    for (std::size_t k = first; k < ends.size(); ++k) {
      const std::size_t begin = k == 0 ? 0 : ends[k - 1];
      std::reverse(corners.begin() + static_cast<std::ptrdiff_t>(begin),
                   corners.begin() + static_cast<std::ptrdiff_t>(ends[k]));
    }
  }
};

/// Faces from `first` on, up to those of the next run, that belong to an object or a group.
struct FaceRun {
  std::string name;
  std::size_t first = 0;
};

/// What a mesh file says: its vertices, those too that no face uses, and its faces.
struct MeshText {
  std::vector<Vertex> vertices;
  Polygons faces;
  std::vector<FaceRun> runs = {};  ///< of a file whose objects have names, those without faces too
};

/// Mesh files in their own axes and units. The size of the
/// file is believed, not its header: nothing is reserved for what is not there. Each throws
/// InvalidParameterError, which names the file and, of a text, the line, for what is not understood, ends too
/// early or goes on behind its end; NonFiniteError for a coordinate that is NaN, infinite or too large.
/// `name` is what messages call the file.

/// OBJ: polygons. A vertex has 3 numbers, also with a weight of 1 or three numbers of a colour behind them.
/// Faces, lines and points must name vertices that are there. Objects (`o`) name the runs of faces, or groups
/// (`g`) in a file without objects. Free-form curves and surfaces, and what is no
/// keyword of the format, are refused.
MeshText obj_mesh(std::string_view text, const std::string& name);

/// OFF, text or binary of either byte order, also with normals, colours or texture coordinates (NOFF, COFF,
/// STOFF).
MeshText off_mesh(std::string_view bytes, const std::string& name);

/// PLY, text or binary of either byte order.
MeshText ply_mesh(std::string_view bytes, const std::string& name);

/// STL, text or binary: binary if the size of the file is what its count of facets makes it.
MeshText stl_mesh(std::string_view bytes, const std::string& name);

/// PCD, text or binary: its points, without faces. Compressed ones are refused.
MeshText pcd_points(std::string_view bytes, const std::string& name);

/// Collada: the positions of all meshes that the scene shows, moved by its nodes and multiplied by the unit
/// that the file states; its up axis turns nothing. Skins in their bind pose. Other geometry than meshes is
/// refused.
MeshText collada_mesh(std::string_view text, const std::string& name);

/// glTF 2.0, binary or text: the positions of all meshes that the scene shows, moved by its nodes, in metres;
/// y is up, and nothing turns it. The meshes of nodes are objects. Skins, sparse accessors and extensions
/// that change positions are refused. A text may name buffers in files beside it.
MeshText gltf_mesh(std::string_view bytes, const std::string& name);

}  // namespace raygauge::cli
