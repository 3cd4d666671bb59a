# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Every example in a docstring is run, and everything public has a docstring."""
import doctest
import os
import pathlib
import shutil
import tempfile
import unittest

import numpy as np
import raygauge as rg
from raygauge import files, plot, sweeps

RUNS_THE_PROGRAM = ("open", "run", "Robot", "load_scene", "load_set", "EdgeChecker", "prove_path", "plan")
SOURCE = pathlib.Path(os.environ["RAYGAUGE_SOURCE"])
CUBE = "".join(f"v {x} {y} {z}\n" for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)) + "f 1 2 4 3\nf 5 6 8 7\n"


class Docstrings(unittest.TestCase):
    def examples(self):
        finder = doctest.DocTestFinder(exclude_empty=True)
        parser = doctest.DocTestParser()
        names = {"rg": rg, "np": np, "toml_text": sweeps.toml_text}
        yield from finder.find(sweeps.toml_text, "toml_text", globs=names)
        for name in rg.__all__:
            text = getattr(getattr(rg, name), "__doc__", None)
            needs = "RAYGAUGE_PLANNERS" if name == "plan" else "RAYGAUGE_PROGRAM"
            if text and not (name in RUNS_THE_PROGRAM and needs not in os.environ):
                yield parser.get_doctest(text, dict(names), name, name, 0)

    def test_the_examples_print_what_they_say(self):
        folder = os.getcwd()
        ran = 0
        with tempfile.TemporaryDirectory() as scratch:
            os.chdir(scratch)
            try:
                if "RAYGAUGE_PROGRAM" in os.environ:
                    for name in ("arm.urdf", "falling_box.toml"):
                        shutil.copy(SOURCE / "experiments/scenes" / name, scratch)
                    pathlib.Path("cube.obj").write_text(CUBE, encoding="ascii")
                    methods = [{"name": "column_generation"}, {"name": "clp_dual"}, {"name": "clp_primal"}]
                    rg.run({"sweep": {"n": [3], "N": [200], "repetitions": 3}, "method": methods,
                            "generator": [{"name": "example2"}]}, "example2.h5")
                runner = doctest.DocTestRunner(optionflags=doctest.REPORT_NDIFF | doctest.ELLIPSIS)
                for example in self.examples():
                    ran += len(example.examples)
                    runner.run(example)
            finally:
                os.chdir(folder)
        self.assertEqual(runner.summarize(verbose=False).failed, 0)
        self.assertGreater(ran, 35)

    def test_everything_public_says_what_it_is(self):
        for name in rg.__all__:
            self.assertTrue(getattr(rg, name).__doc__, msg=name)
        for function in (files.open, plot.time, plot.performance_profile, plot.medians, sweeps.run):
            self.assertTrue(function.__doc__)


if __name__ == "__main__":
    unittest.main()
