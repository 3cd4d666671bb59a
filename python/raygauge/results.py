# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""The dataset that raygauge.open makes of a results file; docs/file-format.md describes the file."""

from __future__ import annotations

import os
import zlib
from typing import Any

import h5py
import numpy as np
import pandas as pd
import xarray as xr

from .files import ResultsError


class Results(xr.Dataset):  # type: ignore[no-untyped-call]
    """An xarray.Dataset whose data frames hold texts as categories."""

    __slots__ = ()

    def to_dataframe(self, dim_order: Any = None) -> pd.DataFrame:
        """A pandas.DataFrame with a row for each record; columns of texts are categorical."""
        frame: pd.DataFrame = super().to_dataframe(dim_order)
        texts = [name for name, column in frame.items() if column.dtype == object]
        return frame.astype({name: "category" for name in texts})


# The schema versions whose files are read: from those of release 0.2 on (docs/file-format.md).
_FIRST_VERSIONS = {"raygauge-results": 3, "raygauge-scene": 2}
_LAST_VERSIONS = {"raygauge-results": 3, "raygauge-scene": 2}


def _values(dataset: h5py.Dataset) -> np.ndarray[Any, Any]:
    if h5py.check_string_dtype(dataset.dtype) is None:
        return np.asarray(dataset[...])
    # Fixed-length texts repeat: each distinct one is decoded once.
    texts, numbers = np.unique(dataset[...], return_inverse=True)
    decoded = np.array([text.decode() for text in texts], dtype=object)
    return decoded[numbers] if len(texts) else np.empty(0, dtype=object)


def _variable(dataset: h5py.Dataset) -> Any:
    attributes = {"units": str(dataset.attrs["unit"]), "description": str(dataset.attrs["description"])}
    make: Any = xr.Variable
    return make(("record",), _values(dataset), attributes)


def _check_version(file: h5py.File, path: str, kind: str) -> None:
    """Raises ResultsError where the program does not read this schema version, in the program's words."""
    version, first, last = int(file.attrs["schema_version"]), _FIRST_VERSIONS[kind], _LAST_VERSIONS[kind]
    found = f"{path}: {'a scene: ' if kind == 'raygauge-scene' else ''}schema version {version}"
    if version < first:
        raise ResultsError(f"{found}, from before the first release (0.2), is not read: measure anew")
    if version > last:
        known = f"version {last}" if first == last else f"versions {first} to {last}"
        raise ResultsError(f"{found}, this raygauge reads {known}")


def _scene(file: h5py.File) -> Results:
    """The answers of a scene, with the names of bodies and queries instead of their numbers."""
    make: Any = xr.Variable
    variables = {name: _variable(column) for name, column in file["records"].items()}
    for column, table in (("query", "queries"), ("body_a", "bodies"), ("body_b", "bodies")):
        names = _values(file[table]["name"])[variables[column].values]
        description = str(file[table]["name"].attrs["description"])
        variables[column] = make(("record",), names, {"units": "", "description": description})
    attributes = {
        "name": file["name"].asstr()[()],
        "scene": file["scene"].asstr()[()],
        "raygauge_version": str(file.attrs["raygauge_version"]),
        "schema_version": int(file.attrs["schema_version"]),
    }
    return Results(variables, attrs=attributes)


_MARK = b"raygauge CRC-32 "
_LINE = len(_MARK) + 9


def _check(name: str) -> None:
    """Raises ResultsError where the checksum at the end of the file (docs/file-format.md) is not that of the file."""
    with open(name, "rb") as file:
        size = file.seek(0, os.SEEK_END) - _LINE
        file.seek(max(size, 0))
        line = file.read()
        file.seek(0)
        checksum, left = 0, size
        while line.startswith(_MARK) and left > 0 and (block := file.read(min(left, 1 << 20))):
            checksum, left = zlib.crc32(block, checksum), left - len(block)
    if line.startswith(_MARK) and line != _MARK + b"%08x\n" % checksum:
        raise ResultsError(f"{name}: truncated or damaged: its checksum is wrong")


def _dataset(file: h5py.File, path: str) -> Results:
    kind = str(file.attrs.get("format"))
    if kind not in _FIRST_VERSIONS:
        raise ResultsError(f"{path}: no results file of raygauge")
    _check_version(file, path, kind)
    if kind == "raygauge-scene":
        return _scene(file)
    variables = {name: _variable(column) for name, column in file["records"].items()}
    attributes = {
        "experiment": file["provenance/experiment"].asstr()[()],
        "raygauge_version": str(file.attrs["raygauge_version"]),
        "schema_version": int(file.attrs["schema_version"]),
    }
    return Results(variables, attrs=attributes)


def read(path: str | os.PathLike[str]) -> Results:
    """See raygauge.open."""
    name = os.fspath(path)
    try:
        _check(name)
        with h5py.File(name, "r") as file:
            return _dataset(file, name)
    except (OSError, KeyError) as error:
        raise ResultsError(f"{name}: {error}") from error
