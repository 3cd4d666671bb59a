# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Nothing is ignored: every key of scene, set and experiment files and every option of every command has an effect or is
refused. The program says itself which keys (its answer to an unknown one) and options (--help) there are: one that this
test does not know fails it.

    every_key_and_option.py --raygauge PROGRAM
"""
import argparse
import gzip
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SCENE = """name = "base"
description = "words"
[time]
to = 1
instants = 3
[[body]]
name = "a"
shape = { shape = "box", lower = [-1, -1, -1], upper = [1, 1, 1] }
motion = { spin = [0, 0, 1] }
[[body]]
name = "b"
file = "points.csv"
[[robot]]
name = "arm"
file = "arm.urdf"
group = "crew"
[[query]]
effects = ["separated", "distance"]
[[query]]
between = ["crew", "b"]
effects = ["distance"]
"""

MOVES = 'effects = ["clearance", "time_of_impact"]'
SEPARATED = 'effects = ["separated"]'
BALL = '{ shape = "ball", center = [0, 0, 0], radius = 2 }'
CUBE = '{ shape = "box", lower = [-1, -2, -1], upper = [2, 1, 1] }'

# Keys of a body that have no effect without [dynamics], and their other values where there is.
REACTION_KEYS = {"density": "density = 2", "mass": "mass = 3", "inertia": "mass = 2\ninertia = [1, 2, 3]",
                 "velocity": "mass = 2\nvelocity = [1, 0, 0]", "angular_velocity": "mass = 2\nangular_velocity = [1, 0, 0]"}
REACTING = """[time]
to = 0.5
instants = 3
[dynamics]
gravity = [0, 0, -9.81]
contact = { restitution = 0.5 }
[[body]]
name = "a"
shape = { shape = "box", lower = [-1, -1, -1], upper = [1, 1, 1] }
pose = { translation = [0.2, 0, 2.1], rpy = [0.1, 0.2, 0] }
mass = 2
angular_velocity = [0, 0, 1]
[[body]]
name = "b"
shape = { shape = "box", lower = [-9, -9, -1], upper = [9, 9, 0] }
"""

PAIRED = REACTING.replace("[[body]]", '[[dynamics.pair]]\nbetween = ["a", "b"]\nrestitution = 0.9\n[[body]]', 1)

# By table and key: the lines of the table in two files that must give different motions.
DYNAMICS_KEYS = {
    "dynamics": {"gravity": "gravity = [0, 0, -5]", "contact": "contact = { restitution = 0.5, friction = 0.5 }",
                 "damping": "damping = { linear = 1, angular = 2 }", "step": "step = 1e-2", "tolerance": "tolerance = 1e-3",
                 "overlap_at_start": 'overlap_at_start = "resolve"', "pair": "", "engine": 'engine = "bullet"'},
    "dynamics.pair": {"between": 'between = ["b", "b"]', "friction": "friction = 0.5", "restitution": "restitution = 1"},
}

# By table and key: the lines of the table in two files that must give different answers; a line takes the place of one
# with the same key.
SCENE_KEYS = {
    "": {"name": ("", 'name = "other"'), "description": ("", 'description = "other words"'),
         "dimension": ("", "dimension = 2"), "dynamics": ("", "dynamics = { step = 1 }"), "ignore": ("", 'ignore = [["a", "b"]]')},
    "time": {"from": ("", "from = 0.5"), "to": ("", "to = 2"), "instants": ("", "instants = 5")},
    "body": {"name": ("", 'name = "c"'), "group": ("", 'group = "crew"'), "shape": ("", "shape = " + BALL),
             "parts": ("", f"parts = [{BALL}]"), "file": ("", 'file = "points.csv"'), "as": ("", 'as = "hull"'),
             "scale": ("", "scale = 0.5"),
             "pose": ("", "pose = { translation = [0, 0, 1] }"), "motion": ("", "motion = { velocity = [1, 0, 0] }"),
             **{key: ("", lines) for key, lines in REACTION_KEYS.items()}},
    "robot": {"name": ("", 'name = "other"'), "file": ("", 'file = "other.urdf"'), "urdf": ("", 'urdf = "other.urdf"'), "as": ("", 'as = "hull"'),
              "base": ("", "base = { translation = [0, 1, 0] }"), "trajectory": ("", 'trajectory = "joints.csv"'),
              "group": ("", 'group = "a"'), "srdf": ("", 'srdf = "arm.srdf"')},
    "query": {"name": ("", 'name = "asked"'), "between": ("", 'between = ["a", "b"]'),
              "effects": ("", 'effects = ["distance"]'), "metric": ("", f"metric = {CUBE}"),
              "metric_body": (f"metric = {CUBE}", f'metric = {CUBE}\nmetric_body = "a"'), "within": ("", "within = 3"),
              "nearest": ("", "nearest = 1"), "tolerance": ("", "tolerance = 1e-3"),
              "contact": (MOVES, MOVES + "\ncontact = 0.5"),
              "clearance_tolerance": (MOVES, MOVES + "\nclearance_tolerance = 0.5"),
              "every_instant": (SEPARATED, SEPARATED + "\nevery_instant = true")},
}

# Keys that the effects of a query do not look at, by key.
WITHOUT_USE = {"contact": "contact = 1e-3", "clearance_tolerance": "clearance_tolerance = 1e-2",
               "every_instant": 'effects = ["distance"]\nevery_instant = true', "metric_body": 'metric_body = "a"'}

FILES = {
    "points.csv": "4 0 0\n5 0 0\n4 1 0\n4 0 1\n",
    "other.csv": "6 0 0\n5 0 0\n4 1 0\n4 0 1\n",
    "arm.urdf": '<robot name="r"><link name="u"><collision><geometry><sphere radius="1"/></geometry></collision></link>'
                '<link name="v"><collision><origin xyz="3 0 0"/><geometry><sphere radius="1"/></geometry></collision></link>'
                '<joint name="j" type="revolute"><origin xyz="0 0 9"/><parent link="u"/><child link="v"/><axis xyz="0 1 0"/>'
                '<limit lower="-1" upper="1"/></joint><link name="w"><collision><geometry><sphere radius="0.5"/></geometry>'
                '</collision></link><joint name="f" type="fixed"><origin xyz="0 0 3"/><parent link="v"/><child link="w"/>'
                "</joint></robot>",
    "arm.srdf": '<robot name="r"><disable_collisions link1="u" link2="w" reason="Never"/></robot>',
    "other.urdf": '<robot name="r"><link name="u"><collision><geometry><sphere radius="0.5"/></geometry></collision></link>'
                  "</robot>",
    "mesh.urdf": '<robot name="r"><link name="u"><collision><geometry><mesh filename="package://p/m.obj"/></geometry>'
                 '</collision><collision><geometry><sphere radius="1"/></geometry></collision></link></robot>',
    "m.obj": "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\n",
    "joints.csv": "time,j\n0,0.5\n1,0.7\n",
    "A.csv": "3 0.3 0.2\n4 1 0\n4 0 1\n",
    "headed.csv": "x,y,z\n3,0.3,0.2\n4,1,0\n4,0,1\n",
    "Q.csv": "1 1 1\n-1 0 0\n0 -1 0\n0 0 -1\n",
    "e.toml": 'name = "e"\n[sweep]\nn = [3, 4]\nN = [20, 30]\nrepetitions = 2\n[[generator]]\nname = "example2"\n'
              '[[method]]\nname = "column_generation"\n[[method]]\nname = "glpk_dual"\n[run]\nthreads = 1\n',
    "scene.toml": SCENE,
    "reacting.toml": REACTING,
}

# The parameters of each shape of a set file: a value, and one that makes another set.
SET = '{ shape = "box", lower = [1, 1, 1], upper = [2, 2, 2] }'
OTHER_SET = '{ shape = "box", lower = [1, 1, 1], upper = [2, 2, 3] }'
LOW, OTHER_LOW = ("[1.5, 1, 1]", "[1.25, 1, 1]")
SHAPES = {
    "point_set": {"points": ("[[3, 1, 1], [4, 1, 1]]", "[[2, 1, 1], [4, 1, 1]]")},
    "file": {"file": ('"points.csv"', '"other.csv"')},
    "ball": {"center": ("[3, 1, 1]", "[4, 1, 1]"), "radius": ("1", "0.5")},
    "ellipsoid": {"center": ("[3, 1, 1]", "[4, 1, 1]"), "factor": ("[[1, 0, 0], [0, 1, 0], [0, 0, 1]]",
                                                                  "[[0.5, 0, 0], [0, 1, 0], [0, 0, 1]]")},
    "p_norm_ball": {"center": ("[3, 1, 1]", "[4, 1, 1]"), "semi_axes": ("[1, 1, 1]", "[0.5, 1, 1]"), "p": ("3", "1.5")},
    "box": {"lower": (LOW, OTHER_LOW), "upper": ("[2, 1.5, 2]", "[2, 2, 2]")},
    "simplex": {"corner": ("[3, 1, 1]", "[4, 1, 1]"), "legs": ("[-1, 1, 1]", "[-1.5, 1, 1]")},
    "h_polytope": {"G": ("[[-1, 0, 0], [0, -1, 0], [0, 0, -1], [1, 1, 1]]", "[[-2, 0, 0], [0, -1, 0], [0, 0, -1], [1, 1, 1]]"),
                   "g": ("[-1, -1, -1, 5]", "[-2, -1, -1, 5]")},
    "mesh": {"file": ('"two.obj"', '"one.obj"'), "as": ('"surface"', '"hull"')},
    "cloud": {"file": ('"two.obj"', '"one.obj"'), "radius": ("0.5", "0.25")},
    "height_field": {"file": ('"Q.csv"', '"headless.csv"'), "spacing": ("1", "2"), "unit": ("1", "2"), "floor": ("-2.5", "-9")},
    "half_space": {"normal": ("[0, 0, 1]", "[0, 1, 1]"), "offset": ("1", "2")},
    "zonotope": {"center": ("[3, 1, 1]", "[4, 1, 1]"), "generators": ("[[1, 0, 0], [0, 1, 0]]", "[[0.5, 0, 0], [0, 1, 0]]")},
    "capsule": {"p": ("[3, 1, 1]", "[2.5, 1, 1]"), "q": ("[3, 1, 2]", "[2, 1, 2]"), "radius": ("0.5", "0.25")},
    "cylinder": {"p": ("[3, 1, 1]", "[2.5, 1, 1]"), "q": ("[3, 1, 2]", "[2, 1, 2]"), "radius": ("0.5", "0.25")},
    "truncated_cone": {"base": ("[3, 1, 1]", "[2.5, 1, 1]"), "base_radius": ("0.5", "0.25"),
                       "top": ("[3, 1, 2]", "[1, 1, 2]"), "top_radius": ("0.25", "0.5")},
    "contact_wrenches": {"p": ("[3, 1, 1]", "[3, 1, 2]"), "n": ("[1, 0, 0]", "[0, 1, 0]"), "mu": ("0.5", "0.25"),
                         "facets": ("4", "3")},
    "affine_image": {"S": (SET, OTHER_SET), "M": ("[[1, 0, 0], [0, 1, 0], [0, 0, -1]]", "[[1, 0, 0], [0, 1, 0], [0, 0, -2]]"),
                     "t": ("[0, 0, 4]", "[0, 0, 5]")},
    "rigid_image": {"S": (SET, OTHER_SET), "R": ("[[1, 0, 0], [0, -1, 0], [0, 0, -1]]", "[[0, -1, 0], [1, 0, 0], [0, 0, 1]]"),
                    "t": ("[0, 0, 4]", "[0, 0, 5]")},
    "minkowski_sum": {"A": (SET, SET.replace("[1,", "[0.5,")), "B": (SET, SET.replace("[1,", "[0.5,"))},
    "minkowski_difference": {"A2": (SET, SET.replace("1]", "1.5]", 1)), "A1": (BALL, BALL.replace("2 }", "0.5 }"))},
    "union_hull": {"sets": (f"[{SET}]", f"[{SET}, {BALL}]")},
}

# A plan: the outer rod has to get past a ball.
ROD = '<collision><origin rpy="0 1.5707963 0" xyz="0.5 0 0"/><geometry><cylinder length="1" radius="0.05"/></geometry></collision>'
FILES["rods.urdf"] = (
    f'<robot name="r"><link name="ground"/><link name="inner">{ROD}</link><link name="outer">{ROD}</link>'
    '<joint name="j" type="revolute"><parent link="ground"/><child link="inner"/><axis xyz="0 0 1"/>'
    '<limit lower="-2" upper="2"/></joint><joint name="k" type="revolute"><origin xyz="1 0 0"/><parent link="inner"/>'
    '<child link="outer"/><axis xyz="0 0 1"/><limit lower="-2.6" upper="2.6"/></joint></robot>')
FILES["rods.srdf"] = ('<robot name="r"><group name="tip"><joint name="k"/></group><group name="all"><joint name="j"/></group>'
                      '<group_state name="low" group="all"><joint name="j" value="-0.6"/></group_state></robot>')
PLAN = """[time]
to = 1
[[robot]]
name = "first"
urdf = "rods.urdf"
srdf = "rods.srdf"
[[robot]]
name = "second"
urdf = "rods.urdf"
base = { translation = [0, 0, 3] }
[[body]]
shape = { shape = "ball", center = [1.6, 0, 0], radius = 0.3 }
[[query]]
effects = ["distance"]
[plan]
robot = "first"
start = { j = -0.8 }
goal = { j = 0.8 }
"""
PLAN_KEYS = {"robot": 'robot = "second"', "group": 'group = "tip"', "start": "start = { j = -0.7 }", "goal": "goal = { j = 0.7, k = 0.3 }",
             "planner": 'planner = "rrt"', "margin": "margin = 0.1", "time_limit": "time_limit = 1e-9", "seed": "seed = 2"}

# For each table of an experiment file: values of another type than its keys have.
EXPERIMENT_KEYS = {
    "": {"name", "description", "sweep", "generator", "method", "run"},
    "sweep": {"n", "N", "tolerance", "grid", "repetitions", "min_repetitions", "stop_when_within", "seed"},
    "run": {"threads", "timing", "pin_threads", "warmup", "min_seconds", "time_limit", "shuffle"},
}

RUN, SCENE_RUN = ["run", "e.toml", "-o", "x.h5"], ["scene", "run", "scene.toml", "-o", "x.h5"]
COLLISIONS = ["scene", "collisions", "arm.urdf"]
SCENE_PLAN = ["scene", "plan", "plan.toml", "-o", "x.h5"]
DISTANCE = ["distance", "A.csv", "Q.csv"]
RERUN = ["compare", "--rerun", "e.toml", "--set", "sweep.n=3", "--set", "sweep.N=20", "--pairs", "1"]
SUBMIT = ["submit", "e.toml", "-o", "x.h5", "--slurm", "--array", "2", "--print"]
NO_EFFECT = 2  # the exit status of what is refused


def kept(name):
    return lambda test, done: test.assertTrue((test.work / name).exists(), done.stderr)


def says(pattern):
    return lambda test, done: test.assertRegex(done.stdout + done.stderr, pattern)


def silent(test, done):
    test.assertEqual(done.stdout + done.stderr, "")


# By command and option: arguments with the option, the exit status, and what shows the effect.
OPTIONS = {
    "run": {
        "--output": (RUN, 0, kept("x.h5")),
        "--set": (RUN + ["--set", "sweep.repetitions=3"], 0, says("24 records")),
        "--threads": (RUN + ["--threads", "3"], 0, says("3 threads")),
        "--stop-when-within": (RUN + ["--stop-when-within", "2"], NO_EFFECT, says("stop_when_within")),
        "--shard": (RUN + ["--shard", "1/2"], 0, kept("x.shard-1-of-2.h5")),
        "--resume": (["run", "e.toml", "-o", "e.h5", "--resume"], 0, says("complete|nothing|already|done")),
        "--force": (["run", "e.toml", "-o", "copy.h5", "--force"], 0, says("records")),
        "--dry-run": (RUN + ["--dry-run"], 0, says("8 cells|cells")),
        "--ranks": (RUN + ["--ranks", "2"], NO_EFFECT, says("--dry-run")),
        "--times": (RUN + ["--dry-run", "--times", "e.h5"], NO_EFFECT, says("--ranks")),
        "--quiet": (RUN + ["--quiet"], 0, silent),
        "--max-input": (["run", "packed.toml", "-o", "x.h5", "--max-input", "1"], NO_EFFECT, says("--max-input")),
    },
    "scene run": {
        "--set": (SCENE_RUN + ["--set", 'name="set"'], 0, says("set: ")),
        "--package": (["scene", "run", "mesh.toml", "-o", "x.h5", "--package", "p=."], 0, kept("x.h5")),
        "--skip-missing-meshes": (["scene", "run", "mesh.toml", "-o", "x.h5", "--skip-missing-meshes"], 0,
                                  says("note: robot 'r': left out, for they are missing: package://p/m.obj of link 'u'")),
        "--output": (SCENE_RUN, 0, kept("x.h5")),
        "--threads": (SCENE_RUN + ["--threads", "3"], 0, says("on 3 threads")),
        "--shard": (SCENE_RUN + ["--shard", "1/1"], 0, kept("x.shard-1-of-1.h5")),
        "--resume": (["scene", "run", "scene.toml", "-o", "s.h5", "--resume"], 0, says("0 cells")),
        "--force": (["scene", "run", "scene.toml", "-o", "scene_copy.h5", "--force"], 0, says("records")),
        "--quiet": (SCENE_RUN + ["--quiet"], 0, silent),
        "--max-input": (["scene", "run", "large.toml", "-o", "x.h5", "--max-input", "1"], NO_EFFECT, says("--max-input")),
    },
    "scene explain": {
        "--set": (["scene", "explain", "scene.toml", "--set", 'name="set"'], 0, says("^set: ")),
        "--package": (["scene", "explain", "mesh.toml", "--package", "p=."], 0, says("mesh: ")),
        "--skip-missing-meshes": (["scene", "explain", "mesh.toml", "--skip-missing-meshes"], 0, says("note: ")),
        "--json": (["scene", "explain", "scene.toml", "--json"], 0, says('^{"scene"|^{')),
        "--max-input": (["scene", "explain", "large.toml", "--max-input", "1"], NO_EFFECT, says("--max-input")),
    },
    "scene plan": {
        "--set": (SCENE_PLAN + ["--set", 'name="set"'], 0, says("set: ")),
        "--package": (["scene", "plan", "mesh.toml", "-o", "x.h5", "--package", "p=."], NO_EFFECT, says("no \\[plan\\]")),
        "--skip-missing-meshes": (["scene", "plan", "mesh.toml", "-o", "x.h5", "--skip-missing-meshes"], NO_EFFECT,
                                  says("no \\[plan\\]")),
        "--output": (SCENE_PLAN, 0, kept("x.path.csv")),
        "--planner": (SCENE_PLAN + ["--planner", "est"], 0, says("found by est")),
        "--time-limit": (SCENE_PLAN + ["--time-limit", "1e-9"], 3, says("no path was found")),
        "--seed": (SCENE_PLAN + ["--seed", "0"], NO_EFFECT, says("the seed of a plan must be")),
        "--threads": (SCENE_PLAN + ["--threads", "3"], 0, says("on 3 threads")),
        "--force": (["scene", "plan", "plan.toml", "-o", "plan_copy.h5", "--force"], 0, says("records")),
        "--quiet": (SCENE_PLAN + ["--quiet"], 0, silent),
        "--max-input": (["scene", "plan", "large.toml", "-o", "x.h5", "--max-input", "1"], NO_EFFECT, says("--max-input")),
    },
    "scene simulate": {
        "--output": (["scene", "simulate", "reacting.toml", "-o", "x.h5"], 0, kept("x.h5")),
        "--set": (["scene", "simulate", "reacting.toml", "-o", "x.h5", "--set", 'name="set"'], 0, says("^set: ")),
        "--package": (["scene", "simulate", "reacting.toml", "--package", "p"], NO_EFFECT, says("NAME=FOLDER")),
        "--skip-missing-meshes": (["scene", "simulate", "meshes.toml", "-o", "x.h5", "--skip-missing-meshes"], 0, says("note: ")),
        "--step": (["scene", "simulate", "reacting.toml", "-o", "x.h5", "--step", "0.25"], 0, says("2 steps")),
        "--tolerance": (["scene", "simulate", "reacting.toml", "-o", "x.h5", "--tolerance", "2"], NO_EFFECT, says("tolerance")),
        "--engine": (["scene", "simulate", "reacting.toml", "-o", "x.h5", "--engine", "havok"], NO_EFFECT, says("raygauge, bullet")),
        "--threads": (["scene", "simulate", "reacting.toml", "-o", "x.h5", "--threads", "-1"], NO_EFFECT, says("--threads")),
        "--force": (["scene", "simulate", "reacting.toml", "-o", "moved.h5", "--force"], 0, says("500 steps")),
        "--resume": (["scene", "simulate", "reacting.toml", "-o", "moved.h5", "--resume"], 0, says("500 steps")),
        "--quiet": (["scene", "simulate", "reacting.toml", "-o", "x.h5", "--quiet"], 0, silent),
        "--max-input": (["scene", "simulate", "heavy.toml", "--max-input", "1"], NO_EFFECT, says("--max-input")),
    },
    "scene collisions": {
        "--srdf": (COLLISIONS + ["--srdf", "x.srdf"], 0, kept("x.srdf")),
        "--compare": (COLLISIONS + ["--compare", "arm.srdf"], 0, says("differs|0 always")),
        "--journal": (COLLISIONS + ["--journal", "x.jsonl"], 0, kept("x.jsonl")),
        "--boxes": (COLLISIONS + ["--boxes", "0"], NO_EFFECT, says("--boxes")),
        "--threads": (COLLISIONS + ["--threads", "-1"], NO_EFFECT, says("--threads")),
        "--package": (["scene", "collisions", "arm.urdf", "--package", "p"], NO_EFFECT, says("NAME=FOLDER")),
        "--skip-missing-meshes": (["scene", "collisions", "mesh.urdf", "--skip-missing-meshes"], NO_EFFECT,
                                  says("fewer than two links")),
        "--as": (COLLISIONS + ["--as", "hull"], NO_EFFECT, says("has none")),
        "--force": (COLLISIONS + ["--srdf", "taken.svg", "--force"], 0, says("never")),
        "--json": (COLLISIONS + ["--json"], 0, says("^{")),
        "--max-input": (["scene", "collisions", "arm.urdf", "--max-input", "0"], NO_EFFECT, says("--max-input")),
    },
    "distance": {
        "--tolerance": (DISTANCE + ["--tolerance", "1e-3"], 0, says("tolerance 0.001|tolerance 1e-3")),
        "--method": (DISTANCE + ["--method", "zheng_yamane"], 0, says("zheng_yamane")),
        "--skip-header": (["distance", "headed.csv", "Q.csv", "--skip-header"], 0, says("distance")),
        "--witness": (DISTANCE + ["--witness"], 0, says("contact")),
        "--json": (DISTANCE + ["--json"], 0, says("^{")),
        "--max-iterations": (DISTANCE + ["--max-iterations", "1"], 3, says("iteration_limit")),
        "--time-limit": (DISTANCE + ["--time-limit", "-1"], NO_EFFECT, says("time-limit")),
        "--stop-rule": (DISTANCE + ["--stop-rule", "published_sigma"], NO_EFFECT, says("published_sigma")),
        "--instruction-set": (DISTANCE + ["--instruction-set", "none"], NO_EFFECT, says("instruction set")),
        "--threads": (DISTANCE + ["--threads", "2", "--method", "glpk_dual"], NO_EFFECT, says("--threads")),
        "--between": (DISTANCE + ["--between"], 0, says("distance")),
        "--metric": (DISTANCE + ["--metric", "Q.csv"], NO_EFFECT, says("--between")),
        "--signed": (DISTANCE + ["--signed"], NO_EFFECT, says("--between")),
        "--max-input": (["distance", "large.csv.gz", "Q.csv", "--max-input", "1"], NO_EFFECT, says("--max-input")),
    },
    "table": {
        "--where": (["table", "e.h5", "--rows", "n", "--where", "n==3"], 0, says(r"glpk_dual +3 +\S+\n\n")),
        "--paper": (["table", "e.h5", "--paper", "table3"], 0, says("(?i)table")),
        "--stability": (["table", "e.h5", "--stability"], 0, says("glpk_dual")),
        "--accuracy": (["table", "e.h5", "--accuracy"], 0, says("glpk_dual")),
        "--wrong": (["table", "e.h5", "--wrong"], NO_EFFECT, says("bodies")),
        "--rows": (["table", "e.h5", "--rows", "N"], 0, says("N ")),
        "--cols": (["table", "e.h5", "--cols", "method"], 0, says("glpk_dual")),
        "--value": (["table", "e.h5", "--rows", "n", "--value", "count"], 0, says("8")),
        "--intervals": (["table", "e.h5", "--rows", "n", "--intervals"], 0, says("\\[|95")),
        "--baseline": (["table", "e.h5", "--rows", "n", "--value", "median ratio", "--baseline", "nobody"], NO_EFFECT,
                       says("nobody")),
        "--format": (["table", "e.h5", "--rows", "n", "--format", "markdown"], 0, says("\\|")),
        "--output": (["table", "e.h5", "--rows", "n", "-o", "x.txt"], 0, kept("x.txt")),
        "--force": (["table", "e.h5", "--rows", "n", "-o", "A.csv", "--format", "text", "--force"], 0, silent),
    },
    "plot": {
        "--where": (["plot", "e.h5", "--figure", "fig5", "-o", "x.svg", "--where", "n>99"], NO_EFFECT, says("n>99|no record")),
        "--figure": (["plot", "e.h5", "--figure", "nothing", "-o", "x.svg"], NO_EFFECT, says("unknown figure")),
        "--output": (["plot", "s.h5", "-o", "x.svg"], 0, kept("x.svg")),
        "--size": (["plot", "s.h5", "-o", "x.svg", "--size", "huge"], NO_EFFECT, says("huge")),
        "--baseline": (["plot", "e.h5", "--figure", "ratio_heatmap", "-o", "x.svg", "--baseline", "nobody"], NO_EFFECT,
                       says("nobody")),
        "--force": (["plot", "s.h5", "-o", "taken.svg", "--force"], 0, kept("taken.svg")),
    },
    "export": {
        "--where": (["export", "e.h5", "--csv", "-", "--where", "n==77"], NO_EFFECT, says("n==77")),
        "--csv": (["export", "e.h5", "--csv", "x.csv"], 0, kept("x.csv")),
        "--refutations": (["export", "e.h5", "--refutations", "-"], NO_EFFECT, says("bodies")),
        "--tidy": (["export", "e.h5", "--csv", "-", "--tidy"], 0, says("separation")),
        "--force": (["export", "e.h5", "--csv", "taken.svg", "--force"], 0, silent),
        "--contacts": (["export", "moved.h5", "--csv", "-", "--contacts"], 0, says("^step,time,body_a")),
        "--steps": (["export", "moved.h5", "--csv", "-", "--steps"], 0, says("^time,substeps")),
        "--simulations": (["export", "moved.h5", "--csv", "-", "--simulations"], 0, says("^step,tolerance,delta")),
        "--answers": (["export", "moved.h5", "--csv", "-", "--answers"], 0, says("^cell,session")),
    },
    "compare": {
        "--base": (["compare", "--base", "e.h5"], NO_EFFECT, says("--new")),
        "--new": (["compare", "--new", "e.h5"], NO_EFFECT, says("--base")),
        "--rerun": (["compare", "--rerun", "e.toml"], NO_EFFECT, says("program")),
        "--base-program": (["compare", "e.h5", "copy.h5", "--base-program", "p"], NO_EFFECT, says("--rerun")),
        "--new-program": (["compare", "e.h5", "copy.h5", "--new-program", "p"], NO_EFFECT, says("--rerun")),
        "--pairs": (["compare", "e.h5", "copy.h5", "--pairs", "6"], NO_EFFECT, says("--rerun")),
        "--set": (["compare", "e.h5", "copy.h5", "--set", "sweep.n=3"], NO_EFFECT, says("--rerun")),
        "--where": (["compare", "e.h5", "copy.h5", "--where", "n>99"], NO_EFFECT, says("n>99|no record|no cell")),
        "--threshold": (["compare", "e.h5", "copy.h5", "--threshold", "-1"], NO_EFFECT, says("threshold")),
        "--significance": (["compare", "e.h5", "copy.h5", "--significance", "2"], NO_EFFECT, says("significance")),
        "--all": (["compare", "e.h5", "copy.h5", "--all", "--json"], NO_EFFECT, says("--all")),
        "--format": (["compare", "e.h5", "copy.h5", "--format", "csv"], 0, says(",")),
        "--quiet": (["compare", "e.h5", "copy.h5", "--quiet"], NO_EFFECT, says("--rerun")),
        "--json": (["compare", "e.h5", "copy.h5", "--json"], 0, says("^{")),
    },
    "report": {
        "--where": (["report", "e.h5", "-o", "x.html", "--where", "n>"], NO_EFFECT, says("n>")),
        "--output": (["report", "e.h5", "-o", "x.html"], 0, kept("x.html")),
        "--baseline": (["report", "e.h5", "-o", "x.html", "--baseline", "nobody"], NO_EFFECT, says("nobody")),
        "--force": (["report", "e.h5", "-o", "taken.svg", "--force"], 0, kept("taken.svg")),
    },
    "info": {"--json": (["info", "e.h5", "--json"], 0, says("^{"))},
    "merge": {
        "--output": (["merge", "p.shard-1-of-2.h5", "p.shard-2-of-2.h5", "-o", "x.h5"], 0, kept("x.h5")),
        "--partial": (["merge", "p.shard-1-of-2.h5", "-o", "x.h5", "--partial"], 0, kept("x.h5")),
        "--mixed-builds": (["merge", "p.shard-1-of-2.h5", "p.shard-2-of-2.h5", "-o", "x.h5", "--mixed-builds"], 0, kept("x.h5")),
        "--quiet": (["merge", "p.shard-1-of-2.h5", "p.shard-2-of-2.h5", "-o", "x.h5", "--quiet"], 0, silent),
    },
    "submit": {
        "--output": (SUBMIT, 0, says("x.h5")),
        "--slurm": (["submit", "e.toml", "--array", "2", "--print"], NO_EFFECT, says("--slurm")),
        "--array": (SUBMIT, 0, says("--array=.*2")),
        "--time": (SUBMIT + ["--time", "7:00"], 0, says("7:00")),
        "--partition": (SUBMIT + ["--partition", "fast"], 0, says("fast")),
        "--account": (SUBMIT + ["--account", "mine"], 0, says("mine")),
        "--cpus-per-task": (SUBMIT + ["--cpus-per-task", "7"], 0, says("cpus-per-task=7")),
        "--set": (SUBMIT + ["--set", "sweep.n=3"], 0, says("sweep.n=3")),
        "--print": (SUBMIT, 0, says("SBATCH")),
    },
}

# Options for the records of sweeps, given for those of a scene.
OF_SWEEPS_ALONE = [
    ["table", "s.h5", "--paper", "table3"], ["table", "s.h5", "--stability"], ["table", "s.h5", "--accuracy"],
    ["table", "s.h5", "--wrong"],
    ["table", "s.h5", "--rows", "n"], ["table", "s.h5", "--cols", "n"], ["table", "s.h5", "--value", "count"],
    ["table", "s.h5", "--intervals"], ["table", "s.h5", "--baseline", "glpk"], ["table", "s.h5", "--format", "csv"],
    ["table", "s.h5", "--where", "n==3"], ["plot", "s.h5", "-o", "x.svg", "--baseline", "glpk"],
    ["plot", "s.h5", "-o", "x.svg", "--where", "n==3"], ["export", "s.h5", "--csv", "-", "--tidy"],
    ["export", "s.h5", "--csv", "-", "--where", "n==3"], ["report", "s.h5", "-o", "x.html", "--baseline", "glpk"],
    ["report", "s.h5", "-o", "x.html", "--where", "n==3"],
]


def with_lines(text, table, lines):
    """The text with lines in the first table of that name, each instead of one with its key."""
    rows = text.splitlines()
    start = 0
    if table:
        start = next(i for i, row in enumerate(rows) if row.strip("[]") == table) + 1
    for line in filter(None, lines.splitlines()):
        end = next((i for i in range(start, len(rows)) if rows[i].startswith("[")), len(rows))
        key = line.split("=")[0].strip()
        rows[start:end] = [row for row in rows[start:end] if row.split("=")[0].strip() != key] + [line]
    return "\n".join(rows) + "\n"


class NothingIsIgnored(unittest.TestCase):
    raygauge = None

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.base = pathlib.Path(cls.folder.name)
        for name, text in FILES.items():
            (cls.base / name).write_text(text)
        (cls.base / "meshes.toml").write_text(REACTING + '[[robot]]\nurdf = "mesh.urdf"\nbase = { translation = [99, 0, 0] }\n')
        (cls.base / "mesh.toml").write_text('[[robot]]\nurdf = "mesh.urdf"\n[[body]]\nfile = "points.csv"\n[[query]]\n'
                                            'effects = ["distance"]\n')
        for command in (["run", "e.toml", "-o", "e.h5"], ["run", "e.toml", "-o", "p.h5", "--shard", "1/2"], ["run", "e.toml", "-o", "p.h5", "--shard", "2/2"],
                        ["scene", "simulate", "reacting.toml", "-o", "moved.h5"], ["scene", "run", "scene.toml", "-o", "s.h5"], ["scene", "run", "scene.toml", "-o", "scene_copy.h5"]):
            subprocess.run([cls.raygauge, *command], cwd=cls.base, check=True, capture_output=True)
        shutil.copy(cls.base / "e.h5", cls.base / "copy.h5")  # what `compare` finds no regression in, whatever the machine does
        (cls.base / "plan.toml").write_text(PLAN)
        planned = subprocess.run([cls.raygauge, "scene", "plan", "plan.toml", "-o", "plan_copy.h5"], cwd=cls.base,
                                 capture_output=True, text=True)
        cls.has_planners = "libompl-dev" not in planned.stderr
        (cls.base / "taken.svg").write_text("of somebody else")
        with gzip.open(cls.base / "large.csv.gz", "wt") as file:
            file.write("2 1 1\n" * 200000)
        (cls.base / "large.toml").write_text('[[body]]\nfile = "large.csv.gz"\n[[body]]\nfile = "points.csv"\n'
                                             '[[query]]\neffects = ["distance"]\n')
        (cls.base / "heavy.toml").write_text('[[body]]\nfile = "large.csv.gz"\n' + REACTING)
        (cls.base / "packed.toml").write_text('[sweep]\nn = 3\nN = 4\n[[generator]]\nname = "files"\n'
                                              'A = "large.csv.gz"\nQ = "Q.csv"\n[[method]]\nname = "column_generation"\n')

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def setUp(self):
        self.work = self.base

    def run_raygauge(self, *arguments):
        return subprocess.run([self.raygauge, *arguments], cwd=self.work, capture_output=True, text=True)

    def answers(self, text):
        """What a scene's file shows of it, but for its text, times and who ran it."""
        (self.work / "changed.toml").write_text(text)
        plan = self.run_raygauge("scene", "explain", "changed.toml", "--json")
        if plan.returncode != 0:
            return plan.stderr
        self.run_raygauge("scene", "run", "changed.toml", "-q", "-o", "changed.h5", "--force")
        rows = self.run_raygauge("export", "changed.h5", "--csv", "-").stdout.splitlines()
        names = rows[0].split(",")
        kept_columns = [i for i, name in enumerate(names) if name not in ("session", "seconds")]
        records = [[row.split(",")[i] for i in kept_columns] for row in rows]
        dump = subprocess.run(["h5dump", "-g", "/queries", "-g", "/bodies", "changed.h5"], cwd=self.work,
                              capture_output=True, text=True).stdout
        whole = subprocess.run(["h5dump", "changed.h5"], cwd=self.work, capture_output=True, text=True).stdout
        return plan.stdout, records, dump, "other words" in whole, re.findall(r"clearance_tolerance [0-9.e-]+", whole)

    def known_keys(self, text, table, command):
        (self.work / "unknown.toml").write_text(with_lines(text, table, "zzz = 1"))
        message = self.run_raygauge(*command, "unknown.toml").stderr
        self.assertIn("'zzz'", message)
        return set(re.search(r"\(known: (.*)\)", message).group(1).split())

    def test_every_key_of_a_scene_file_changes_the_answers_or_is_refused(self):
        for table, keys in SCENE_KEYS.items():
            known = self.known_keys(SCENE, table, ["scene", "explain"])
            self.assertEqual(known - {"time", "body", "robot", "plan", "query"}, set(keys), f"keys of [{table}]")
            for key, (one, other) in keys.items():
                with self.subTest(table=table, key=key):
                    self.assertNotEqual(self.answers(with_lines(SCENE, table, one)),
                                        self.answers(with_lines(SCENE, table, other)))
        self.assertRegex(self.answers(with_lines(SCENE, "body", "scale = 0")), "scale must not be 0")

    def planned(self, text):
        """The path of a scene, or why there is none."""
        (self.work / "changed.toml").write_text(text)
        done = self.run_raygauge("scene", "plan", "changed.toml", "-q", "-o", "changed.h5", "--force")
        return (self.work / "changed.path.csv").read_text() if done.returncode == 0 else done.stderr

    def test_every_key_of_a_plan_changes_the_path_or_is_refused(self):
        if not self.has_planners:
            self.skipTest("the program is built without OMPL")
        self.assertEqual(self.known_keys(PLAN, "plan", ["scene", "explain"]), set(PLAN_KEYS))
        base = self.planned(PLAN)
        self.assertRegex(base, r"^time,j,k\n0,-0\.8")
        self.assertEqual(base, self.planned(PLAN))
        for key, line in PLAN_KEYS.items():
            with self.subTest(key):
                self.assertNotEqual(base, self.planned(with_lines(PLAN, "plan", line)))

    def motions(self, text):
        """Where the bodies of a simulation are, and its steps, or why there is none."""
        (self.work / "moving.toml").write_text(text)
        done = self.run_raygauge("scene", "simulate", "moving.toml", "-q", "-o", "moving.h5", "--force")
        if done.returncode != 0:
            return done.stderr
        return [self.run_raygauge("export", "moving.h5", "--csv", "-", *table).stdout for table in ([], ["--steps"])]

    def test_every_key_of_dynamics_changes_the_motion_or_is_refused(self):
        usual = self.motions(REACTING)
        paired = self.motions(PAIRED)
        self.assertNotEqual(usual, paired)
        for table, keys in DYNAMICS_KEYS.items():
            text, before = (PAIRED, paired) if table == "dynamics.pair" else (REACTING, usual)
            self.assertIsInstance(before, list, before)
            self.assertEqual(self.known_keys(text, table, ["scene", "simulate"]), set(keys))
            for key, lines in keys.items():
                if key == "pair":
                    continue
                with self.subTest(table=table, key=key):
                    if key == "overlap_at_start":
                        deeper = text.replace("2.1]", "0.9]")
                        self.assertIn("overlap at the start", self.motions(deeper))
                        self.assertIsInstance(self.motions(with_lines(deeper, table, lines)), list)
                        continue
                    self.assertNotEqual(before, self.motions(with_lines(text, table, lines)))
        for lines in REACTION_KEYS.values():
            with self.subTest(lines):
                changed = REACTING.replace("mass = 2\n", "") if lines.startswith("density") else REACTING
                self.assertNotEqual(usual, self.motions(with_lines(changed, "body", lines)))
        for key in REACTION_KEYS:
            self.assertRegex(self.answers(with_lines(SCENE, "body", REACTION_KEYS[key])), "has no effect without")

    def test_a_key_that_no_effect_looks_at_is_refused(self):
        for key, lines in WITHOUT_USE.items():
            with self.subTest(key):
                self.assertRegex(self.answers(with_lines(SCENE, "query", lines)), key)

    def test_every_parameter_of_every_shape_changes_the_set(self):
        listing = self.run_raygauge("distance", "--help").stdout
        shapes = dict(re.findall(r"(?m)^  ([a-z_]+) {2,}([A-Za-z_0-9, ]+?) {2,}\S", listing.split("tells more):")[1]))
        self.assertEqual({name: set(names.split(", ")) for name, names in shapes.items()},
                         {name: set(keys) for name, keys in SHAPES.items()})
        (self.work / "ball3.toml").write_text('shape = "ball"\ncenter = [0.1, 0, 0]\nradius = 1\n')
        (self.work / "ball6.toml").write_text('shape = "ball"\ncenter = [0.1, 0, 0, 0, 0, 0]\nradius = 1\n')
        triangles = ["v 10 10 0\nv 10 12 0\nv 12 10 1\n", "v 10 -10 0\nv 10 -12 0\nv 12 -10 1\n"]
        (self.work / "headless.csv").write_text("7 7 7\n-1 0 0\n0 -1 0\n0 0 -1\n")
        (self.work / "one.obj").write_text(triangles[0] + "f 1 2 3\n")
        (self.work / "two.obj").write_text("".join(triangles) + "f 1 2 3\nf 4 5 6\n")
        for shape, keys in SHAPES.items():
            values = {key: one for key, (one, _) in keys.items()}
            for key, (_, other) in keys.items():
                with self.subTest(shape=shape, key=key):
                    self.assertNotEqual(self.support(shape, values), self.support(shape, {**values, key: other}))

    def support(self, shape, values):
        """The distances from 0 to the set moved in several ways: another set gives others."""
        n = 6 if shape == "contact_wrenches" else 3
        (self.work / "set.toml").write_text(f'shape = "{shape}"\n' + "".join(f"{k} = {v}\n" for k, v in values.items()))
        distances = []
        for shift in ([40] * n, [-40] * n, [40] + [0] * (n - 1), [-40] + [0] * (n - 1), [0] * (n - 1) + [40], [0, 40] + [0] * (n - 2)):
            (self.work / "moved.toml").write_text(
                f'shape = "minkowski_sum"\nA = {{ shape = "file", file = "set.toml" }}\n'
                f'B = {{ shape = "point_set", points = [{shift}] }}\n')
            if shape in ("half_space", "mesh", "cloud", "height_field"):  # take no sums
                (self.work / "moved.toml").write_text(f'shape = "ball"\ncenter = {shift}\nradius = 1\n')
                operands = ["set.toml", "moved.toml", "--between"] + ["--signed"] * (shape == "half_space")
            else:
                operands = ["moved.toml", f"ball{n}.toml"]
            done = self.run_raygauge("distance", *operands, "--json", "--tolerance", "1e-9")
            self.assertEqual(done.returncode, 0, done.stderr)
            distances.append(f"{json.loads(done.stdout)['distance']:.6g}")
        return distances

    def test_every_key_of_an_experiment_file_is_looked_at(self):
        for table, keys in EXPERIMENT_KEYS.items():
            self.assertEqual(self.known_keys(FILES["e.toml"], table, ["run", "--dry-run"]), keys, f"keys of [{table}]")
            for key in keys - {"sweep", "generator", "method", "run"}:
                with self.subTest(table=table, key=key):
                    (self.work / "wrong.toml").write_text(with_lines(FILES["e.toml"], table, f"{key} = 1979-05-27"))
                    done = self.run_raygauge("run", "--dry-run", "wrong.toml")
                    self.assertEqual(done.returncode, 2)
                    self.assertRegex(done.stderr, f"wrong.toml:[0-9]+: .*{key}")

    def test_every_option_has_an_effect_or_is_refused(self):
        for command, options in OPTIONS.items():
            text = self.run_raygauge(*command.split(), "--help").stdout
            known = set(re.findall(r"(?m)^ +(?:-[a-zA-Z],)?(--[a-z-]+)", text)) - {"--help"}
            self.assertEqual(known, set(options), f"options of {command}")
            if command == "scene plan" and not self.has_planners:
                continue
            for option, (arguments, status, shown) in options.items():
                with self.subTest(command=command, option=option):
                    for left in ("x.h5", "x.svg", "x.html", "x.csv", "x.txt", "x.shard-1-of-2.h5", "x.shard-1-of-1.h5", "x.path.csv", "x.srdf"):
                        (self.work / left).unlink(missing_ok=True)
                    done = self.run_raygauge(*arguments)
                    self.assertEqual(done.returncode, status, done.stdout + done.stderr)
                    shown(self, done)

    def test_options_for_records_of_sweeps_are_refused_for_those_of_a_scene(self):
        for arguments in OF_SWEEPS_ALONE:
            with self.subTest(arguments):
                done = self.run_raygauge(*arguments)
                self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
                option = next(word for word in reversed(arguments) if word.startswith("--") and word != "--csv")
                self.assertIn(option, done.stderr)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--raygauge", required=True)
    arguments, rest = parser.parse_known_args()
    NothingIsIgnored.raygauge = str(pathlib.Path(arguments.raygauge).resolve())
    unittest.main(argv=[sys.argv[0], *rest])
