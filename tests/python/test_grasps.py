# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""The quality of grasps against closed forms and all planes through corners of pyramids."""
import itertools
import math
import pickle
import unittest

import numpy as np

import raygauge as rg

AXES = np.vstack([np.eye(3), -np.eye(3)])


def random_grasp(random, count):
    points = random.normal(size=(count, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    return points, -points + 0.2 * random.normal(size=(count, 3)), random.uniform(0.4, 1, count)


def corners(points, normals, mu, edges):
    """The wrenches at the edges of pyramids, from the support mapping of each contact alone."""
    found = []
    for p, n, friction in zip(points, normals, mu):
        cone = rg.ContactWrenches(p, n, friction, edges)
        n = n / np.linalg.norm(n)
        seen = []
        for angle in np.linspace(0, 2 * np.pi, 24 * edges, endpoint=False):
            side = np.cross(n, [1, 0, 0]) / np.linalg.norm(np.cross(n, [1, 0, 0]))
            u = 100 * n + np.cos(angle) * side + np.sin(angle) * np.cross(n, side)
            x = cone.support_mapping([*u, 0, 0, 0])
            if not any(np.allclose(x, y, atol=1e-9) for y in seen):
                seen.append(x)
        found += seen
    return np.array(found)


def depth_of(corner):
    """The least distance of a facet of the hull from 0: of all planes through six corners with none beyond; 0 without."""
    sixes = corner[np.array(list(itertools.combinations(range(len(corner)), 6)))]
    sixes = sixes[np.abs(np.linalg.det(sixes)) > 1e-9]
    planes = np.linalg.solve(sixes, np.ones((len(sixes), 6, 1)))[:, :, 0]  # plane·x = 1
    facets = planes[(planes @ corner.T <= 1 + 1e-9).all(axis=1)]
    lower = planes[(planes @ corner.T >= 1 - 1e-9).all(axis=1)]
    return 0.0 if len(lower) > 0 or len(facets) == 0 else (1 / np.linalg.norm(facets, axis=1)).min()


class GraspQuality(unittest.TestCase):
    def test_of_six_contacts_on_axes_is_known(self):
        r = rg.grasp_quality(AXES, -AXES, 0.5, tolerance=1e-4)
        self.assertEqual((r.status, r.force_closure), ("optimal", True))
        self.assertTrue(r.lower <= 0.5 * math.sqrt(2 / 3) <= r.upper == r.quality == float(r))
        self.assertAlmostEqual(np.linalg.norm(r.normal), 1)
        np.testing.assert_allclose(r.wrench, r.upper * r.normal)
        self.assertGreaterEqual(rg.grasp_quality(AXES, -AXES, 0.5, edges=8, forces="each").upper, r.lower - 0.05)

    def test_of_pyramids_is_that_of_all_planes_through_their_corners(self):
        random = np.random.default_rng(1)
        closures = 0
        for _ in range(10):
            points, normals, mu = random_grasp(random, 5)
            truth = depth_of(corners(points, normals, mu, 3))
            r = rg.grasp_quality(points, normals, mu, edges=3)
            self.assertLessEqual(r.lower, truth + 1e-9)
            self.assertGreaterEqual(r.upper, truth - 1e-9)
            closures += r.force_closure is True
            if truth > 1e-6:
                self.assertEqual(r.status, "optimal")
        self.assertGreater(closures, 2)

    def test_of_contacts_on_one_side_is_none(self):
        random = np.random.default_rng(2)
        points = np.abs(random.normal(size=(5, 3))) + [3, 0, 0]
        r = rg.grasp_quality(points, np.tile([-1, 0, 0], (5, 1)), 0.3)
        self.assertEqual((r.lower, r.upper, r.force_closure, r.status), (0, 0, False, "optimal"))

    def test_weighs_torques_by_the_metric(self):
        metric = rg.Ellipsoid(np.zeros(6), np.diag([1, 1, 1, 4, 4, 4]))
        self.assertAlmostEqual(rg.grasp_quality(AXES, -AXES, 0.5, metric, edges=5).quality,
                               rg.grasp_quality(AXES / 4, -AXES, 0.5, edges=5).quality, delta=2e-6)

    def test_refuses_what_is_no_grasp(self):
        for wrong in (lambda: rg.grasp_quality(AXES, -AXES, -1), lambda: rg.grasp_quality(AXES, -AXES, 1, edges=2)):
            with self.assertRaises(rg.InvalidParameterError):
                wrong()
        for wrong in (lambda: rg.grasp_quality(AXES, -AXES[:5], 1), lambda: rg.grasp_quality(AXES, -AXES, [1, 2]),
                      lambda: rg.grasp_quality(AXES, -AXES, 1, rg.Ball([0, 0, 0]))):
            with self.assertRaises(rg.DimensionMismatchError):
                wrong()
        with self.assertRaises(rg.UnknownNameError):
            rg.grasp_quality(AXES, -AXES, 1, forces="all")

    def test_is_copied_whole(self):
        r = rg.grasp_quality(AXES, -AXES, 1, edges=4)
        s = pickle.loads(pickle.dumps(r))
        self.assertEqual((s.lower, s.upper, s.status, s.force_closure), (r.lower, r.upper, r.status, True))
        np.testing.assert_array_equal(s.normal, r.normal)
        self.assertIn("GraspQuality", repr(s))


if __name__ == "__main__":
    unittest.main()
