# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Files that were misread once (tests/cli/reports), with their right answers, and what robots are told of.

    reported_files.py --raygauge PROGRAM --reports FOLDER
"""
import argparse
import csv
import io
import json
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

# Answers by hand: the vertex of least 1-norm; the top of the mesh is at 5, the ball of radius 1 at 10; 3 - 1 - 0.5.
DISTANCES = {"lone_vertex.obj": 3, "two_points.obj": 3, "byte_order_mark.obj": 2, "header_with_counts.off": 2}
SCENES = {"z_up.toml": 4, "scale.toml": 1.5}

# By scene, and query, or body or effect: columns and their right values: in closed form, or in rational numbers.
ANSWERS = {
    "stale.toml": {"segment": {"status": "separated", "lower": 1.06245e-13, "upper": 1.06245e-13}},
    "rest.toml": {"time_of_impact": {"status": "contact"}, "clearance": {"status": "intersecting"}},
    "rest_large.toml": {"time_of_impact": {"status": "contact"}, "clearance": {"status": "intersecting"}},
    "teleport_clearance.toml": {"clearance": {"status": "intersecting", "upper": 0}},
    "inside.toml": {"far": {"status": "intersecting"}, "yesno": {"status": "intersecting"}, "clear": {"status": "intersecting"},
                    "growth": {"growth_lower": 1 / 6, "growth_upper": 1 / 6}},
    "flat.toml": {"query1": {"status": "intersecting", "growth_lower": 0.5, "growth_upper": 0.5}},
    "rotation_8_digits.toml": {"query1": {"lower": 4 - 2 ** 0.5, "upper": 4 - 2 ** 0.5}},
}
# The origin is in A, whatever is asked and by which method.
ORIGIN = [("octahedra.toml", "unit_ball.toml"), ("origin_in_face.csv", "unit_ball.toml"), ("fibonacci_A.csv", "fibonacci_Q.csv")]
METHODS = ["automatic", "column_generation", "newton", "zheng_yamane"]

ARM = ('<robot name="r">'
       '<link name="a"><collision><geometry><sphere radius="1"/></geometry></collision></link>'
       '<link name="b"><collision><origin xyz="5 0 0"/><geometry><sphere radius="1"/></geometry></collision></link>'
       '<link name="c"><collision><origin xyz="-3.5 0 0"/><geometry><sphere radius="1"/></geometry></collision></link>'
       '<link name="d"><collision><geometry><mesh filename="gone.stl"/></geometry></collision></link>'
       '<joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="1 0 0"/>'
       '<limit lower="-1" upper="2"/></joint>'
       '<joint name="k" type="revolute"><origin xyz="5 0 0"/><parent link="b"/><child link="c"/><axis xyz="1 0 0"/></joint>'
       '<joint name="l" type="fixed"><parent link="a"/><child link="d"/></joint></robot>')
SCENE = ('[time]\nto = 1\n[[robot]]\nurdf = "arm.urdf"\ntrajectory = "joints.csv"\n[[query]]\neffects = ["distance"]\n')


class ReportedFiles(unittest.TestCase):
    raygauge = None
    reports = None

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.work = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def run_raygauge(self, *arguments, status=0):
        done = subprocess.run([self.raygauge, *map(str, arguments)], cwd=self.work, capture_output=True, text=True)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def test_meshes_give_the_distances_of_all_their_vertices(self):
        for name, distance in DISTANCES.items():
            with self.subTest(name):
                done = self.run_raygauge("distance", self.reports / name, self.reports / "cross_polytope.csv", "--json")
                self.assertAlmostEqual(json.loads(done.stdout)["distance"], distance, 12)

    def test_scenes_give_the_distances_of_what_their_files_say(self):
        for name, distance in SCENES.items():
            with self.subTest(name):
                results = self.work / (name + ".h5")
                self.run_raygauge("scene", "run", self.reports / name, "-q", "-o", results)
                row = next(csv.DictReader(io.StringIO(self.run_raygauge("export", results, "--csv", "-").stdout)))
                self.assertLessEqual(float(row["lower"]), distance + 1e-12)
                self.assertGreaterEqual(float(row["upper"]), distance - 1e-12)
                self.assertAlmostEqual(float(row["upper"]), float(row["lower"]), 4)

    def rows_of(self, scene, *options):
        results = self.work / (scene + ".h5")
        self.run_raygauge("scene", "run", self.reports / scene, "-q", "-o", results, *options)
        return list(csv.DictReader(io.StringIO(self.run_raygauge("export", results, "--csv", "-").stdout)))

    def test_scenes_give_the_answers_in_closed_form(self):
        for scene, answers in ANSWERS.items():
            rows = self.rows_of(scene)
            for which, columns in answers.items():
                found = [row for row in rows if which in (row["query"], row["body_a"], row["kind"])]
                with self.subTest(scene, which=which):
                    self.assertTrue(found)
                    for row in found:
                        for column, right in columns.items():
                            if isinstance(right, str):
                                self.assertEqual(row[column], right)
                            else:
                                self.assertAlmostEqual(float(row[column]) / (right or 1), 1 if right else 0, 4)

    def test_an_origin_in_the_object_is_found_by_every_method(self):
        for A, Q in ORIGIN:
            for method in METHODS:
                with self.subTest(A, method=method):
                    done = self.run_raygauge("distance", self.reports / A, self.reports / Q, "--method", method, "--json")
                    self.assertEqual(json.loads(done.stdout)["status"], "contains_origin")
                    self.assertEqual(json.loads(done.stdout)["upper"], 0)

    def test_sums_are_as_exact_at_every_size(self):
        shapes = {"rounded box": ('shape = "minkowski_sum"\nA = { shape = "ball", center = [0, 0, 0], radius = %(s)s }\n'
                                  'B = { shape = "box", lower = [-%(s)s, -%(s)s, -%(s)s], upper = [%(s)s, %(s)s, %(s)s] }\n'),
                  "cone and ball": ('shape = "minkowski_sum"\nA = { shape = "ball", center = [0, 0, 0], radius = %(s)s }\n'
                                    'B = { shape = "truncated_cone", base = [0, 0, -%(s)s], base_radius = %(s)s, '
                                    'top = [0, 0, %(s)s], top_radius = 0 }\n'),
                  "hull of a union": ('shape = "union_hull"\nsets = [{ shape = "ball", center = [0, 0, 0], radius = %(s)s }, '
                                      '{ shape = "box", lower = [-%(s)s, -%(s)s, -%(s)s], upper = [%(s)s, %(s)s, %(s)s] }]\n')}
        for shape, text in shapes.items():
            answers = []
            for size in ("1", "1e-12", "1e-120", "1e120"):
                (self.work / "Q.toml").write_text(text % {"s": size})
                (self.work / "p.csv").write_text(" ".join(repr(x * float(size)) for x in (3, -2, 5)) + "\n")
                answer = json.loads(self.run_raygauge("distance", "p.csv", "Q.toml", "--json").stdout)
                self.assertEqual(answer["status"], "optimal", shape)  # the distance does not change with the size
                answers.append((answer["lower"], answer["upper"]))
                if shape == "rounded box":  # the point alone changes its size, and with it the distance
                    answer = json.loads(self.run_raygauge("distance", "p.csv", self.reports / "rounded_box.toml", "--json").stdout)
                    self.assertEqual(answer["status"], "optimal", size)
                    answers.append((answer["lower"] / float(size), answer["upper"] / float(size)))
            self.assertLessEqual(max(lower for lower, _ in answers), min(upper for _, upper in answers), shape)

    def test_a_name_with_a_line_feed_runs_nothing(self):
        self.rows_of("newline.toml")
        self.run_raygauge("plot", self.work / "newline.toml.h5", "-o", self.work / "x.svg")
        self.assertFalse((self.work / "pwned").exists())

    def test_a_scene_of_one_body_replaces_the_file_of_another(self):
        self.rows_of("flat.toml")
        (self.work / "flat.toml.h5").rename(self.work / "lone_body.toml.h5")
        self.assertEqual(self.rows_of("lone_body.toml", "--force"), [])
        self.assertIn("results of the scene 'lone_body'", self.run_raygauge("info", self.work / "lone_body.toml.h5").stdout)
        for shard in ("1/2", "2/2"):
            self.run_raygauge("scene", "run", self.reports / "lone_body.toml", "-q", "-o", "lone.h5", "--shard", shard)
        self.run_raygauge("merge", "lone.shard-1-of-2.h5", "lone.shard-2-of-2.h5", "-o", "lone.h5")

    def test_a_rotation_of_ten_digits_is_replaced_by_the_nearest_one(self):
        done = self.run_raygauge("distance", self.reports / "rotation_10_digits.toml", self.reports / "unit_ball.toml", "--json")
        self.assertIn("the nearest rotation is used", done.stderr)
        self.assertAlmostEqual(json.loads(done.stdout)["distance"], 3.65236169651, 9)

    def test_every_report_is_asked_about(self):
        text = pathlib.Path(__file__).read_text(encoding="utf-8")
        for path in self.reports.iterdir():
            if path.suffix not in (".dae", ".urdf"):  # which z_up.toml names
                self.assertTrue(path.name in text, path.name)

    def test_a_polytope_without_a_point_is_called_empty(self):
        done = self.run_raygauge("distance", self.reports / "empty_polytope.toml", self.reports / "unit_ball.toml", status=2)
        self.assertIn("is empty", done.stderr)

    def test_robots_tell_what_is_left_out_beyond_limits_and_in_contact(self):
        (self.work / "arm.urdf").write_text(ARM)
        (self.work / "joints.csv").write_text("time,j,k\n0,0,0\n0.5,2.5,9\n1,1,0\n")
        (self.work / "arm.toml").write_text(SCENE)
        refused = self.run_raygauge("scene", "explain", "arm.toml", status=2)
        self.assertEqual(refused.stderr, "raygauge: arm.toml:4: arm.urdf:1: link 'd': there is no mesh gone.stl "
                                         "(--skip-missing-meshes leaves it out)\n")
        notes = self.run_raygauge("scene", "run", "arm.toml", "--skip-missing-meshes", "-o", "arm.h5").stderr.splitlines()
        ignore = 'ignore = [["r/a", "r/c"]]'
        self.assertEqual([note for note in notes if note.startswith("note: ")], [
            "note: robot 'r': left out, for they are missing: gone.stl of link 'd'",
            "note: robot 'r': joint values beyond their limits: j is 2.5 at time 0.5, its limits are -1 and 2",
            f"note: robot 'r': 1 pair of links in contact at the start; this leaves them out: {ignore}"])
        (self.work / "arm.toml").write_text(ignore + "\n" + SCENE)
        after = self.run_raygauge("scene", "explain", "arm.toml", "--skip-missing-meshes").stderr
        self.assertNotIn("contact", after)
        (self.work / "joints.csv").write_text("time,j,k\n0,0,0\n1,1,0\n")
        self.assertNotIn("limits", self.run_raygauge("scene", "explain", "arm.toml", "--skip-missing-meshes").stderr)
        self.assertEqual("", self.run_raygauge("scene", "run", "arm.toml", "--skip-missing-meshes", "-q", "-o", "q.h5").stderr)

    def test_a_byte_order_mark_and_blanks_in_front_are_read_over_in_every_text(self):
        texts = {"arm.urdf": ARM, "joints.csv": "time,j,k\n0,0,0\n1,1,0\n", "arm.toml": SCENE,
                 "ball.toml": 'shape = "ball"\ncenter = [0, 0, 0]\nradius = 1\n', "A.csv": "3 0 0\n", "pairs.csv": "A,Q\nA.csv,Q.csv\n",
                 "Q.csv": "1 1 1\n-1 0 0\n0 -1 0\n0 0 -1\n",
                 "e.toml": '[[generator]]\nname = "files"\npairs = "pairs.csv"\n[[method]]\nname = "column_generation"\n',
                 "m.obj": "v 3 0 0\n", "m.off": "OFF 1 0 0\n3 0 0\n", "m.stl": "solid\nfacet normal 0 0 1\nouter loop\n" +
                 "vertex 3 0 0\n" * 3 + "endloop\nendfacet\nendsolid\n",
                 "m.ply": "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
                          "end_header\n3 0 0\n"}
        for front in ("\ufeff", "\n  ", "\ufeff \t\n"):
            for name, text in texts.items():
                (self.work / name).write_text(front + text, encoding="utf-8")
            with self.subTest(front):
                self.run_raygauge("scene", "explain", "arm.toml", "--skip-missing-meshes")
                self.run_raygauge("run", "e.toml", "--dry-run")
                for name in ("A.csv", "m.obj", "m.off", "m.stl", "m.ply"):
                    done = self.run_raygauge("distance", name, "ball.toml", "--json")
                    self.assertAlmostEqual(json.loads(done.stdout)["distance"], 3, 5, name)

    def test_set_files_that_name_each_other_end_soon(self):
        for level in range(1, 19):
            (self.work / f"s{level}.toml").write_text(
                f'shape = "minkowski_sum"\nA = {{ shape = "file", file = "s{level - 1}.toml" }}\n'
                f'B = {{ shape = "file", file = "s{level - 1}.toml" }}\n')
        (self.work / "s0.toml").write_text('shape = "ball"\ncenter = [0, 0, 0]\nradius = 1\n')
        start = time.monotonic()
        done = self.run_raygauge("distance", "s18.toml", self.reports / "unit_ball.toml", status=2)
        self.assertLess(time.monotonic() - start, 10)
        self.assertIn("more than 16 set files inside one another", done.stderr)
        done = self.run_raygauge("distance", "s15.toml", self.reports / "unit_ball.toml", status=2)
        self.assertIn("more than 1000 files in one set", done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1)
        self.run_raygauge("distance", "s5.toml", self.reports / "unit_ball.toml")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--raygauge", required=True)
    parser.add_argument("--reports", type=pathlib.Path, required=True)
    arguments, rest = parser.parse_known_args()
    ReportedFiles.raygauge = str(pathlib.Path(arguments.raygauge).resolve())
    ReportedFiles.reports = arguments.reports.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
