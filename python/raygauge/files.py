# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Results files as xarray datasets."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from ._raygauge import Error
from .extras import extra

if TYPE_CHECKING:
    from .results import Results


class ResultsError(Error):
    """A file that is missing, is no HDF5 or holds no results of raygauge."""


def open(path: str | os.PathLike[str]) -> Results:
    """The records of a results file, as an xarray.Dataset with one row a solve along `record`.

    Every variable has its `units` and `description`; texts are real strings. `attrs` holds the experiment's TOML
    text, the program's version and the schema version. `to_dataframe()` gives texts as categories. A run that has not
    been finished is opened after `raygauge run --resume`. Of a scene's results the rows are its answers, with the names
    of bodies and queries; `attrs["scene"]` is the scene file.

    Needs python3-h5py and python3-xarray. Raises ResultsError.

    >>> results = rg.open("example2.h5")
    >>> results.seconds.attrs["units"]
    's'
    >>> sorted(set(results.method.values))[:2]
    ['clp_dual', 'clp_primal']
    >>> results.to_dataframe().groupby("method", observed=True).seconds.median().idxmin()
    'column_generation'
    """
    with extra("results"):
        from .results import read

    return read(path)
