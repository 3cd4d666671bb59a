# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Whatever array is given: an answer, or an exception of raygauge's; never a crash, never a wrong answer."""
import unittest

import numpy as np

import raygauge as rg

SQUARE = rg.PointSet([[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0, 0, 1], [0, 0, -1]])


class Layouts(unittest.TestCase):
    def setUp(self):
        self.points = np.random.default_rng(5).integers(2, 60, size=(30, 3)).astype(float)
        self.expected = rg.distance(self.points, SQUARE)

    def assert_same(self, points):
        result = rg.distance(points, SQUARE)
        for name in ("distance", "lower", "upper"):
            self.assertEqual(getattr(result, name), getattr(self.expected, name))

    def test_every_layout_of_the_same_numbers_gives_the_same_bits(self):
        points = self.points
        padded = np.zeros((60, 7))
        padded[::2, 1::2] = points
        unaligned = np.frombuffer(b"x" + points.tobytes(), dtype=np.uint8)[1:].view(np.float64).reshape(30, 3)
        readonly = points.copy()
        readonly.flags.writeable = False
        layouts = [np.asfortranarray(points), padded[::2, 1::2], points[::-1][::-1], unaligned, readonly,
                   points.astype(">f8"), points.tolist(), points.astype(object), np.ma.masked_array(points),
                   memoryview(points)]
        for layout in layouts:
            self.assert_same(layout)

    def test_every_real_dtype_that_holds_the_numbers_gives_the_same_bits(self):
        for dtype in ("f2", "f4", "f8", "g", "i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", ">i4", ">f4"):
            self.assert_same(self.points.astype(dtype))

    def test_an_array_of_doubles_in_c_order_is_not_changed(self):
        before = self.points.copy()
        rg.distance(self.points, SQUARE)
        np.testing.assert_array_equal(self.points, before)


class Refusals(unittest.TestCase):
    def test_what_is_no_array_of_real_numbers_is_refused_with_what_it_is(self):
        refused = [None, "text", b"bytes", object(), {}, {1, 2}, 3.0, [[1, 2], [3]], [["a", "b", "c"]], [[1j, 0, 0]],
                   np.array([["2020-01-01"] * 3], dtype="M8[D]"), np.zeros((1, 3), dtype="V8"),
                   np.zeros(3, dtype=[("x", float)]), np.zeros((2, 2, 2, 2)), [[None, 1, 2]], lambda u: u,
                   np.array([[object()] * 3]), [[10**400, 0, 0]], np.zeros(()), range(0)]
        for value in refused:
            with self.assertRaises(rg.Error, msg=repr(value)) as caught:
                rg.distance(value, SQUARE)
            self.assertNotIn("\n", str(caught.exception))

    def test_what_memory_cannot_hold_is_refused(self):
        endless = np.broadcast_to(np.zeros((1, 3)), (10**13, 3))
        with self.assertRaises((MemoryError, rg.Error)):
            rg.distance(endless, SQUARE)

    def test_numbers_that_are_none_are_refused(self):
        for bad in (np.nan, np.inf, -np.inf):
            points = np.ones((4, 3))
            points[2, 1] = bad
            with self.assertRaisesRegex(rg.NonFiniteError, "2"):
                rg.distance(points, SQUARE)

    def test_objects_with_hostile_conversions_pass_on_what_they_raise(self):
        class Hostile:
            def __array__(self, *arguments, **keywords):
                raise KeyError("on purpose")

            def __float__(self):
                raise KeyError("on purpose")

        with self.assertRaises((KeyError, rg.Error)):
            rg.distance(Hostile(), SQUARE)


class Fuzz(unittest.TestCase):
    def random_operand(self, generator):
        kind = generator.integers(8)
        shape = tuple(generator.integers(0, 5, size=generator.integers(0, 5)))
        if kind == 0:
            return generator.normal(size=shape)
        if kind == 1:
            return generator.integers(-9, 9, size=shape).astype(generator.choice(["i1", "u8", ">i2", "f2", "?"]))
        if kind == 2:
            array = generator.normal(size=shape)
            if array.size:
                array.flat[generator.integers(array.size)] = generator.choice([np.nan, np.inf, 1e308, 5e-324])
            return array
        if kind == 3:
            return np.empty(shape, dtype=generator.choice(["O", "U3", "S2", "c16", "m8[s]", "V4"]))
        if kind == 4:
            return (10.0 ** generator.integers(-300, 300, size=(4, 3))) * generator.normal(size=(4, 3))
        if kind == 5:
            return generator.normal(size=(6, 6))[:: generator.choice([-2, 2, 3]), ::2]
        if kind == 6:
            return generator.choice(np.array([None, "x", 3.5, True], dtype=object))
        return [[1.0, 2.0, float(generator.integers(9))]] * int(generator.integers(0, 4))

    def test_random_operands_are_answered_or_refused(self):
        generator = np.random.default_rng(20)
        answered = refused = 0
        for _ in range(4000):
            A, Q = self.random_operand(generator), self.random_operand(generator)
            call = generator.choice([rg.distance, rg.distances, rg.growth_distance, rg.separation])
            method = str(generator.choice(["column_generation", "newton", "zheng_yamane"]))
            try:
                result = call(A, Q, 1e-6, method, time_limit=1.0)
            except (rg.Error, MemoryError):
                refused += 1
                continue
            answered += 1
            if call in (rg.distance, rg.growth_distance):
                self.assertFalse(result.lower > result.upper, msg=f"{A!r} {Q!r} {result!r}")
        self.assertGreater(answered, 50)
        self.assertGreater(refused, 1000)

    def test_masked_entries_are_refused_and_masks_without_any_are_not(self):
        masked = np.ma.array([[2.0, 0], [3, 1], [9, 9]], mask=[[0, 0], [0, 0], [1, 1]])
        whole = np.ma.array([[2.0, 0], [3, 1]], mask=False)
        Q = rg.Ball([0, 0])
        for call in (lambda: rg.distance(masked, Q), lambda: rg.PointSet(masked), lambda: rg.PointSet([masked[0], masked[2]]),
                     lambda: rg.Ball(masked[2]), lambda: rg.distances([masked, whole], Q),
                     lambda: rg.distances(np.ma.array([masked, masked]), Q), lambda: rg.gauge(Q, masked[2])):
            with self.assertRaisesRegex(rg.InvalidParameterError, "masked entries"):
                call()
        self.assertEqual(rg.distance(whole, Q).distance, rg.distance(np.asarray(whole), Q).distance)

    def test_signatures_say_types(self):
        for function in (rg.distance, rg.distances, rg.object_distance, rg.growth_distance, rg.separation, rg.contains):
            first = function.__doc__.splitlines()[0]
            self.assertNotIn("handle", first)
            self.assertIn("ConvexSet | ArrayLike", first)
        self.assertIn("pose_A: ArrayLike | None = None", rg.distance.__doc__)
        self.assertIn("tolerance: float = 1e-06", rg.distance.__doc__)
        for name in rg.__all__:
            kind = getattr(rg, name)
            if isinstance(kind, type) and issubclass(kind, rg.ConvexSet) and kind is not rg.ConvexSet:
                self.assertNotIn("handle", kind.__init__.__doc__, msg=name)

    def test_random_arguments_of_sets_are_answered_or_refused(self):
        generator = np.random.default_rng(21)
        kinds = [rg.Ball, rg.Box, rg.Ellipsoid, rg.PNormBall, rg.Simplex, rg.UnionHull, rg.MinkowskiSum, rg.PointSet]
        made = 0
        for _ in range(4000):
            kind = kinds[generator.integers(len(kinds))]
            arguments = [self.random_operand(generator) for _ in range(generator.integers(1, 3))]
            try:
                shape = kind(*arguments)
            except (rg.Error, TypeError, MemoryError):
                continue
            made += 1
            self.assertFalse(np.isnan(shape.support_function(np.ones(shape.dimension))))
        self.assertGreater(made, 100)


if __name__ == "__main__":
    unittest.main()
