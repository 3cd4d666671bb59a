# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""usage: lp_programs.py RAYGAUGE EXPERIMENT QSOPT_EX. The shipped sweep over HiGHS and QSopt_ex, small, and what both answer to
questions that no sweep asks."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

RAYGAUGE, EXPERIMENT, QSOPT_EX = sys.argv[1:4]
ROOT = pathlib.Path(EXPERIMENT).resolve().parents[1]
HIGHS = ROOT / "docs/examples/highs.py"
PROGRAMS = [[QSOPT_EX], [sys.executable, HIGHS, "highs-ds"], [sys.executable, HIGHS, "highs-ipm"]]
TRIANGLE_AND_SQUARE = "points 3 4 2\n2 0\n4 -1\n4 1\n1 0\n-1 0\n0 1\n0 -1\n"
UNREACHABLE = "points 1 1 2\n1 0\n0 1\n"


def answers(program, text):
    run = subprocess.run([*map(str, program)], input=text, text=True, capture_output=True, check=True)
    return run.stdout.splitlines()


class LpPrograms(unittest.TestCase):
    def test_a_distance_has_a_normal_and_the_points_that_meet(self):
        for program in PROGRAMS:
            ready, answer = answers(program, TRIANGLE_AND_SQUARE + "solve 1e-6 inf\n")
            self.assertEqual(ready, "ready")
            distance, *rest = answer.split()
            self.assertAlmostEqual(float(distance), 2)
            u = [float(word) for word in rest[1:3]]
            self.assertAlmostEqual(u[0], -1)  # the face of the square that the triangle's vertex meets
            self.assertLessEqual(abs(u[1]), 1 + 1e-9)
            self.assertEqual(rest[3:], ["a", "0", "q", "0"])

    def test_the_next_points_replace_the_last_and_may_be_out_of_reach(self):
        for program in PROGRAMS:
            text = TRIANGLE_AND_SQUARE + "solve 1e-6 10\n" + UNREACHABLE + "solve 1e-6 10\nsolve 1e-6 inf\n"
            lines = answers(program, text)
            self.assertEqual(lines[2:], ["ready", "inf", "inf"])

    def test_the_shipped_sweep_runs_and_exact_solvers_agree(self):
        with tempfile.TemporaryDirectory() as folder:
            experiment = pathlib.Path(folder, "lp.toml")
            text = pathlib.Path(EXPERIMENT).read_text()
            text = text.replace("build/release/raygauge_qsopt_ex", QSOPT_EX).replace("/usr/bin/python3", sys.executable)
            experiment.write_text(text)
            results = pathlib.Path(folder, "lp.h5")
            subprocess.run([RAYGAUGE, "run", experiment, "-o", results, "-q", "--set", "sweep.n=3,10",
                            "--set", "sweep.repetitions=1"], cwd=ROOT, check=True)
            table = subprocess.run([RAYGAUGE, "table", results, "--stability", "--format", "csv"], cwd=ROOT, text=True,
                                   capture_output=True, check=True).stdout.splitlines()
        rows = [row.split(",") for row in table]
        family, method, certified, wrong = (rows[0].index(name) for name in ("family", "method", "certified_share", "wrong"))
        self.assertEqual({"exact", "qsopt_ex", "highs_dual", "highs_interior"} - {row[method] for row in rows}, set())
        for row in rows[1:]:
            if row[method] in ("exact", "qsopt_ex", "column_generation"):
                self.assertEqual(float(row[wrong]), 0, row)
            if row[family] == "example2":
                self.assertEqual(float(row[certified]), 1, row)


unittest.main(argv=["lp_programs.py"], verbosity=2)
