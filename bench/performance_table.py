# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Measures the table of docs/performance.md and prints it as Markdown, with machine and commit.

    performance_table.py [--build build/release] [--page docs/performance.md] [--only grid,high]

With --page the table of that page, between the two comments, is replaced.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SUMMARY = re.compile(r"^(?P<what>.{22,}?) geometric mean (?P<mean>\S+), worst (?P<worst>\S+) \((?P<where>.*?)\)")

# Row and options of raygauge_ratios; for each of its summaries what it is, and the targets of mean and worst cell.
RATIOS = [
    ("grid", [], [
        ("Table III grid, `column_generation` / LP", 0.005, 0.015),
        ("the same, `zheng_yamane` / LP", 0.018, None),
    ]),
    ("high", ["--processor-time", "--quick", "--dimensions", "20,50,100,200", "--instances", "3"], [
        ("n = 20 … 200, N = 3 n, 10 n, `column_generation` / LP", 0.05, 0.15),
        ("the same, `zheng_yamane` / LP", 0.3, 1),
        ("n = 20 … 200, N = n + 2 … 2 n, `column_generation` / LP", 0.2, 0.5),
        ("the same, `zheng_yamane` / LP", None, None),
    ]),
    ("shapes", ["--processor-time", "--instances", "5"], [
        ("boxes to n = 12, cross-polytopes to n = 500, `column_generation` / LP", None, None),
        ("the same, `zheng_yamane` / LP", None, None),
    ]),
    ("euclidean", ["--processor-time", "--instances", "5"], [
        ("Euclidean distances, n = 3 … 200, default method / LIBSVM", 0.1, 0.5),
        ("the same, LIBSVM at its own tolerance of 1e-3", None, None),
    ]),
    ("large", ["--instances", "5"], [
        ("N = 2·10^4 … 10^6, n = 5, 10, 20, `column_generation` / pass", None, 5),
        ("the same, N >= 2·10^5", None, 3.5),
    ]),
]
# Rows with one line of their own: what it is, where its number is, the target.
SINGLE = [
    ("n100", [], "n = 100, N = 10^4, `column_generation` / LP", r"/ LP (\S+)", 0.02),
    ("memory", [], "heap beyond the points, N = 10^6, n = 10, per cent", r"([\d.]+) % of the input", 25),
]


OUTPUTS = {}  # what the runs printed, by row and options


def measured(program, row, options):
    key = (row, *options)
    if key not in OUTPUTS:
        command = [program, "--rows", row, *options]
        print("measuring:", *command[1:], file=sys.stderr, flush=True)
        OUTPUTS[key] = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return OUTPUTS[key]


def marked(number, target):
    """The number, bold where it misses the target."""
    return f"**{number}**" if target is not None and float(number) > target else number


def targets(*numbers):
    return ", ".join("–" if number is None else f"{number:g}" for number in numbers)


def lines_of_the_table(program, only):
    for rows, options, cases in RATIOS:
        if only and not set(rows.split(",")) & only:
            continue
        summaries = [match for line in measured(program, rows, options).splitlines() if (match := SUMMARY.match(line))]
        assert len(summaries) == len(cases), f"{rows}: {len(summaries)} summaries, {len(cases)} expected"
        for (case, mean, worst), found in zip(cases, summaries):
            yield (f"| {case} | {targets(mean, worst)} | {marked(found['mean'], mean)} | "
                   f"{marked(found['worst'], worst)} ({found['where']}) |")
    for row, options, case, pattern, target in SINGLE:
        if only and row not in only:
            continue
        number = re.search(pattern, measured(program, row, options)).group(1)
        yield f"| {case} | {targets(target)} | {marked(number, target)} | |"


def output_of(*command):
    return subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout.strip()


def machine():
    text = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8")
    model = re.search(r"model name\s*: (.*)", text).group(1)
    return f"{model}, {os.cpu_count()} cores, load {os.getloadavg()[1]:.1f}"


def table(program, only):
    lines = list(lines_of_the_table(program, only))
    kernels = next((match.group(1) for output in OUTPUTS.values() if (match := re.search(r"a cell, (\w+)", output))), "")
    commit = output_of("git", "rev-parse", "--short=12", "HEAD")
    head = f"Commit {commit}, {output_of('date', '+%Y-%m-%d')}; {machine()}, {kernels}.\n\n"
    return head + "| case | target: mean, worst | mean | worst cell |\n| --- | --- | --- | --- |\n" + "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    parser.add_argument("--page", type=pathlib.Path)
    parser.add_argument("--only", default="", help="rows of raygauge_ratios, separated by commas")
    arguments = parser.parse_args()
    text = table(str(arguments.build / "bench" / "raygauge_ratios"), set(filter(None, arguments.only.split(","))))
    print(text, end="")
    if arguments.page:
        page = arguments.page.read_text(encoding="utf-8")
        begin, end = "<!-- table -->\n", "<!-- end of the table -->\n"
        before, _, rest = page.partition(begin)
        _, _, after = rest.partition(end)
        assert after or page.endswith(end), f"{arguments.page} has no place for the table"
        arguments.page.write_text(before + begin + "\n" + text + "\n" + end + after, encoding="utf-8")


if __name__ == "__main__":
    main()
