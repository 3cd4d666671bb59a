// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/mesh_formats.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "raygauge/exceptions.h"

namespace raygauge::cli::test_mesh_formats {
namespace {

using Reader = std::vector<Vertex> (*)(std::string_view, const std::string&);

std::string error(Reader read, const std::string& text) {
  try {
    read(text, "m");
  } catch (const Error& caught) {
    return caught.what();
  }
  return "nothing was thrown";
}

struct Refusal {
  std::string text, message;
};

void expect_refusals(Reader read, const std::vector<Refusal>& refusals) {
  for (const Refusal& refusal : refusals)
    EXPECT_EQ(error(read, refusal.text), refusal.message) << refusal.text;
}

std::vector<Vertex> obj_vertices(std::string_view text, const std::string& name) {
  return obj_mesh(text, name).vertices;
}
std::vector<Vertex> off_vertices(std::string_view text, const std::string& name) {
  return off_mesh(text, name).vertices;
}
std::vector<Vertex> ply_vertices(std::string_view text, const std::string& name) {
  return ply_mesh(text, name).vertices;
}
std::vector<Vertex> stl_vertices(std::string_view text, const std::string& name) {
  return stl_mesh(text, name).vertices;
}
std::vector<Vertex> collada_vertices(std::string_view text, const std::string& name) {
  return collada_mesh(text, name).vertices;
}

const std::vector<Vertex> kTriangle = {{1, 0, 0}, {0, 2, 0}, {0, 0, 4}};

TEST(ObjRuns, AreThoseOfObjectsOrElseOfGroupsAlsoOfThoseThatHaveNoFace) {
  const auto runs = [](const std::string& text) {
    std::string all;
    for (const FaceRun& run : obj_mesh("v 1 0 0\nv 0 1 0\nv 0 0 1\n" + text, "m").runs)
      all += run.name + "@" + std::to_string(run.first) + " ";
    return all;
  };
  EXPECT_EQ(runs("f 1 2 3\n"), "");
  EXPECT_EQ(runs("g one\nf 1 2 3\ng two  b\nf 1 2 3\nf 1 2 3\n"), "one@0 two b@1 ");
  EXPECT_EQ(runs("g default\no one\ng x\nf 1 2 3\ng y\nf 1 2 3\no two\nf 1 2 3\n"), "one@0 two@2 ");
  EXPECT_EQ(runs("f 1 2 3\no none\no last\nf 3 2 1\no\n"), "@0 none@1 last@1 ");
}

TEST(ObjVertices, AreAllVerticesThoseTooThatNoFaceUses) {
  EXPECT_EQ(obj_vertices("v 3 1 1\nv 2 1 0\nf 1 1 1\n", "m").size(), 2U);
  EXPECT_EQ(obj_vertices("v 3 1 1\nv 2 1 0\n", "m").size(), 2U);
}

TEST(ObjVertices, AreReadWithAllThatTheFormatAllowsAboutThem) {
  for (const char* text : {
           "v 1 0 0\nv 0 2 0\nv 0 0 4\nf 1 2 3\n",
           "v 1 0 0\rv 0 2 0\rv 0 0 4\r",                          // line ends of old systems
           "\n  v 1 0 0\r\n\tv 0 2 0\r\n v 0 0 4 # a corner\r\n",  // blanks in front
           "v 1.0 0 0 1\nv +0 2e0 -0 1.0\nv .0 0. 4 1\n",          // a weight of 1
           "v 1 0 0 0.5 0.5 0.5\nv 0 2 0 1 1 1\nv 0 0 4 0 0 0\n",  // colours
           "v 1 0 \\\n0\nv 0 2 0\nv 0 0 4\nf 1 2 \\\n 3\n",        // lines that go on
           "# a path C:\\\nv 1 0 0\nv 0 2 0\nv 0 0 4\n",           // a comment does not go on
           "mtllib a b.mtl\no x\ng\ns off\nusemtl m#1\nv 1 0 0\nv 0 2 0\nv 0 0 4\n",
           "v 1 0 0\nv 0 2 0\nv 0 0 4\nvt 0 0\nvn nan 0 1\nf 1/1/1 2//1 3/1\nf -1 -2 -3\nl 1 2\np 3\nf 1/ 2/ "
           "3/\n",
           "f 1 2 3\nv 1 0 0\nv 0 2 0\nv 0 0 4\n",  // a face may stand above its vertices
           "3 1\nv 1 0 0\nv 0 2 0\nv 0 0 4\nf 1 2 3\n",
       }) {
    std::vector<Vertex> vertices;
    ASSERT_NO_THROW(vertices = obj_vertices(text, "m")) << text;
    EXPECT_EQ(vertices, kTriangle) << text;
  }
  EXPECT_EQ(obj_vertices("v 0.1 1e-9 123456789.125\n", "m")[0], (Vertex{0.1, 1e-9, 123456789.125}));
}

TEST(ObjVertices, AreRefusedWithTheLineOfWhatIsNotUnderstood) {
  expect_refusals(
      obj_vertices,
      {{"v 1 0 0\nv 1,5 0 0\n", "m:2: '1,5' is not a number"},
       {"v 0x10 0 0\n", "m:1: '0x10' is not a number"},
       {"v 1 2\n",
        "m:1: a vertex has 2 numbers; 3 are read, also with a weight of 1 or a colour of three behind them"},
       {"v 1 2 3 4 5\n",
        "m:1: a vertex has 5 numbers; 3 are read, also with a weight of 1 or a colour of three behind them"},
       {"v 1 2 3 0.5\n", "m:1: a vertex of the weight 0.5; only the weight 1 is read"},
       {"v 1 2 nan\n", "m:1: 'nan' is not a finite number"},
       {"v 1 2 1e999\n", "m:1: '1e999' is too large for double precision"},
       {"v 1 0 0\n\nV 1 0 0\n", "m:3: 'V' is no keyword of an OBJ file"},
       {"v 1 0 0\nvx 1 0 0\n", "m:2: 'vx' is no keyword of an OBJ file"},
       {"v 1 0 0\ncurv 0 1 1 1\n", "m:2: free-form curves and surfaces are not read, here 'curv'"},
       {"v 1 0 0\nf 1 2 1\nv 2 0 0\nf 1 3 1\n", "m:4: vertex 3 is not there: the file has 2"},
       {"v 1 0 0\nf -1 -2 -1\n", "m:2: vertex -2 is not there: 1 stand above"},
       {"v 1 0 0\nf 1 0 1\n", "m:2: '0' names no vertex"},
       {"v 1 0 0\nf 1 1/a 1\n", "m:2: '1/a' names no vertex"},
       {"v 1 0 0\nf 1/1/1/1\n", "m:2: '1/1/1/1' names no vertex"},
       {"v 1 0 0\nf 1.0\n", "m:2: '1.0' names no vertex"},
       {"v 1 0 0\nf\n", "m:2: 'f' names no vertex"},
       {"v 1 0 0\nvn 1 0\n", "m:2: 'vn' with 2 numbers"},
       {"v 1 0 0\\", "m:1: the last line ends in a backslash"},
       {"2 0\nv 1 0 0\n", "m:1: 2 vertices and 0 faces are promised, the file has 1 and 0"},
       {"v 1 0 0\n1 0\n", "m:2: '1' is no keyword of an OBJ file"}});
}

std::string facet(const std::string& vertices, const std::string& normal = "0 0 1") {
  return "facet normal " + normal + "\nouter loop\n" + vertices + "endloop\nendfacet\n";
}

const char* const kCorners = "vertex 1 0 0\nvertex 0 2 0\nvertex 0 0 4\n";

TEST(StlVertices, OfATextAreReadInSmallLettersAndCapitalsAndFromSeveralSolids) {
  EXPECT_EQ(stl_vertices("solid a b\n" + facet(kCorners) + "endsolid a b\n", "m"), kTriangle);
  EXPECT_EQ(stl_vertices(
                "\n  SOLID\n" + facet("Vertex 1 0 0\n VERTEX 0 2 0\n\tvertex 0 0 4\r\n") + "ENDSOLID\n", "m"),
            kTriangle);
  EXPECT_EQ(
      stl_vertices("solid\n" + facet(kCorners, "-nan(ind) -1.#IND 0") + "endsolid\nsolid\nendsolid\n", "m"),
      kTriangle);
}

TEST(StlVertices, OfATextAreRefusedWithTheLineOfWhatIsNotUnderstood) {
  const std::string start = "solid\nfacet normal 0 0 1\nouter loop\n";
  expect_refusals(
      stl_vertices,
      {{"solid\n" + facet(kCorners), "m:8: the file ends inside a solid: there is no endsolid"},
       {start + "vertex 1 0\n", "m:4: vertex with 2 words behind it"},
       {start + "vertex 1 0 0,5\n", "m:4: '0,5' is not a number"},
       {start + "vertex 1 0 inf\n", "m:4: 'inf' is not a finite number"},
       {start + "vertex 1 0 0\nendloop\n", "m:5: vertex is expected, not 'endloop'"},
       {"solid\n" + facet(std::string(kCorners) + "vertex 1 1 1\n"),
        "m:7: endloop is expected, not 'vertex'"},
       {"solid\nfacet normal 0 0\n", "m:2: facet normal and three numbers are expected, not 'facet'"},
       {"solid\nfacet normal 0 0 z\n", "m:2: 'z' is not a number"},
       {"solid\ncolor 1 0 0\n", "m:2: facet normal and three numbers are expected, not 'color'"},
       {"solid\nendsolid\nx\n", "m:3: solid is expected, not 'x'"}});
}

std::string binary_stl(const std::string& head, std::uint32_t promised, std::uint32_t facets) {
  std::string bytes = head + std::string(80 - head.size(), ' ');
  bytes.append(reinterpret_cast<const char*>(&promised), sizeof promised);
  for (std::uint32_t i = 0; i < facets; ++i) {
    const float numbers[12] = {0, 0, 1, 1, 0, 0, 0, 2, 0, 0, 0, 4};
    bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers).append(2, '\0');
  }
  return bytes;
}

TEST(StlVertices, AreOfABinaryFileIfItsSizeIsWhatItsCountMakesItWhateverItBeginsWith) {
  EXPECT_EQ(stl_vertices(binary_stl("binary", 1, 1), "m"), kTriangle);
  EXPECT_EQ(stl_vertices(binary_stl("solid of SolidWorks", 1, 1), "m"), kTriangle);
  const std::string neither = "m: neither a text STL file, which begins with solid, nor a whole binary one";
  expect_refusals(stl_vertices,
                  {{binary_stl("binary", 2, 1), neither + ": 2 facets would be 184 bytes, it has 134"},
                   {binary_stl("solid", 1, 2), neither + ": 1 facets would be 134 bytes, it has 184"},
                   {"facet\n", neither}});
}

TEST(OffVertices, MayFollowCountsBehindTheHeaderWithoutABlank) {
  EXPECT_EQ(off_vertices("OFF3 1 0\n1 0 0\n0 2 0\n0 0 4\n3 0 1 2\n", "m"), kTriangle);
  EXPECT_EQ(off_vertices(" OFF 3 1\n1 0 0\n0 2 0\n0 0 4\n3 0 1 2 255 0 0\n", "m"), kTriangle);
  EXPECT_EQ(off_vertices("COFF\n3 1 3\n1 0 0 1 1 1 1\n0 2 0 1 1 1 1\n0 0 4 1 1 1 1\n3 0 1 2 7\n# end\n", "m"),
            kTriangle);
}

TEST(OffVertices, AreRefusedWhereCountsAndLinesDoNotMatch) {
  expect_refusals(
      off_vertices,
      {{"OFF 1 0 0\n1 0 0\n2 0 0\n", "m:3: the file goes on behind what its header promises"},
       {"OFF 2 0 0\n1 0 0\n  \n# 2\n", "m:4: the file ends before what its header promises"},
       {"OFF 3 1 0\n1 0 0\n0 2 0\n0 0 4\n3 0 1 3\n", "m:5: vertex 3 is not there: 3 are, counted from 0"},
       {"OFF 3 1 0\n1 0 0\n0 2 0\n0 0 4\n3 0 1\n", "m:5: a face of 3 vertices has 2 numbers"},
       {"OFF 3 1 0\n1 0 0\n0 2 0\n0 0 4\n3 0 1 -2\n", "m:5: '-2' is not a count"},
       {"OFF 2 1 0\n1 0 0\n0 2 0\n0 0 4\n3 0 1 2\n", "m:4: a face of 0 vertices has 2 numbers"},
       {"OFF 1\n1 0 0\n", "m:1: the numbers of vertices, faces and edges are expected"},
       {"OFF 1 0 0\n1 0 0,5\n", "m:2: '0,5' is not a number"},
       {"OFF 1 0 0\n1 0\n9 9 9\n", "m:2: a vertex has fewer than three coordinates"},
       {"4OFF 1 0 0\n1 0 0 0\n",
        "m:1: an OFF file of another kind, '4OFF'; OFF with three coordinates is read"}});
}

std::string ply(const std::string& body, const std::string& format = "format ascii 1.0\n") {
  return "ply\n" + format +
         "element vertex 2\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
         "property list uchar int vertex_indices\nend_header\n" +
         body;
}

TEST(PlyVertices, AreRefusedWhereTheHeaderAndTheLinesDoNotMatch) {
  EXPECT_EQ(ply_vertices(ply("1 0 0\n0 2 0\n2 0 1\n"), "m").size(), 2U);
  expect_refusals(
      ply_vertices,
      {{ply("1 0 0\n0 2 0\n"), "m:11: the header promises 1 of 'face', and 0 bytes are left"},
       {ply("1 0 0\n0 2 0\n2 0 1\n9\n"), "m:13: the file goes on behind what its header promises"},
       {ply("1 0 0 9\n0 2 0\n2 0 1\n"), "m:10: a line has too many values"},
       {ply("1 0\n0 2 0\n2 0 1\n"), "m:10: a line has too few values"},
       {ply("1 0 0\n0 2 0\n2 0 b\n"), "m:12: 'b' is not a number"},
       {ply("1 0 0\n0 2 0\n2 0 1\n", ""), "m:8: a line of the PLY header is not understood"}});
}

std::vector<Vertex> pcd_vertices(std::string_view text, const std::string& name) {
  return pcd_points(text, name).vertices;
}

/// Two points with an intensity between y and z.
std::string pcd(const std::string& data, const std::string& size = "4 4 2 4") {
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS x y intensity z\nSIZE " + size +
         "\nTYPE F F U F\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA " + data;
}

std::string bytes_of(const std::vector<float>& numbers) {
  std::string bytes;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    char raw[sizeof(float)];
    std::memcpy(raw, &numbers[i], sizeof raw);
    bytes.append(raw, sizeof raw);
    if (i % 3 == 1) bytes.append("\x7f\x7f");
  }
  return bytes;
}

TEST(PcdPoints, AreThoseOfTextsAndOfBytes) {
  const std::vector<Vertex> points = {{1, 2, 3}, {4, 5, 6.5}};
  EXPECT_EQ(pcd_vertices(pcd("ascii\n1 2 9 3\n4 5 9 6.5\n"), "m"), points);
  EXPECT_EQ(pcd_vertices(pcd("binary\n" + bytes_of({1, 2, 3, 4, 5, 6.5F})), "m"), points);
}

TEST(PcdPoints, AreRefusedWhereTheHeaderAndTheDataDoNotMatch) {
  const std::string nan = bytes_of({1, 2, 3, 4, std::nanf(""), 6});
  expect_refusals(
      pcd_vertices,
      {{pcd("ascii\n1 2 9 3\n"), "m:11: the header promises 2 points, and 8 bytes are left"},
       {pcd("ascii\n1 2 9 3\n4 5 6\n      "), "m:13: a point of 3 numbers; the header promises 4"},
       {pcd("ascii\n1 2 9 3\n4 x 9 6\n"), "m:13: 'x' is not a number"},
       {pcd("ascii\n1 2 9 3\n4 nan 9 6\n"), "m:13: 'nan' is not a finite number"},
       {pcd("ascii\n1 2 9 3\n4 5 9 6\n7\n"), "m:14: the file goes on behind what its header promises"},
       {pcd("binary\n" + nan), "m: point 1, counted from 0, is not finite: leave out what was not measured"},
       {pcd("binary\n" + bytes_of({1, 2, 3, 4, 5})),
        "m:11: the header promises 2 points, and 24 bytes are left"},
       {pcd("binary\n", "4 4 2 2"), "m:11: x, y and z are read as single numbers of TYPE F and SIZE 4 or 8"},
       {pcd("binary\n", "4 4 4"), "m:4: SIZE is not one word a field, behind FIELDS"},
       {pcd("binary_compressed\n"),
        "m:11: DATA binary_compressed is not read: pcl_convert_pcd_ascii_binary IN OUT 1 writes binary"},
       {"FIELDS x y\n", "m:1: its points have no fields x, y and z"},
       {"POINTS 1\nDATA ascii\n", "m:2: its points have no fields x, y and z"},
       {"FIELDS x y z\nDATA ascii\n", "m: no points"},
       {"ply\n", "m:1: 'ply' is no line of the header of a PCD file"},
       {"FIELDS x y z\nFIELDS x y z\n", "m:2: FIELDS stands there twice"},
       {"FIELDS x y z\nWIDTH 2\nHEIGHT 2\nPOINTS 3\nDATA ascii\n", "m:5: WIDTH times HEIGHT is not POINTS"},
       {"FIELDS x y z\nWIDTH w\n", "m:2: 'w' is not a count"},
       {"FIELDS x y z\nPOINTS 1\nDATA binary\n123456789012", "m:3: binary points need SIZE and TYPE"},
       {"VERSION 0.7\n", "m:1: the file ends before what its header promises"}});
}

/// A triangle in Collada; `node` stands inside its node, in front of the mesh.
std::string collada(const std::string& asset, const std::string& node = "",
                    const std::string& faces = "0 1 2") {
  return "<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\"><asset>" + asset +
         "</asset><library_geometries><geometry id=\"g\"><mesh>\n<source id=\"p\"><float_array id=\"pa\" "
         "count=\"9\">"
         "1 0 0 0 2 0 0 0 4</float_array><technique_common><accessor source=\"#pa\" count=\"3\" stride=\"3\">"
         "<param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" "
         "type=\"float\"/>"
         "</accessor></technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" "
         "source=\"#p\"/>"
         "</vertices>\n<triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>" +
         faces +
         "</p></triangles></mesh></geometry></library_geometries>\n<library_visual_scenes><visual_scene "
         "id=\"s\"><node>" +
         node +
         "<instance_geometry url=\"#g\"/></node></visual_scene></library_visual_scenes><scene>"
         "<instance_visual_scene url=\"#s\"/></scene></COLLADA>";
}

TEST(ColladaVertices, MayStandOnLinesOfTheirOwn) {
  std::string text = collada("");
  text.replace(text.find("1 0 0 0 2"), 9, "\n1 0 0\r\n0 2");
  EXPECT_EQ(collada_vertices(text, "m"), kTriangle);
}

TEST(ColladaFaces, AreTurnedAboutByAMirror) {
  const auto corners = [](const std::string& node) {
    return collada_mesh(collada("", node), "m").faces.corners;
  };
  EXPECT_EQ(corners("<scale>1 2 1</scale>"), (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(corners("<scale>1 -2 1</scale>"), (std::vector<std::uint32_t>{2, 1, 0}));
}

TEST(ColladaVertices, KeepTheAxesOfTheFileAndTakeItsUnit) {
  for (const char* up : {"X_UP", "Y_UP", "Z_UP"})
    EXPECT_EQ(collada_vertices(collada(std::string("<up_axis>") + up + "</up_axis>"), "m"), kTriangle) << up;
  const std::vector<Vertex> large = {{2, 0, 0}, {0, 4, 0}, {0, 0, 8}};
  EXPECT_EQ(collada_vertices(collada("<unit meter=\"2\"/><up_axis>Z_UP</up_axis>"), "m"), large);
}

TEST(ColladaVertices, AreMovedByTheNodesThatHoldThem) {
  const auto moved = [](const std::string& node) {
    return collada_vertices(collada("", node), "m").at(0);
  };  // (1, 0, 0)
  EXPECT_EQ(moved("<translate>1 2 3</translate><scale>2 1 1</scale>"), (Vertex{3, 2, 3}));
  EXPECT_EQ(moved("<matrix>0 0 1 5 1 0 0 6 0 1 0 7 0 0 0 1</matrix>"), (Vertex{5, 7, 7}));
  EXPECT_NEAR(moved("<rotate>0 0 2 90</rotate>")[1], 1, 1e-15);
  EXPECT_EQ(
      collada_vertices(
          collada("", "<node><translate>0 0 9</translate><instance_geometry url=\"#g\"/></node>"), "m")[0],
      (Vertex{1, 0, 9}));
}

TEST(ColladaVertices, AreRefusedWithTheLineOfWhatIsNotUnderstood) {
  const auto with = [](const std::string& old, const std::string& fresh) {
    std::string text = collada("");
    return text.replace(text.find(old), old.size(), fresh);
  };
  expect_refusals(
      collada_vertices,
      {{"<robot/>", "m:1: not a Collada file: its root is <robot>, not <COLLADA>"},
       {collada("", "", "0 1 nan"), "m:3: 'nan' is not a count"},
       {collada("", "", "0 1 3"), "m:3: vertex 3 is not there: 3 are, counted from 0"},
       {with("1 0 0 0", "1 0 0,5 0"), "m:2: '0,5' is not a finite number"},
       {with("count=\"9\"", "count=\"8\""), "m:2: <float_array> has 9 numbers, 8 are expected"},
       {with("count=\"3\"", "count=\"4\""),
        "m:2: it reads beyond the numbers that there are, or fewer than three for a position"},
       {with("source=\"#p\"", "source=\"#q\""), "m:2: source names no <source> of this file: '#q'"},
       {with("POSITION", "POSITIO"), "m:2: vertices without positions"},
       {with("<instance_geometry url=\"#g\"/>", "<instance_geometry url=\"o.dae#g\"/>"),
        "m:4: url names no <geometry> of this file: 'o.dae#g'"},
       {collada("<unit meter=\"0\"/>"), "m:1: the unit must be positive"},
       {collada("", "<skew>1 2 3 4 5 6 7</skew>"), "m:4: <skew> is not read"},
       {collada("", "<translate>1 2</translate>"), "m:4: <translate> has 2 numbers, 3 are expected"}});
  std::string circle = collada("", "<node id=\"n\"><instance_node url=\"#n\"/></node>");
  EXPECT_EQ(error(collada_vertices, circle), "m:4: nodes that contain themselves, or too many");
}

using Corners = std::vector<std::uint32_t>;

TEST(Faces, AreTheCornersInTheOrderOfTheFile) {
  const Corners all = {0, 1, 2, 2, 1, 0};
  const std::string v = "v 1 0 0\nv 0 2 0\nv 0 0 4\n";
  EXPECT_EQ(obj_mesh(v + "f 1/1 2/2 3\nf -1 -2 -3\nl 1 2\n", "m").faces.corners, all);
  EXPECT_EQ(obj_mesh("f 1 2 3\n" + v + "f 3 2 1\n", "m").faces.ends, (std::vector<std::size_t>{3, 6}));
  EXPECT_EQ(off_mesh("OFF 3 2\n1 0 0\n0 2 0\n0 0 4\n3 0 1 2 255 0 0\n3 2 1 0\n", "m").faces.corners, all);
  EXPECT_EQ(ply_mesh(ply("1 0 0\n0 2 0\n2 0 1\n"), "m").faces.corners, (Corners{0, 1}));
  EXPECT_EQ(stl_mesh(binary_stl("binary", 2, 2), "m").faces.corners, (Corners{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(collada_mesh(collada("", "", "0 1 2 2 1 0"), "m").faces.corners, all);
  EXPECT_EQ(error(ply_vertices, ply("1 0 0\n0 2 0\n2 0 2\n")),
            "m:12: vertex 2 is not there: 2 are, counted from 0");
}

TEST(Faces, OfColladaAreListsStripsAndFans) {
  const auto corners = [](const std::string& kind, const std::string& before, const std::string& faces) {
    std::string text = collada("", "", faces);
    for (const std::string mark : {"<triangles", "</triangles"})
      text.replace(text.find(mark), mark.size(), mark.substr(0, mark.size() - 9) + kind);
    return collada_mesh(text.replace(text.find("<p>"), 0, before), "m").faces.corners;
  };
  EXPECT_EQ(corners("tristrips", "", "0 1 2 0"), (Corners{0, 1, 2, 2, 1, 0}));
  EXPECT_EQ(corners("trifans", "", "0 1 2 1"), (Corners{0, 1, 2, 0, 2, 1}));
  EXPECT_EQ(corners("polylist", "<vcount>3 2</vcount>", "0 1 2 1 2"), (Corners{0, 1, 2, 1, 2}));
  EXPECT_EQ(corners("lines", "", "0 1"), Corners{});
  EXPECT_THROW(corners("polylist", "<vcount>3 3</vcount>", "0 1 2 1 2"), InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::cli::test_mesh_formats
