# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""raygauge: by how much must a convex set Q be scaled about the origin until it touches a convex set A?

>>> import raygauge as rg
>>> rg.distance([[2, 0], [4, -1], [4, 1]], rg.Ball([0, 0])).distance
2.0
"""

import copyreg
from typing import Any

from ._raygauge import (
    AffineImage,
    Ball,
    Box,
    Capsule,
    ContactPatch,
    ContactWrenches,
    ConvexSet,
    Counters,
    Cylinder,
    Depth,
    DimensionMismatchError,
    Distance,
    Distances,
    Ellipsoid,
    EmptySetError,
    Error,
    GraspQuality,
    HPolytope,
    HalfSpace,
    InvalidParameterError,
    Mesh,
    MinkowskiDifference,
    MinkowskiSum,
    NonFiniteError,
    ObjectDistance,
    ObjectDistances,
    PNormBall,
    PointSet,
    PoseGradient,
    PreparedSet,
    Separation,
    SeparationResult,
    Separations,
    Simplex,
    Status,
    SupportMappingSet,
    TruncatedCone,
    UnionHull,
    UnknownNameError,
    WarmStart,
    Zonotope,
    __version__,
    contact_patch,
    contains,
    distance,
    distances,
    gauge,
    gradient_moving_A,
    gradient_moving_Q,
    grasp_quality,
    growth_distance,
    object_distance,
    object_distances,
    origin_in_interior,
    separation,
    separations,
)
from . import plot
from .components import Answer, generator, method
from .edges import EdgeChecker, EdgeVerdict, prove_path
from .files import ResultsError, open
from .loading import Robot, SceneFile, load_robot, load_scene, load_set
from .planning import Plan, plan
from .scenes import Scene, SceneAnswers
from .simulation import Simulation, SimulationError, simulate
from .sweeps import ProgramError, run



def _by_name(function: Any) -> Any:
    """A compiled function is pickled by its name, as other functions are: multiprocessing can call it."""
    return function.__name__ if function.__module__ == f"{__name__}._raygauge" else function.__reduce_ex__(4)


copyreg.pickle(type(distance), _by_name)

__all__ = [
    "AffineImage",
    "Answer",
    "Ball",
    "Box",
    "Capsule",
    "ContactPatch",
    "ContactWrenches",
    "ConvexSet",
    "Counters",
    "Cylinder",
    "Depth",
    "DimensionMismatchError",
    "Distance",
    "Distances",
    "EdgeChecker",
    "EdgeVerdict",
    "Ellipsoid",
    "EmptySetError",
    "Error",
    "GraspQuality",
    "HPolytope",
    "HalfSpace",
    "InvalidParameterError",
    "Mesh",
    "MinkowskiDifference",
    "MinkowskiSum",
    "NonFiniteError",
    "ObjectDistance",
    "ObjectDistances",
    "PNormBall",
    "Plan",
    "PointSet",
    "PoseGradient",
    "PreparedSet",
    "ProgramError",
    "ResultsError",
    "Robot",
    "Scene",
    "SceneAnswers",
    "SceneFile",
    "Separation",
    "SeparationResult",
    "Separations",
    "Simplex",
    "Simulation",
    "SimulationError",
    "Status",
    "SupportMappingSet",
    "TruncatedCone",
    "UnionHull",
    "UnknownNameError",
    "WarmStart",
    "Zonotope",
    "__version__",
    "contact_patch",
    "contains",
    "distance",
    "distances",
    "gauge",
    "generator",
    "gradient_moving_A",
    "gradient_moving_Q",
    "grasp_quality",
    "growth_distance",
    "load_robot",
    "load_scene",
    "load_set",
    "method",
    "object_distance",
    "object_distances",
    "open",
    "origin_in_interior",
    "plan",
    "plot",
    "prove_path",
    "run",
    "separation",
    "separations",
    "simulate",
]
