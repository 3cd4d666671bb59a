#!/usr/bin/env python3
# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Every kind of table as LaTeX, compiled by pdflatex without a package."""
import argparse
import pathlib
import subprocess
import sys
import tempfile

RUNS = {  # results file: experiment, overrides
    "example1.h5": ("example1_smoke.toml", []),
    "example2.h5": ("smoke.toml", []),
    "hard.h5": ("hard_smoke.toml", []),
    "again.h5": ("smoke.toml", []),
}
TABLES = {  # name: arguments, exit statuses
    "table1": (["table", "example1.h5", "--paper", "table1"], [0]),
    "table2": (["table", "example1.h5", "--paper", "table2"], [0]),
    "table3": (["table", "example2.h5", "--paper", "table3"], [0]),
    "accuracy": (["table", "example1.h5", "--accuracy"], [0]),
    "stability": (["table", "hard.h5", "--stability"], [0]),
    "pivot": (["table", "example2.h5", "--rows", "method,n", "--cols", "N", "--value", "median ms", "--intervals"],
              [0]),
    "statuses": (["table", "hard.h5", "--rows", "generator,generator_parameters", "--cols", "status", "--value",
                  "count"], [0]),
    "compare": (["compare", "example2.h5", "again.h5", "--all", "--threshold", "0"], [0, 1]),
}


def run(command, folder, statuses=(0,)):
    outcome = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if outcome.returncode not in statuses:
        sys.exit(f"exit status {outcome.returncode}: {' '.join(map(str, command))}\n"
                 f"{outcome.stdout[-3000:]}\n{outcome.stderr[-1000:]}")
    return outcome.stdout


def make_tables(raygauge, experiments, folder):
    """One text with every table. What `compare` says below its tables is no LaTeX: its verdict is left out."""
    for results, (experiment, overrides) in RUNS.items():
        run([raygauge, "run", experiments / experiment, *overrides, "--quiet", "-o", results], folder)
    text = ""
    for arguments, statuses in TABLES.values():
        printed = run([raygauge, *arguments, "--format", "latex"], folder, statuses)
        text += printed[: printed.rindex("\\end{table}")] + "\\end{table}\n\\clearpage\n"
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--raygauge", required=True, type=pathlib.Path)
    parser.add_argument("--experiments", required=True, type=pathlib.Path)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="raygauge-latex-") as name:
        folder = pathlib.Path(name)
        tables = make_tables(arguments.raygauge, arguments.experiments, folder)
        document = "\\documentclass{article}\n\\begin{document}\n" + tables + "\\end{document}\n"
        (folder / "tables.tex").write_text(document)
        run(["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "tables.tex"], folder)
        size = (folder / "tables.pdf").stat().st_size
    count = tables.count("\\begin{table}")
    print(f"{count} tables, {size} bytes of PDF")
    return 0 if count > len(TABLES) and size > 20_000 else 1


if __name__ == "__main__":
    sys.exit(main())
