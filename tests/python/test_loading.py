# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Files of one's own are read as the program reads them: sets, robots, scenes."""
import json
import os
import pathlib
import pickle
import subprocess
import tempfile
import unittest

import h5py
import numpy as np
import raygauge as rg

SOURCE = pathlib.Path(os.environ["RAYGAUGE_SOURCE"])
SCENES = SOURCE / "experiments/scenes"
DOCUMENTED = SOURCE / "tests" / "cli" / "documented"


class Loading(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def distance_of_program(self, A, Q):
        answer = subprocess.run([os.environ["RAYGAUGE_PROGRAM"], "distance", A, Q, "--json"], capture_output=True, text=True,
                                check=True).stdout
        return json.loads(answer)["distance"]

    def test_a_set_of_each_kind_of_file_has_the_distance_that_the_program_says(self):
        points = self.folder / "points.h5"
        with h5py.File(points, "w") as file:
            file["A"] = [[3.0, 0, 0], [4, 1, 0], [4, 0, 1]]
        sources = [DOCUMENTED / "A.csv", DOCUMENTED / "Q.obj", DOCUMENTED / "capsule.toml", SCENES / "stone.off", f"{points}:/A"]
        Q = DOCUMENTED / "ellipsoid.toml"
        for source in sources:
            with self.subTest(str(source)):
                mine = rg.distance(rg.load_set(source), rg.load_set(Q))
                self.assertEqual(mine.distance, self.distance_of_program(source, Q))

    def test_a_loaded_set_is_of_its_class_and_pickled(self):
        capsule = rg.load_set(DOCUMENTED / "capsule.toml")
        self.assertIsInstance(pickle.loads(pickle.dumps(capsule)), rg.Capsule)
        self.assertIsInstance(rg.load_set(DOCUMENTED / "A.csv"), rg.PointSet)

    def test_a_heading_is_skipped_where_that_is_said(self):
        path = self.folder / "with_heading.csv"
        path.write_text("x,y\n1,2\n")
        self.assertEqual(len(rg.load_set(path, skip_header=True)), 1)
        with self.assertRaisesRegex(rg.Error, "with_heading.csv"):
            rg.load_set(path)

    def test_what_is_missing_is_named(self):
        with self.assertRaisesRegex(rg.Error, "nowhere.off"):
            rg.load_set(self.folder / "nowhere.off")
        with self.assertRaisesRegex(rg.Error, "nowhere.toml"):
            rg.load_scene(self.folder / "nowhere.toml")
        with self.assertRaisesRegex(rg.Error, "nowhere.urdf"):
            rg.load_robot(self.folder / "nowhere.urdf")

    def test_a_scene_file_has_the_answers_of_the_program(self):
        scene = pickle.loads(pickle.dumps(rg.load_scene(SCENES / "two_vehicles.toml")))
        answers = scene.run()
        output = self.folder / "scene.h5"
        subprocess.run([os.environ["RAYGAUGE_PROGRAM"], "scene", "run", SCENES / "two_vehicles.toml", "-o", output, "--quiet"],
                       check=True, capture_output=True)
        theirs = rg.open(output)
        self.assertEqual(set(answers["query"]), set(scene.queries))
        self.assertEqual(len(answers["query"]), theirs.sizes["record"])
        mine = answers["distance"][np.isfinite(answers["distance"])]
        other = theirs.distance.values[np.isfinite(theirs.distance.values)]
        np.testing.assert_allclose(np.sort(mine), np.sort(other), rtol=1e-6)
        self.assertEqual(len(scene.explain()), len(scene.queries))

    def test_overrides_change_a_scene(self):
        whole = rg.load_scene(SCENES / "falling_box.toml")
        with self.assertRaisesRegex(rg.Error, "nonsense"):
            rg.load_scene(SCENES / "falling_box.toml", set=["nonsense=1"])
        self.assertGreater(len(whole.instants), 2)

    def test_a_robot_has_its_links_where_its_joints_put_them(self):
        robot = rg.load_robot(SCENES / "arm.urdf")
        home = robot.poses()
        self.assertEqual(list(home), list(robot.links))
        for link, matrix in home.items():
            np.testing.assert_allclose(matrix[:3, :3] @ matrix[:3, :3].T, np.eye(3), atol=1e-12, err_msg=link)
            np.testing.assert_array_equal(matrix[3], [0, 0, 0, 1])
        moved = robot.poses({robot.joints[0]: 1.0})
        self.assertTrue(any(not np.allclose(moved[link], home[link]) for link in robot.links))
        np.testing.assert_array_equal(moved[robot.links[0]], home[robot.links[0]])
        with self.assertRaisesRegex(rg.UnknownNameError, "no joint is called 'elbwo'"):
            robot.poses({"elbwo": 1})
        with self.assertRaises(rg.DimensionMismatchError):
            robot.poses([0.0])

    def test_a_robot_stands_in_a_scene(self):
        robot = rg.load_robot(SCENES / "arm.urdf")
        scene = rg.Scene([0.0])
        scene.add_robot(robot, {robot.joints[0]: 0.5})
        scene.add_body("ball", rg.Ball([0, 0, 30], 1))
        scene.add_query(["distance"], between=(robot.name, "ball"))
        distances = scene.run()["distance"]
        self.assertEqual(len(distances), sum(1 for link in robot.links if robot.shapes(link)))
        self.assertTrue((distances > 20).all())


if __name__ == "__main__":
    unittest.main()
