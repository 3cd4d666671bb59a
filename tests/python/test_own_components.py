# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Methods and generators in Python take part in sweeps as the others do."""
import functools
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

import raygauge as rg

SWEEP = {"n": [2, 3], "N": [12], "tolerance": 1e-6, "repetitions": 3}
EXAMPLES = pathlib.Path(os.environ["RAYGAUGE_SOURCE"], "python", "examples")


@rg.generator
def shifted_cloud(rng, n, N, shift=4.0):
    """A cloud at a distance from another one around the origin."""
    A = rng.normal(size=(N, n))
    A[:, 0] += shift
    return A, np.vstack([rng.normal(size=(N, n)), np.eye(n), -np.eye(n)])


@rg.generator
def points_before_crosses(rng, n):
    """One point in the gauge of the 1-norm: the distance is known."""
    a = rng.normal(size=n)
    return [a], np.vstack([np.eye(n), -np.eye(n)]), np.abs(a).sum()


@rg.generator
def balls(rng, n, radius=1.0):
    center = rng.normal(size=n)
    center *= 5 / np.linalg.norm(center)
    return rg.Ball(center, radius), rg.Ball(np.zeros(n)), 5 - radius


@rg.method
def one_norm(A, Q, scale=1.0):
    """Right for points in the gauge of the 1-norm."""
    return scale * np.abs(A).sum(axis=1).min()


@rg.method
def by_raygauge(A, Q, tolerance, time_limit):
    """raygauge itself, called from Python."""
    r = rg.distance(A, Q, tolerance, time_limit=time_limit)
    return rg.Answer(r.distance, u=r.normal, points_A=range(len(A)), points_Q=range(len(Q)), pivots=r.counters.pivots)


@rg.method(name="two_steps")
class TwoSteps:
    """Loads first, solves then."""

    def __init__(self, factor=1):
        self.factor = factor

    def load(self, A, Q):
        self.A, self.Q = A, Q

    def solve(self, tolerance):
        return self.factor * rg.distance(self.A, self.Q, tolerance).distance


@rg.method
def fails_at_three(A, Q):
    if A.shape[1] == 3:
        raise RuntimeError("no solver\nfor n = 3")
    return rg.distance(A, Q).distance


class OwnComponents(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.path = pathlib.Path(scratch.name, "own.h5")

    def run_with(self, methods, generators, sweep=None, **options):
        experiment = {"sweep": {**SWEEP, **(sweep or {})}, "run": options.pop("run", {"threads": 2}),
                      "generator": [{"name": name} if isinstance(name, str) else name for name in generators],
                      "method": [{"name": name} if isinstance(name, str) else name for name in methods]}
        return rg.run(experiment, self.path, **options)

    def test_a_method_is_timed_and_certified_as_the_others_are(self):
        results = self.run_with(["column_generation", "by_raygauge"], ["shifted_cloud", "example2"])
        self.assertEqual(results.sizes["record"], 2 * 2 * 3 * 2)
        own = results.isel(record=results.method.values == "by_raygauge")
        other = results.isel(record=results.method.values == "column_generation")
        self.assertTrue((own.seconds.values > 0).all() and (own.load_seconds.values > 0).all())
        self.assertTrue(own.agrees.values.all())
        np.testing.assert_array_less(own.lower.values, own.upper.values * (1 + 1e-15))
        self.assertTrue((own.upper.values - own.lower.values <= 1e-6 * own.upper.values).all())
        np.testing.assert_allclose(own.distance.values, other.distance.values, rtol=1e-6)
        self.assertIn("shifted_cloud", set(results.generator.values))
        self.assertIn("shift=4", set(results.generator_parameters.values))

    def test_without_the_programs_libraries_the_error_is_one_line(self):
        @rg.method
        def nothing(A, Q):
            return 1.0

        experiment = {"sweep": {"n": [2], "N": [5], "repetitions": 1}, "generator": [{"name": "example2"}],
                      "method": [{"name": "nothing"}]}
        present = sys.modules.get("raygauge._sweeps")
        sys.modules["raygauge._sweeps"] = None  # as after ./run.sh python alone
        before = getattr(rg, "_sweeps", None)
        if before is not None:
            del rg._sweeps
        try:
            with self.assertRaises(rg.ProgramError) as raised:
                rg.run(experiment, os.path.join(tempfile.gettempdir(), "never.h5"))
        finally:
            if present is None:
                del sys.modules["raygauge._sweeps"]
            else:
                sys.modules["raygauge._sweeps"] = present
            if before is not None:
                rg._sweeps = before
        self.assertTrue(raised.exception.__suppress_context__)
        self.assertIsNone(raised.exception.__cause__)
        self.assertEqual(str(raised.exception), "methods and generators in Python need the package built beside the "
                         "program: ./run.sh build, then ./run.sh python")

    def test_a_known_distance_is_compared_and_bare_numbers_have_no_bounds(self):
        results = self.run_with([{"name": "one_norm"}, {"name": "one_norm", "scale": 1.5, "label": "wrong"}, "newton"],
                                ["points_before_crosses"])
        of = {name: results.isel(record=results.method.values == name) for name in ("one_norm", "wrong", "newton")}
        np.testing.assert_allclose(of["one_norm"].distance.values, of["one_norm"].exact_distance.values, rtol=1e-15)
        self.assertTrue(np.isnan(of["one_norm"].lower.values).all() and np.isnan(of["one_norm"].upper.values).all())
        self.assertEqual(set(of["one_norm"].status.values), {"optimal"})
        np.testing.assert_allclose(of["wrong"].distance.values, 1.5 * of["newton"].distance.values, rtol=1e-6)

    def test_classes_load_and_solve_and_sets_come_as_they_are(self):
        results = self.run_with([{"name": "two_steps", "factor": 2}, "newton"], [{"name": "balls", "radius": 2}],
                                run={"timing": "serial"})
        own = results.isel(record=results.method.values == "two_steps")
        np.testing.assert_allclose(own.distance.values, 6, rtol=1e-5)
        self.assertEqual(set(own.method_parameters.values), {"factor=2"})

    def test_instances_depend_on_their_key_alone(self):
        once = self.run_with(["column_generation"], ["shifted_cloud"], run={"threads": 1})
        again = self.run_with(["column_generation"], ["shifted_cloud"], force=True)
        np.testing.assert_array_equal(once.distance.values, again.distance.values)

    def test_an_exception_ends_the_sweep_in_one_line_and_the_rest_can_be_resumed(self):
        with self.assertRaisesRegex(rg.ProgramError, r"method 'fails_at_three': RuntimeError: no solver for n = 3 "
                                                     r"\(test_own_components.py, line \d+\)") as caught:
            self.run_with(["fails_at_three"], ["shifted_cloud"], run={"threads": 1})
        self.assertNotIn("\n", str(caught.exception))
        self.assertIsInstance(caught.exception.__cause__, RuntimeError)

    def test_nonsense_is_refused_in_one_line(self):
        answers = {"returns_none": None, "returns_text": "much", "returns_less": -1.0,
                   "returns_index": rg.Answer(1.0, points_A=[99]), "returns_short_u": rg.Answer(1.0, u=[1.0]),
                   "returns_status": rg.Answer(1.0, status="fine")}
        for name, answer in answers.items():
            # Bound now: the method that is found by this name returns this answer.
            rg.method(name=name)(functools.partial(lambda given, A, Q: given, answer))
            with self.assertRaisesRegex(rg.ProgramError, name, msg=name) as caught:
                self.run_with([name], ["shifted_cloud"], force=True)
            self.assertNotIn("\n", str(caught.exception))
        instances = {"gives_text": ("much", [[1.0]]), "gives_nan": ([[np.nan, 0.0]], [[1.0, 0.0]]), "gives_one": [[1.0, 0.0]]}
        for name, instance in instances.items():
            rg.generator(name=name)(functools.partial(lambda given, n: given, instance))
            with self.assertRaisesRegex(rg.ProgramError, name, msg=name):
                self.run_with(["column_generation"], [name], force=True)

    def test_what_cannot_be_called_by_name_is_refused_when_it_is_registered(self):
        for wrong in (lambda A, Q, unknown: 0, lambda A: 0, lambda A, Q, *more: 0, 5, object):
            with self.assertRaises(rg.InvalidParameterError):
                rg.method(name="wrong")(wrong)
        with self.assertRaises(rg.InvalidParameterError):
            rg.generator(name="wrong")(lambda n, N, shape=(): (n, N))
        with self.assertRaisesRegex(rg.InvalidParameterError, "lambda"):
            rg.method(lambda A, Q: 0)
        with self.assertRaisesRegex(rg.ProgramError, "scal"):
            self.run_with([{"name": "one_norm", "scal": 2}], ["points_before_crosses"])

    def test_ctrl_c_keeps_what_is_done_and_resume_finishes_it(self):
        @rg.method
        def slow(A, Q):
            time.sleep(0.02)
            return rg.distance(A, Q).distance

        sweep = {"n": [2], "N": list(range(10, 40)), "repetitions": 2}
        timer = threading.Timer(0.4, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            self.run_with(["slow"], ["shifted_cloud"], sweep)
        some = rg.open(self.path).sizes["record"]
        self.assertLess(some, 60)
        self.assertEqual(self.run_with(["slow"], ["shifted_cloud"], sweep, resume=True).sizes["record"], 60)

    def test_an_answer_after_the_time_limit_is_no_answer(self):
        @rg.method
        def late(A, Q):
            time.sleep(0.05)
            return 1.0

        results = self.run_with(["late"], ["shifted_cloud"], {"n": [2], "repetitions": 1}, run={"time_limit": 0.01})
        self.assertEqual(list(results.status.values), ["time_limit"])

    def test_the_example_runs(self):
        run = subprocess.run([sys.executable, EXAMPLES / "own_competitor.py", self.path], capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, msg=run.stderr)
        self.assertIn("highs", run.stdout)


if __name__ == "__main__":
    unittest.main()
