# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Edges of a robot from Python: the closed form of an arm and a ball, motions, grasped objects, mistakes."""

import math
import pathlib
import tempfile
import unittest

import numpy as np
import raygauge as rg

ROD = '<collision><origin rpy="0 1.5707963267948966 0" xyz="0.5 0 0"/><geometry><capsule length="1" radius="0.05"/></geometry></collision>'
ARM = (
    f'<robot name="arm"><link name="ground"/><link name="inner">{ROD}</link><link name="flange"/><link name="outer">{ROD}</link>'
    '<joint name="j" type="revolute"><parent link="ground"/><child link="inner"/><axis xyz="0 0 1"/></joint>'
    '<joint name="f" type="fixed"><origin xyz="1 0 0"/><parent link="inner"/><child link="flange"/></joint>'
    '<joint name="k" type="revolute"><parent link="flange"/><child link="outer"/><axis xyz="0 0 1"/></joint></robot>'
)


class Edges(unittest.TestCase):
    def setUp(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "arm.urdf"
            path.write_text(ARM)
            self.robot = rg.load_robot(path)
        self.scene = rg.Scene()
        self.scene.add_body("ball", rg.Ball([0, 0, 0], 0.1), pose=self.at(0, 1.6, 0))

    @staticmethod
    def at(*place):
        pose = np.eye(4)
        pose[:3, 3] = place
        return pose

    def test_a_straight_arm_meets_a_ball_at_the_angle_of_the_closed_form(self):
        for margin in (0.0, 0.05):
            checker = rg.EdgeChecker(self.robot, self.scene, margin=margin)
            reached = math.pi / 2 - math.asin((0.15 + margin) / 1.6)
            free = checker.edge([0, 0], [reached - 1e-5, 0])
            self.assertEqual(free.outcome, "free")
            self.assertTrue(free)
            self.assertIsNone(free.bodies)
            contact = checker.edge([0, 0], np.array([reached + 1e-4, 0]))
            self.assertEqual((contact.outcome, contact.bodies), ("contact", ("outer", "ball")))
            self.assertFalse(contact)
            self.assertLessEqual(contact.lower, contact.upper)
            self.assertLessEqual(contact.upper, margin + 1e-6)
            self.assertGreaterEqual(contact.time * (reached + 1e-4), reached - 1e-5)
            self.assertEqual(contact.point_a.shape, (3,))
        self.assertEqual(checker.configuration([math.pi / 2, 0]).outcome, "contact")
        self.assertGreater(checker.configuration([math.pi / 2, 0]).depth, 0.1)
        self.assertEqual(checker.configuration([0, 0]).outcome, "free")

    def test_links_that_a_fixed_link_joins_are_left_out_and_others_can_be(self):
        checker = rg.EdgeChecker(self.robot, None, ignore=[("inner", "outer")])
        self.assertTrue(checker.edge([0, 0], [0, math.pi]))
        self.assertTrue(rg.EdgeChecker(self.robot, self.scene, ignore=[("outer", "ball")]).configuration([math.pi / 2, 0]))

    def test_obstacles_move_and_a_base_moves_the_robot(self):
        scene = rg.Scene()
        scene.add_body("falling", rg.Ball([0, 0, 0], 0.1), pose=self.at(1.5, 2, 0), velocity=[0, -4, 0])
        checker = rg.EdgeChecker(self.robot, scene)
        self.assertEqual(checker.edge([0, 0], [0, 0]).outcome, "contact")
        self.assertTrue(checker.edge([0, 0], [0, 0], stop=0.4))
        self.assertEqual(checker.configuration([0, 0], time=0.5).outcome, "contact")
        self.assertTrue(rg.EdgeChecker(self.robot, scene, base=self.at(0, 0, 1)).edge([0, 0], [0, 0]))

    def test_a_grasped_object_counts(self):
        held = {"held": ("outer", rg.Ball([0, 0, 0], 0.3), self.at(1.2, 0, 0))}
        scene = rg.Scene()
        scene.add_body("far", rg.Ball([0, 0, 0], 0.1), pose=self.at(0, 2.4, 0))
        path = [[0, 0], [1, 0], [2, 0]]
        self.assertTrue(rg.prove_path(self.robot, path, scene))
        found = rg.prove_path(self.robot, path, scene, grasped=held, ignore=[("outer", "held")], times=[0, 2, 3])
        self.assertEqual(found.bodies, ("held", "far"))
        self.assertTrue(2 < found.time < 3)

    def test_distances_have_gradients_along_the_joints(self):
        ball, Q, q = rg.Ball([0, 1.6, 0.2], 0.1), rg.Ball([0, 0, 0]), np.array([0.4, 0.7])
        (rod,) = self.robot.shapes("outer")

        def distance(values, **more):
            return rg.object_distance(rod, ball, Q, 1e-11, pose_1=self.robot.poses(values)["outer"], **more)

        found = distance(q, gradient=True).pose_gradient
        self.assertEqual(found.kind, "unique")
        twists = self.robot.twists(q)["outer"]
        self.assertEqual(twists.shape, (2, 6))
        step = 1e-5 * np.eye(2)
        slopes = [(float(distance(q + e)) - float(distance(q - e))) / 2e-5 for e in step]
        np.testing.assert_allclose(twists @ found.body_1, slopes, rtol=1e-6)
        self.assertAlmostEqual(found.along([1, 2] @ twists, np.zeros(6)), slopes[0] + 2 * slopes[1], places=6)
        np.testing.assert_array_equal(self.robot.twists({"k": 0.5})["inner"][1], np.zeros(6))
        with self.assertRaises(rg.DimensionMismatchError):
            self.robot.twists([1, 2, 3])

    def test_a_path_of_one_row_is_a_configuration(self):
        self.assertTrue(rg.prove_path(self.robot, [[0, 0]], self.scene))
        found = rg.prove_path(self.robot, [[math.pi / 2, 0]], self.scene, times=[3])
        self.assertEqual((found.outcome, found.time), ("contact", 3))

    def test_mistakes_are_refused(self):
        checker = rg.EdgeChecker(self.robot, self.scene)
        with self.assertRaises(rg.DimensionMismatchError):
            checker.edge([0], [1])
        with self.assertRaises(rg.NonFiniteError):
            checker.configuration([0, math.nan])
        with self.assertRaises(rg.InvalidParameterError):
            checker.edge([0, 0], [1, 0], start=1, stop=0)
        with self.assertRaises(rg.InvalidParameterError):
            rg.EdgeChecker(self.robot, margin=-1)
        with self.assertRaises(rg.UnknownNameError):
            rg.EdgeChecker(self.robot, ignore=[("inner", "nobody")])
        with self.assertRaises(rg.UnknownNameError):
            rg.EdgeChecker(self.robot, grasped={"held": ("nowhere", rg.Ball([0, 0, 0]), None)})
        with self.assertRaises(rg.Error):
            rg.prove_path(self.robot, np.zeros((0, 2)), self.scene)
        with self.assertRaises(TypeError):
            rg.prove_path(self.robot, [[0, 0], [1, 0]], speed=1)


if __name__ == "__main__":
    unittest.main()
