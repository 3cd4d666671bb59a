// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/set_file.h"

#include <gtest/gtest.h>

#include <map>

#include "cli/input/set_source.h"
#include "raygauge/exceptions.h"
#include "raygauge/meshes/mesh.h"
#include "raygauge/sets/half_space.h"
#include "raygauge/sets/point_set.h"
#include "tests/results/complaint.h"
#include "tests/results/support.h"

namespace raygauge::cli::test_set_file {
namespace {

using testing::TemporaryFolder;
using testing::write_bytes;

class SetFiles : public ::testing::Test {
 protected:
  SetPointer read(const std::string& text) const {
    write_bytes(folder_.file("set.toml"), text);
    return read_set_source(folder_.file("set.toml"));
  }

  /// What is said of the text, without the folder.
  std::string complaint(const std::string& text) const {
    return testing::complaint_of(folder_, [&] { read(text); });
  }

  TemporaryFolder folder_;
};

/// A set file, and the support function of its set along (1, 2).
struct Described {
  std::string text;
  double support;
};

const double kLength = std::sqrt(5.0);  // of (1, 2)

/// One text for each shape.
constexpr const char* kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 1 2 3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

std::map<std::string, Described> described_shapes() {
  const std::string ball = "{shape = \"ball\", center = [1, 0], radius = 2}";
  return {
      {"point_set", {"points = [[1, 2], [3, -4], [0, 0]]", 5}},
      {"file", {"file = \"points.csv\"", 9}},
      {"ball", {"center = [1, 0]\nradius = 2", 1 + 2 * kLength}},
      {"ellipsoid", {"center = [1, 1]\nfactor = [[3, 0], [0, 2.0]]", 3 + 5}},
      {"p_norm_ball", {"center = [0, 0]\nsemi_axes = [3, 2]\np = inf", 3 + 4}},
      {"box", {"lower = [-1, -2]\nupper = [3, 5]", 3 + 10}},
      {"simplex", {"corner = [1, 1]\nlegs = [2, -3]", 3 + 2}},
      {"h_polytope", {"G = [[1, 0], [0, 1], [-1, -1]]\ng = [3, 4, 5]", 3 + 8}},
      {"half_space", {"normal = [1, 2]\noffset = 7", 7}},
      {"cloud", {"file = \"tetra.obj\"\nradius = 0.5", 4}},
      {"height_field", {"file = \"points.csv\"\nspacing = 1\nunit = 1\nfloor = -3", 2 + 3 * 4}},
      {"mesh", {"file = \"tetra.obj\"\nas = \"hull\"", 5}},
      {"zonotope", {"center = [1, 1]\ngenerators = [[1, 0], [0, 2], [1, -1]]", 3 + 1 + 4 + 1}},
      {"capsule", {"p = [0, 0]\nq = [3, 1]\nradius = 1", 5 + kLength}},
      {"cylinder", {"p = [0, 0]\nq = [3, 0]\nradius = 2", 3 + 4}},
      {"contact_wrenches", {"p = [0, 0, 1]\nn = [2, 0, 0]\nmu = 0.5\nfacets = 0", 1 + 0.5 * 2}},
      {"truncated_cone", {"base = [0, 0]\nbase_radius = 1\ntop = [3, 0]\ntop_radius = 2", 3 + 4}},
      {"affine_image", {"S = " + ball + "\nM = [[0, 1], [2, 0]]\nt = [0, 1]", 2 + 4 + 2 * std::sqrt(17.0)}},
      {"rigid_image", {"S = " + ball + "\nR = [[0, -1], [1, 0]]\nt = [1, 0]", 1 + 2 + 2 * kLength}},
      {"minkowski_sum",
       {"A = " + ball + "\nB = {shape = \"point_set\", points = [[3, 1]]}", 6 + 2 * kLength}},
      {"minkowski_difference",
       {"A2 = {shape = \"point_set\", points = [[3, 1]]}\nA1 = " + ball, 4 + 2 * kLength}},
      {"union_hull", {"sets = [" + ball + ", {shape = \"point_set\", points = [[9, 9]]}]", 27}},
  };
}

TEST_F(SetFiles, DescribeEveryShape) {
  write_bytes(folder_.file("points.csv"), "1 4\n3 -1\n");
  write_bytes(folder_.file("tetra.obj"), kTetrahedron);
  const std::map<std::string, Described> described = described_shapes();
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    const auto found = described.find(shape.name);
    ASSERT_NE(found, described.end());
    const SetPointer set = read("shape = \"" + shape.name + "\"\n" + found->second.text);
    if (const Mesh* mesh = as_mesh(*set)) {  // has no support function
      EXPECT_EQ(static_cast<double>(mesh->size()), found->second.support);
      continue;
    }
    Vector u = Vector::Zero(set->dimension());
    u.head(2) << 1, 2;
    const HalfSpace* half_space = as_half_space(*set);
    const double support = half_space == nullptr ? set->support_function(u)
                                                 : half_space->offset() * u.dot(half_space->normal()) /
                                                       half_space->normal().squaredNorm();
    EXPECT_NEAR(support, found->second.support, 1e-14);
  }
}

TEST_F(SetFiles, TakeAMeshAsItsHullItsSurfaceOrTheSolidThatItBounds) {
  write_bytes(folder_.file("tetra.obj"), kTetrahedron);
  write_bytes(folder_.file("open.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto take = [&](const std::string& file, const std::string& as) {
    return read("shape = \"mesh\"\nfile = \"" + file + "\"\nas = \"" + as + "\"\n");
  };
  EXPECT_EQ(as_mesh(*take("tetra.obj", "hull")), nullptr);
  const SetPointer surface = take("tetra.obj", "surface"), solid = take("tetra.obj", "solid");
  ASSERT_NE(as_mesh(*surface), nullptr);
  EXPECT_EQ(as_mesh(*surface)->kind(), MeshKind::surface);
  ASSERT_NE(as_mesh(*solid), nullptr);
  EXPECT_DOUBLE_EQ(as_mesh(*solid)->volume(), 1.0 * 2 * 3 / 6);
  EXPECT_NO_THROW(take("open.obj", "surface"));
  const auto complaint = [&](const std::string& file, const std::string& as) {
    try {
      take(file, as);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(complaint("open.obj", "solid").find("open.obj: a solid needs a closed surface"),
            std::string::npos)
      << complaint("open.obj", "solid");
  EXPECT_NE(complaint("tetra.obj", "sold").find("solid"), std::string::npos);
  EXPECT_NE(complaint("none.obj", "solid").find("none.obj"), std::string::npos);
}

TEST_F(SetFiles, TakeACloudOfBallsFromPointsOfAnyFormat) {
  write_bytes(folder_.file("cloud.csv"), "x y z\n0 0 0\n0 0 5\n1 1 1\n");
  write_bytes(folder_.file("plane.csv"), "0 0\n1 1\n");
  write_bytes(folder_.file("cloud.pcd"), "VERSION .7\nFIELDS x y z\nPOINTS 1\nDATA ascii\n1 2 3\n");
  const auto complaint = [&](const std::string& file, const std::string& radius) {
    try {
      read("shape = \"cloud\"\nfile = \"" + file + "\"\nradius = " + radius + "\n");
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(complaint("cloud.pcd", "0"), "");
  EXPECT_NE(complaint("cloud.csv", "1").find("cloud.csv:1:1: 'x' is not a number"), std::string::npos)
      << complaint("cloud.csv", "1");
  EXPECT_NE(complaint("plane.csv", "1").find("plane.csv: a cloud has points of R^3, these are of R^2"),
            std::string::npos);
  EXPECT_NE(complaint("cloud.pcd", "-1").find("cloud.pcd: the radius of a cloud must lie in [0, 1e30]"),
            std::string::npos);
  EXPECT_NE(complaint("none.pcd", "1").find("none.pcd"), std::string::npos);
}

TEST_F(SetFiles, TakeTheSolidBelowHeights) {
  const auto take = [&](const std::string& name, const std::string& bytes, const std::string& rest) {
    write_bytes(folder_.file(name), bytes);
    return read("shape = \"height_field\"\nfile = \"" + name + "\"\n" + rest);
  };
  const std::string numbers = "spacing = 0.5\nunit = 2\nfloor = -1\n";
  for (const auto& [name, bytes] : std::map<std::string, std::string>{
           {"h.csv", "0 1 2\n1 2 3\n"},
           {"text.pgm", "P2 # a hill\n3 2\n9\n0 1 2 1 2 3\n"},
           {"one.pgm", std::string("P5\n3 2 255\n") + std::string("\0\1\2\1\2\3", 6)},
           {"two.pgm", std::string("P5\n3 2 256\n") + std::string("\0\0\0\1\0\2\0\1\0\2\0\3", 12)}}) {
    const SetPointer set = take(name, bytes, numbers);
    ASSERT_NE(as_mesh(*set), nullptr) << name;
    EXPECT_EQ(as_mesh(*set)->kind(), MeshKind::solid);
    // A cell of heights a, b, c, d has 0.25 (1 + 2 (2a + b + 2c + d) / 6), a and c on its diagonal.
    EXPECT_NEAR(as_mesh(*set)->volume(), 0.25 * (1 + 2.0) + 0.25 * (1 + 4.0), 1e-12) << name;
  }
  EXPECT_NEAR(as_mesh(*take("h.csv", "1 2\n2 3\n", "spacing = 1\n"))->volume(), 2, 1e-12)
      << "unit 1, floor 0";
  const auto complaint = [&](const std::string& name, const std::string& bytes, const std::string& rest) {
    try {
      take(name, bytes, rest);
    } catch (const Error& error) {
      const std::string text = error.what();
      return text.substr(std::min(text.find(name), text.size()));
    }
    return std::string();
  };
  EXPECT_EQ(complaint("h.csv", "0 1\n1 -0.5\n", numbers),
            "h.csv: the height in row 1 and column 1, counted from 0, is not above the floor");
  EXPECT_EQ(complaint("h.csv", "0 1 2\n", numbers), "h.csv: a height field needs 2 rows and columns or more");
  EXPECT_EQ(complaint("h.csv", "0 1\n1\n", numbers).substr(0, 13), "h.csv: line 2");
  EXPECT_EQ(complaint("a.pgm", "P6 2 2 9\n", numbers),
            "a.pgm: not a grey picture: it begins with neither P2 nor P5");
  EXPECT_EQ(complaint("a.pgm", "P5 2 2 9\n\1\1\1", numbers),
            "a.pgm: the header promises 2 x 2 numbers, and 3 bytes are left");
  EXPECT_EQ(complaint("a.pgm", "P2 2 2 9\n1 1 1 x", numbers), "a.pgm: number: 'x' is not a count");
  EXPECT_EQ(complaint("a.pgm", "P2 2 2 9\n1 1 1 10", numbers),
            "a.pgm: number 3, counted from 0, is more than 9");
  EXPECT_EQ(complaint("a.pgm", "P2 2 2 9\n1 1 1 1 1", numbers),
            "a.pgm: the file goes on behind what its header promises");
  EXPECT_EQ(complaint("a.pgm", "P2 2 2 70000\n1 1 1 1", numbers),
            "a.pgm: a width, height or greatest value of 0, or more than 65535");
}

TEST_F(SetFiles, AreDocumentedShapeByShape) {
  const std::string page = testing::read_bytes(RAYGAUGE_EXPERIMENTS "/../docs/sets.md");
  for (const Shape& shape : shapes()) {
    const std::size_t line = page.find("\n| `" + shape.name + "` |");
    ASSERT_NE(line, std::string::npos) << shape.name;
    const std::string text = page.substr(line + 1, page.find('\n', line + 1) - line);
    for (const ShapeParameter& parameter : shape.parameters)
      EXPECT_NE(text.find("`" + parameter.name + "`"), std::string::npos)
          << shape.name << " " << parameter.name;
  }
}

TEST_F(SetFiles, NameAllKeysThatAreMissing) {
  for (const Shape& shape : shapes()) {
    const std::string said = complaint("# nothing but\nshape = \"" + shape.name + "\"");
    EXPECT_TRUE(said.starts_with("set.toml:2: " + shape.name + " needs the key")) << said;
    for (const ShapeParameter& parameter : shape.parameters)
      EXPECT_EQ(said.find("'" + parameter.name + "'") != std::string::npos, !parameter.usual) << said;
  }
  EXPECT_EQ(complaint("shape = \"height_field\""),
            "set.toml:1: height_field needs the keys 'file', 'spacing'");
  EXPECT_EQ(complaint("shape = \"ball\"\nradius = 1"), "set.toml:1: ball needs the key 'center'");
}

TEST_F(SetFiles, TakeRowsAsPointsForEveryMethodOfPointSets) {
  const SetPointer set = read("shape = \"point_set\"\npoints = [[1, 2, 3], [4, 5, 6]]");
  const PointSet* points = as_point_set(*set);
  ASSERT_NE(points, nullptr);
  EXPECT_EQ(points->points(), (Eigen::MatrixXd{{1, 4}, {2, 5}, {3, 6}}));
}

TEST_F(SetFiles, FindFilesFromTheirOwnFolder) {
  std::filesystem::create_directories(folder_.file("parts/points"));
  write_bytes(folder_.file("parts/points/hand.csv"), "1 2\n");
  write_bytes(folder_.file("parts/hand.toml"), "shape = \"file\"\nfile = \"points/hand.csv\"");
  EXPECT_NE(as_point_set(*read("shape = \"file\"\nfile = \"parts/hand.toml\"")), nullptr);
  EXPECT_NE(as_point_set(*read("shape = \"file\"\nfile = \"" + folder_.file("parts/hand.toml") + "\"")),
            nullptr);
}

TEST_F(SetFiles, MayNameAFileTwiceButNotThemselves) {
  write_bytes(folder_.file("point.csv"), "1 2\n");
  write_bytes(folder_.file("part.toml"), "shape = \"file\"\nfile = \"point.csv\"");
  const std::string part = "{shape = \"file\", file = \"part.toml\"}";
  EXPECT_EQ(complaint("shape = \"minkowski_sum\"\nA = " + part + "\nB = " + part), "");
  EXPECT_EQ(complaint("shape = \"file\"\nfile = \"set.toml\""), "set.toml:2: this set file names itself");
  write_bytes(folder_.file("part.toml"), "shape = \"file\"\nfile = \"./set.toml\"");
  EXPECT_EQ(complaint("shape = \"file\"\nfile = \"part.toml\""),
            "set.toml:2: part.toml:2: ./set.toml: this set file names itself");
}

TEST_F(SetFiles, NameTheFileThatIsMissing) {
  EXPECT_EQ(complaint("shape = \"file\"\nfile = \"parts/none.csv\""),
            "set.toml:2: parts/none.csv: No such file or directory");
  EXPECT_EQ(complaint("shape = \"file\"\nfile = \"-\""), "set.toml:2: a set file cannot name standard input");
}

TEST_F(SetFiles, WithoutAShapeAreRefused) {
  for (const char* text : {"", "# a comment\n", "radius = 1"})
    EXPECT_EQ(complaint(text), "set.toml:1: a set needs a shape, as in shape = \"ball\"") << text;
  EXPECT_EQ(complaint("shape = 3"), "set.toml:1: shape must be a string, got 3");
  EXPECT_EQ(complaint("shape = \"minkowski_sum\"\nB = 2\n[A]\nshape = \"file\"\nfile = 1\n"),
            "set.toml:5: file.file must be a string, got 1");
}

TEST_F(SetFiles, AnswerUnknownNamesWithTheNearest) {
  EXPECT_EQ(complaint("shape = \"capsul\"")
                .rfind("set.toml:1: unknown shape 'capsul'; did you mean 'capsule'? (known: ", 0),
            0U);
  EXPECT_EQ(complaint("shape = \"ball\"\ncenter = [1, 2]\nradus = 1"),
            "set.toml:3: unknown key of ball 'radus'; did you mean 'radius'? (known: shape center radius)");
}

TEST_F(SetFiles, NameTheLineOfAValueOfAnotherType) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"center = 1\nradius = 1", "set.toml:2: ball.center must be a nonempty list of numbers, got 1"},
      {"center = []\nradius = 1", "set.toml:2: ball.center must be a nonempty list of numbers, got a list"},
      {"center = [1,\n  true]\nradius = 1", "set.toml:3: ball.center must be a number, got true"},
      {"center = [1,\n  nan]\nradius = 1", "set.toml:3: ball.center must be made of finite numbers, got nan"},
      {"center = [1,\n -inf]\nradius = 1",
       "set.toml:3: ball.center must be made of finite numbers, got -inf"},
      {"center = [1, 2]\nradius = \"big\"", "set.toml:3: ball.radius must be a number, got 'big'"},
      {"center = [1, 2]\nradius = nan", "set.toml:3: ball.radius must be a number, got nan"},
      {"center = [1, 2\nradius = 1", "set.toml:3: Error while parsing array"},
  };
  for (const auto& [text, expected] : cases)
    EXPECT_EQ(complaint("shape = \"ball\"\n" + text).substr(0, expected.size()), expected);
}

TEST_F(SetFiles, NameTheRowThatIsTooLong) {
  EXPECT_EQ(complaint("shape = \"point_set\"\npoints = [\n  [1, 2],\n  [3],\n]"),
            "set.toml:4: a row of point_set.points has 1 number, the first one has 2");
  EXPECT_EQ(complaint("shape = \"point_set\"\npoints = []"),
            "set.toml:2: point_set.points must be a nonempty list of rows, got a list");
}

TEST_F(SetFiles, PassOnWhatTheEngineRefuses) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"shape = \"ball\"\ncenter = [1, 2]\nradius = -1",
       "set.toml:1: ball: radius must not be negative, got -1"},
      {"shape = \"ball\"\ncenter = [1, 2]\nradius = inf",
       "set.toml:1: ball: radius must be a finite number, got inf"},
      {"shape = \"capsule\"\np = [1, 2]\nq = [1, 2, 3]\nradius = 1",
       "set.toml:1: capsule: q has dimension 3, the set lives in R^2"},
      {"shape = \"affine_image\"\nM = [[1, 2], [2, 4]]\nt = [0, 0]\n[S]\nshape = \"ball\"\ncenter = [0, 0]\n"
       "radius = 1",
       "set.toml:1: affine image: M must be invertible, but it is singular"},
      {"shape = \"affine_image\"\nM = [[1, 0], [0, 1]]\nt = [0, 0]\n[S]\nshape = \"ball\"\ncenter = [0, 0]\n"
       "radius = -2",
       "set.toml:5: ball: radius must not be negative, got -2"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(complaint(text), expected);
}

TEST_F(SetFiles, TakeSetsWhereSetsAreWanted) {
  EXPECT_EQ(complaint("shape = \"union_hull\"\nsets = []"),
            "set.toml:2: union_hull.sets must be a list of sets, [[sets]]");
  EXPECT_EQ(complaint("shape = \"union_hull\"\nsets = [1]"),
            "set.toml:2: union_hull.sets must be a set, that is a table with a shape");
  EXPECT_EQ(complaint("shape = \"minkowski_sum\"\nA = 1\nB = 2"),
            "set.toml:2: minkowski_sum.A must be a set, that is a table with a shape");
}

TEST_F(SetFiles, EndWhereSetsLieTooDeep) {
  const auto nested = [](int depth) {
    std::string text, path;
    for (int i = 0; i < depth; ++i) {
      text += "shape = \"rigid_image\"\nR = [[1]]\nt = [0]\n";
      path += i == 0 ? "S" : ".S";
      text += "[" + path + "]\n";
    }
    return text + "shape = \"ball\"\ncenter = [0]\nradius = 1\n";
  };
  EXPECT_EQ(complaint(nested(kDeepestSet)), "");
  EXPECT_NE(complaint(nested(kDeepestSet + 1)).find("more than 16 sets inside one another"),
            std::string::npos);
}

}  // namespace
}  // namespace raygauge::cli::test_set_file
