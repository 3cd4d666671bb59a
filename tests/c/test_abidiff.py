# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""usage: test_abidiff.py SOURCE C_COMPILER [--write]. abidiff of abigail-tools compares the interface of raygauge_c, as the header declares
it, with the kept bindings/c/raygauge_c.abi: nothing that programs rely on may change. It reads a library of empty functions, compiled
from the header: the C++ types behind the handles are no part of the interface. test_abi.py looks at the symbols of the real library."""
import pathlib
import re
import subprocess
import sys
import tempfile

source, compiler = pathlib.Path(sys.argv[1]), sys.argv[2]
kept = source / "bindings/c/raygauge_c.abi"
header = (source / "include/raygauge/raygauge_c.h").read_text(encoding="utf-8")


def library_of(text, folder, name):
    """A shared library of empty functions of this header, with debug information."""
    bare = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    declared = re.findall(r"^RG_API ([^;]*);", bare, flags=re.M)
    bodies = [line + ("{}" if line.startswith("void") else "{ return 0; }") for line in declared]
    (folder / "raygauge_c.h").write_text(text, encoding="utf-8")
    (folder / f"{name}.c").write_text('#include "raygauge_c.h"\n' + "\n".join(bodies), encoding="utf-8")
    library = folder / f"lib{name}.so"
    subprocess.run([compiler, "-g", "-fPIC", "-shared", "-w", f"{name}.c", "-o", library.name], check=True, cwd=folder)
    return library


def incompatible(library):
    """What abidiff says if programs that rely on the kept interface would break; "" if not."""
    finished = subprocess.run(["abidiff", "--no-added-syms", kept, library], capture_output=True, text=True)
    return finished.stdout + finished.stderr if finished.returncode else ""


with tempfile.TemporaryDirectory() as scratch:
    folder = pathlib.Path(scratch)
    library = library_of(header, folder, "raygauge_c")
    if sys.argv[3:] == ["--write"]:
        subprocess.run(["abidw", "--no-corpus-path", "--no-comp-dir-path", "--no-show-locs", "--out-file", kept, library], check=True)
    wrong = incompatible(library)
    without_a_function = re.sub(r"RG_API void rg_warm_free[^;]*;", "", header)
    shorter = header.replace("  double lower;\n  double upper;\n  int32_t status;", "  double lower;\n  int32_t status;", 1)
    for name, changed in (("gone", without_a_function), ("shorter", shorter)):
        if changed == header or not incompatible(library_of(changed, folder, name)):
            wrong += f"abidiff does not see the change '{name}'\n"
print(wrong or "the interface is compatible with the kept one")
sys.exit(1 if wrong else 0)
