# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Sweeps, run by the program raygauge; docs/experiments.md describes an experiment."""

from __future__ import annotations

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ._raygauge import Error, InvalidParameterError
from .components import GENERATORS, METHODS, Component
from .files import open as open_results

if TYPE_CHECKING:
    from .results import Results


class ProgramError(Error):
    """The program raygauge is missing or has refused; the message is its own."""


def _text(value: Any, place: str) -> str:
    """A value in TOML."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, (str, os.PathLike)):
        escaped = os.fspath(value).replace("\\", "\\\\").replace('"', '\\"')
        return '"' + "".join(c if c.isprintable() else f"\\u{ord(c):04X}" for c in escaped) + '"'
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{_text(str(k), place)} = {_text(v, place)}" for k, v in value.items()) + "}"
    if hasattr(value, "tolist"):  # NumPy's numbers and arrays
        return _text(value.tolist(), place)
    if isinstance(value, Sequence):
        return "[" + ", ".join(_text(item, place) for item in value) + "]"
    raise InvalidParameterError(f"experiment: {place} cannot be a {type(value).__name__}")


def _lines(table: Mapping[str, Any], place: str) -> list[str]:
    return [f"{_text(str(key), place)} = {_text(value, f'{place}{key}')}" for key, value in table.items()]


def toml_text(experiment: Mapping[str, Any]) -> str:
    """The experiment as the text of a TOML file: tables for dicts, arrays of tables for lists of dicts.

    >>> print(toml_text({"name": "mine", "sweep": {"n": [3, 5]}, "method": [{"name": "column_generation"}]}))
    "name" = "mine"
    [sweep]
    "n" = [3, 5]
    [[method]]
    "name" = "column_generation"
    """
    lines = []
    tables = []
    for key, value in experiment.items():
        if isinstance(value, Mapping):
            tables += [f"[{key}]", *_lines(value, f"{key}.")]
        elif isinstance(value, (list, tuple)) and value and all(isinstance(item, Mapping) for item in value):
            for item in value:
                tables += [f"[[{key}]]", *_lines(item, f"{key}.")]
        else:
            lines += _lines({key: value}, "")
    return "\n".join(lines + tables)


def program() -> str:
    """The program raygauge: $RAYGAUGE_PROGRAM, or the first on PATH. Raises ProgramError."""
    found = os.environ.get("RAYGAUGE_PROGRAM") or shutil.which("raygauge")
    if not found:
        raise ProgramError("the program raygauge is not on PATH, nor named by RAYGAUGE_PROGRAM; ./run.sh build makes it")
    return found


def _call(arguments: list[str], progress: bool) -> None:
    errors = None if progress else subprocess.PIPE
    with subprocess.Popen(arguments, stdout=subprocess.DEVNULL, stderr=errors, text=True) as process:
        try:
            _, message = process.communicate()
        except KeyboardInterrupt:  # the terminal has told the program as well; it keeps what is done
            process.wait()
            raise
    if process.returncode != 0:
        text = (message or "").strip() or f"raygauge run ended with exit status {process.returncode}"
        raise ProgramError(text.splitlines()[-1])


def _own_components(source: pathlib.Path) -> tuple[list[Component], list[Component]]:
    """The methods and generators in Python that an experiment names; the program tells what is wrong with its text."""
    try:
        experiment = tomllib.loads(source.read_text(encoding="utf-8"))
        found = []
        for kind, known in (("method", METHODS), ("generator", GENERATORS)):
            names = {str(entry.get("name")) for entry in experiment.get(kind, [])}
            found.append([known[name] for name in sorted(names & known.keys())])
        return found[0], found[1]
    except (OSError, ValueError, AttributeError, TypeError):
        return [], []


def _versions(components: list[Component]) -> list[tuple[str, str]]:
    """What the provenance of a run in this process names besides the solvers."""
    versions = [("Python", sys.version.split()[0]), ("NumPy", np.__version__)]
    for name in ("scipy", "cvxpy"):
        if name in sys.modules:
            versions.append((name, str(getattr(sys.modules[name], "__version__", "unknown"))))
    return versions + [(f"{component.kind} {component.name}", component.place()) for component in components]


def _run_here(
    source: pathlib.Path,
    output: str,
    own: tuple[list[Component], list[Component]],
    threads: int | None,
    progress: bool,
    resume: bool,
    force: bool,
) -> None:
    """Runs the sweep in this process, where its functions are."""
    try:
        from . import _sweeps
    except ImportError:
        raise ProgramError(
            "methods and generators in Python need the package built beside the program: ./run.sh build, then ./run.sh python"
        ) from None
    failures: list[BaseException] = []
    try:
        _sweeps.run(
            source=os.fspath(source), output=output, threads=threads, resume=resume, force=force, progress=progress,
            methods=own[0], generators=own[1], versions=_versions(own[0] + own[1]), failures=failures,
        )  # fmt: skip
    except Error as error:
        raise ProgramError(" ".join(str(error).split())) from (failures[0] if failures else None)


def run(
    experiment: str | os.PathLike[str] | Mapping[str, Any],
    output: str | os.PathLike[str],
    *,
    threads: int | None = None,
    progress: bool = False,
    resume: bool = False,
    force: bool = False,
) -> Results:
    """Runs a sweep and opens its results.

    experiment: a TOML file, or a dict of the same keys. output: the results file, which must not exist unless
    resume=True (finishes an interrupted run) or force=True (replaces it). threads: 0 for one on each core; default:
    the experiment's. progress: shows the program's bar on standard error.

    The program raygauge does the work, as `raygauge run` does: the measurements are the same. An experiment that names
    what raygauge.method or raygauge.generator has registered is run in this process by the same code. Ctrl-C interrupts
    it; what is done is kept for resume=True. Raises ProgramError with the program's own message.

    >>> results = rg.run({"sweep": {"n": [2, 3], "N": [50], "repetitions": 3}, "generator": [{"name": "example2"}],
    ...                   "method": [{"name": "column_generation"}]}, "mine.h5")
    >>> results.sizes["record"]
    6
    """
    with tempfile.TemporaryDirectory() as folder:
        if isinstance(experiment, Mapping):
            source = pathlib.Path(folder, "experiment.toml")
            source.write_text(toml_text(experiment) + "\n", encoding="utf-8")
        else:
            source = pathlib.Path(experiment)
        own = _own_components(source)
        if own[0] or own[1]:
            sys.stdout.flush()
            _run_here(source, os.fspath(output), own, threads, progress, resume, force)
            return open_results(output)
        arguments = [program(), "run", str(source), "-o", os.fspath(output)]
        arguments += [] if progress else ["--quiet"]
        arguments += [] if threads is None else ["--threads", str(threads)]
        arguments += ["--resume"] if resume else []
        arguments += ["--force"] if force else []
        sys.stdout.flush()
        _call(arguments, progress)
    return open_results(output)
