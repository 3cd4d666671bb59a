# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Queries against closed forms: values, certificates, statuses, errors."""
import pickle
import unittest

import numpy as np

import raygauge as rg

TRIANGLE = np.array([[2.0, 0.0], [4.0, -1.0], [4.0, 1.0]])
SQUARE = np.array([[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]])


def pose(rotation, translation):
    matrix = np.eye(len(translation) + 1)
    matrix[:-1, :-1] = rotation
    matrix[:-1, -1] = translation
    return matrix


class Distances(unittest.TestCase):
    def test_bounds_enclose_the_distance_within_the_tolerance(self):
        for method in ("column_generation", "newton", "zheng_yamane"):
            result = rg.distance(TRIANGLE, SQUARE, 1e-9, method)
            self.assertEqual(result.status, "optimal")
            self.assertLessEqual(result.lower, 2.0)
            self.assertGreaterEqual(result.upper, 2.0)
            self.assertLessEqual(result.gap, 1e-9 * result.upper)

    def test_a_rotation_of_few_digits_is_replaced_by_the_nearest_one_with_a_warning(self):
        half = np.sqrt(0.5)
        exact = np.array([[half, -half], [half, half]])
        expected = rg.distance(TRIANGLE, SQUARE, pose_A=pose(exact, [3, 0])).distance
        printed = pose(exact.round(8), [3, 0])
        with self.assertWarnsRegex(UserWarning, "the nearest rotation is used"):
            result = rg.distance(TRIANGLE, SQUARE, pose_A=printed)
        self.assertAlmostEqual(result.distance, expected, delta=1e-7)
        with self.assertWarnsRegex(UserWarning, "the nearest rotation is used"):
            rg.distances([TRIANGLE, TRIANGLE], SQUARE, poses_A=np.array([printed, printed]))
        with self.assertRaisesRegex(ValueError, "by 6.78e-06"):
            rg.distance(TRIANGLE, SQUARE, pose_A=pose(exact.round(4), [3, 0]))

    def test_the_normal_proves_the_lower_bound(self):
        result = rg.distance(TRIANGLE, SQUARE)
        proven = -(TRIANGLE @ result.normal).max() / (SQUARE @ -result.normal).max()
        self.assertAlmostEqual(proven, result.lower, delta=1e-12)

    def test_all_sets_have_their_closed_forms(self):
        u = np.array([0.3, -1.1, 0.7])
        length, across = np.linalg.norm(u), np.linalg.norm(u[:2])
        p, q = np.zeros(3), np.array([0.0, 0.0, 2.0])
        forms = {
            rg.PointSet([[1, 2, 3], [0, 0, 1]]): max(0.3 - 2.2 + 2.1, 0.7),
            rg.Ball([1, 0, 0], 2): 0.3 + 2 * length,
            rg.Ellipsoid([0, 0, 0], np.diag([1.0, 2.0, 3.0])): np.linalg.norm(np.array([1, 2, 3]) * u),
            rg.PNormBall([0, 0, 0], p=np.inf): np.abs(u).sum(),
            rg.Capsule(p, q, 0.5): 1.4 + 0.5 * length,
            rg.Cylinder(p, q, 0.5): 1.4 + 0.5 * across,
            rg.TruncatedCone(p, 1.0, q, 0.5): max(across, 1.4 + 0.5 * across),
            rg.Box([-1, -1, -1], [1, 2, 3]): 0.3 + 1.1 + 2.1,
            rg.Simplex([0, 0, 0]): 0.7,
            rg.HPolytope(np.vstack([np.eye(3), -np.eye(3)]), [1, 2, 3, 1, 1, 1]): 0.3 + 1.1 + 2.1,
            rg.Zonotope([1, 0, 0], [[2, 0, 0], [0, 1, 1]]): 0.3 + 0.6 + 0.4,
            rg.AffineImage(rg.Ball([0, 0, 0]), np.diag([2.0, 1, 1]), [1, 1, 1]): np.linalg.norm(np.array([2, 1, 1]) * u) + u.sum(),
            rg.MinkowskiSum(rg.Ball([0, 0, 0]), rg.Ball([0, 0, 0], 2)): 3 * length,
            rg.MinkowskiDifference(rg.Ball([1, 0, 0]), rg.Ball([0, 0, 0])): 0.3 + 2 * length,
            rg.UnionHull([rg.Ball([0, 0, 0]), [[9, 0, 0]]]): 2.7,
        }
        for shape, value in forms.items():
            self.assertAlmostEqual(shape.support_function(u), value, places=12, msg=repr(shape))
            self.assertAlmostEqual(shape.support_mapping(u) @ u, value, places=12, msg=repr(shape))

    def test_gauge_and_membership_have_their_closed_forms(self):
        ellipsoid = rg.Ellipsoid([0, 0, 0], np.diag([1.0, 2.0, 4.0]))
        lower, upper = rg.gauge(ellipsoid, [0, 3, 0])
        self.assertTrue(lower <= 1.5 <= upper and upper - lower <= 1e-8)
        self.assertEqual(rg.gauge(SQUARE, [0.25, -0.25]), rg.gauge(rg.PointSet(SQUARE), np.array([0.25, -0.25])))
        self.assertEqual(rg.gauge([[1, 0], [2, 1]], [0, 5])[0], np.inf)
        self.assertIs(rg.contains(TRIANGLE, [3, 0.1]), True)
        self.assertIs(rg.contains(TRIANGLE, [1.9, 0.0]), False)
        self.assertIsNone(rg.contains(rg.Ball([0, 0], 5), [3, 4]))
        self.assertIs(rg.contains(rg.SupportMappingSet(np.zeros(2), np.sign), [0.5, -0.9]), True)
        self.assertRaises(rg.DimensionMismatchError, rg.gauge, SQUARE, [1, 2, 3])
        with self.assertRaisesRegex(rg.InvalidParameterError, r"^tolerance must lie in \(0, 1\), got 2$"):
            rg.distance(SQUARE, SQUARE, 2)
        self.assertRaises(rg.NonFiniteError, rg.contains, SQUARE, [np.nan, 0])

    def test_many_points_of_one_set_are_asked_about_at_once(self):
        generator = np.random.default_rng(7)
        hull, X = rg.PointSet(generator.normal(size=(60, 4))), generator.normal(size=(300, 4))
        inside = rg.contains(hull, X, threads=2)
        lower, upper = rg.gauge(hull, X)
        self.assertFalse(np.any(np.ma.getmaskarray(inside)))
        self.assertGreater(np.sum(inside), 10)
        for i, x in enumerate(X):
            self.assertIs(bool(inside[i]), rg.contains(hull, x))
            alone = rg.gauge(hull, x)
            self.assertTrue(lower[i] <= alone[1] and alone[0] <= upper[i])
        self.assertEqual(rg.contains(rg.Ball([0, 0], 5), [[3, 4], [0, 0], [9, 9]]).tolist(), [None, True, False])
        self.assertEqual(rg.contains(hull, np.zeros((0, 4))).shape, (0,))
        self.assertRaises(rg.DimensionMismatchError, rg.contains, hull, X[:, :2])
        self.assertRaises(rg.NonFiniteError, rg.gauge, hull, X * np.inf)
        self.assertRaises(rg.InvalidParameterError, rg.gauge, hull, X, threads=-1)

    def test_a_set_of_ones_own_gives_the_answer_of_the_set_that_it_is(self):
        def ball(u):
            length = np.linalg.norm(u)
            return u / length if length > 0 else u

        own = rg.SupportMappingSet([0.0, 0.0, 0.0], ball)
        result = rg.distance([[2.0, 2.0, 1.0]], own, 1e-6)
        self.assertLessEqual(result.lower, 3.0)
        self.assertGreaterEqual(result.upper, 3.0)

    def test_a_mapping_may_call_raygauge_itself(self):
        inner = rg.PointSet(SQUARE)

        def mapping(u):
            rg.distance(TRIANGLE, inner)  # another solve on this thread, in the middle of one
            return inner.support_mapping(u)

        own = rg.SupportMappingSet([0.0, 0.0], mapping)
        self.assertAlmostEqual(rg.distance(TRIANGLE, own).distance, 2.0, places=9)

    def test_what_a_mapping_raises_passes_through(self):
        calls = []

        def mapping(u):
            calls.append(1)
            if len(calls) > 6:
                raise ZeroDivisionError("on purpose")
            return np.sign(u)

        own = rg.SupportMappingSet([0.0, 0.0], mapping)
        with self.assertRaisesRegex(ZeroDivisionError, "on purpose"):
            rg.distance(TRIANGLE, own)

    def test_a_point_within_is_proven_by_weights(self):
        result = rg.distance(SQUARE, SQUARE)
        self.assertEqual(result.status, rg.Status.contains_origin)
        combination = sum(weight * SQUARE[index] for index, weight in result.origin_weights)
        np.testing.assert_allclose(combination, 0, atol=1e-15)

    def test_what_is_out_of_reach_is_infinitely_far(self):
        result = rg.distance([[1.0, 0.0]], [[-1.0, 0.0], [-1.0, 1.0]])
        self.assertEqual(result.status, "unreachable")
        self.assertEqual(result.distance, np.inf)

    def test_a_limit_is_a_status_with_bounds(self):
        generator = np.random.default_rng(3)
        A = generator.normal(size=(400, 8)) + 6
        result = rg.distance(A, generator.normal(size=(400, 8)), max_iterations=3)
        self.assertEqual(result.status, "iteration_limit")
        self.assertLessEqual(result.lower, result.upper)


class Objects(unittest.TestCase):
    def test_a_half_space_is_an_object_and_nothing_else(self):
        floor, ball, metric = rg.HalfSpace([0, 0, 2], 1), rg.Ball([1, 2, 3], 1), rg.Ball([0, 0, 0])
        r = rg.object_distance(ball, floor, metric, signed=True, closest_points=True)
        self.assertAlmostEqual(float(r), 1.5, places=12)
        np.testing.assert_allclose(r.closest_point_2, [1, 2, 0.5], atol=1e-12)
        poses = np.tile(np.eye(4), (3, 1, 1))
        poses[:, 2, 3] = [0, -2, 1]
        batch = rg.object_distances(ball, floor, metric, poses_1=poses, signed=True)
        np.testing.assert_allclose(batch.distance, [1.5, -0.5, 2.5], atol=1e-12)
        self.assertEqual(rg.separation(ball, floor).outcome, rg.Separation.separated)
        for use in (lambda: rg.distance(ball, floor), lambda: rg.distance(floor, ball), lambda: rg.growth_distance(ball, floor),
                    lambda: rg.object_distance(floor, floor, metric), lambda: rg.contains(floor, [0, 0, 0])):
            with self.assertRaisesRegex(rg.InvalidParameterError, "half-space"):
                use()

    def test_a_mesh_is_its_triangles_or_the_solid_that_they_bound(self):
        corners = np.array([[x, y, z] for x in (0, 4) for y in (0, 4) for z in (0, 4)], dtype=float)
        faces = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]
        surface, solid = rg.Mesh(corners, faces), rg.Mesh(corners, faces, solid=True)
        self.assertEqual((solid.size, solid.volume, solid.solid, surface.solid), (12, 64, True, False))
        ball, metric = rg.Ball([2, 2, 1.5], 0.5), rg.Ball([0, 0, 0])
        r = rg.object_distance(surface, ball, metric, closest_points=True)
        self.assertAlmostEqual(float(r), 1, places=6)
        np.testing.assert_allclose(r.closest_point_1, [2, 2, 0], atol=1e-5)
        self.assertEqual(rg.object_distance(ball, solid, metric).status, rg.Status.contains_origin)
        self.assertEqual(rg.separation(solid, ball).outcome, rg.Separation.intersecting)
        self.assertEqual(rg.separation(surface, ball).outcome, rg.Separation.separated)
        self.assertAlmostEqual(float(rg.object_distance(surface, rg.HalfSpace([0, 0, 1], -3), metric)), 3, places=6)
        poses = np.tile(np.eye(4), (3, 1, 1))
        poses[:, 0, 3] = [10, 5, 4.5]
        np.testing.assert_allclose(rg.object_distances(surface, solid, metric, poses_2=poses).distance, [6, 1, 0.5], atol=1e-5)
        again = pickle.loads(pickle.dumps(solid))
        self.assertEqual((again.volume, again.solid), (64, True))
        for use in (lambda: rg.growth_distance(solid, ball), lambda: rg.object_distance(solid, ball, metric, signed=True)):
            with self.assertRaisesRegex(rg.InvalidParameterError, "convex parts"):
                use()
        with self.assertRaisesRegex(rg.InvalidParameterError, "Euclidean"):
            rg.object_distance(solid, ball, rg.Box([-1] * 3, [1] * 3))
        with self.assertRaisesRegex(rg.InvalidParameterError, "closed surface"):
            rg.Mesh(corners, faces[1:], solid=True)
        with self.assertRaisesRegex(rg.InvalidParameterError, "names no vertex"):
            rg.Mesh(corners, [[0, 1, 2.5]])

    def test_closest_points_and_gradients_of_two_balls(self):
        unit = rg.Ball([0, 0, 0])
        result = rg.object_distance(
            unit, rg.Ball([0, 4, 3], 2), unit, 1e-12, "newton", closest_points=True, gradient=True
        )
        self.assertAlmostEqual(result.distance, 2.0, places=10)
        np.testing.assert_allclose(result.closest_point_1, [0, 0.8, 0.6], atol=1e-5)
        np.testing.assert_allclose(result.gradient_2, [0, 0.8, 0.6], atol=1e-5)
        np.testing.assert_allclose(result.gradient_1, [0, -0.8, -0.6], atol=1e-5)

    def test_growth_distance_and_separation_of_two_balls(self):
        near, far = rg.Ball([0, 0]), rg.Ball([3, 0])
        self.assertAlmostEqual(rg.growth_distance(far, near, 1e-9).distance, 1.5, places=9)
        self.assertEqual(rg.separation(near, far).outcome, "separated")
        self.assertEqual(rg.separation(near, rg.Ball([1, 0])).outcome, rg.Separation.intersecting)

    def test_a_posed_set_answers_as_the_set_moved(self):
        angle = 0.3
        rotation = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        moved = TRIANGLE @ rotation.T + [1, 2]
        expected = rg.distance(moved, SQUARE).distance
        posed = rg.distance(TRIANGLE, SQUARE, pose_A=pose(rotation, [1, 2]))
        self.assertAlmostEqual(posed.distance, expected, delta=1e-8)

    def test_a_warm_start_changes_no_certified_answer(self):
        warm = rg.WarmStart()
        ellipsoid = rg.Ellipsoid([0, 0, 0], np.diag([1.0, 2.0, 3.0]))
        for step in range(5):
            where = pose(np.eye(3), [6 + 0.01 * step, 1, 0])
            cold = rg.distance(ellipsoid, rg.Ball([0, 0, 0]), 1e-9, "newton", pose_A=where)
            kept = rg.distance(ellipsoid, rg.Ball([0, 0, 0]), 1e-9, "newton", pose_A=where, warm=warm)
            self.assertLessEqual(kept.lower, cold.upper)
            self.assertLessEqual(cold.lower, kept.upper)

    def test_gradients_match_differences(self):
        gauge, step = rg.Ball([0, 0]), 1e-4
        gradient = rg.gradient_moving_A(rg.distance([[3.0, 4.0]], gauge, 1e-12, "newton"))
        ahead = rg.distance([[3.0 + step, 4.0]], gauge, 1e-12, "newton").distance
        behind = rg.distance([[3.0 - step, 4.0]], gauge, 1e-12, "newton").distance
        self.assertAlmostEqual(gradient[0], (ahead - behind) / (2 * step), places=6)


class Errors(unittest.TestCase):
    def test_each_mistake_has_its_exception_and_all_are_value_errors(self):
        cases = [
            (rg.DimensionMismatchError, lambda: rg.distance(TRIANGLE, rg.Ball([0, 0, 0]))),
            (rg.NonFiniteError, lambda: rg.PointSet([[np.nan, 0]])),
            (rg.EmptySetError, lambda: rg.PointSet(np.empty((0, 3)))),
            (rg.InvalidParameterError, lambda: rg.Ball([0, 0], -1)),
            (rg.InvalidParameterError, lambda: rg.distance(TRIANGLE, SQUARE, 2.0)),
            (rg.InvalidParameterError, lambda: rg.distance("triangle", SQUARE)),
            (rg.InvalidParameterError, lambda: rg.distance(TRIANGLE, SQUARE, warm=3)),
            (rg.InvalidParameterError, lambda: rg.distance(TRIANGLE, SQUARE, pose_A=2 * np.eye(3))),
            (rg.DimensionMismatchError, lambda: rg.distance(TRIANGLE, SQUARE, pose_A=np.eye(4))),
            (rg.UnknownNameError, lambda: rg.distance(TRIANGLE, SQUARE, method="dircet")),
            (rg.InvalidParameterError, lambda: rg.SupportMappingSet([0, 0], "no callable")),
            (rg.DimensionMismatchError, lambda: rg.SupportMappingSet([0, 0], lambda u: [1, 2, 3])),
            (rg.EmptySetError, lambda: rg.UnionHull([])),
        ]
        for kind, call in cases:
            with self.assertRaises(kind) as caught:
                call()
            self.assertIsInstance(caught.exception, rg.Error)
            self.assertIsInstance(caught.exception, ValueError)
            self.assertNotIn("\n", str(caught.exception))

    def test_a_misspelt_method_is_answered_with_the_nearest_one(self):
        with self.assertRaisesRegex(rg.UnknownNameError, "column_generation"):
            rg.distance(TRIANGLE, SQUARE, method="dircet")

    def test_abstract_classes_and_results_cannot_be_made(self):
        for kind in (rg.ConvexSet, rg.Distance, rg.Distances, rg.Counters):
            with self.assertRaises(TypeError):
                kind()

    def test_results_are_read_only(self):
        result = rg.distance(TRIANGLE, SQUARE)
        with self.assertRaises(ValueError):
            result.normal[0] = 7
        with self.assertRaises(AttributeError):
            result.distance = 1.0

    def test_point_sets_are_pickled(self):
        again = pickle.loads(pickle.dumps(rg.PointSet(TRIANGLE)))
        np.testing.assert_array_equal(again.points, TRIANGLE)


if __name__ == "__main__":
    unittest.main()
