# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""What docs/promises.md promises is there: commands and options, columns, headers, the Python API."""
import ast
import enum
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import h5py

import raygauge as rg
from raygauge import _raygauge

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


def output_of(*command, **options):
    return subprocess.run([os.environ["RAYGAUGE_PROGRAM"], *map(str, command)], check=True, capture_output=True,
                          text=True, **options).stdout


def commands_of(help_text):
    """The commands that a help text lists."""
    listed = help_text.partition("Subcommands:")[2].partition("\n\n")[0]
    return re.findall(r"(?m)^  ([a-z]+) ", listed)


def every_command():
    for command in commands_of(output_of("--help")):
        inner = commands_of(output_of(command, "--help"))
        yield from (f"{command} {name}" for name in inner) if inner else [command]


class Promises(unittest.TestCase):
    def test_commands_are_these_and_their_options_are_there(self):
        table = rows(section("The program"))
        self.assertEqual({words(command)[0] for command, _ in table}, set(every_command()))
        for command, options in table:
            help_text = output_of(*words(command)[0].split(), "--help")
            there = set(re.findall(r"(?<![\w-])--?[A-Za-z][\w-]*", help_text))
            for option in words(options):
                self.assertIn(option, there, msg=command)

    def test_the_json_of_a_distance_has_its_keys(self):
        promised = words(section("The program").partition("prints one object")[2])
        promised = [word for word in promised if re.fullmatch(r"[a-zA-Z_]+", word)]
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "A.csv").write_text("2,0\n3,1\n", encoding="utf-8")
            pathlib.Path(folder, "Q.csv").write_text("1,0\n-1,1\n-1,-1\n", encoding="utf-8")
            answer = json.loads(output_of("distance", "A.csv", "Q.csv", "--witness", "--json", cwd=folder))
        self.assertEqual(set(promised), set(answer))

    def assert_columns(self, title, results):
        promised = {column: words(unit)[0] if words(unit) else ""
                    for columns, unit in rows(section(title)) for column in words(columns)}
        there = {name: variable.attrs["unit"] for name, variable in results.items()}
        self.assertEqual(promised, there)

    def test_columns_are_these_with_their_units(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "one.h5")
            rg.run({"sweep": {"n": [2], "N": [9], "repetitions": 1}, "generator": [{"name": "example2"}],
                    "method": [{"name": "column_generation"}]}, path)
            with h5py.File(path) as file:
                self.assert_columns("The results file", file["records"])

    def test_columns_of_a_scene_are_these_with_their_units(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "scene.h5")
            output_of("scene", "run", SOURCE / "experiments/scenes" / "two_vehicles.toml", "-o", path)
            with h5py.File(path) as file:
                self.assert_columns("The file of a scene", file["records"])

    def test_statuses_are_those_of_the_engine(self):
        self.assertEqual(words(section("Statuses")), [status.value for status in rg.Status])

    def test_the_python_api_is_this_and_nothing_else(self):
        self.assertEqual(sorted(words(section("The Python package"))), sorted(set(rg.__all__) - {"__version__"}))

    def test_the_public_header_declares_the_promised_names(self):
        names = words(section("The C\\+\\+ library"))
        self.assertGreaterEqual(len(names), 25)
        lines = ['#include "raygauge/raygauge.h"', *(f"using raygauge::{name};" for name in names)]
        command = [os.environ["RAYGAUGE_COMPILER"], "-std=c++20", "-fsyntax-only",
                   f"-I{SOURCE / 'include'}", "-isystem", "/usr/include/eigen3", "-x", "c++", "-"]
        compiled = subprocess.run(command, input="\n".join(lines) + "\n", capture_output=True, text=True)
        self.assertEqual(compiled.returncode, 0, msg=compiled.stderr)

    def test_the_stubs_are_the_module(self):
        """Every name, class and property of _raygauge.pyi is in the compiled module, and the other way round."""
        stub = ast.parse((SOURCE / "python" / "raygauge" / "_raygauge.pyi").read_text(encoding="utf-8"))
        for node in stub.body:
            if not isinstance(node, ast.ClassDef):
                continue
            member = getattr(_raygauge, node.name)
            told = {item.name for item in node.body if isinstance(item, ast.FunctionDef)}
            there = {name for name in vars(member) if not name.startswith("_")} - set(dir(str))
            self.assertEqual({name for name in told if not hasattr(member, name)}, set(), msg=node.name)
            if not issubclass(member, enum.Enum):
                self.assertEqual(there - told, set(), msg=node.name)


if __name__ == "__main__":
    unittest.main()
