// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/hull_note.h"

#include <gtest/gtest.h>

#include "cli/input/set_source.h"
#include "engine/sets/hull_3d.h"
#include "tests/cli/input/mesh_text.h"
#include "tests/results/support.h"

namespace raygauge::cli::test_hull_note {
namespace {

using raygauge::testing::box_shape;
using raygauge::testing::hollow;
using raygauge::testing::kOne;
using raygauge::testing::kZero;
using raygauge::testing::MeshShape;
using raygauge::testing::obj_text;

class HullNote : public ::testing::Test {
 protected:
  Notes notes_of(const std::string& name, const std::string& bytes) {
    testing::write_bytes(folder_.file(name), bytes);
    Notes notes;
    read_set_source(folder_.file(name), {}, &notes);
    read_set_source(folder_.file(name), {}, &notes);
    return notes;
  }
  testing::TemporaryFolder folder_;
};

TEST_F(HullNote, IsSaidOnceOfAMeshThatIsNotConvexWithBothVolumes) {
  const Notes notes = notes_of("hollow.obj", obj_text(hollow()));
  ASSERT_EQ(notes.size(), 1U);
  const std::string expected = has_hull_3d() ? ": the hull has 27 of volume, the mesh 26" : "";
  EXPECT_EQ(notes[0], folder_.file("hollow.obj") +
                          ": this mesh is not convex, and its convex hull stands for it" + expected +
                          "; shape = \"mesh\" of a set file takes it as it is, and so does a scene without "
                          "as = \"hull\"; convex parts (as = \"parts\") have a depth, too");
}

TEST_F(HullNote, SaysThatAMeshIsOpen) {
  MeshShape open = box_shape(kZero, kOne);
  open.triangles.pop_back();
  const Notes notes = notes_of("open.obj", obj_text(open));
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("the surface is not closed, so it bounds no volume"), std::string::npos);
}

TEST_F(HullNote, IsNotSaidOfConvexMeshesAndOfPointsWithoutFaces) {
  EXPECT_TRUE(notes_of("box.obj", obj_text(box_shape(kZero, kOne, 3))).empty());
  EXPECT_TRUE(notes_of("points.obj", "v 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 0\n").empty());
  EXPECT_TRUE(notes_of("cube.obj",
                       "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                       "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n")
                  .empty());
  EXPECT_TRUE(notes_of("points.csv", "0 0 0\n1 1 1\n").empty());
}

}  // namespace
}  // namespace raygauge::cli::test_hull_note
