# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""usage: test_pkg_config.py PREFIX SOURCE C_COMPILER CXX_COMPILER FLAGS. What is installed is found by pkg-config: the examples of
C and C++ are compiled by the line that the C example gives, and run; the prefix may stand anywhere."""
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile

prefix, source, c_compiler, cxx_compiler, flags = sys.argv[1:]


def output_of(*command, **options):
    finished = subprocess.run(list(map(str, command)), capture_output=True, text=True, **options)
    if finished.returncode != 0:
        sys.exit(f"{command}: {finished.stdout}{finished.stderr}")
    return finished.stdout


def run_example(folder, compiler, file, package, expected):
    """Compiles the file with what pkg-config says of the package in this folder, and runs it."""
    description = next(folder.rglob(f"{package}.pc"))
    environment = {**os.environ, "PKG_CONFIG_PATH": str(description.parent), "LD_LIBRARY_PATH": str(description.parent.parent)}
    words = shlex.split(output_of("pkg-config", "--cflags", "--libs", package, env=environment))
    program = folder / file.stem
    output_of(*compiler, file, *words, "-o", program)
    answer = output_of(program, env=environment)
    if expected not in answer:
        sys.exit(f"{file} with {words}: {answer}")


def check_language(compiler, language, standard, expected, header="raygauge"):
    """One line that includes the library's header, in that language; `expected` is what the compiler says, once."""
    command = [*compiler, f"-std={standard}", f"-I{prefix}/include", "-isystem", "/usr/include/eigen3", "-fsyntax-only", "-x", language, "-"]
    said = subprocess.run(command, input=f"#include <raygauge/{header}.h>\n", capture_output=True, text=True).stderr
    errors = [line for line in said.splitlines() if "error:" in line]
    if [expected in line for line in errors] != ([True] if expected else []):
        sys.exit(f"{header}, {standard}: {said}")


check_language([c_compiler], "c", "c99", "")
check_language([cxx_compiler], "c++", "c++20", "")
for name in ("raygauge", "sweep", "results", "simulation", "ompl"):
    check_language([cxx_compiler], "c++", "c++17", "raygauge needs C++20", name)

with tempfile.TemporaryDirectory() as scratch:
    moved = pathlib.Path(scratch, "moved")
    shutil.copytree(prefix, moved, symlinks=True)
    root = pathlib.Path(source)
    run_example(moved, [c_compiler, "-std=c99", *shlex.split(flags)], root / "docs/examples/first_distance.c", "raygauge_c",
                "signed distance -0.750000")
    run_example(moved, [cxx_compiler, "-std=c++20", *shlex.split(flags)], root / "tests/package/example/quickstart.cc", "raygauge",
                "distance 2, certified")
