# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Edges of a robot: proven free, or found in contact."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _raygauge
from ._raygauge import ConvexSet, UnknownNameError

if TYPE_CHECKING:
    from ._raygauge import SetLike
    from .loading import Robot
    from .scenes import Scene


@dataclass(frozen=True)
class EdgeVerdict:
    """What is proven of an edge, a configuration or a path.

    outcome: free, contact or undecided. Of a contact: time, bodies and parts (names and numbers of the pair), lower and upper
    (bounds on the distance then), point_a and point_b (points of both), depth (how far they have to be pushed apart). A contact is
    not always the first one.
    """

    outcome: Literal["free", "contact", "undecided"]
    time: float
    bodies: tuple[str, str] | None
    parts: tuple[int, int]
    lower: float
    upper: float
    point_a: NDArray[np.float64] | None
    point_b: NDArray[np.float64] | None
    depth: float

    def __bool__(self) -> bool:
        """Whether it is proven free."""
        return self.outcome == "free"


class EdgeChecker:
    """Proves that a robot moves without contact along straight lines of its joint space, or finds a contact.

    robot: from load_robot. obstacles: the bodies of a Scene, which stand or move. base: homogeneous matrix of shape (4, 4). grasped:
    by name (LINK, SHAPE, POSE): what is held, and where on the link; links that touch it belong into ignore. ignore: pairs of names
    of links, grasped objects and obstacles that never count; links that a joint joins are left out anyway. margin: free edges keep
    more than this distance. contact: a distance of at most margin + contact is a contact. max_looks: pairs solved until an edge
    is undecided. One checker a thread.

    Raises UnknownNameError, InvalidParameterError, DimensionMismatchError.

    >>> scene = rg.Scene()
    >>> scene.add_body("ball", rg.Ball([0.6, 0, 0.6], 0.1))
    >>> checker = rg.EdgeChecker(rg.load_robot("arm.urdf"), scene, margin=0.001)
    >>> q = np.zeros(6)
    >>> checker.configuration(q).outcome
    'free'
    >>> verdict = checker.edge(q, [0, 1.5, 0, 0, 0, 0])
    >>> verdict.outcome, "ball" in verdict.bodies
    ('contact', True)
    """

    def __init__(
        self,
        robot: Robot,
        obstacles: Scene | None = None,
        *,
        base: ArrayLike | None = None,
        grasped: Mapping[str, tuple[str, SetLike, ArrayLike | None]] | None = None,
        ignore: Iterable[tuple[str, str]] = (),
        margin: float = 0.0,
        contact: float = 1e-6,
        max_looks: int = 20000,
    ) -> None:
        problem = robot_problem(robot, obstacles, base, grasped, ignore, margin, contact, max_looks)
        self._proofs = _raygauge.EdgeProofs(problem)

    def edge(self, q0: ArrayLike, q1: ArrayLike, *, start: float = 0.0, stop: float = 1.0) -> EdgeVerdict:
        """The line from q0 at time start to q1 at time stop, shapes (joints,). Raises DimensionMismatchError, NonFiniteError."""
        return self._verdict(self._proofs.edge(q0, q1, start, stop))

    def configuration(self, q: ArrayLike, *, time: float = 0.0) -> EdgeVerdict:
        """One configuration, shape (joints,), at one time. Raises DimensionMismatchError, NonFiniteError."""
        return self._verdict(self._proofs.configuration(q, time))

    def path(self, path: ArrayLike, *, times: ArrayLike | None = None) -> EdgeVerdict:
        """The edges of a path, shape (K, joints), up to the first that is not free. times: shape (K,); default 0, 1, 2, ...

        One row is a configuration.
        """
        rows = np.asarray(path, dtype=float)
        return self._verdict(self._proofs.path(np.arange(float(len(rows))) if times is None else times, rows))

    def _verdict(self, found: tuple[Any, ...]) -> EdgeVerdict:
        outcome, time, (a, b), *rest = found
        return EdgeVerdict(outcome, time, None if a < 0 else (self._proofs.name(a), self._proofs.name(b)), *rest)


def prove_path(robot: Robot, path: ArrayLike, obstacles: Scene | None = None, **options: Any) -> EdgeVerdict:
    """Whether a path, shape (K, joints), is free at every time: of a planner, say. options: times, and those of EdgeChecker.

    >>> path = [[0, 0, 0, 0, 0, 0], [1, 0, 0, 0, 0, 0], [1, 0.5, 0, 0, 0, 0]]
    >>> bool(rg.prove_path(rg.load_robot("arm.urdf"), path, margin=0.001))
    True
    """
    times = options.pop("times", None)
    return EdgeChecker(robot, obstacles, **options).path(path, times=times)


def robot_problem(
    robot: Robot,
    obstacles: Scene | None = None,
    base: ArrayLike | None = None,
    grasped: Mapping[str, tuple[str, SetLike, ArrayLike | None]] | None = None,
    ignore: Iterable[tuple[str, str]] = (),
    margin: float = 0.0,
    contact: float = 1e-6,
    max_looks: int = 20000,
) -> _raygauge.RobotProblem:
    """The arguments of EdgeChecker and plan as compiled code takes them."""
    bodies: list[dict[str, Any]] = [
        {"name": link, "link": number, "pose": None, "parts": robot.shapes(link)}
        for number, link in enumerate(robot.links)
        if robot.shapes(link)
    ]
    for name, (link, shape, pose) in (grasped or {}).items():
        if link not in robot.links:
            raise UnknownNameError(f"robot: no link is called '{link}'; known: {', '.join(robot.links)}")
        bodies.append({"name": name, "link": robot.links.index(link), "pose": pose, "parts": _parts(shape)})
    around = [] if obstacles is None else obstacles._bodies
    numbers = {body["name"]: number for number, body in enumerate([*bodies, *around])}
    pairs = []
    for pair in [*ignore, *_joined(robot, set(numbers))]:
        for name in pair:
            if name not in numbers:
                raise UnknownNameError(f"no link with a shape, grasped object or obstacle is called '{name}'")
        pairs.append((numbers[pair[0]], numbers[pair[1]]))
    tree = {"links": robot._file.tree(), "joints": len(robot.joints), "base": base, "bodies": bodies, "ignored": pairs}
    return _raygauge.RobotProblem(tree, around, margin, contact, max_looks)


def _parts(shape: Any) -> list[Any]:
    is_list = isinstance(shape, (list, tuple)) and any(isinstance(part, ConvexSet) for part in shape)
    return list(shape) if is_list else [shape]


def _joined(robot: Robot, with_shape: set[str]) -> list[tuple[str, str]]:
    """Pairs of links that a joint joins, also over links without a shape."""
    above = {child: parent for parent, child in robot.joined}
    pairs = []
    for link in robot.links:
        parent = above.get(link)
        while parent is not None and parent not in with_shape:
            parent = above.get(parent)
        if link in with_shape and parent is not None:
            pairs.append((parent, link))
    return pairs
