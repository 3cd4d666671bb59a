// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/mesh_file.h"

#include <gtest/gtest.h>

#include <string>

#include "engine/exceptions.h"
#include "tests/results/support.h"

namespace raygauge::cli::test_mesh_file {
namespace {

constexpr const char* kObj = "v 1 0 0\nv 0 2 0\nv 0 0 4\nf 1 2 3\n";
constexpr const char* kOff = "OFF\n# a triangle\n3 1 0\n1 0 0\n0 2 0\n0 0 4\n3 0 1 2\n";
constexpr const char* kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n1 0 0\n0 2 0\n0 0 4\n3 0 1 2\n";
constexpr const char* kStl =
    "solid t\nfacet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 0 2 0\nvertex 0 0 4\nendloop\nendfacet\n"
    "endsolid t\n";

class MeshFile : public ::testing::Test {
 protected:
  Eigen::MatrixXd read(const std::string& name, const std::string& bytes) {
    testing::write_bytes(folder_.file(name), bytes);
    return read_mesh_vertices(folder_.file(name));
  }

  /// The error without the folder of the file.
  std::string error(const std::string& name, const std::string& bytes) {
    try {
      read(name, bytes);
    } catch (const Error& caught) {
      return std::string(caught.what()).substr(folder_.path().size() + 1);
    }
    return "nothing was thrown";
  }

  testing::TemporaryFolder folder_;
};

TEST_F(MeshFile, EveryFormatGivesTheVerticesOfATriangle) {
  // In increasing order of coordinates.
  const Eigen::MatrixXd expected{{0, 0, 1}, {0, 2, 0}, {4, 0, 0}};
  EXPECT_EQ(read("t.obj", kObj), expected);
  EXPECT_EQ(read("t.off", kOff), expected);
  EXPECT_EQ(read("t.ply", kPly), expected);
  EXPECT_EQ(read("t.stl", kStl), expected);
}

TEST_F(MeshFile, TheNameOfTheFormatMayBeInCapitals) {
  EXPECT_TRUE(is_mesh_file("a.b/T.OBJ"));
  EXPECT_TRUE(is_mesh_file("t.Stl"));
  EXPECT_FALSE(is_mesh_file("obj"));
  EXPECT_FALSE(is_mesh_file("t.csv"));
  EXPECT_EQ(read("T.OBJ", kObj).cols(), 3);
}

TEST_F(MeshFile, VerticesSharedByFacesCountOnce) {
  EXPECT_EQ(
      read("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\nf 2 5 3\n").cols(), 4);
}

TEST_F(MeshFile, PointsWithoutFacesAreAccepted) {
  EXPECT_EQ(read("cloud.obj", "v 1 0 0\nv 0 1 0\nv 0 0 1\nv 2 2 2\n").cols(), 4);
}

TEST_F(MeshFile, WhatIsNoMeshIsNamedOnOneLine) {
  for (const char* name : {"t.obj", "t.off", "t.stl", "t.ply"}) {
    const std::string message = error(name, "this is not a mesh, whatever its name says\n");
    EXPECT_EQ(message.rfind(name, 0), 0U) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_EQ(error("empty.off", ""), "empty.off: the file is empty");
}

TEST_F(MeshFile, BinaryOffIsRefusedByName) {
  EXPECT_EQ(error("b.off", "OFF BINARY\n\1\2\3"), "b.off: binary OFF is not read; save the mesh as ASCII");
}

TEST_F(MeshFile, CoordinatesThatAreNotFiniteAreRefused) {
  std::string bytes = kPly;
  bytes.replace(bytes.find("0 0 4"), 5, "0 0 nan");
  EXPECT_EQ(error("t.ply", bytes), "t.ply: a vertex has the coordinate NaN");
}

TEST_F(MeshFile, AMissingFileIsNamedWithTheReason) {
  try {
    read_mesh_vertices("nowhere.obj");
    FAIL() << "read a file that is not there";
  } catch (const InvalidParameterError& caught) {
    EXPECT_STREQ(caught.what(), "nowhere.obj: No such file or directory");
  }
}

}  // namespace
}  // namespace raygauge::cli::test_mesh_file
