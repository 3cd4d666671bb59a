# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""usage: test_optional_packages.py OPTION=PACKAGE...: the options of this build that are on, each with its CMake package.

An optional package that is not there when a folder is first configured, and later is, is found then. An option that the
user sets ON needs its package, or the configuration ends with a line that says what to install."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PACKAGES = dict(argument.split("=") for argument in sys.argv[1:])


def has(option):
    return option.replace("_WITH_", "_HAS_").replace("_BUILD_", "_HAS_")


class OptionalPackages(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def configure(self, *options):
        return subprocess.run(
            ["cmake", "-S", SOURCE, "-B", self.folder.name, "-G", "Ninja", "-DRAYGAUGE_BUILD_TESTS=OFF",
             "-DRAYGAUGE_BUILD_BENCH=OFF", *options], capture_output=True, text=True, env=os.environ)

    def stored(self, name):
        text = (pathlib.Path(self.folder.name) / "CMakeCache.txt").read_text()
        return next((line.split("=", 1)[1] for line in text.splitlines() if line.startswith(name + ":")), None)

    @staticmethod
    def without(packages):
        return [f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON" for package in packages]

    def test_a_package_that_arrives_late_is_found_by_the_next_configuration(self):
        first = self.configure(*self.without(PACKAGES.values()))
        self.assertEqual(first.returncode, 0, first.stderr)
        for option in PACKAGES:
            self.assertEqual(self.stored(has(option)), "OFF", option)
            self.assertEqual(self.stored(option), "AUTO", option)
        if "RAYGAUGE_BUILD_PYTHON" in PACKAGES:
            built = subprocess.run(["cmake", "--build", self.folder.name, "--target", "raygauge_python"],
                                   capture_output=True, text=True)
            self.assertNotEqual(built.returncode, 0)
            self.assertIn("No Python package: apt-get install python3-dev", built.stdout)
        later = self.configure(*(f"-UCMAKE_DISABLE_FIND_PACKAGE_{package}" for package in PACKAGES.values()))
        self.assertEqual(later.returncode, 0, later.stderr)
        for option in PACKAGES:
            self.assertEqual(self.stored(has(option)), "ON", option)

    def test_what_is_on_and_missing_is_an_error_that_names_the_package(self):
        for option, package in PACKAGES.items():
            with self.subTest(option):
                result = self.configure(f"-D{option}=ON", *self.without([package]))
                self.assertNotEqual(result.returncode, 0)
                self.assertRegex(" ".join(result.stderr.split()), option + "=ON needs .* apt-get install [a-z0-9-]+-dev")
                self.configure(f"-D{option}=AUTO", f"-UCMAKE_DISABLE_FIND_PACKAGE_{package}")

    def test_what_the_user_has_set_is_kept(self):
        option = next(iter(PACKAGES))
        self.configure(f"-D{option}=OFF")
        self.configure()
        self.assertEqual(self.stored(option), "OFF")
        self.assertEqual(self.stored(has(option)), "OFF")

    def test_a_value_that_is_none_is_refused(self):
        result = self.configure("-DRAYGAUGE_WITH_QHULL=maybe")
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("must be AUTO, ON or OFF", result.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
