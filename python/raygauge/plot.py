# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Figures of results on matplotlib axes, in the colours and dashes of the program's own figures.

Each takes the dataset of raygauge.open and draws on `axes` (default: matplotlib's current ones), which it returns.
Needs python3-matplotlib and python3-pandas.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._raygauge import InvalidParameterError
from .extras import extra

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.axes import Axes

    from .results import Results

# Colour, marker and dash of each method, as in analysis/render/method_look.cc.
_LOOKS = {
    "column_generation": ("#D55E00", "o", "-"),
    "zheng_yamane": ("#0072B2", "s", "-"),
    "newton": ("#009E73", "^", "-"),
    "glpk_primal": ("#000000", "o", "--"),
    "glpk_dual": ("#8C8C8C", "s", ":"),
    "clp_primal": ("#56B4E9", "^", "--"),
    "clp_dual": ("#E69F00", "D", ":"),
    "exact": ("#CC79A7", "v", "-."),
    "nlopt_slsqp": ("#6A3D9A", "D", "--"),
    "paper": ("#8C8C8C", "o", "-"),
}
_OTHER_COLORS = ("#B15928", "#1B7837", "#B2182B", "#C51B7D", "#35978F", "#4D4D4D")
_SOLVED = ("optimal", "contains_origin", "unreachable")
_AXIS_LABELS = {"N": "points in each set, N", "n": "dimension n", "tolerance": "tolerance"}


def _letters_of(text: str) -> int:
    """FNV-1a, as in method_look.cc."""
    value = 2166136261
    for byte in text.encode():
        value = ((value ^ byte) * 16777619) & 0xFFFFFFFF
    return value


def _look(method: str, filled: bool) -> dict[str, Any]:
    """How the curve of a method looks; one that the program does not know has a look drawn from its letters.

    The markers of raygauge's own methods are filled.
    """
    known = _LOOKS.get(method)
    if known is None:
        letters = _letters_of(method)
        known = (_OTHER_COLORS[letters % 6], "os^Dv"[letters // 7 % 5], ("--", ":", "-.")[letters // 37 % 3])
    look = {"color": known[0], "marker": known[1], "linestyle": known[2]}
    return look if filled else {**look, "markerfacecolor": "none"}


def _looks(results: Results) -> dict[str, dict[str, Any]]:
    roles = dict(zip(results.method.values, results.role.values, strict=True))
    return {method: _look(method, roles[method] == "engine") for method in sorted(roles)}


def _current(axes: Axes | None) -> Axes:
    if axes is not None:
        return axes
    with extra("plot"):
        import matplotlib.pyplot as plt

    return plt.gca()


def _median_interval(values: np.ndarray[Any, Any]) -> tuple[float, float, float]:
    """The median and its 95 % order-statistic interval; with fewer than 6 values the interval is their range."""
    ordered = np.sort(values)
    count = len(ordered)
    half = 0.98 * np.sqrt(count)
    low = max(0, int(np.floor(count / 2 - half)))
    high = min(count - 1, int(np.ceil(count / 2 + half)))
    return float(np.median(ordered)), float(ordered[low]), float(ordered[high])


# What makes two records of a method different measurements, besides the axis of a figure.
_CIRCUMSTANCES = ("n", "N", "tolerance", "generator", "generator_parameters")


def _varying(results: Results, by: str) -> list[str]:
    """The circumstances of which there are several, but for the axis."""
    return [name for name in _CIRCUMSTANCES if name != by and len(np.unique(results[name].values.astype(str))) > 1]


def _of_one_kind(results: Results, by: str, curves: tuple[str, ...]) -> None:
    for name in _varying(results, by):
        if name in curves:
            continue
        values = sorted(set(results[name].values.tolist()))
        shown = ", ".join(str(value) for value in values[:4]) + (", …" if len(values) > 4 else "")
        raise InvalidParameterError(
            f"the results have several values of {name} ({shown}), which one curve would mix: choose one, as in "
            f"results.isel(record=results.{name}.values == {values[0]!r})"
        )


def medians(results: Results, by: str = "N") -> pd.DataFrame:
    """The median seconds of a solve with their 95 % interval, by method, `by` ("N", "n" or "tolerance") and what else varies.

    What counts is as in `raygauge table`: an unsolved record counts as infinitely slow; where methods disagree on an
    instance, the record is left out. Columns: method, those of n, N, tolerance, generator and generator_parameters that have
    several values, `by`, median, low, high.
    """
    with extra("plot"):
        import pandas as pd

    keys = ["method", *_varying(results, by), by]
    frame = results[[*keys, "seconds", "status", "agrees"]].to_dataframe()
    frame = frame[frame["agrees"].astype(bool)]
    solved = frame["status"].isin(_SOLVED)
    frame["seconds"] = frame["seconds"].where(solved, np.inf)
    rows = []
    for values, group in frame.groupby(keys, observed=True, sort=True):
        rows.append((str(values[0]), *values[1:], *_median_interval(group["seconds"].to_numpy())))
    return pd.DataFrame(rows, columns=[*keys, "median", "low", "high"])


def time(results: Results, by: str = "N", axes: Axes | None = None) -> Axes:
    """Median seconds of a solve against N, n or the tolerance, with 95 % intervals.

    A curve for each method and, where there are several, each n (each N against n), paler for smaller ones. Raises
    InvalidParameterError where a curve would mix generators, their parameters, or tolerances: choose some of the records first.
    """
    here = _current(axes)
    size = "N" if by == "n" else "n"
    _of_one_kind(results, by, (size,))
    table = medians(results, by)
    sizes = sorted(table[size].unique()) if size in table else [None]
    for method, look in _looks(results).items():
        for rank, value in enumerate(sizes):
            rows = table[(table["method"] == method) & np.isfinite(table["median"])]
            curve = rows if value is None else rows[rows[size] == value]
            if curve.empty:
                continue
            high = curve["high"].where(np.isfinite(curve["high"]), curve["median"])
            bars = [curve["median"] - curve["low"], high - curve["median"]]
            label = method if value is None else f"{method}, {size} = {value}"
            paleness = 0.35 + 0.65 * (rank + 1) / len(sizes)
            here.errorbar(
                curve[by], curve["median"], yerr=bars, label=label, alpha=paleness, linewidth=1, markersize=4, capsize=2, **look
            )
    here.set_xscale("log")
    here.set_yscale("log")
    here.set_xlabel(_AXIS_LABELS.get(by, by))
    here.set_ylabel("median seconds of a solve")
    here.legend()
    return here


def performance_profile(results: Results, axes: Axes | None = None) -> Axes:
    """The share of instances that each method solves within a factor of the fastest one (Dolan and Moré)."""
    here = _current(axes)
    frame = results[["method", "cell", "repetition", "seconds", "status", "agrees"]].to_dataframe()
    solved = frame["status"].isin(_SOLVED) & frame["agrees"].astype(bool)
    frame["seconds"] = frame["seconds"].where(solved, np.inf)
    frame["method"] = frame["method"].astype(str)
    table = frame.pivot_table(index=["cell", "repetition"], columns="method", values="seconds", aggfunc="min")
    fastest = table.min(axis=1)
    ratios = table.div(fastest, axis=0).where(np.isfinite(fastest), np.inf)
    for method, look in _looks(results).items():
        ordered = np.sort(ratios[method].to_numpy())
        finite = ordered[np.isfinite(ordered)]
        share = np.arange(1, len(finite) + 1) / len(ordered)
        here.step(finite, share, where="post", label=method, color=look["color"], linestyle=look["linestyle"])
    here.set_xscale("log")
    here.set_ylim(0, 1.02)
    here.set_xlabel("time / time of the fastest method")
    here.set_ylabel("share of instances solved")
    here.legend()
    return here
