# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""What the tests of the program's scenes share: where it is, a folder of their own, and their command line

    TEST.py --raygauge PROGRAM --scenes FOLDER
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile
import unittest


class SceneProgram(unittest.TestCase):
    raygauge = None
    scenes = None

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.work = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def run_raygauge(self, *arguments, status=0):
        done = subprocess.run([self.raygauge, *map(str, arguments)], capture_output=True, text=True)
        self.assertEqual(done.returncode, status, done.stderr)
        return done


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--raygauge", required=True)
    parser.add_argument("--scenes", type=pathlib.Path, required=True)
    arguments, rest = parser.parse_known_args()
    SceneProgram.raygauge, SceneProgram.scenes = arguments.raygauge, arguments.scenes
    unittest.main(argv=[sys.argv[0], *rest])
