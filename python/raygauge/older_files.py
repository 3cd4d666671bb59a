# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""What results files of the schema versions 1 and 2 do not say, as in "Versions" of docs/file-format.md.

The program has the same rules in results/schema/older_files.cc; a test compares the two.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

_METHODS = ("direct", "newton", "zheng_yamane", "glpk_primal", "glpk_dual", "clp_dual", "clp_primal",
            "nlopt_slsqp", "nlopt_mma", "exact", "command", "fcl_libccd", "fcl_indep")
_ROLES = (("exact", "oracle"), ("glpk", "baseline"), ("clp", "baseline"), ("nlopt", "baseline"), ("fcl", "baseline"),
          ("command", "baseline"))
_HARDNESS: tuple[tuple[str, str, Callable[[float], float]], ...] = (
    ("aspect", "aspect", lambda value: value),
    ("delta", "1/δ", lambda value: 1 / value),
    ("entry", "entry", lambda value: value),
    ("exponent", "scale", lambda value: float(2**value)),
    ("offset", "offset", lambda value: value),
)
_NOT_KNOWN = float("nan")

# Unit and description of each column, as files of today have them.
COLUMNS = {
    "method_name": ("", "registered name of the method"),
    "role": ("", "whose the method is: engine, baseline or oracle"),
    "exact_distance_rounding": ("1", "relative rounding error of exact_distance; 0 where exact_distance is exact for the"
                                     " stored coordinates"),
    "hardness_label": ("", "what hardness is, as in 1/δ; empty where the generator has no such parameter"),
    "hardness": ("1", "how hard the generator's parameters make the instance; nan where it has no such parameter"),
    "host": ("", "name of the machine that ran the cell"),
    "rank": ("1", "MPI rank that ran the cell; 0 without MPI"),
}


def current_method_name(name: str) -> str:
    """`column_generation` was `direct`."""
    return "column_generation" if name == "direct" else name


_VALUE = re.compile(r'(?<==)"(?:\\.|[^"\\])*"?|(?<=[=\[,])[^ ,\[\]{}="\n]+')
_NUMBER = re.compile(r"(-?)(\d+)(?:\.(\d+))?(?:e([+-]\d+))?")


def _current_number(token: str) -> str:
    """A real number as std::to_chars wrote it becomes one of today; integers and anything else stay."""
    number = _NUMBER.fullmatch(token)
    if not number or not set(".e") & set(token):
        return token
    sign, whole, fraction, exponent = number[1], number[2], number[3] or "", number[4]
    if exponent is not None:
        power = int(exponent)
        return f"{sign}{whole}{'0' * power}" if 0 <= power < 6 else f"{token.split('e')[0]}e{power}"
    digits = fraction.lstrip("0")
    if int(whole) or not digits or float(token) >= 0.01 or float(token) <= -0.01:
        return token
    power = len(digits) - len(fraction) - 1
    return f"{sign}{digits[0]}{'.' + digits[1:] if digits[1:] else ''}e{power}"


def with_current_numbers(text: str) -> str:
    """Parameters as name=value with numbers as today: earlier versions wrote 1e-08, 0.001 and 1e+05."""
    return _VALUE.sub(lambda value: _current_number(value[0]), text)


def _entries(identity: str) -> list[str]:
    """The entries of the line "methods = [a, b as c {x=1, y=2}]"."""
    line = re.search(r"^methods = \[(.*)\]$", identity, re.MULTILINE)
    return re.split(r", (?![^{]*\})", line[1]) if line and line[1] else []


def _names_by_label(identity: str) -> dict[str, str]:
    names: dict[str, str] = {}
    for entry in _entries(identity):
        name, _, label = entry.split(" {")[0].partition(" as ")
        names.setdefault(label or current_method_name(name), current_method_name(name))
    return names


def _name_of(label: str, names: Mapping[str, str]) -> str:
    if label in names:
        return names[label]
    return current_method_name(max((name for name in _METHODS if label.startswith(name)), key=len, default=label))


def _role_of(name: str) -> str:
    return next((role for prefix, role in _ROLES if name.startswith(prefix)), "engine")


def _hardness_of(parameters: str) -> tuple[str, float]:
    values = dict(entry.split("=", 1) for entry in parameters.split(" ") if "=" in entry)
    for parameter, label, of in _HARDNESS:
        if parameter in values:
            return label, of(float(values[parameter]))
    return "", _NOT_KNOWN


def hosts(sessions: Any, hostnames: Any) -> dict[str, Any]:
    """`host` and `rank` of records, which a file of the versions 1 and 2 lacks, of their sessions."""
    return {
        "host": np.asarray(hostnames, dtype=object)[np.asarray(sessions)],
        "rank": np.zeros(len(sessions), dtype=np.int32),
    }


def completed(columns: Mapping[str, Any], identity: str) -> dict[str, Any]:
    """The columns that a file of version 1 lacks, and `method` with today's names, of the columns that it has."""
    names = _names_by_label(identity)
    labels = [label if label in names else current_method_name(label) for label in columns["method"]]
    method_names = [_name_of(label, names) for label in labels]
    hardness = {text: _hardness_of(text) for text in set(columns["generator_parameters"])}
    pairs = [hardness[text] for text in columns["generator_parameters"]]
    return {
        "method": np.array(labels, dtype=object),
        "method_name": np.array(method_names, dtype=object),
        "role": np.array([_role_of(name) for name in method_names], dtype=object),
        "exact_distance_rounding": np.where(np.asarray(columns["generator"]) == "example1", 2.0**-45, 0.0),
        "hardness_label": np.array([label for label, _ in pairs], dtype=object),
        "hardness": np.array([value for _, value in pairs], dtype=float),
    }
