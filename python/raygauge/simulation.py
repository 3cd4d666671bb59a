# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Simulation: bodies of a scene that fall, hit, slide and rest."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from numpy.typing import ArrayLike

from . import _raygauge
from ._raygauge import Error, InvalidParameterError, UnknownNameError
from .scenes import Columns, Scene, SceneAnswers


class Simulation:
    """What `simulate` found.

    states: a row a body and instant: time, body, position, quaternion (w, x, y, z), velocity, spin, of the centre of mass.
    contacts: a row a contact that carried an impulse: step, time, body_a, body_b, impact (by the law of restitution), point,
    normal (from b to a), gap, impulse (on a). steps: a row a step: time of its end, substeps, impacts, contacts, residual,
    least_distance (proven: no pair came closer at any time of the step; -inf: unproven), kinetic and potential energy, momentum,
    angular_momentum. counters: how often what was computed. tolerance: δ in units of the scene. answers: to the scene's queries.
    """

    def __init__(self, found: Mapping[str, Any], bodies: Sequence[str], queries: Sequence[str]) -> None:
        self.states = Columns.of_numbers(found["states"], bodies)
        self.contacts = Columns.of_numbers(found["contacts"], bodies)
        self.steps = Columns(found["steps"])
        self.counters: dict[str, int] = found["counters"]
        self.tolerance: float = found["tolerance"]
        self.answers = SceneAnswers.of_numbers(found["answers"], bodies, queries)

    def __repr__(self) -> str:
        return f"<raygauge.Simulation, {self.steps.rows} steps, {self.contacts.rows} contacts>"


class SimulationError(Error):
    """A simulation that cannot go on: driven bodies jam others, or one spins too fast for a step to be proven.

    done: the Simulation until the last step before; its last instant is the end of that.
    """

    def __init__(self, message: str, done: Simulation) -> None:
        super().__init__(message)
        self.done = done

    def __reduce__(self) -> tuple[Any, ...]:
        return SimulationError, (str(self), self.done)


def simulation_of(found: Mapping[str, Any], bodies: Sequence[str], queries: Sequence[str]) -> Simulation:
    """What was found, where it did not end before its time."""
    done = Simulation(found, bodies, queries)
    if found["ended_by"] is not None:
        raise SimulationError(found["ended_by"], done)
    return done


def checked(given: Mapping[str, float] | None, name: str, known: tuple[str, ...]) -> dict[str, float] | None:
    """The numbers, none of them under a name that has no effect."""
    if given is not None and not isinstance(given, Mapping):
        raise InvalidParameterError(f"{name}: a dict is needed, got {given!r}")
    for key in given or ():
        if key not in known:
            raise UnknownNameError(f"{name}: no effect is called '{key}'; known: {', '.join(known)}")
    return None if given is None else dict(given)


def simulate(
    scene: Scene,
    *,
    gravity: ArrayLike | None = None,
    contact: Mapping[str, float] | None = None,
    pairs: Iterable[tuple[str, str, Mapping[str, float]]] = (),
    damping: Mapping[str, float] | None = None,
    step: float = 1e-3,
    tolerance: float = 1e-6,
    overlap_at_start: str = "refuse",
    threads: int = 0,
) -> Simulation:
    """Lets the bodies of a scene that have a density or a mass react, from the first instant to the last.

    What is not named is not computed. gravity: shape (n,). contact: {"friction": μ, "restitution": e}, either left out or both;
    None: bodies pass through each other. pairs: (body or group, another, contact) in place of it. damping: {"linear": c,
    "angular": c}, 1/s. step: the longest step. tolerance: bodies overlap by at most this, relative to the smallest one that
    reacts; it is proven of every step. overlap_at_start: "refuse", or "resolve": bodies are first moved apart. threads: 0 for
    one on each CPU; what is found does not depend on it.

    Ctrl-C ends it. Raises InvalidParameterError, DimensionMismatchError, UnknownNameError and what Scene.run raises;
    SimulationError where it cannot go on, with what was done until then.

    >>> scene = rg.Scene(np.linspace(0, 2, 21))
    >>> scene.add_body("cube", rg.Box([-0.1] * 3, [0.1] * 3), density=1000, velocity=[0, 0, 1])
    >>> scene.add_body("floor", rg.HalfSpace([0, 0, 1], -0.1))
    >>> found = rg.simulate(scene, gravity=[0, 0, -9.81], contact={"friction": 0.5})
    >>> found.states.where(body="cube")["position"][-1].round(6) + 0.0
    array([0., 0., 0.])
    >>> bool(min(found.steps["least_distance"]) >= -found.tolerance)
    True
    """
    pairs = list(pairs)
    if any(len(pair) != 3 or pair[2] is None for pair in pairs):
        raise InvalidParameterError("pairs: each is a body or group, another, and their contact; Scene.ignore leaves pairs out")
    effects = {
        "gravity": gravity, "contact": checked(contact, "contact", ("friction", "restitution")),
        "damping": checked(damping, "damping", ("linear", "angular")), "step": step, "tolerance": tolerance,
        "overlap_at_start": overlap_at_start,
        "pairs": [(scene._members(a), scene._members(b), checked(law, "pairs", ("friction", "restitution"))) for a, b, law in pairs],
    }  # fmt: skip
    found = _raygauge.simulation(scene._bodies, scene._instants, scene._ignored, scene._queries, effects, threads)
    return simulation_of(found, [body["name"] for body in scene._bodies], [query["name"] for query in scene._queries])
