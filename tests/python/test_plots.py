# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Figures: the curves hold the medians of the records, and the colours are those of the program's figures."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import matplotlib.pyplot as plt
import numpy as np

import raygauge as rg
from raygauge import plot

SOURCE = pathlib.Path(os.environ["RAYGAUGE_SOURCE"])
EXPERIMENT = {
    "sweep": {"n": [3], "N": [20, 40, 80], "repetitions": 7},
    "generator": [{"name": "example2"}],
    "method": [{"name": "column_generation"}, {"name": "zheng_yamane"}, {"name": "clp_dual"}],
}


class Plots(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.scratch.name, "mine.h5")
        cls.results = rg.run(EXPERIMENT, cls.path)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_curves_are_the_medians_of_the_records(self):
        axes = plot.time(self.results, axes=plt.figure().gca())
        curves = {container.get_label(): container.lines[0] for container in axes.containers}
        self.assertEqual(sorted(curves), ["clp_dual", "column_generation", "zheng_yamane"])
        for method, curve in curves.items():
            for N, seconds in zip(*curve.get_data()):
                chosen = (self.results.method == method) & (self.results.N == N)
                self.assertEqual(seconds, np.median(self.results.seconds[chosen]))

    def test_each_size_has_a_curve_of_its_own(self):
        two = {**EXPERIMENT, "sweep": {"n": [3, 5], "N": [20, 40], "repetitions": 6}}
        results = rg.run(two, pathlib.Path(self.scratch.name, "two.h5"))
        axes = plot.time(results, axes=plt.figure().gca())
        curves = {container.get_label(): container.lines[0] for container in axes.containers}
        self.assertIn("column_generation, n = 5", curves)
        self.assertEqual(len(curves), 6)
        for N, seconds in zip(*curves["column_generation, n = 5"].get_data()):
            chosen = (results.method == "column_generation") & (results.N == N) & (results.n == 5)
            self.assertEqual(seconds, np.median(results.seconds[chosen]))

    def test_tolerances_are_not_mixed(self):
        loose = {**EXPERIMENT, "sweep": {"n": [3], "N": [20, 40], "tolerance": [1e-3, 1e-6], "repetitions": 2}}
        results = rg.run(loose, pathlib.Path(self.scratch.name, "loose.h5"))
        with self.assertRaisesRegex(rg.InvalidParameterError, "several values of tolerance .*, choose one|choose one, as in"):
            plot.time(results, axes=plt.figure().gca())
        plot.time(results.isel(record=results.tolerance.values == 1e-6), axes=plt.figure().gca())

    def test_unsolved_records_count_as_infinitely_slow(self):
        results = self.results.copy(deep=True)
        results["status"][:] = "time_limit"
        self.assertTrue(np.isinf(plot.medians(results)["median"]).all())

    def test_an_interval_of_a_median_is_that_of_order_statistics(self):
        # Of 20 sorted values the 95 % interval of the median is from the 6th to the 15th (coverage 0.9586).
        median, low, high = plot._median_interval(np.arange(1.0, 21.0))
        self.assertEqual(median, 10.5)
        self.assertLessEqual(low, 6)
        self.assertGreaterEqual(high, 15)

    def test_a_profile_reaches_one_where_everything_is_solved(self):
        axes = plot.performance_profile(self.results, plt.figure().gca())
        for line in axes.lines:
            self.assertEqual(line.get_ydata()[-1], 1.0)

    def test_colours_are_those_of_the_programs_figures(self):
        source = (SOURCE / "analysis/render/method_look.cc").read_text(encoding="utf-8")
        theirs = re.findall(r'\{"(\w+)", "(#[0-9A-F]{6})", "#[0-9A-F]{6}", Marker::(\w+), Dash::(\w+)', source)
        self.assertGreaterEqual(len(theirs), 10)
        markers = {"circle": "o", "square": "s", "triangle": "^", "diamond": "D", "triangle_down": "v"}
        dashes = {"solid": "-", "dashed": "--", "dotted": ":", "dash_dotted": "-."}
        looks = {name: (color, markers[marker], dashes[dash]) for name, color, marker, dash in theirs}
        self.assertEqual(plot._LOOKS, looks)
        others = re.search(r"kOtherColors = \{(.*?)\}", source, re.DOTALL).group(1)
        self.assertEqual(list(plot._OTHER_COLORS), re.findall(r"#[0-9A-F]{6}", others))

    def test_the_example_draws_a_figure(self):
        picture = pathlib.Path(self.scratch.name, "time.svg")
        example = SOURCE / "python" / "examples" / "figure.py"
        subprocess.run([sys.executable, example, self.path, picture], check=True)
        self.assertIn("zheng_yamane", picture.read_text(encoding="utf-8").replace("zheng\\_yamane", "zheng_yamane"))


if __name__ == "__main__":
    unittest.main()
