#!/usr/bin/env python3
# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Every kind of table as LaTeX, compiled by pdflatex without a package: none is wider or longer than a page.

With --tikz also the figures as TikZ (needs TeX's pgf).
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

RUNS = {  # results file: experiment, overrides
    "example1.h5": ("example1_smoke.toml", []),
    "example2.h5": ("smoke.toml", []),
    "hard.h5": ("hard_smoke.toml", []),
    "again.h5": ("smoke.toml", []),
    "wide.h5": ("smoke.toml", ["--set", "sweep.N=20,40,60,80,100,120,140,160,180,200", "--set", "sweep.n=3,4,5,6,7,8,9,10",
                               "--set", "sweep.repetitions=1"]),
}
TABLES = {  # name: arguments, exit statuses
    "table1": (["table", "example1.h5", "--paper", "table1"], [0]),
    "table2": (["table", "example1.h5", "--paper", "table2"], [0]),
    "table3": (["table", "example2.h5", "--paper", "table3"], [0]),
    "wide table3": (["table", "wide.h5", "--paper", "table3"], [0]),
    "long": (["table", "wide.h5", "--rows", "n,N,method", "--value", "median ms"], [0]),
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


OVERFULL = re.compile(r"^Overfull \\hbox \(([\d.]+)pt too wide.*|^LaTeX Warning: Float too large.*", re.MULTILINE)
MOST = 3  # points, which no reader sees


def too_large(log):
    """What pdflatex says does not fit a page."""
    return [line.group(0) for line in OVERFULL.finditer(log) if line.group(1) is None or float(line.group(1)) > MOST]


def compiled(folder, name, packages, body):
    document = f"\\documentclass{{article}}\n{packages}\\begin{{document}}\n{body}\\end{{document}}\n"
    (folder / f"{name}.tex").write_text(document)
    run(["pdflatex", "-interaction=nonstopmode", "-halt-on-error", f"{name}.tex"], folder)
    found = too_large((folder / f"{name}.log").read_text(errors="replace"))
    if found:
        sys.exit(f"{name}.tex does not fit its pages:\n" + "\n".join(found))
    return (folder / f"{name}.pdf").stat().st_size


def make_figures(raygauge, folder):
    """A figure of each kind of text: several panels, powers of ten, Greek letters."""
    body = ""
    for results, figure in (("wide.h5", "time_vs_N"), ("wide.h5", "performance_profile"), ("example1.h5", "work_precision")):
        run([raygauge, "plot", results, "--figure", figure, "--size", "single", "-o", f"{figure}.tikz"], folder)
        body += f"\\noindent\\input{{{figure}.tikz}}\n\\clearpage\n"
    return body


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--raygauge", required=True, type=pathlib.Path)
    parser.add_argument("--experiments", required=True, type=pathlib.Path)
    parser.add_argument("--tikz", action="store_true")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="raygauge-latex-") as name:
        folder = pathlib.Path(name)
        tables = make_tables(arguments.raygauge, arguments.experiments, folder)
        size = compiled(folder, "tables", "", tables)
        if arguments.tikz:
            figures = make_figures(arguments.raygauge, folder)
            compiled(folder, "figures", "\\usepackage{tikz}\n\\usepackage{gnuplot-lua-tikz}\n", figures)
    count = tables.count("\\begin{table}")
    print(f"{count} tables, {size} bytes of PDF")
    return 0 if count > len(TABLES) and size > 20_000 else 1


if __name__ == "__main__":
    sys.exit(main())
