// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/mesh_file.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <vector>

#include "raygauge/exceptions.h"
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
    return distinct_vertices(read_mesh(folder_.file(name)));
  }

  static std::string big_endian_ints(const std::vector<int>& values) {
    std::string bytes;
    for (const int value : values)
      for (const int shift : {24, 16, 8, 0})
        bytes += static_cast<char>(static_cast<unsigned>(value) >> shift);
    return bytes;
  }

  /// The coordinates of the triangle in single precision, each vertex with `extra` zeros behind it.
  static std::string floats(bool big_endian, int extra) {
    std::string bytes;
    for (const std::array<float, 3>& vertex : {std::array<float, 3>{1, 0, 0}, {0, 2, 0}, {0, 0, 4}}) {
      for (const float value : vertex) {
        std::string raw(sizeof value, ' ');
        std::memcpy(raw.data(), &value, sizeof value);
        if (big_endian) std::reverse(raw.begin(), raw.end());
        bytes += raw;
      }
      bytes += std::string(sizeof(float) * static_cast<std::size_t>(extra), '\0');
    }
    return bytes;
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

TEST_F(MeshFile, AByteOrderMarkIsSkippedInEveryTextFormat) {
  const Eigen::MatrixXd expected{{0, 0, 1}, {0, 2, 0}, {4, 0, 0}};
  const std::string mark = "\xEF\xBB\xBF";
  EXPECT_EQ(read("t.obj", mark + kObj), expected);
  EXPECT_EQ(read("t.off", mark + kOff), expected);
  EXPECT_EQ(read("t.ply", mark + kPly), expected);
  EXPECT_EQ(read("t.stl", mark + kStl), expected);
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

TEST_F(MeshFile, BinaryFormatsGiveTheVerticesOfATriangle) {
  const Eigen::MatrixXd expected{{0, 0, 1}, {0, 2, 0}, {4, 0, 0}};
  EXPECT_EQ(read("t.off", "OFF BINARY\n" + big_endian_ints({3, 0, 0}) + floats(true, 0)), expected);
  const std::string face = big_endian_ints({3, 0, 1, 2});
  EXPECT_EQ(read("t.off", "OFF BINARY\n" + big_endian_ints({3, 1, 0}) + floats(true, 0) + face), expected);
  EXPECT_EQ(read("t.off", "COFF BINARY\n" + big_endian_ints({3, 1, 0}) + floats(true, 4) + face +
                              big_endian_ints({0})),
            expected);
  // 3, 0, 0 and floats in the order of the machine that wrote them, as pmp-library does
  const std::string counts("\3\0\0\0\0\0\0\0\0\0\0\0", 12);
  EXPECT_EQ(read("t.off", "OFF BINARY\n" + counts + floats(false, 0)), expected);
  for (const bool big : {false, true}) {
    std::string header = kPly;
    header.resize(header.find("1 0 0\n0 2 0"));
    header.replace(header.find("ascii"), 5, big ? "binary_big_endian" : "binary_little_endian");
    const std::string face_of_ply = std::string(1, '\3') + std::string(12, '\0');
    EXPECT_EQ(read("t.ply", header + floats(big, 0) + face_of_ply), expected) << big;
  }
  std::string stl(80, ' ');
  stl += std::string("\1\0\0\0", 4) + std::string(12, '\0') + floats(false, 0) + std::string(2, '\0');
  EXPECT_EQ(read("t.stl", stl), expected);
}

TEST_F(MeshFile, TextFormatsKeepEveryDigit) {
  EXPECT_EQ(read("t.off", "OFF 1 0 0\n0.1 1e-9 123456789.125 255 0 0\n")(0, 0), 0.1);
  EXPECT_EQ(read("t.off", "OFF 1 0 0\n0.1 1e-9 123456789.125 255 0 0\n")(2, 0), 123456789.125);
}

TEST_F(MeshFile, GzipIsReadUnderAnyName) {
  const Eigen::MatrixXd expected{{0, 0, 1}, {0, 2, 0}, {4, 0, 0}};
  for (const char* name : {"t.off.gz", "t.off"}) {
    const gzFile file = gzopen(folder_.file(name).c_str(), "wb");
    gzputs(file, kOff);
    gzclose(file);
    EXPECT_EQ(distinct_vertices(read_mesh(folder_.file(name))), expected) << name;
  }
  const std::string half = testing::read_bytes(folder_.file("t.off")).substr(0, 30);
  EXPECT_EQ(error("half.off.gz", half), "half.off.gz: gzip data that is truncated or damaged");
}

TEST_F(MeshFile, AHeaderThatPromisesTooMuchIsNotBelieved) {
  EXPECT_EQ(error("t.off", "OFF\n1000000000 1 0\n1 0 0\n"),
            "t.off:2: the header promises 1000000000 vertices, and 6 bytes are left");
  EXPECT_EQ(error("t.off", "OFF BINARY\n" + big_endian_ints({-1, 1, 0})),
            "t.off: the header promises 4294967295 vertices, and 0 bytes are left");
  std::string ply = kPly;
  ply.replace(ply.find("vertex 3"), 8, "vertex 1000000000000");
  EXPECT_EQ(error("t.ply", ply),
            "t.ply:9: the header promises 1000000000000 of 'vertex', and 26 bytes are left");
  EXPECT_EQ(
      error("t.stl", std::string(80, ' ') + "\xFF\xFF\xFF\x7F"),
      "t.stl: neither a text STL file, which begins with solid, nor a whole binary one: 2147483647 facets "
      "would be 107374182434 bytes, it has 84");
  EXPECT_EQ(error("t.off", "OFF BINARY\n" + big_endian_ints({3, 1, 0}) + floats(true, 0)),
            "t.off: the 1 faces that the header promises are not what follows the vertices");
}

TEST_F(MeshFile, CoordinatesThatAreNotFiniteAreRefused) {
  std::string bytes = kPly;
  bytes.replace(bytes.find("0 0 4"), 5, "0 0 nan");
  EXPECT_EQ(error("t.ply", bytes), "t.ply:12: 'nan' is not a finite number");
}

TEST_F(MeshFile, AMissingFileIsNamedWithTheReason) {
  try {
    distinct_vertices(read_mesh("nowhere.obj"));
    FAIL() << "read a file that is not there";
  } catch (const InvalidParameterError& caught) {
    EXPECT_STREQ(caught.what(), "nowhere.obj: No such file or directory");
  }
}

}  // namespace
}  // namespace raygauge::cli::test_mesh_file
