# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Scenes: bodies that move, and what is asked of them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _raygauge
from ._raygauge import ConvexSet, InvalidParameterError, UnknownNameError
from .extras import extra

if TYPE_CHECKING:
    import pandas as pd

    from ._raygauge import SetLike
    from .loading import Robot

Effect = Literal["separated", "distance", "closest_points", "gradient", "depth", "growth", "time_of_impact", "clearance"]


class Columns(Mapping[str, NDArray[Any]]):
    """A table: arrays by the name of a column, all with the same number of rows."""

    def __init__(self, columns: Mapping[str, NDArray[Any]]) -> None:
        self._columns = dict(columns)

    @classmethod
    def of_numbers(cls, columns: Mapping[str, NDArray[Any]], bodies: Sequence[str], queries: Sequence[str] = ()) -> Self:
        """Columns whose bodies and queries are numbers."""
        known = np.array(list(bodies))
        names = {"query": np.array(list(queries) or [""]), "body": known, "body_a": known, "body_b": known}
        return cls({name: names[name][column] if name in names else column for name, column in columns.items()})

    def __getitem__(self, name: str) -> NDArray[Any]:
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    @property
    def rows(self) -> int:
        """How many rows there are."""
        return len(next(iter(self._columns.values()), ()))

    def __repr__(self) -> str:
        return f"<raygauge.{type(self).__name__}, {self.rows} rows: {', '.join(self)}>"

    def where(self, **values: Any) -> Self:
        """The rows in which every column named has the value."""
        keep = np.ones(self.rows, dtype=bool)
        for name, value in values.items():
            keep &= self[name] == value
        return type(self)({name: column[keep] for name, column in self._columns.items()})

    def to_dataframe(self) -> pd.DataFrame:
        """A pandas.DataFrame with a row for each row; vectors are columns point_a_0, point_a_1, ..."""
        with extra("results"):
            import pandas as pd

        columns: dict[str, NDArray[Any]] = {}
        for name, column in self._columns.items():
            if column.ndim == 1:
                columns[name] = column
            else:
                columns.update({f"{name}_{k}": column[:, k] for k in range(column.shape[1])})
        return pd.DataFrame(columns)


class SceneAnswers(Columns):
    """The answers of a scene: arrays by the name of a column, one row an answer.

    query, body_a, body_b: names. part_a, part_b: numbers of the nearest convex parts, -1: not looked for. kind: instant,
    time_of_impact or clearance. instant: its number, -1 for the whole time. time: seconds. time_lower, time_upper: no contact
    before, a contact at. status: separated, intersecting, undecided, contact or free. decided: solved, broad_phase, coherence
    or static. distance with lower and upper; growth and depth with their bounds; point_a, point_b, gradient: shape (rows, n).
    nan: not asked for. solves, seconds: the work.
    """


def _kept(values: Any) -> Any:
    """Arrays and lists as they are now: what the caller does with them later changes no scene. Sets never change."""
    if isinstance(values, (list, tuple)):
        return [_kept(value) for value in values]
    return values.copy() if isinstance(values, np.ndarray) else values


class Scene:
    """Bodies that move in R^2 or R^3 (or up to R^6 without turning), and questions about their pairs.

    instants: the times, rising, seconds, at which the bodies are looked at; the first and the last span the scene's time.
    Only what a query asks for is computed, and of that what nothing cheaper proves (docs/scenes.md).

    >>> scene = rg.Scene(np.linspace(0, 2, 41))
    >>> scene.add_body("box", rg.Box([-0.5] * 3, [0.5] * 3), velocity=[2, 0, 0], spin=[0, 0, 1])
    >>> scene.add_body("ball", rg.Ball([3, 0, 0]))
    >>> scene.add_query(["distance", "time_of_impact"], between=("box", "ball"))
    >>> answers = scene.run()
    >>> impact = answers.where(kind="time_of_impact")
    >>> impact["status"][0], 0.6 < impact["time_lower"][0] <= impact["time_upper"][0] < 0.8
    ('contact', True)
    >>> answers.where(kind="instant", instant=0)["distance"].round(6)
    array([1.5])
    """

    def __init__(self, instants: ArrayLike = (0.0,)) -> None:
        try:
            self._instants = np.array(instants, dtype=float)
        except ValueError:
            raise InvalidParameterError(f"scene: instants are times in seconds, got {instants!r}") from None
        self._bodies: list[dict[str, Any]] = []
        self._groups: dict[str, list[int]] = {}
        self._ignored: list[tuple[int, int]] = []
        self._queries: list[dict[str, Any]] = []

    def __repr__(self) -> str:
        return f"<raygauge.Scene, {len(self._bodies)} bodies, {len(self._queries)} queries, {self._instants.size} instants>"

    def add_body(
        self,
        name: str,
        parts: SetLike | Sequence[ConvexSet],
        *,
        pose: ArrayLike | None = None,
        times: ArrayLike | None = None,
        poses: ArrayLike | None = None,
        velocity: ArrayLike | None = None,
        acceleration: ArrayLike | None = None,
        spin: ArrayLike | None = None,
        density: float | None = None,
        mass: float | None = None,
        inertia: ArrayLike | None = None,
        groups: Iterable[str] | str = (),
    ) -> None:
        """Adds a rigid body: a set, an array of points, or a list of sets whose union it is.

        pose: homogeneous matrix of shape (n+1, n+1), where it is at the first instant. velocity, acceleration: shape (n,); spin:
        angular velocity, a number in the plane, shape (3,) in space: constant rates from there on. Or keyframes: times,
        shape (K,), and poses, shape (K, n+1, n+1), between which it moves straight and turns about a fixed axis.
        density or mass: it reacts, see simulate; velocity (of its centre of mass) and spin are then its first ones. inertia: about
        the centre of mass, in place of that of the shape: 3 moments or shape (3, 3), in the plane a number.
        groups: names under which queries find it besides its own.

        Raises InvalidParameterError; what is wrong with the numbers is raised by run.
        """
        if name in self._groups:
            raise InvalidParameterError(f"a body or group '{name}' is there already")
        if (times is None) != (poses is None):
            raise InvalidParameterError(f"body '{name}': times and poses belong together")
        if times is not None and any(value is not None for value in (pose, velocity, acceleration, spin)):
            raise InvalidParameterError(f"body '{name}': keyframes, or a pose and rates, not both")
        if density is None and mass is None and inertia is not None:
            raise InvalidParameterError(f"body '{name}': inertia needs a mass")
        if (density is not None or mass is not None) and (times is not None or acceleration is not None):
            raise InvalidParameterError(f"body '{name}': a body that reacts follows no motion; it has a first velocity and spin")
        is_list = isinstance(parts, (list, tuple)) and any(isinstance(part, ConvexSet) for part in parts)
        self._groups[name] = [len(self._bodies)]
        for group in [groups] if isinstance(groups, str) else groups:
            self._groups.setdefault(group, []).append(len(self._bodies))
        self._bodies.append(
            {"name": name, "parts": _kept(parts if is_list else [parts]), "pose": _kept(pose), "times": _kept(times), "poses": _kept(poses),
             "velocity": _kept(velocity), "acceleration": _kept(acceleration), "spin": _kept(spin), "density": density, "mass": mass,
             "inertia": _kept(inertia)}
        )  # fmt: skip

    def add_robot(
        self,
        robot: Robot,
        values: Mapping[str, float] | ArrayLike = (),
        *,
        name: str | None = None,
        pose: ArrayLike | None = None,
    ) -> None:
        """Adds the links of a robot that have shapes, as they are at these values of its joints, as bodies "NAME/LINK" in the group NAME.

        pose: homogeneous matrix of its base, shape (4, 4). Pairs of links that a joint joins are left out. For a robot
        that moves, write a scene file (docs/scenes.md) and load it with load_scene.
        """
        group = name or robot.name
        base = np.eye(4) if pose is None else np.asarray(pose, dtype=float)
        for link, place in robot.poses(values).items():
            if shapes := robot.shapes(link):
                self.add_body(f"{group}/{link}", shapes, pose=base @ place, groups=[group])
        for first, second in robot.joined:
            if robot.shapes(first) and robot.shapes(second):
                self.ignore(f"{group}/{first}", f"{group}/{second}")

    def ignore(self, first: str, second: str) -> None:
        """Leaves out the pairs of two bodies or groups, as of links that a joint joins. Raises UnknownNameError."""
        self._ignored += [(a, b) for a in self._members(first) for b in self._members(second) if a != b]

    def add_query(
        self,
        effects: Iterable[Effect] | Effect,
        *,
        between: tuple[str, str] | str | None = None,
        name: str | None = None,
        metric: SetLike | None = None,
        metric_body: str | None = None,
        within: float = np.inf,
        nearest: int = 0,
        tolerance: float = 1e-6,
        contact: float = 1e-6,
        clearance_tolerance: float = 1e-3,
        every_instant: bool = False,
    ) -> None:
        """Asks for effects of pairs of bodies: of two groups, within one, or of all.

        metric: the unit ball of the distance, 0 inside; default: Euclidean. metric_body: whose rotation it follows. within, nearest:
        at instants, of interest are pairs of at most this distance, or so many nearest ones; 0: all. tolerance:
        relative gap of distances. contact: for time_of_impact, a distance of at most this counts. clearance_tolerance:
        relative gap of clearance. every_instant: separated is recorded not only where it changes.

        Raises UnknownNameError; other mistakes are raised by run.
        """
        pair = (between, between) if isinstance(between, str) else between
        if pair is not None and len(pair) != 2:
            raise InvalidParameterError(f"between: a body or group, or two of them, got {between!r}")
        everyone = list(range(len(self._bodies)))
        groups = [everyone, everyone] if pair is None else [self._members(group) for group in pair]
        self._queries.append(
            {"name": name or f"query {len(self._queries) + 1}", "effects": [effects] if isinstance(effects, str) else list(effects), "group_1": groups[0],
             "group_2": groups[1], "metric": _kept(metric), "metric_body": -1 if metric_body is None else self._members(metric_body)[0],
             "within": within, "nearest": nearest, "tolerance": tolerance, "contact": contact,
             "clearance_tolerance": clearance_tolerance, "every_instant": every_instant}
        )  # fmt: skip

    def explain(self) -> list[list[str]]:
        """What each query will compute and what not, and why: lines of text."""
        return _raygauge.scene_explanation(self._bodies, self._instants, self._ignored, self._queries)

    def run(self, *, threads: int = 0) -> SceneAnswers:
        """Answers every query. threads: 0 for one on each CPU; answers do not depend on it but for seconds.

        Without the interpreter's lock; Ctrl-C ends it after the cells in work. Raises InvalidParameterError,
        DimensionMismatchError, NonFiniteError, EmptySetError, UnknownNameError.
        """
        for body in self._bodies:
            if body["density"] is not None or body["mass"] is not None:
                raise InvalidParameterError(f"body '{body['name']}' has a mass: simulate lets it react, and answers the queries")
        columns = _raygauge.scene_answers(self._bodies, self._instants, self._ignored, self._queries, threads)
        bodies = [body["name"] for body in self._bodies]
        return SceneAnswers.of_numbers(columns, bodies, [query["name"] for query in self._queries])

    def _members(self, group: str) -> list[int]:
        if group not in self._groups:
            raise UnknownNameError(f"scene: no body or group is called '{group}'; known: {', '.join(self._groups)}")
        return self._groups[group]
