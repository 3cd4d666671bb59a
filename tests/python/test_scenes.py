# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Scenes, prepared sets and paths from Python."""
import unittest

import numpy as np

import raygauge as rg


def turned(angle, x=0.0):
    """Turned about the third axis, then moved along the first."""
    pose = np.eye(4)
    pose[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    pose[0, 3] = x
    return pose


class Scenes(unittest.TestCase):
    def approach(self):
        """A ball that comes towards a box at speed 1 and touches it at time 2."""
        scene = rg.Scene(np.linspace(0, 3, 7))
        scene.add_body("ball", rg.Ball([-3.5, 0, 0], 1), velocity=[1, 0, 0], groups=["moving"])
        scene.add_body("box", [rg.Box([-0.5] * 3, [0.5] * 3), rg.Ball([9, 9, 9])], groups=["fixed"])
        return scene

    def test_a_floor_is_a_half_space(self):
        scene = rg.Scene(np.linspace(0, 2, 5))
        scene.add_body("ball", rg.Ball([0, 0, 2], 0.5), velocity=[0, 0, -1])
        scene.add_body("floor", rg.HalfSpace([0, 0, 3], 0))
        scene.add_query(["depth", "time_of_impact"])
        answers = scene.run()
        at = answers.where(kind="instant")
        signed = np.where(at["depth"] > 0, -at["depth"], at["distance"])
        np.testing.assert_allclose(signed, 1.5 - at["time"], atol=1e-12)
        np.testing.assert_allclose(answers.where(kind="time_of_impact")["time"], [1.5], atol=1e-6)
        scene.add_query(["growth"])
        with self.assertRaisesRegex(rg.InvalidParameterError, "floor.*half-space.*no centre"):
            scene.run()

    def test_depth_is_that_of_the_ball_in_the_box(self):
        scene = self.approach()
        scene.add_query(["depth"], between=("moving", "fixed"))
        answers = scene.run()
        gap = np.abs(-3.5 + answers["time"]) - 1.5
        signed = np.where(answers["depth"] > 0, -answers["depth"], answers["distance"])
        np.testing.assert_allclose(signed, gap, atol=1e-9)
        self.assertTrue(np.all(answers["depth_lower"] <= answers["depth"]))
        np.testing.assert_allclose(answers["gradient"][gap != 0, 0], -1, atol=1e-6)

    def test_distances_at_instants_and_the_time_of_impact(self):
        scene = self.approach()
        scene.add_query(["distance", "closest_points", "gradient"], between=("moving", "fixed"), name="gap")
        scene.add_query(["time_of_impact"], name="touch")
        answers = scene.run()
        gap = answers.where(query="gap", kind="instant")
        np.testing.assert_allclose(gap["distance"], [2, 1.5, 1, 0.5, 0, 0, 0], atol=1e-5)
        np.testing.assert_allclose(gap["point_b"][:3, 0], -0.5, atol=1e-5)
        np.testing.assert_allclose(gap["gradient"][:3], [[-1, 0, 0]] * 3, atol=1e-4)
        self.assertEqual(set(gap["body_a"]), {"ball"})
        touch = answers.where(query="touch")
        self.assertEqual(list(touch["status"]), ["contact"])
        self.assertLessEqual(touch["time_lower"][0], 2.0)
        self.assertAlmostEqual(touch["time_upper"][0], 2.0, delta=1e-4)
        self.assertTrue(np.isnan(touch["distance"][0]) or touch["distance"][0] <= 1e-6)

    def test_answers_do_not_depend_on_the_threads(self):
        scene = self.approach()
        scene.add_query(["distance"])
        scene.add_query(["clearance"])
        one, two = scene.run(threads=1), scene.run(threads=2)
        for name in set(one) - {"seconds"}:
            np.testing.assert_array_equal(one[name], two[name], err_msg=name)

    def test_keyframes_and_pairs_left_out(self):
        scene = rg.Scene([0, 0.5, 1])
        rod = rg.Capsule([0, 0, 0], [2, 0, 0], 0.1)
        scene.add_body("rod", rod, times=[0, 1], poses=[turned(0), turned(np.pi / 2)])
        scene.add_body("peg", rg.Ball([0, 3, 0], 0.5))
        scene.add_body("wall", rg.Box([-9, -9, -1], [-8, 9, 1]))
        scene.ignore("rod", "wall")
        scene.add_query(["distance"], between=("rod", "peg"))
        scene.add_query(["separated"], name="all", every_instant=True)
        answers = scene.run()
        middle = answers.where(query="query 1", instant=1)["distance"][0]
        tip = np.array([np.sqrt(2), np.sqrt(2)])
        self.assertAlmostEqual(middle, np.linalg.norm(tip - [0, 3]) - 0.6, places=5)
        pairs = {(a, b) for a, b in zip(answers.where(query="all")["body_a"], answers.where(query="all")["body_b"])}
        self.assertEqual(pairs, {("rod", "peg"), ("peg", "wall")})

    def test_explain_says_what_is_computed(self):
        scene = self.approach()
        scene.add_query(["distance"], within=1.0)
        self.assertTrue(any("within" in line or "1" in line for line in scene.explain()[0]))

    def test_a_frame_has_a_row_for_each_answer(self):
        scene = self.approach()
        scene.add_query(["closest_points"])
        frame = scene.run().to_dataframe()
        self.assertEqual(len(frame), 7)
        self.assertIn("point_a_2", frame.columns)

    def test_a_grasp_in_six_dimensions(self):
        corners = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]) / np.sqrt(3)
        grasp = rg.UnionHull([rg.ContactWrenches(p, -p, 0.5, 4) for p in corners])
        scene = rg.Scene()
        scene.add_body("zero", np.zeros((1, 6)))
        scene.add_body("task", [[0, 0, 1, 0, 0, 0.2]])
        scene.add_query(["distance"], metric=grasp)
        found = scene.run()
        direct = rg.distance([[0, 0, 1, 0, 0, 0.2]], grasp, 1e-6)
        self.assertAlmostEqual(found["distance"][0], direct.distance, delta=1e-5)
        self.assertAlmostEqual(found["distance"][0], 1.218, delta=1e-3)  # docs/scenes.md

    def test_one_group_and_one_effect_need_no_list(self):
        scene = self.approach()
        scene.add_body("hand", rg.Ball([9, 0, 0]), groups="arm")
        scene.add_query("distance", between=("arm", "box"))
        self.assertEqual(set(scene.run()["body_b"]) | set(scene.run()["body_a"]), {"hand", "box"})

    def test_arrays_that_change_later_change_no_scene(self):
        pose, points = np.eye(3), np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
        scene = rg.Scene()
        for k in range(2):
            pose[0, 2] = 3.0 * k
            scene.add_body(f"triangle {k}", points, pose=pose)
        points *= 10
        scene.add_query(["distance"])
        self.assertAlmostEqual(scene.run()["distance"][0], 2.0)

    def test_mistakes_are_exceptions_of_ours(self):
        scene = self.approach()
        for mistake in (
            lambda: scene.add_body("ball", rg.Ball([0, 0, 0])),
            lambda: scene.add_body("x", rg.Ball([0, 0, 0]), times=[0, 1]),
            lambda: scene.add_query(["distance"], between=("ball", "nobody")),
            lambda: scene.add_query(["distance"], between=()),
            lambda: scene.add_query(["distance"], between=("ball", "box", "ball")),
            lambda: scene.ignore("nobody", "box"),
        ):
            self.assertRaises(rg.Error, mistake)
        for wrong in ({"effects": ["distances"]}, {"effects": []}, {"effects": ["distance"], "tolerance": 2},
                      {"effects": ["distance"], "metric": rg.Ball([0, 0])}, {"effects": ["distance"], "within": "near"},
                      {"effects": ["distance"], "within": None}, {"effects": ["distance"], "nearest": 1.5},
                      {"effects": ["distance"], "name": 3}, {"effects": [3]}):
            other = self.approach()
            other.add_query(**wrong)
            self.assertRaises(rg.Error, other.run)
        for body in ({"pose": np.eye(3)}, {"pose": 2 * np.eye(4)}, {"velocity": [1, 2]}, {"spin": 1.0},
                     {"pose": np.full((4, 4), np.nan)}, {"times": [0, 3], "poses": np.eye(4)}):
            other = self.approach()
            other.add_body("wrong", rg.Ball([5, 0, 0]), **body)
            self.assertRaises(rg.Error, other.run)
        other = self.approach()
        other.add_body(3, rg.Ball([5, 0, 0]))
        self.assertRaisesRegex(rg.InvalidParameterError, "name cannot be 3", other.run)
        self.assertRaises(rg.Error, rg.Scene().run)
        self.assertRaisesRegex(rg.InvalidParameterError, "instants are times in seconds, got 'name'", rg.Scene, "name")
        self.assertRaises(rg.Error, rg.Scene([1, 0]).run)


class PreparedSets(unittest.TestCase):
    def test_answers_are_those_of_the_points_warm_and_cold(self):
        generator = np.random.default_rng(3)
        A, B = generator.normal(size=(2, 300, 3))
        pair = rg.PreparedSet(A), rg.PreparedSet(B)
        euclidean, warm = rg.Ball(np.zeros(3)), rg.WarmStart()
        for step in range(20):
            pose = turned(0.02 * step, 6 + 0.01 * step)
            plain = rg.object_distance(A, B, euclidean, pose_2=pose)
            climbed = rg.object_distance(*pair, euclidean, pose_2=pose, warm=warm)
            self.assertLessEqual(max(plain.lower, climbed.lower), min(plain.upper, climbed.upper) * (1 + 1e-12))
        if rg.PreparedSet.has_hulls():
            self.assertGreater(pair[0].vertex_count, 0)
            self.assertLess(len(pair[0]), 300)
        self.assertGreater(pair[0].memory, 0)
        self.assertEqual(pair[0].points.shape, (len(pair[0]), 3))

    def test_what_is_no_point_set_cannot_be_prepared(self):
        self.assertRaises(rg.InvalidParameterError, rg.PreparedSet, rg.Ball([0, 0, 0]))
        self.assertRaises(rg.NonFiniteError, rg.PreparedSet, [[np.nan, 0, 0]])


class Paths(unittest.TestCase):
    def test_a_path_gives_the_same_answers_within_their_bounds_on_any_threads(self):
        cloud = rg.PreparedSet(np.random.default_rng(4).normal(size=(200, 3)))
        poses = np.array([turned(0.01 * k, 5 - 0.01 * k) for k in range(100)])
        ball = rg.Ball(np.zeros(3))
        cold = rg.distances(cloud, ball, poses_A=poses, method="newton")
        one = rg.distances(cloud, ball, poses_A=poses, method="newton", along_path=True, threads=1)
        many = rg.distances(cloud, ball, poses_A=poses, method="newton", along_path=True, threads=3)
        np.testing.assert_array_equal(one.distance, many.distance)
        np.testing.assert_array_equal(one.lower, many.lower)
        self.assertTrue((np.maximum(cold.lower, one.lower) <= np.minimum(cold.upper, one.upper)).all())
        self.assertEqual(set(one.status), {"optimal"})


if __name__ == "__main__":
    unittest.main()
