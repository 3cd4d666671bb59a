// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "cli/input/mesh_formats.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli::test_gltf_file {
namespace {

template <class T>
std::string bytes_of(const std::vector<T>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T)};
}

/// A tetrahedron: four corners of floats, then twelve indices.
const std::string kBuffer = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 4}) +
                            bytes_of<std::uint16_t>({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});

struct Parts {
  std::string nodes = R"([{"mesh": 0}])";
  std::string accessors = R"([{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                              {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}])";
  std::string primitive = R"({"attributes": {"POSITION": 0}, "indices": 1})";
  std::string more;
};

Parts with(std::string Parts::*part, const std::string& text) {
  Parts parts;
  parts.*part = text;
  return parts;
}

std::string chunk(const std::string& text, std::uint32_t kind) {
  return bytes_of<std::uint32_t>({static_cast<std::uint32_t>(text.size()), kind}) + text;
}

std::string glb(const Parts& parts, const std::string& buffer = kBuffer) {
  std::string json = R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": )" + parts.nodes +
                     R"(, "meshes": [{"primitives": [)" + parts.primitive + R"(]}], "accessors": )" +
                     parts.accessors + R"(, "bufferViews": [{"buffer": 0, "byteLength": 48},
                     {"buffer": 0, "byteOffset": 48, "byteLength": 24}], "buffers": [{"byteLength": 72}])" +
                     parts.more + "}";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string body = chunk(json, 0x4E4F534A) + chunk(buffer, 0x004E4942);
  return "glTF" + bytes_of<std::uint32_t>({2, static_cast<std::uint32_t>(12 + body.size())}) + body;
}

std::string error(const std::string& bytes) {
  try {
    gltf_mesh(bytes, "m");
  } catch (const Error& caught) {
    return caught.what();
  }
  return "nothing was thrown";
}

TEST(GltfMesh, PositionsAreInMetresAsTheyAreWithYUp) {
  const MeshText mesh = gltf_mesh(glb({}), "m");
  EXPECT_EQ(mesh.vertices, (std::vector<Vertex>{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 4}}));
  EXPECT_EQ(mesh.faces.ends.size(), 4U);
  EXPECT_EQ(mesh.faces.corners[3], 0U);
}

TEST(GltfMesh, NodesPlaceMeshesAndAreObjectsAndMirrorsTurnTheTriangles) {
  const std::string nodes = R"([{"translation": [1, 0, 0], "children": [1, 2]}, {"mesh": 0, "name": "left"},
      {"mesh": 0, "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476], "scale": [-1, 1, 1]}])";
  const MeshText mesh = gltf_mesh(glb(with(&Parts::nodes, nodes)), "m");
  ASSERT_EQ(mesh.vertices.size(), 8U);
  EXPECT_EQ(mesh.vertices[1], (Vertex{2, 0, 0}));
  EXPECT_NEAR(mesh.vertices[5][0], 1, 1e-15);
  EXPECT_NEAR(mesh.vertices[5][1], -1, 1e-15);
  ASSERT_EQ(mesh.runs.size(), 2U);
  EXPECT_EQ(mesh.runs[0].name, "left");
  EXPECT_EQ(mesh.runs[1].first, 4U);
  const std::vector<std::uint32_t> own(mesh.faces.corners.begin(), mesh.faces.corners.begin() + 3);
  const std::vector<std::uint32_t> mirrored(mesh.faces.corners.begin() + 12, mesh.faces.corners.begin() + 15);
  EXPECT_EQ(own, (std::vector<std::uint32_t>{0, 2, 1}));
  EXPECT_EQ(mirrored, (std::vector<std::uint32_t>{5, 6, 4}));
}

TEST(GltfMesh, StripsFansAndTextsWithBase64AreRead) {
  const auto triangles = [](const std::string& mode) {
    return gltf_mesh(glb(with(&Parts::primitive, R"({"attributes": {"POSITION": 0}, "mode": )" + mode + "}")),
                     "m")
        .faces.corners;
  };
  EXPECT_EQ(triangles("5"), (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3}));
  EXPECT_EQ(triangles("6"), (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_TRUE(triangles("0").empty());
  const std::string text =
      R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}], "meshes": [{"primitives":
         [{"attributes": {"POSITION": 0}, "mode": 0}]}], "accessors": [{"bufferView": 0, "componentType": 5121,
         "count": 1, "type": "VEC3"}], "bufferViews": [{"buffer": 0, "byteLength": 3}], "buffers": [{"byteLength": 3,
         "uri": "data:application/octet-stream;base64,AQL/"}]})";
  EXPECT_EQ(gltf_mesh(text, "m").vertices, (std::vector<Vertex>{{1, 2, 255}}));
}

TEST(GltfMesh, WhatIsWrongIsNamed) {
  const std::string good = glb({});
  EXPECT_EQ(error(good.substr(0, good.size() - 1)), "m: its header promises another length");
  EXPECT_EQ(error(glb({}, kBuffer.substr(0, 50))), "m: a buffer is shorter than its byteLength");
  std::string beyond = kBuffer;
  beyond[48] = 9;
  EXPECT_EQ(error(glb({}, beyond)), "m: vertex 9 is not there: 4 are, counted from 0");
  const std::string long_accessor =
      R"([{"bufferView": 0, "componentType": 5126, "count": 5, "type": "VEC3"}, {}])";
  EXPECT_EQ(error(glb(with(&Parts::accessors, long_accessor))),
            "m: an accessor reads beyond its buffer view");
  const std::string huge =
      R"([{"bufferView": 0, "componentType": 5126, "count": 18446744073709551615, "type": "VEC3"}, {}])";
  EXPECT_EQ(error(glb(with(&Parts::accessors, huge))), "m: an accessor reads beyond its buffer view");
  const std::string negative =
      R"([{"bufferView": 0, "componentType": 5126, "count": -1, "type": "VEC3"}, {}])";
  EXPECT_EQ(error(glb(with(&Parts::accessors, negative))), "m: count must be a count, got -1");
  EXPECT_EQ(error(glb(with(&Parts::nodes, R"([{"children": [0]}])"))),
            "m: nodes that contain themselves, or too many");
  EXPECT_EQ(error(glb(with(&Parts::nodes, R"([{"mesh": 7}])"))), "m: meshes has no entry 7");
  EXPECT_EQ(error(glb(with(&Parts::nodes, R"([{"mesh": 0, "skin": 0}])"))),
            "m: a mesh with a skin is not read");
  EXPECT_EQ(error(glb(with(&Parts::more, R"(, "extensionsRequired": ["KHR_draco_mesh_compression"])"))),
            "m: it needs the extension KHR_draco_mesh_compression, which is not read");
  for (const std::string& bytes : {std::string("glTF"), std::string("{"), std::string("{}"),
                                   std::string("[1]"), std::string(R"({"asset": {"version": 2}})")}) {
    EXPECT_EQ(error(bytes).substr(0, 2), "m:") << bytes;
    EXPECT_EQ(error(bytes).find('\n'), std::string::npos) << bytes;
  }
}

}  // namespace
}  // namespace raygauge::cli::test_gltf_file
