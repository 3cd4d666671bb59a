# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""What docs/promises.md promises is there: commands and options, columns, headers, the Python API."""
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import raygauge as rg

SOURCE = pathlib.Path(os.environ["RAYGAUGE_SOURCE"])
PAGE = (SOURCE / "docs" / "promises.md").read_text(encoding="utf-8")


def section(title):
    return re.search(rf"(?ms)^## {title}\n(.*?)(?=^## |\Z)", PAGE).group(1)


def words(text):
    """What stands between backquotes."""
    return re.findall(r"`([^`]+)`", text)


def rows(text):
    """The cells of each row of a table, its head left out."""
    lines = [line for line in text.splitlines() if line.startswith("|")][2:]
    return [[cell.strip() for cell in line.strip("|").split(" | ")] for line in lines]


def help_of(*command):
    return subprocess.run([os.environ["RAYGAUGE_PROGRAM"], *command, "--help"], check=True, capture_output=True,
                          text=True).stdout


class Promises(unittest.TestCase):
    def test_commands_and_options_are_there(self):
        table = rows(section("The program"))
        self.assertGreaterEqual(len(table), 8)
        for command, options in table:
            there = set(re.findall(r"(?<![\w-])--?[A-Za-z][\w-]*", help_of(*words(command))))
            for option in words(options):
                self.assertIn(option, there, msg=command)

    def test_columns_are_there_with_their_units(self):
        with tempfile.TemporaryDirectory() as folder:
            results = rg.run({"sweep": {"n": [2], "N": [9], "repetitions": 1}, "generator": [{"name": "example2"}],
                              "method": [{"name": "direct"}]}, pathlib.Path(folder, "one.h5"))
        table = rows(section("The results file"))
        self.assertGreaterEqual(len(table), 30)
        for column, unit in table:
            self.assertEqual(results[words(column)[0]].attrs["units"], words(unit)[0] if words(unit) else "")

    def test_statuses_are_those_of_the_engine(self):
        self.assertEqual(words(section("Statuses")), [status.value for status in rg.Status])

    def test_the_python_api_is_this_and_nothing_else(self):
        self.assertEqual(sorted(words(section("The Python package"))), sorted(set(rg.__all__) - {"__version__"}))

    def test_the_public_header_declares_the_promised_names(self):
        text = "\n".join(path.read_text(encoding="utf-8") for path in SOURCE.rglob("*.h")
                         if path.relative_to(SOURCE).parts[0] == "include")
        names = words(section("The C\\+\\+ library"))
        self.assertGreaterEqual(len(names), 25)
        for name in names:
            self.assertRegex(text, rf"\b(class|struct|enum class) {name}\b", msg=name)


if __name__ == "__main__":
    unittest.main()
