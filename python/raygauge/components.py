# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Methods and generators of sweeps, written in Python."""

from __future__ import annotations

import inspect
import pathlib
import traceback
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike

from ._raygauge import InvalidParameterError

Own = TypeVar("Own", bound=Callable[..., Any])
Value = bool | int | float | str

_METHOD_INPUTS = ("tolerance", "time_limit")
_GENERATOR_INPUTS = ("rng", "n", "N", "seed", "repetition")


@dataclass(frozen=True)
class Answer:
    """What a method of one's own found, and what proves it.

    distance: the method's claim, inf for unreachable, nan where it failed. u: shape (n,), duals of the linear program:
    raygauge proves the lower bound -h_A(u) / h_Q(-u) from them. points_A, points_Q: the rows of A and Q that meet, of which
    raygauge proves the upper bound. Bounds are proven for point sets; without u or points they are nan.
    status: a Status; default: what the distance says. pivots: iterations, for the record.

    >>> rg.Answer(2.0, u=[-1.0, 0.0], points_A=[0]).distance
    2.0
    """

    distance: float
    u: ArrayLike | None = None
    points_A: Sequence[int] | np.ndarray[Any, Any] = ()
    points_Q: Sequence[int] | np.ndarray[Any, Any] = ()
    status: str | None = None
    pivots: int = 0


@dataclass(frozen=True)
class Component:
    """A registered function or class; the compiled part reads these."""

    kind: str
    name: str
    description: str
    made_of: Callable[..., Any]
    inputs: tuple[str, ...]
    parameters: list[tuple[str, Value]] = field(default_factory=list)

    def make(self, parameters: Mapping[str, Value]) -> Any:
        """What a sweep calls: `load` and `solve` of a method, or a generator's function of an instance's key."""
        if self.kind == "generator":
            return _Instances(self, parameters)
        if inspect.isclass(self.made_of):
            return _ClassSolver(self, parameters)
        return _FunctionSolver(self, parameters)

    def place(self) -> str:
        """The file and line of the source."""
        code = inspect.unwrap(self.made_of)
        try:
            return f"{pathlib.Path(inspect.getsourcefile(code) or '').name}:{inspect.getsourcelines(code)[1]}"
        except (OSError, TypeError):
            return "unknown"


METHODS: dict[str, Component] = {}
GENERATORS: dict[str, Component] = {}


class _FunctionSolver:
    def __init__(self, component: Component, parameters: Mapping[str, Value]) -> None:
        self._function = component.made_of
        self._wants = component.inputs
        self._fixed = dict(parameters)

    def load(self, A: Any, Q: Any) -> None:
        self._sets = (A, Q)

    def solve(self, tolerance: float, time_limit: float) -> Any:
        given = {"tolerance": tolerance, "time_limit": time_limit}
        return self._function(*self._sets, **{name: given[name] for name in self._wants}, **self._fixed)


class _ClassSolver:
    def __init__(self, component: Component, parameters: Mapping[str, Value]) -> None:
        self._solver = component.made_of(**parameters)
        self._wants = component.inputs

    def load(self, A: Any, Q: Any) -> None:
        self._solver.load(A, Q)

    def solve(self, tolerance: float, time_limit: float) -> Any:
        given = {"tolerance": tolerance, "time_limit": time_limit}
        return self._solver.solve(**{name: given[name] for name in self._wants})


class _Instances:
    def __init__(self, component: Component, parameters: Mapping[str, Value]) -> None:
        self._component = component
        self._fixed = dict(parameters)

    def __call__(self, seed: int, n: int, N: int, repetition: int) -> tuple[Any, Any, float | None]:
        given = {"n": n, "N": N, "seed": seed, "repetition": repetition}
        if "rng" in self._component.inputs:
            given["rng"] = np.random.default_rng([seed, n, N, repetition])  # type: ignore[assignment]
        wanted = {name: given[name] for name in self._component.inputs}
        made = self._component.made_of(**wanted, **self._fixed)
        if not isinstance(made, tuple) or len(made) not in (2, 3):
            raise TypeError(f"returned {made!r:.60}; (A, Q) or (A, Q, exact_distance) is needed")
        exact = made[2] if len(made) == 3 else None
        return made[0], made[1], None if exact is None else float(exact)


def answer_of(value: Any) -> Answer:
    """What a method returned, as an Answer."""
    answer = value if isinstance(value, Answer) else Answer(value)
    answer = replace(answer, distance=float(answer.distance), pivots=int(answer.pivots))
    if answer.distance < 0:
        raise ValueError(f"a distance of {answer.distance}")
    return answer


def failure_text(component: Component, error: BaseException) -> str:
    """One line: whose function raised what, and where."""
    text = f"{component.kind} '{component.name}': {type(error).__name__}: {error}"
    own = [frame for frame in traceback.extract_tb(error.__traceback__) if frame.filename != __file__]
    place = f" ({pathlib.Path(own[-1].filename).name}, line {own[-1].lineno})" if own else ""
    return " ".join((text + place).split())


def _refuse(kind: str, name: str, why: str) -> InvalidParameterError:
    return InvalidParameterError(f"{kind} '{name}': {why}")


def _signature(function: Callable[..., Any], kind: str, name: str) -> list[inspect.Parameter]:
    try:
        return list(inspect.signature(function).parameters.values())
    except (TypeError, ValueError) as error:
        raise _refuse(kind, name, f"its parameters cannot be told: {error}") from error


def _split(
    parameters: list[inspect.Parameter], inputs: Sequence[str], kind: str, name: str
) -> tuple[tuple[str, ...], list[tuple[str, Value]]]:
    """Which inputs are asked for, and what an experiment may set, with its default."""
    wanted = []
    own: list[tuple[str, Value]] = []
    for parameter in parameters:
        if parameter.kind in (parameter.VAR_POSITIONAL, parameter.VAR_KEYWORD, parameter.POSITIONAL_ONLY):
            raise _refuse(kind, name, f"a parameter '{parameter}' cannot be passed by name")
        if parameter.name in inputs:
            wanted.append(parameter.name)
        elif isinstance(parameter.default, (bool, int, float, str)):
            own.append((parameter.name, parameter.default))
        else:
            known = ", ".join(inputs)
            raise _refuse(kind, name, f"'{parameter.name}' is none of {known} and has no number or text as default")
    return tuple(wanted), own


def _method_component(made_of: Callable[..., Any], name: str, description: str) -> Component:
    if inspect.isclass(made_of):
        if not (callable(getattr(made_of, "load", None)) and callable(getattr(made_of, "solve", None))):
            raise _refuse("method", name, "a class needs load(A, Q) and solve(tolerance, time_limit)")
        nothing, own = _split(_signature(made_of, "method", name), (), "method", name)
        asked = _signature(made_of.solve, "method", name)[1:]
        inputs, _ = _split(asked, _METHOD_INPUTS, "method", name)
        return Component("method", name, description, made_of, inputs, own)
    parameters = _signature(made_of, "method", name)
    if len(parameters) < 2:
        raise _refuse("method", name, "a function f(A, Q, ...) is needed")
    inputs, own = _split(parameters[2:], _METHOD_INPUTS, "method", name)
    return Component("method", name, description, made_of, inputs, own)


def _register(made_of: Any, kind: str, given_name: str | None) -> None:
    if not callable(made_of):
        raise InvalidParameterError(f"{kind}: a function or a class is needed, got {type(made_of).__name__}")
    name = given_name or str(getattr(made_of, "__name__", ""))
    if not name.isidentifier():
        raise _refuse(kind, name, "a name is made of letters, digits and '_'")
    description = (inspect.getdoc(made_of) or f"a {kind} in Python").splitlines()[0]
    if kind == "method":
        METHODS[name] = _method_component(made_of, name, description)
    else:
        inputs, own = _split(_signature(made_of, kind, name), _GENERATOR_INPUTS, kind, name)
        GENERATORS[name] = Component(kind, name, description, made_of, inputs, own)


@overload
def method(function: Own) -> Own: ...
@overload
def method(*, name: str) -> Callable[[Own], Own]: ...
def method(function: Own | None = None, *, name: str | None = None) -> Own | Callable[[Own], Own]:
    """Makes a Python function or class a competitor in raygauge.run, under its name or `name`.

    A function f(A, Q) returns the distance: a number, or an Answer with what proves it. A and Q are arrays of points,
    shape (N, n), read-only, or sets. Parameters called `tolerance` and `time_limit` (seconds) are given what the sweep asks for;
    any other one needs a number or a text as default, and is a parameter of the method in experiments.

    A class has load(A, Q), for the model (timed as load_seconds), and solve(), for the solution (timed as
    seconds), with the same parameters; what an experiment may set are parameters of the class. One object solves on one thread.

    Functions are called one at a time, so that a time is a function's own; an answer after the time limit counts as
    time_limit. What a function raises ends the sweep: ProgramError, in one line, raised from the function's exception.

    >>> @rg.method
    ... def vertex(A, Q, scale=1.0):
    ...     "The smallest coordinate sum: right where Q is a cross-polytope and A one point."
    ...     return scale * np.abs(A).sum(axis=1).min()
    >>> vertex(np.array([[1.0, -2.0]]), None)
    3.0
    """
    if function is None:
        return lambda late: _named(late, "method", name)
    _register(function, "method", name)
    return function


@overload
def generator(function: Own) -> Own: ...
@overload
def generator(*, name: str) -> Callable[[Own], Own]: ...
def generator(function: Own | None = None, *, name: str | None = None) -> Own | Callable[[Own], Own]:
    """Makes a Python function a source of instances in raygauge.run, under its name or `name`.

    The function returns (A, Q), arrays of points or sets, or (A, Q, exact_distance). Parameters called `rng`, `n`, `N`, `seed`
    and `repetition` are given the instance's: rng is a numpy.random.Generator seeded by the other four, of which
    alone the instance is to depend. Any other parameter needs a number or a text as default, and is one of the
    generator in experiments. What it raises ends the sweep, as with raygauge.method.

    >>> @rg.generator
    ... def shifted_cloud(rng, n, N, shift=3.0):
    ...     A = rng.normal(size=(N, n))
    ...     A[:, 0] += shift
    ...     return A, rng.normal(size=(N, n))
    >>> shifted_cloud(np.random.default_rng(0), 2, 5)[0].shape
    (5, 2)
    """
    if function is None:
        return lambda late: _named(late, "generator", name)
    _register(function, "generator", name)
    return function


def _named(function: Own, kind: str, name: str | None) -> Own:
    _register(function, kind, name)
    return function
