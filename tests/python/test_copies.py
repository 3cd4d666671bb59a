# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Sets and results are pickled and copied: a copy gives the same bits, in this process and in another."""
import copy
import multiprocessing
import pickle
import unittest

import numpy as np
import raygauge as rg


def farthest(u):
    """A ball of radius 2, as a set of one's own: a function that other processes can import."""
    length = np.linalg.norm(u)
    return 2 * u / length if length else np.zeros_like(u)


def sets():
    ball, box = rg.Ball([3, 0.1, 0], 0.7), rg.Box([4, -1, -1], [5, 1, 1])
    points = rg.PointSet(np.random.default_rng(1).normal(size=(20, 3)) + [5, 0, 0])
    return [
        ball, box, points,
        rg.PreparedSet(points),
        rg.Ellipsoid([4, 0, 0], np.diag([1.0, 0.5, 0.3])),
        rg.PNormBall([4, 0, 0], [1, 0.5, 0.3], 3),
        rg.Capsule([4, 0, 0], [5, 1, 0], 0.3),
        rg.Cylinder([4, 0, 0], [5, 1, 0], 0.3),
        rg.TruncatedCone([4, 0, 0], 0.5, [5, 1, 0], 0.2),
        rg.Simplex([4, 0, 0], [1, 2, 3]),
        rg.HPolytope(np.vstack([np.eye(3), -np.eye(3)]), [6, 1, 1, -4, 1, 1]),
        rg.Zonotope([5, 0, 0], [[1, 0, 0], [0.3, 1, 0]]),
        rg.AffineImage(ball, [[1, 0.1, 0], [0, 1, 0], [0, 0, 2]], [1, 0, 0]),
        rg.MinkowskiSum(ball, box),
        rg.MinkowskiDifference(box, ball),
        rg.UnionHull([ball, box, points]),
        rg.SupportMappingSet([0, 0, 0], farthest),
    ]


class Copies(unittest.TestCase):
    def copies(self, thing):
        yield pickle.loads(pickle.dumps(thing))
        yield copy.copy(thing)
        yield copy.deepcopy(thing)

    def test_a_copy_of_a_set_has_the_same_bits(self):
        for given in sets():
            for made in self.copies(given):
                with self.subTest(type(given).__name__):
                    self.assertIs(type(made), type(given))
                    for u in np.random.default_rng(2).normal(size=(20, 3)):
                        self.assertEqual(made.support_function(u), given.support_function(u))

    def test_wrenches_keep_their_normal(self):
        given = rg.ContactWrenches([0, 0.1, 1], [0.2, 0.3, -1], 0.5, 8)
        made = pickle.loads(pickle.dumps(given))
        for u in np.random.default_rng(2).normal(size=(20, 6)):
            self.assertEqual(made.support_function(u), given.support_function(u))

    def test_a_copy_of_a_result_has_the_same_values(self):
        A, Q = rg.Ball([3, 0, 0]), rg.Box([-1] * 3, [1] * 3)
        points = [[2.0, 0, 0], [3, 1, 0]]
        results = [rg.distance(A, Q), rg.distance(points, np.vstack([np.eye(3), -np.eye(3)]), witness=True),
                   rg.distance([[1.0, 0, 0], [-1, 0, 0]], np.vstack([np.eye(3), -np.eye(3)])),
                   rg.object_distance(A, Q, rg.Ball([0, 0, 0]), closest_points=True, gradient=True), rg.separation(A, Q)]
        for given in results:
            for made in self.copies(given):
                with self.subTest(repr(given)):
                    self.assertEqual(repr(made), repr(given))
                    self.assertEqual(repr(made.counters), repr(given.counters))
                    for name in ("normal", "contact_point", "closest_point_1", "gradient_2", "origin_weights", "status"):
                        np.testing.assert_array_equal(getattr(made, name, None), getattr(given, name, None))

    def test_a_copy_of_a_batch_has_the_same_arrays(self):
        given = rg.distances([rg.Ball([2, 0]), rg.Ball([0, 4])], rg.Ball([0, 0]), witness=True)
        for made in self.copies(given):
            for name in ("distance", "lower", "upper", "status", "normal", "contact_point", "pivots"):
                np.testing.assert_array_equal(getattr(made, name), getattr(given, name))

    def test_scenes_and_their_answers_are_copied(self):
        scene = rg.Scene(np.linspace(0, 1, 3))
        scene.add_body("a", rg.Ball([0, 0, 0]))
        scene.add_body("b", rg.Ball([3, 0, 0]), velocity=[-1, 0, 0])
        scene.add_query(["distance"])
        answers = pickle.loads(pickle.dumps(scene)).run(threads=1)
        np.testing.assert_array_equal(pickle.loads(pickle.dumps(answers))["distance"], scene.run(threads=1)["distance"])

    def test_other_processes_take_sets_and_give_results(self):
        pairs = [(rg.Ball([3, 0, 0]), rg.Ball([0, 0, 0])), (rg.Box([4, 0, 0], [5, 1, 1]), rg.Ball([0, 0, 0]))]
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            there = pool.starmap(rg.distance, pairs)
        self.assertEqual([r.distance for r in there], [rg.distance(*pair).distance for pair in pairs])


if __name__ == "__main__":
    unittest.main()
