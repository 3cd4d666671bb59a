# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Gradients by pose and contact patches against closed forms and differences."""
import os
import pathlib
import pickle
import re
import unittest

import numpy as np

import raygauge as rg

EUCLIDEAN = rg.Ball([0, 0, 0])
CUBE = rg.Box([-1, -1, -1], [1, 1, 1])


def at(x, y, z):
    pose = np.eye(4)
    pose[:3, 3] = x, y, z
    return pose


class Gradients(unittest.TestCase):
    def test_of_two_balls_is_along_the_line_of_centres(self):
        r = rg.object_distance(rg.Ball([1, 0, 0]), rg.Ball([0, 0, 0], 0.5), EUCLIDEAN, 1e-12, pose_2=at(5, 0, 3),
                               gradient=True)
        u = np.array([0.8, 0, 0.6])
        self.assertEqual(r.pose_gradient.kind, "unique")
        expected = np.concatenate([-u, np.cross([1, 0, 0] + u, -u)])
        np.testing.assert_allclose(r.pose_gradient.body_1, expected, atol=1e-9)
        np.testing.assert_allclose(r.pose_gradient.body_2, [*u, 0, 0, 0], atol=1e-9)
        self.assertIsNone(r.closest_point_1)  # it was not asked for

    def test_of_parallel_faces_is_one_sided(self):
        r = rg.object_distance(CUBE, CUBE, EUCLIDEAN, pose_2=at(0.5, 0, 3), gradient=True)
        for gradient in (r.pose_gradient, pickle.loads(pickle.dumps(r)).pose_gradient):
            self.assertEqual(gradient.kind, "one_sided")
            self.assertAlmostEqual(gradient.along(np.zeros(6), [0, 0, 0, 0, 1, 0]), -0.5)
            self.assertAlmostEqual(gradient.along(np.zeros(6), [0, 0, 0, 0, -1, 0]), -1)
        with self.assertRaises(rg.DimensionMismatchError):
            r.pose_gradient.along(np.zeros(3), np.zeros(6))

    def test_in_the_plane_has_three_numbers(self):
        r = rg.object_distance(rg.Box([0, 0], [2, 2]), rg.Ball([3, 1.5], 0.5), rg.Ball([0, 0]), 1e-12, gradient=True)
        np.testing.assert_allclose(r.pose_gradient.body_1, [-1, 0, 1.5], atol=1e-9)
        batch = rg.object_distances([rg.Box([0, 0], [2, 2])], rg.Ball([3, 1.5], 0.5), rg.Ball([0, 0]), 1e-12, gradient=True)
        np.testing.assert_array_equal(batch.pose_gradient_1[0], r.pose_gradient.body_1)
        self.assertTrue(batch.is_unique[0])

    def test_formula_of_the_examples_is_that_of_differences(self):
        page = pathlib.Path(os.environ["RAYGAUGE_SOURCE"], "python", "examples", "gradients.md").read_text(encoding="utf-8")
        names = {}
        exec(re.search(r"(?s)```python\n(.*?)```", page).group(1), names)  # pylint: disable=exec-used
        rod, count, step = rg.Capsule([-1, 0, 0], [1, 0.5, 0], 0.25), 6, 1e-5
        random = np.random.default_rng(3)
        poses_1 = names["moved"](np.tile(np.eye(4), (count, 1, 1)), random.normal(size=(count, 6)))
        poses_2 = names["moved"](poses_1, 2 * random.normal(size=(count, 6)))
        poses_2[: count // 2] = names["moved"](poses_1, 0.3 * random.normal(size=(count, 6)))[: count // 2]
        value, by_1, by_2 = names["value_and_gradient"](CUBE, rod, poses_1, poses_2)
        self.assertTrue((value < 0).any() and (value > 0).any())
        for k in range(6):
            twist = np.tile(step * np.eye(6)[k], (count, 1))
            for gradient, side in ((by_1, 0), (by_2, 1)):
                ends = []
                for sign in (1, -1):
                    poses = [poses_1, poses_2]
                    poses[side] = names["moved"](poses[side], sign * twist)
                    ends.append(names["value_and_gradient"](CUBE, rod, *poses)[0])
                np.testing.assert_allclose((ends[0] - ends[1]) / (2 * step), gradient[:, k], atol=1e-4)


class Patches(unittest.TestCase):
    def test_of_squares_turned_by_an_eighth_is_an_octagon(self):
        turned = at(0, 0, 2.125)
        turned[:2, :2] = np.sqrt(0.5) * np.array([[1, -1], [1, 1]])
        patch = rg.contact_patch(CUBE, CUBE, 0.25, pose_2=turned)
        self.assertEqual((len(patch), patch.points_1.shape, patch.status), (8, (8, 3), "optimal"))
        np.testing.assert_allclose(patch.gap, 0.125, atol=1e-12)
        np.testing.assert_allclose(np.abs(patch.points_1[:, :2]).max(axis=1), 1, atol=1e-9)
        np.testing.assert_allclose(patch.points_2 - patch.points_1, 0.125 * np.tile(patch.normal, (8, 1)), atol=1e-12)
        self.assertLess(patch.error, 1e-10)

    def test_of_bodies_apart_is_empty_and_mistakes_are_refused(self):
        self.assertEqual(len(rg.contact_patch(CUBE, CUBE, 0.5, pose_2=at(4, 0, 0))), 0)
        with self.assertRaises(rg.InvalidParameterError):
            rg.contact_patch(CUBE, CUBE, -1)
        with self.assertRaises(rg.DimensionMismatchError):
            rg.contact_patch(CUBE, rg.Ball([0, 0]))


if __name__ == "__main__":
    unittest.main()
