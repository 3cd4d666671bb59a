# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Paths of a robot from start to goal, proven at every time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._raygauge import InvalidParameterError
from .edges import robot_problem
from .loading import Robot, SceneFile, _readers

if TYPE_CHECKING:
    from .scenes import Scene

Planner = Literal["rrt_connect", "bi_est", "rrt", "est"]


@dataclass(frozen=True)
class Plan:
    """A path that is proven to be free at every time, or none.

    path: shape (K, joints), configurations from start to goal, between which joints move straight; no row: none was found within the
    time limit. times: shape (K,), over the time of the scene file; 0, 1, 2, ... without one. length: of the path, Euclidean, in joint
    space. search_seconds, shorten_seconds, proof_seconds: for the first path, for making it shorter and smoother, and for one proof
    of the whole path. edges: lines that the planner asked about. undecided: of these, not proven either way; they count as contacts.
    """

    path: NDArray[np.float64]
    times: NDArray[np.float64]
    length: float
    search_seconds: float
    shorten_seconds: float
    proof_seconds: float
    edges: int
    undecided: int

    def __bool__(self) -> bool:
        """Whether a path was found."""
        return len(self.path) > 0


def plan(
    what: Robot | SceneFile,
    start: Mapping[str, float] | ArrayLike | None = None,
    goal: Mapping[str, float] | ArrayLike | None = None,
    obstacles: Scene | None = None,
    *,
    planner: Planner | None = None,
    time_limit: float | None = None,
    seed: int | None = None,
    **options: Any,
) -> Plan:
    """A path by a planner of OMPL, each edge of which is proven, shortened and smoothed.

    what: a robot, with start and goal (values by joint, others 0, or all of them, shape (joints,)) and obstacles that stand still; or
    a scene file with a [plan], which has all of these. planner: default rrt_connect. time_limit: seconds for the search, default 10.
    seed: default 1; the same one gives the same path. options: those of EdgeChecker. Joints keep within their limits; one that turns
    without limits stays within half a turn of start and goal. Ctrl-C ends the search.

    Raises InvalidParameterError where start or goal is not proven free or OMPL is missing, UnknownNameError, DimensionMismatchError;
    ProgramError where the package was built without the program.

    >>> found = rg.plan(rg.load_robot("arm.urdf"), {}, {"turn": 1.0}, margin=0.001)
    >>> bool(found), bool(rg.prove_path(rg.load_robot("arm.urdf"), found.path, margin=0.001))
    (True, True)
    """
    if isinstance(what, SceneFile):
        if start is not None or goal is not None or obstacles is not None or options:
            raise InvalidParameterError("plan: a scene file has start, goal, obstacles and margin in its [plan]")
        return Plan(*_readers().plan_scene(what._file, planner, time_limit, seed))
    if start is None or goal is None:
        raise InvalidParameterError("plan: a robot needs a start and a goal")
    problem = robot_problem(what, obstacles, **options)
    first, last = what._numbers(start), what._numbers(goal)
    limits = what._file.limits(first, last)
    return Plan(*_readers().plan(problem, limits, first, last, planner, time_limit, seed))
