# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Batches: the answers of single calls, whatever the operands are and however many threads share them."""
import threading
import unittest

import numpy as np

import raygauge as rg


def rotations(generator, count):
    axes, _ = np.linalg.qr(generator.normal(size=(count, 3, 3)))
    axes[:, :, 0] *= np.sign(np.linalg.det(axes))[:, None]
    return axes


class Batches(unittest.TestCase):
    def setUp(self):
        generator = np.random.default_rng(2)
        self.A = generator.normal(size=(120, 20, 3)) + generator.normal(size=(120, 1, 3)) * 4
        self.Q = generator.normal(size=(120, 15, 3))

    def assert_same(self, batch, singles):
        self.assertEqual(len(batch), len(singles))
        for name in ("distance", "lower", "upper"):
            np.testing.assert_array_equal(getattr(batch, name), [getattr(single, name) for single in singles])
        self.assertEqual(list(batch.status), [single.status for single in singles])

    def test_arrays_of_problems_have_the_bits_of_single_calls(self):
        batch = rg.distances(self.A, self.Q, witness=True)
        singles = [rg.distance(a, q, witness=True) for a, q in zip(self.A, self.Q)]
        self.assert_same(batch, singles)
        for k, single in enumerate(singles):
            for name in ("normal", "contact_point"):
                expected = getattr(single, name)
                found = getattr(batch, name)[k]
                np.testing.assert_array_equal(found, np.full(3, np.nan) if expected is None else expected)
        self.assertEqual(list(batch.pivots), [single.counters.pivots for single in singles])

    def test_many_points_against_a_set_of_many_have_proven_distances_and_normals(self):
        generator = np.random.default_rng(4)
        S = generator.normal(size=(400, 4))
        S /= np.linalg.norm(S, axis=1)[:, None]
        X = generator.normal(size=(2000, 4))
        X[7] = 0
        X[8] *= 1e200  # beyond single precision
        batch = rg.distances(X[:, None, :], S, threads=1)
        self.assertEqual(batch.status[7], "contains_origin")
        self.assertEqual(batch.distance[7], 0)
        for k in (*range(7), *range(8, 60)):
            single = rg.distance(X[k], S)
            self.assertEqual(batch.status[k], "optimal")
            self.assertLessEqual(batch.lower[k], single.upper)
            self.assertGreaterEqual(batch.upper[k], single.lower)
            self.assertLessEqual(batch.upper[k] - batch.lower[k], 1e-6 * batch.upper[k])
            w = -batch.normal[k]
            self.assertLessEqual((S @ w).max(), 1 + 1e-12)
            np.testing.assert_allclose(w @ X[k], batch.lower[k], rtol=1e-9)
        again = rg.distances(X[:, None, :], S, threads=2)
        for name in ("distance", "lower", "upper", "normal"):
            np.testing.assert_array_equal(getattr(batch, name), getattr(again, name))

    def test_many_points_that_cannot_be_reached_are_told_and_one_that_is_no_number_is_named(self):
        generator = np.random.default_rng(5)
        S = np.abs(generator.normal(size=(400, 4)))
        X = generator.normal(size=(2000, 4))
        X[1] = -1
        batch = rg.distances(X[:, None, :], S)
        self.assertEqual([batch.status[1], batch.distance[1], batch.lower[1]], ["unreachable", np.inf, np.inf])
        w = batch.normal[1]
        self.assertTrue(w @ X[1] < 0 and (S @ -w <= 0).all())
        self.assertEqual(list(batch.status[:40]), [rg.distance(x, S).status for x in X[:40]])
        X[1500, 2] = np.nan
        with self.assertRaisesRegex(rg.NonFiniteError, "1500"):
            rg.distances(X[:, None, :], S)

    def test_a_problem_is_indexed_and_problems_are_gone_through(self):
        batch = rg.distances(self.A, self.Q, witness=True)
        for k in (0, 7, -1):
            single = rg.distance(self.A[k], self.Q[k], witness=True)
            self.assertEqual(repr(batch[k]), repr(single))
            for name in ("normal", "contact_point"):
                np.testing.assert_array_equal(getattr(batch[k], name), getattr(single, name))
            self.assertEqual(batch[k].counters.pivots, single.counters.pivots)
        self.assertEqual([result.distance for result in batch], list(batch.distance))
        self.assertEqual(len(batch[10:20:2]), 5)
        np.testing.assert_array_equal(batch[10:20:2].normal, batch.normal[10:20:2])
        far = batch[batch.distance > 3]
        self.assertTrue(0 < len(far) < len(batch) and (far.distance > 3).all())
        self.assertEqual(list(batch[[3, 1]].distance), [batch.distance[3], batch.distance[1]])
        for wrong in (120, -121):
            with self.assertRaises(IndexError):
                batch[wrong]

    def test_a_data_frame_has_a_row_for_each_problem(self):
        batch = rg.distances(self.A, self.Q, witness=True)
        frame = batch.to_dataframe()
        self.assertEqual(len(frame), 120)
        np.testing.assert_array_equal(frame["distance"], batch.distance)
        np.testing.assert_array_equal(frame["contact_point_2"], batch.contact_point[:, 2])
        self.assertEqual(list(frame["status"].astype(str)), list(batch.status))
        self.assertNotIn("contact_point_0", rg.distances(self.A, self.Q).to_dataframe())

    def test_a_shared_operand_is_that_of_every_problem(self):
        self.assert_same(rg.distances(self.A, self.Q[0]), [rg.distance(a, self.Q[0]) for a in self.A])
        ball = rg.Ball([0, 0, 0])
        self.assert_same(rg.distances(ball, self.Q), [rg.distance(ball, q) for q in self.Q])

    def test_lists_mix_sets_and_arrays(self):
        sets = [rg.Ball([5, 0, 0]), self.A[1], rg.Box([2, 2, 2], [3, 3, 3])]
        self.assert_same(rg.distances(sets, self.Q[0]), [rg.distance(a, self.Q[0]) for a in sets])

    def test_answers_do_not_depend_on_the_number_of_threads(self):
        one = rg.distances(self.A, self.Q, threads=1)
        for threads in (2, 3, 8):
            np.testing.assert_array_equal(rg.distances(self.A, self.Q, threads=threads).lower, one.lower)

    def test_poses_move_each_problem(self):
        generator = np.random.default_rng(4)
        poses = np.tile(np.eye(4), (50, 1, 1))
        poses[:, :3, :3] = rotations(generator, 50)
        poses[:, :3, 3] = generator.normal(size=(50, 3)) * 5
        batch = rg.distances(self.A[0], self.Q[0], poses_A=poses)
        self.assert_same(batch, [rg.distance(self.A[0], self.Q[0], pose_A=pose) for pose in poses])

    def test_no_problem_at_all_is_a_batch(self):
        self.assertEqual(len(rg.distances(np.empty((0, 5, 3)), self.Q[0])), 0)

    def test_sets_of_ones_own_are_asked_from_all_threads(self):
        names = set()

        def mapping(u):
            names.add(threading.get_ident())
            return np.sign(u)

        own = rg.SupportMappingSet(np.zeros(3), mapping)
        batch = rg.distances(self.A, own, threads=2)
        box = rg.Box(-np.ones(3), np.ones(3))
        np.testing.assert_allclose(batch.distance, rg.distances(self.A, box).distance, rtol=1e-8)

    def test_other_threads_of_python_run_meanwhile(self):
        ticks, done = [], threading.Event()

        def tick():
            while not done.wait(0.001):
                ticks.append(1)

        thread = threading.Thread(target=tick)
        thread.start()
        problems = np.random.default_rng(1).normal(size=(300, 400, 6)) + 3
        rg.distances(problems, np.random.default_rng(2).normal(size=(400, 6)), threads=1)
        done.set()
        thread.join()
        self.assertGreater(len(ticks), 3)


class Refusals(unittest.TestCase):
    def test_the_problem_is_named(self):
        problems = np.ones((9, 4, 3))
        problems[7, 2, 1] = np.nan
        with self.assertRaisesRegex(rg.NonFiniteError, "problem 7"):
            rg.distances(problems, rg.Ball([0, 0, 0]))

    def test_operands_that_do_not_fit_are_refused(self):
        A, Q = np.ones((4, 5, 3)), np.ones((4, 5, 3))
        refused = [(A, Q[:3], {}), (A, Q[:, :, :2], {}), (A[0], Q[0], {}), (A, Q, {"threads": -1}),
                   (A, Q, {"threads": 10**6}), (A, Q, {"tolerance": 0}), (A, Q, {"method": "glpk"}),
                   (A, Q, {"poses_A": np.eye(4)}), (A, Q, {"poses_A": np.zeros((4, 4, 4))}),
                   (A, Q, {"poses_Q": np.tile(np.eye(4), (3, 1, 1))}), ([], Q, {}), (A, [rg.Ball([0, 0])] * 4, {})]
        for operand, gauge, options in refused:
            with self.assertRaises(rg.Error):
                rg.distances(operand, gauge, **options)

    def test_what_a_mapping_raises_passes_through_a_batch(self):
        calls = []

        def mapping(u):
            calls.append(1)
            if len(calls) > 40:
                raise LookupError("on purpose")
            return np.sign(u)

        own = rg.SupportMappingSet(np.zeros(3), mapping)
        with self.assertRaisesRegex(LookupError, "on purpose"):
            rg.distances(np.random.default_rng(0).normal(size=(200, 5, 3)) + 4, own, threads=2)


class ObjectBatches(unittest.TestCase):
    def test_pairs_in_poses_have_the_bits_of_single_calls_also_of_depths(self):
        generator = np.random.default_rng(3)
        poses = np.tile(np.eye(4), (40, 1, 1))
        poses[:, :3, :3] = rotations(generator, 40)
        poses[:, :3, 3] = generator.normal(size=(40, 3))
        body, cloud, metric = rg.Capsule([0, 0, -1], [0, 0, 1], 0.5), generator.normal(size=(12, 3)), rg.Ball([0, 0, 0])
        for threads in (1, 3):
            batch = rg.object_distances(
                body, cloud, metric, poses_1=poses, signed=True, closest_points=True, threads=threads
            )
            self.assertEqual(len(batch), 40)
            self.assertTrue((batch.distance < 0).any() and (batch.distance > 0).any())
            for k, pose in enumerate(poses):
                single = rg.object_distance(body, cloud, metric, pose_1=pose, signed=True, closest_points=True)
                deep = single.depth
                self.assertEqual(batch.distance[k], single.signed_distance)
                self.assertEqual(batch.lower[k], single.lower if deep is None else -deep.upper)
                self.assertEqual(batch.upper[k], single.upper if deep is None else -deep.lower)
                self.assertEqual(batch.status[k], (deep or single).status)
                point = single.closest_point_2 if deep is None else deep.point_2
                np.testing.assert_array_equal(batch.point_2[k], point)

    def test_operands_that_do_not_fit_are_named(self):
        with self.assertRaisesRegex(rg.DimensionMismatchError, "A1 has n = 2, Q has n = 3"):
            rg.object_distances([rg.Ball([0, 0])], rg.Ball([0, 0]), rg.Ball([0, 0, 0]))
        with self.assertRaisesRegex(rg.InvalidParameterError, r"object_distance\(\) answers a single problem"):
            rg.object_distances(rg.Ball([0, 0]), rg.Ball([0, 0]), rg.Ball([0, 0]))


class SeparationBatches(unittest.TestCase):
    def test_outcomes_are_those_of_single_tests_and_normals_are_planes_between(self):
        generator = np.random.default_rng(4)
        poses = np.tile(np.eye(4), (60, 1, 1))
        poses[:, :3, :3] = rotations(generator, 60)
        poses[:, :3, 3] = generator.normal(size=(60, 3))
        bodies = [rg.Box([-1, -0.5, -0.2], [1, 0.5, 0.2]), rg.Ball([0.1, 0, 0], 0.4),
                  rg.Capsule([0, 0, -1], [0, 0, 1], 0.3), generator.normal(size=(9, 3))]
        first = [bodies[k % 4] for k in range(60)]
        for threads in (1, 3):
            batch = rg.separations(first, bodies[0], poses_1=poses, threads=threads)
            self.assertEqual(len(batch), 60)
            self.assertEqual(set(batch.outcome), {"separated", "intersecting"})
            for k, pose in enumerate(poses):
                outcome = rg.separation(first[k], bodies[0], pose_1=pose).outcome
                self.assertEqual(batch.outcome[k], outcome)
                if outcome != "separated":
                    self.assertTrue(np.isnan(batch.normal[k]).all())
                    continue
                u = batch.normal[k]
                body = rg.PointSet(first[k]) if isinstance(first[k], np.ndarray) else first[k]
                least = u @ pose[:3, 3] - body.support_function(-pose[:3, :3].T @ u)
                self.assertLess(bodies[0].support_function(u), least)

    def test_operands_that_do_not_fit_are_named(self):
        with self.assertRaisesRegex(rg.DimensionMismatchError, "A1 has n = 2, A2 has n = 3"):
            rg.separations([rg.Ball([0, 0])], rg.Ball([0, 0, 0]))
        with self.assertRaisesRegex(rg.NonFiniteError, "problem 1"):
            rg.separations(rg.Ball([0, 0, 0]), rg.Ball([0, 0, 0]),
                           poses_1=np.array([np.eye(4), np.diag([1, 1, np.nan, 1])]))


if __name__ == "__main__":
    unittest.main()
