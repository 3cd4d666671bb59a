# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""raygauge_pairs beside a library behind an adapter: FCL, and files that are no adapters.

Usage: pair_library.py PROGRAM ADAPTER COMPILER"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

HEADER = pathlib.Path(__file__).resolve().parents[2]
OLD = """#include "bench/pair_library.h"
const struct raygauge_pair_library* raygauge_pair_library_entry(void) {
  static struct raygauge_pair_library library;
  library.version = RAYGAUGE_PAIR_LIBRARY_VERSION + 1;
  return &library;
}
"""


class PairLibrary(unittest.TestCase):
    def run_beside(self, library, *options):
        return subprocess.run([PROGRAM, "--library", str(library), "--pairs", "2", *options], capture_output=True, text=True)

    def rows(self, *options):
        run = self.run_beside(ADAPTER, *options)
        self.assertEqual(run.returncode, 0, run.stderr)
        lines = run.stdout.splitlines()
        self.assertIn("beside FCL", lines[0])
        return {tuple(line.split()[:4]): line.split()[4:] for line in lines[2:] if "geometric mean" not in line}, lines

    def test_each_query_that_the_library_has_is_a_row_with_both_times_and_its_errors(self):
        rows, lines = self.rows("--kinds", "ball,box", "--places", "apart,overlap")
        pairs = [("ball", "ball"), ("ball", "box"), ("box", "box")]
        self.assertEqual(
            set(rows), {(*kinds, *place) for kinds in pairs for place in (("apart", "distance"), ("overlap", "depth"))})
        for cells in rows.values():
            ours, theirs, ratio = map(float, cells[:3])
            half = 0.0005  # of the last place that is printed
            self.assertGreaterEqual(ratio + half, (ours - half) / (theirs + half))
            self.assertLessEqual(ratio - half, (ours + half) / (theirs - half))
            self.assertEqual(cells[4], "nan")  # FCL has no warm start
            self.assertEqual(cells[7], "2/2")  # ours are certified
        self.assertEqual(rows["ball", "ball", "apart", "distance"][8], "0/2")
        self.assertTrue(lines[-1].startswith("depth     cold  geometric mean"), lines[-1])

    def test_bodies_that_the_library_has_not_are_left_out(self):
        rows, _ = self.rows("--kinds", "cone,pointed", "--diagonal")
        self.assertEqual(set(rows), {("pointed", "pointed", "apart", "distance")})

    def test_what_is_no_adapter_is_refused_by_name(self):
        with tempfile.TemporaryDirectory() as scratch:
            text = pathlib.Path(scratch, "text.so")
            text.write_text("no library")
            old = pathlib.Path(scratch, "old.c")
            old.write_text(OLD)
            empty = pathlib.Path(scratch, "empty.c")
            empty.write_text("int nothing;\n")
            for source in (old, empty):
                subprocess.run([COMPILER, "-shared", "-fPIC", "-std=c99", "-I", HEADER, source, "-o", source.with_suffix(".so")],
                               check=True)
            for path, cause in ((text, "text.so: "), (old.with_suffix(".so"), "another version of bench/pair_library.h"),
                                (empty.with_suffix(".so"), "no function raygauge_pair_library_entry")):
                run = self.run_beside(path)
                self.assertEqual(run.returncode, 2)
                self.assertIn(cause, run.stderr)
                self.assertEqual(len(run.stderr.splitlines()), 1)


if __name__ == "__main__":
    PROGRAM, ADAPTER, COMPILER = sys.argv[1:4]
    unittest.main(argv=sys.argv[:1])
