# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""usage: test_abi.py LIBRARY SOURCE. The interface that programs rely on is kept: bindings/c/abi.txt lists every function with
its types, every constant with its number and every structure with its members, as the header declares them, and the version
of each symbol. The library exports these functions and nothing else. `--write` as a third argument writes the list."""
import pathlib
import re
import subprocess
import sys


def declared(header):
    """The lines of the list that a header declares: one a function, constant, structure and type of function."""
    text = re.sub(r"/\*.*?\*/", "", header, flags=re.S)
    text = re.sub(r"(?m)^#.*$", "", text)
    for statement in re.findall(r"[^;{}]*(?:\{[^{}]*\}[^;]*)?;", text):
        line = " ".join(statement.split()).removesuffix(";").replace('extern "C" { ', "")
        if line.startswith("enum"):
            yield from (f"constant {constant.strip()}" for constant in re.search(r"\{(.*)\}", line).group(1).split(","))
        elif line.startswith("RG_API"):
            yield line.removeprefix("RG_API ")
        elif line.startswith("typedef"):
            yield line


def functions(lines):
    return {re.search(r"\b(rg_\w+)\(", line).group(1) for line in lines if re.match(r"(?!typedef|constant).*\brg_\w+\(", line)}


def exported(library):
    """NAME@@VERSION of each symbol that others can link."""
    listed = subprocess.run(["nm", "-D", "--defined-only", library], check=True, capture_output=True, text=True).stdout
    symbols = {line.split()[-1] for line in listed.splitlines()}
    return {symbol for symbol in symbols if "@@" in symbol}, {symbol for symbol in symbols if "@@" not in symbol}


def main():
    library, source = sys.argv[1], pathlib.Path(sys.argv[2])
    lines = list(declared((source / "include/raygauge/raygauge_c.h").read_text(encoding="utf-8")))
    symbols, others = exported(library)
    current = sorted(lines) + sorted(f"symbol {symbol}" for symbol in symbols)
    page = source / "bindings/c/abi.txt"
    if sys.argv[3:] == ["--write"]:
        page.write_text("\n".join(current) + "\n", encoding="utf-8")
    kept = page.read_text(encoding="utf-8").splitlines()
    wrong = [f"gone or changed: {line}" for line in kept if line not in current]
    wrong += [f"not in the list yet (--write): {line}" for line in current if line not in kept]
    versions = set(re.findall(r"^(RAYGAUGE_C_\d+) ", (source / "bindings/c/visible.map").read_text(encoding="utf-8"), re.M))  # symbols, too
    wrong += [f"exported without a version: {symbol}" for symbol in others - versions]
    wrong += [f"declared, not exported: {name}" for name in functions(lines) - {symbol.split("@@")[0] for symbol in symbols}]
    print("\n".join(wrong) or f"{len(current)} lines of the interface are kept, {len(functions(lines))} functions")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
