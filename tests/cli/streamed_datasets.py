#!/usr/bin/env python3
# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Datasets of 300 MB, which `raygauge distance` and sweeps read by passes: the planted answer, the same at once for a file in single
precision, little memory, and errors that name the row.

usage: streamed_datasets.py RAYGAUGE MOST_BYTES"""

import csv
import json
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

RAYGAUGE, MOST_BYTES = sys.argv[1], float(sys.argv[2])
ROWS = 12_500_000  # of three numbers


SWEEP = """
name = "streamed"
[sweep]
repetitions = 2
tolerance = 1e-9
[[generator]]
name = "files"
A = "big.h5:/A"
Q = "Q.csv"
stream = true
[[method]]
name = "column_generation"
[[method]]
name = "zheng_yamane"
"""


def ask(*arguments, status=0, command="distance"):
    answer = subprocess.run([RAYGAUGE, command, *map(str, arguments)], capture_output=True, text=True)
    assert answer.returncode == status, (answer.returncode, answer.stderr)
    return answer


def fill(path, kind, planted):
    """Points with x >= 3 but for a planted one; written in pieces."""
    random = np.random.default_rng(7)
    with h5py.File(path, "w") as file:
        data = file.create_dataset("A", (ROWS, 3), dtype=kind)
        for first in range(0, ROWS, ROWS // 10):
            piece = random.uniform(-1, 1, (ROWS // 10, 3))
            piece[:, 0] += 4
            data[first : first + ROWS // 10] = piece
        data[ROWS - 3] = planted


def check(path, Q):
    with_planted = json.loads(ask(path, Q, "--tolerance", "1e-9", "--json").stdout)
    assert with_planted["status"] == "optimal", with_planted
    # Of a cube of half edge 2 the distance is the least max|x_k| / 2.
    assert with_planted["lower"] <= 1.25 <= with_planted["upper"], with_planted
    assert with_planted["upper"] - with_planted["lower"] <= 1e-9, with_planted


def check_sweep(folder):
    experiment, results = folder / "streamed.toml", folder / "streamed.h5"
    experiment.write_text(SWEEP)
    ask(experiment, "--output", results, command="run")
    records = list(csv.DictReader(ask(results, "--csv", "-", command="export").stdout.splitlines()))
    assert len(records) == 4, records
    for record in records:
        assert record["status"] == "optimal" and record["agrees"] == "true" and record["N"] == str(ROWS), record
        assert float(record["lower"]) <= 1.25 <= float(record["upper"]), record
    experiment.write_text(SWEEP.replace("stream = true", "stream = true\nscale_A = 2"))
    error = ask(experiment, "--output", results, "--force", command="run", status=2).stderr
    assert error == f"raygauge: {experiment}:8: 'big.h5:/A' is streamed and stays where it is: no scale, centre or pose\n", error


def main(folder):
    cube = folder / "Q.csv"
    np.savetxt(cube, 2 * np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]), delimiter=",")
    for kind in ("f8", "f4"):
        path = folder / "big.h5"
        fill(path, kind, (2.5, 0.5, 0.25))
        check(f"{path}:/A", cube)
    check_sweep(folder)
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024
    assert peak < MOST_BYTES, peak
    with h5py.File(path, "r+") as file:
        file["A"][ROWS - 2, 1] = np.nan
    error = ask(f"{path}:/A", cube, status=2).stderr
    assert error == f"raygauge: {path}:/A: NaN at row {ROWS - 2}, column 1\n", error
    flat = folder / "flat.csv"
    flat.write_text("1,0\n-1,1\n0,-1\n")
    assert "n = 3" in ask(f"{path}:/A", flat, status=2).stderr


with tempfile.TemporaryDirectory() as made:
    main(Path(made))
