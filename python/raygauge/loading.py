# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Files of one's own: sets, robots and scenes, read as the program reads them."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._raygauge import ConvexSet, InvalidParameterError, Mesh, UnknownNameError
from .scenes import SceneAnswers
from .simulation import Simulation, simulation_of
from .sweeps import ProgramError

if TYPE_CHECKING:
    from ._raygauge import Array

Folders = Mapping[str, str | os.PathLike[str]]


def _readers() -> ModuleType:
    """The compiled readers, which need the libraries of the program."""
    try:
        from . import _sweeps
    except ImportError:
        raise ProgramError(
            "reading files needs the package built beside the program: ./run.sh build, then ./run.sh python"
        ) from None
    return _sweeps


def _folders(packages: Folders | None) -> dict[str, str]:
    return {name: os.fspath(folder) for name, folder in (packages or {}).items()}


def load_set(source: str | os.PathLike[str], *, skip_header: bool = False) -> ConvexSet:
    """The set that a file holds: points (text, also .gz), a mesh (its hull), a dataset ("points.h5:/A"), or a set file (.toml).

    These are the files that `raygauge distance` reads (docs/user-guide.md, docs/sets.md). skip_header: the first line of a
    text is a heading. Raises Error, with file and line; ProgramError where the package was built without the program.

    >>> rg.load_set("cube.obj").support_function([1, 0, 0])
    1.0
    """
    found: ConvexSet = _readers().load_set(os.fspath(source), skip_header)
    return found


def load_mesh(source: str | os.PathLike[str], solid: bool) -> Mesh:
    """See Mesh.from_file."""
    found: Mesh = _readers().load_mesh(os.fspath(source), solid)
    return found


class Robot:
    """A robot of a URDF, MJCF or SDF file: links with collision shapes, and joints.

    name. joints: names of those that take a value, in the order of the values. links: names, parents first. notes: what was left out
    of the file, and what meshes that are not convex are taken for.

    >>> robot = rg.load_robot("arm.urdf")
    >>> len(robot.links) > len(robot.joints) > 0
    True
    """

    def __init__(self, path: str | os.PathLike[str], packages: Folders | None = None, meshes: str | None = None) -> None:
        self._made_of = (os.path.abspath(os.fspath(path)), _folders(packages), meshes or "")
        self._file = _readers().load_robot(*self._made_of)
        self.name: str = self._file.name
        self.joints: tuple[str, ...] = tuple(self._file.joints)
        self.links: tuple[str, ...] = tuple(self._file.links)
        self.notes: tuple[str, ...] = tuple(self._file.notes)
        self._shapes: list[list[ConvexSet]] = self._file.shapes()

    def __reduce__(self) -> tuple[Any, ...]:
        return Robot, self._made_of

    def __repr__(self) -> str:
        return f"<raygauge.Robot {self.name}, {len(self.links)} links, {len(self.joints)} joints>"

    def shapes(self, link: str) -> list[ConvexSet]:
        """The collision shapes of a link, in its frame. Raises UnknownNameError."""
        if link not in self.links:
            raise UnknownNameError(f"robot: no link is called '{link}'; known: {', '.join(self.links)}")
        return list(self._shapes[self.links.index(link)])

    def poses(self, values: Mapping[str, float] | ArrayLike = ()) -> dict[str, Array]:
        """Where each link is, a homogeneous matrix of shape (4, 4), for values of the joints: by name (others 0), or all of them.

        Raises UnknownNameError, DimensionMismatchError.
        """
        return dict(zip(self.links, self._file.poses(self._numbers(values)), strict=True))

    def twists(self, values: Mapping[str, float] | ArrayLike = ()) -> dict[str, Array]:
        """How each link moves with each joint, an array of shape (joints, 6), for values as in poses.

        A row has the velocity of the link's origin and the angular velocity while that joint rises by 1 per second. With a
        PoseGradient g of a body at the pose of the link, twists[link] @ g.body_1 is the gradient along the joints, and
        g.along(rates @ twists[link], np.zeros(6)) the derivative for rates of the joints, also where g is one-sided.

        Raises UnknownNameError, DimensionMismatchError.
        """
        return dict(zip(self.links, self._file.twists(self._numbers(values)), strict=True))

    def _numbers(self, values: Mapping[str, float] | ArrayLike) -> list[float]:
        if not isinstance(values, Mapping):
            return [float(value) for value in np.atleast_1d(np.asarray(values, dtype=float))] or [0.0] * len(self.joints)
        for name in values:
            if name not in self.joints:
                raise UnknownNameError(f"robot: no joint is called '{name}'; known: {', '.join(self.joints)}")
        return [float(values.get(name, 0.0)) for name in self.joints]

    @property
    def joined(self) -> list[tuple[str, str]]:
        """The pairs of links that a joint joins, which touch by design."""
        return [(self.links[a], self.links[b]) for a, b in self._file.joined]


def load_robot(path: str | os.PathLike[str], *, packages: Folders | None = None, meshes: str | None = None) -> Robot:
    """The robot of a URDF, MJCF or SDF file. packages: the folders of package:// names. meshes: what they are taken as, "hull", "surface",
    "solid" or "parts"; None: each as it is, by its hull where it is convex.

    Raises InvalidParameterError, with file and link; UnknownNameError; ProgramError where the package was built without the program.
    """
    return Robot(path, packages, meshes)


class SceneFile:
    """A scene of a scene file: explain and run it.

    name, instants, bodies, queries: as in the file.
    """

    def __init__(self, path: str, overrides: list[str], packages: dict[str, str]) -> None:
        self._made_of = (path, overrides, packages)
        self._file = _readers().load_scene(path, overrides, packages)
        self.name: str = self._file.name
        self.instants: NDArray[np.float64] = np.array(self._file.instants)
        self.bodies: tuple[str, ...] = tuple(self._file.bodies)
        self.queries: tuple[str, ...] = tuple(self._file.queries)

    def __reduce__(self) -> tuple[Any, ...]:
        return SceneFile, self._made_of

    def __repr__(self) -> str:
        return f"<raygauge.SceneFile {self.name}, {len(self.bodies)} bodies, {len(self.queries)} queries>"

    def explain(self) -> list[list[str]]:
        """What each query will compute and what not, and why: lines of text."""
        lines: list[list[str]] = self._file.explain()
        return lines

    def run(self, *, threads: int = 0) -> SceneAnswers:
        """Answers every query, as Scene.run does; nothing is stored. For a file with [dynamics] there is simulate."""
        return SceneAnswers.of_numbers(self._file.columns(threads), self.bodies, self.queries)

    def simulate(self, *, threads: int = 0) -> Simulation:
        """Lets the bodies react as [dynamics] says, like raygauge.simulate; nothing is stored."""
        return simulation_of(self._file.simulation(threads), self.bodies, self.queries)


def load_scene(path: str | os.PathLike[str], *, set: Iterable[str] = (), packages: Folders | None = None) -> SceneFile:
    """The scene of a scene file (docs/scenes.md). set: overrides, as "time.steps=11". packages: folders of package:// names.

    Raises Error, with file and line; ProgramError where the package was built without the program.

    >>> scene = rg.load_scene("falling_box.toml")
    >>> len(scene.run()["distance"]) > 0
    True
    """
    if isinstance(set, str):
        raise InvalidParameterError('set: a list is needed, as in ["time.steps=11"]')
    return SceneFile(os.path.abspath(os.fspath(path)), list(set), _folders(packages))
