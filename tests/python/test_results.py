# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Results files as datasets and frames; sweeps run from Python."""
import csv
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import h5py
import numpy as np

import raygauge as rg
from raygauge.sweeps import toml_text

EXPERIMENT = {
    "name": 'a "quoted" name',
    "sweep": {"n": np.array([2, 3]), "N": [20, 40], "tolerance": 1e-6, "repetitions": 4},
    "run": {"timing": "serial"},
    "generator": [{"name": "example2", "separation": 1.5}],
    "method": [{"name": "column_generation"}, {"name": "zheng_yamane", "label": "paper"}],
}


FILES = pathlib.Path(os.environ["RAYGAUGE_SOURCE"], "tests/results/files")
RELEASED_FILES = sorted(FILES.glob("*.h5"))


def exported(path, folder):
    """The rows that `raygauge export` writes of a file."""
    table = pathlib.Path(folder, path.stem + ".csv")
    subprocess.run([os.environ["RAYGAUGE_PROGRAM"], "export", path, "--csv", table], check=True,
                   stdout=subprocess.DEVNULL)
    with open(table, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def changed(path, folder, version):
    """A copy of the file that claims to be of another schema version."""
    copy = pathlib.Path(folder, f"{path.stem}_of_{version}.h5")
    shutil.copyfile(path, copy)
    with h5py.File(copy, "r+") as file:
        file.attrs["schema_version"] = np.int64(version)
    return copy


class ReleasedFiles(unittest.TestCase):
    def test_they_have_the_columns_and_values_that_the_program_gives_them(self):
        self.assertGreaterEqual(len(RELEASED_FILES), 2)
        for path in RELEASED_FILES:
            results = rg.open(path)
            with tempfile.TemporaryDirectory() as folder:
                rows = exported(path, folder)
            self.assertLessEqual(set(results.variables), set(rows[0]))  # which has columns of later releases, too
            for name, values in results.variables.items():
                expected = [row[name] for row in rows]
                if values.dtype.kind == "f":
                    np.testing.assert_array_equal(values.values, [float(text) for text in expected], err_msg=name)
                elif values.dtype.kind == "O":
                    self.assertEqual(list(values.values), expected, name)

    def test_a_killed_run_is_resumed_to_the_end(self):
        with tempfile.TemporaryDirectory() as folder:
            path, experiment = pathlib.Path(folder, "killed.h5"), pathlib.Path(folder, "killed.toml")
            shutil.copytree(FILES / "killed_0.2.h5.parts", f"{path}.parts")
            with h5py.File(f"{path}.parts/session-0000.h5") as session:
                experiment.write_text(session["provenance/experiment"].asstr()[()], encoding="utf-8")
                cells = int(session["provenance"].attrs["cell_count"])
            subprocess.run([os.environ["RAYGAUGE_PROGRAM"], "run", experiment, "-o", path, "--resume", "-q"], check=True)
            results = rg.open(path)
            self.assertEqual(results.sizes["record"], 2 * cells)
            self.assertEqual(set(results.session.values), {0, 1})

    def test_other_schema_versions_are_refused_in_the_programs_words(self):
        for path in RELEASED_FILES:
            version = rg.open(path).attrs["schema_version"]
            for other in (version - 1, version + 1):
                with tempfile.TemporaryDirectory() as folder:
                    copy = changed(path, folder, other)
                    program = subprocess.run([os.environ["RAYGAUGE_PROGRAM"], "info", copy], capture_output=True, text=True)
                    with self.assertRaises(rg.ResultsError) as refused:
                        rg.open(copy)
                self.assertEqual(program.returncode, 2)
                self.assertEqual(program.stderr, f"raygauge: {refused.exception}\n")
                self.assertIn(f"schema version {other}", program.stderr)
                self.assertIn("measure anew" if other < version else f"reads version {version}", program.stderr)


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.scratch.name, "mine.h5")
        cls.results = rg.run(EXPERIMENT, cls.path)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_every_record_of_the_grid_is_there(self):
        self.assertEqual(self.results.sizes["record"], 2 * 2 * 4 * 2)
        self.assertEqual(set(self.results.method.values), {"column_generation", "paper"})
        self.assertEqual(set(self.results.n.values), {2, 3})

    def test_columns_units_and_values_are_those_of_the_export(self):
        rows = exported(self.path, self.scratch.name)
        self.assertEqual(set(rows[0]), set(self.results.variables))
        for name in ("seconds", "distance", "lower", "upper"):
            np.testing.assert_array_equal(self.results[name].values, [float(row[name]) for row in rows])
        for name in ("method", "status", "generator_parameters"):
            self.assertEqual(list(self.results[name].values), [row[name] for row in rows])
        for variable in self.results.variables.values():
            self.assertTrue(variable.attrs["description"])
            self.assertIn("units", variable.attrs)
        self.assertEqual(self.results.seconds.attrs["units"], "s")

    def test_texts_are_strings_and_in_frames_categories(self):
        self.assertIsInstance(self.results.method.values[0], str)
        frame = self.results.isel(record=self.results.method.values == "column_generation")[["method", "seconds"]].to_dataframe()
        self.assertEqual(str(frame.dtypes["method"]), "category")
        self.assertEqual(len(frame), 16)
        self.assertEqual(self.results.to_dataframe().dtypes["agrees"], bool)

    def test_provenance_is_kept(self):
        self.assertIn("example2", self.results.attrs["experiment"])
        self.assertEqual(self.results.attrs["raygauge_version"], rg.__version__)

    def test_a_run_is_not_overwritten_but_by_force(self):
        with self.assertRaisesRegex(rg.ProgramError, "mine.h5"):
            rg.run(EXPERIMENT, self.path)
        other = pathlib.Path(self.scratch.name, "other.h5")
        rg.run(EXPERIMENT, other)
        self.assertEqual(rg.run(EXPERIMENT, other, force=True, threads=1).sizes["record"], 32)
        self.assertEqual(rg.run(EXPERIMENT, other, resume=True).sizes["record"], 32)

    def test_mistakes_of_an_experiment_are_told_in_the_programs_words(self):
        with self.assertRaisesRegex(rg.ProgramError, "example2"):
            rg.run({**EXPERIMENT, "generator": [{"name": "exampel2"}]}, pathlib.Path(self.scratch.name, "no.h5"))
        with self.assertRaises(rg.InvalidParameterError):
            rg.run({"sweep": {"n": object()}}, pathlib.Path(self.scratch.name, "no.h5"))

    def test_what_is_no_results_file_is_refused(self):
        text = pathlib.Path(self.scratch.name, "text.h5")
        text.write_text("no results", encoding="utf-8")
        for path in (text, pathlib.Path(self.scratch.name, "missing.h5"), self.scratch.name):
            with self.assertRaises(rg.ResultsError):
                rg.open(path)

    def test_a_flipped_bit_is_found_by_the_checksum(self):
        sound = self.path.read_bytes()
        damaged = pathlib.Path(self.scratch.name, "damaged.h5")
        for bit in range(0, 8 * len(sound) - 8 * 25, len(sound) // 5):
            content = bytearray(sound)
            content[bit // 8] ^= 1 << bit % 8
            damaged.write_bytes(content)
            with self.assertRaisesRegex(rg.ResultsError, "checksum"):
                rg.open(damaged)

    def test_answers_of_a_scene_are_those_of_the_export_with_names(self):
        source = pathlib.Path(os.environ["RAYGAUGE_SOURCE"], "experiments/scenes/two_vehicles.toml")
        path = pathlib.Path(self.scratch.name, "two_vehicles.h5")
        subprocess.run([os.environ["RAYGAUGE_PROGRAM"], "scene", "run", source, "-q", "-o", path], check=True)
        answers = rg.open(path)
        rows = exported(path, self.scratch.name)
        self.assertEqual(set(rows[0]), set(answers.variables))
        np.testing.assert_array_equal(answers["lower"].values, [float(row["lower"]) for row in rows])
        self.assertEqual(set(answers["query"].values), {"room", "walls", "crash"})
        self.assertEqual(set(answers["body_a"].values) | set(answers["body_b"].values), {"ego", "other", "wall"})
        self.assertIn("metric_body", answers.attrs["scene"])
        self.assertEqual(str(answers.to_dataframe().dtypes["status"]), "category")
        self.assertEqual(answers["time"].attrs["units"], "s")

    def test_dicts_become_toml_that_reads_back(self):
        import tomllib

        plain = {**EXPERIMENT, "sweep": {**EXPERIMENT["sweep"], "n": [2, 3]}}
        self.assertEqual(tomllib.loads(toml_text(plain)), plain)


if __name__ == "__main__":
    unittest.main()
