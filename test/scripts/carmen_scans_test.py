#!/usr/bin/env python3
"""Cutting sonar scans from a laser log: a room whose walls are known, and logs that are no good."""

import gzip
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

SCRIPTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts")
sys.path.insert(0, SCRIPTS)
import carmen_scans  # noqa: E402

WIDTH, DEPTH = 8.0, 5.0  # of the room, its corner at the origin [m]
PERIMETER = 12.0
FOOT = 0.3048


def ray(x, y, angle):
    """To the wall that the ray meets."""
    c, s = math.cos(angle), math.sin(angle)
    across = ((WIDTH if c > 0 else 0.0) - x) / c if abs(c) > 1e-9 else math.inf
    along = ((DEPTH if s > 0 else 0.0) - y) / s if abs(s) > 1e-9 else math.inf
    return min(across, along)


def pose_at(driven):
    """On a rectangle of 4 m by 2 m amid the room, looking along it."""
    s = driven % PERIMETER
    if s < 4.0:
        return 2.0 + s, 1.5, 0.0
    if s < 6.0:
        return 6.0, 1.5 + s - 4.0, math.pi / 2
    if s < 10.0:
        return 6.0 - (s - 6.0), 3.5, math.pi
    return 2.0, 3.5 - (s - 10.0), -math.pi / 2


def line(pose, rays=181):
    ranges = [ray(pose[0], pose[1], pose[2] + math.radians(i - 90)) for i in range(181)][:rays]
    words = [f"{r:.4f}" for r in ranges] + [f"{p:.5f}" for p in pose]
    return f"FLASER {len(ranges)} " + " ".join(words) + " 0 0 0 12.5 robot 12.5\n"


def drive(rounds):
    return "# a comment\nODOM 0 0 0\n" + "".join(
        line(pose_at(0.1 * i)) for i in range(int(rounds * PERIMETER / 0.1)))


class CarmenScans(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, text, name="drive.log"):
        with open(self.path(name), "w") as file:
            file.write(text)
        return self.path(name)

    def run_on(self, log, out="out.jsonl.gz"):
        return subprocess.run(["/usr/bin/python3", "-B", os.path.join(SCRIPTS, "carmen_scans.py"),
                               log, self.path(out)],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              universal_newlines=True)

    def scans(self, text):
        answer = self.run_on(self.write(text))
        self.assertEqual(answer.returncode, 0, answer.stderr)
        with gzip.open(self.path("out.jsonl.gz"), "rt") as file:
            return [json.loads(row) for row in file]

    def refused(self, text, reason):
        answer = self.run_on(self.write(text))
        self.assertEqual(answer.returncode, 1)
        self.assertIn(reason, answer.stderr)
        self.assertNotIn("Traceback", answer.stderr)
        self.assertFalse(os.path.exists(self.path("out.jsonl.gz")))

    def test_learns_a_place_every_five_feet(self):
        places = [s["pose"] for s in self.scans(drive(2)) if s["role"] == "learn"]
        apart = [math.hypot(a[0] - b[0], a[1] - b[1])
                 for i, a in enumerate(places) for b in places[:i]]
        self.assertGreaterEqual(min(apart), 5 * FOOT - 1e-3)
        self.assertGreaterEqual(len(places), 5)

    def test_what_is_recognized_is_near_what_was_learned(self):
        scans = self.scans(drive(2))
        places = {s["place"]: s["pose"] for s in scans if s["role"] == "learn"}
        visits = [s for s in scans if s["role"] == "recognize"]
        self.assertGreaterEqual(len(visits), 3)
        for visit in visits:
            self.assertTrue(visit["accept"])
            for place in visit["accept"]:
                x, y, _ = places[place]
                self.assertLessEqual(math.hypot(visit["pose"][0] - x, visit["pose"][1] - y),
                                     2.5 * FOOT + 1e-3)

    def test_the_way_leads_from_one_visit_to_the_next(self):
        visits = [s for s in self.scans(drive(2)) if s["role"] == "recognize"]
        before = pose_at(0.0)
        for visit in visits:
            self.assertEqual(visit["way"][-1], visit["pose"])
            for pose in visit["way"]:
                self.assertLess(math.hypot(pose[0] - before[0], pose[1] - before[1]), 0.5)
                before = pose

    def test_a_single_round_visits_nothing_again(self):
        self.assertEqual({s["role"] for s in self.scans(drive(0.7))}, {"learn"})

    def test_a_sonar_returns_the_shortest_ray_of_its_cone(self):
        lost = checked = 0
        for scan in self.scans(drive(2)):
            x, y, yaw = scan["pose"]
            for _, bearing, turn, heard in scan["readings"]:
                cone = [ray(x, y, yaw + math.radians(i - 90)) for i in range(181)
                        if abs(math.radians(i - 90) - bearing - turn) <= scan["fov"] / 2]
                if min(cone) > 4.3:
                    continue
                checked += 1
                if heard is None:
                    lost += 1
                    continue
                self.assertAlmostEqual(heard / min(cone), 1.0, delta=0.06)
        self.assertGreater(checked, 500)
        self.assertLess(lost / checked, 0.03)

    def test_leaves_out_what_the_laser_does_not_see(self):
        bearings = {(b, t) for s in self.scans(drive(1)) for _, b, t, _ in s["readings"]}
        self.assertIn((0.0, 0.0), bearings)
        self.assertNotIn((1.5708, 0.0), bearings)
        self.assertIn((1.5708, -0.17453), bearings)

    def test_no_ray_within_reach_is_no_echo(self):
        far = "FLASER 181 " + "81.83 " * 181 + "0 0 0\n"
        self.assertEqual({r[3] for s in self.scans(far) for r in s["readings"]}, {None})

    def test_where_the_first_ray_points_changes_no_sonar(self):
        even = [carmen_scans.readings([2.0] * n, carmen_scans.random.Random(1)) for n in (180, 360)]
        odd = [carmen_scans.readings([2.0] * n, carmen_scans.random.Random(1)) for n in (181, 361)]
        self.assertEqual([r[:3] for r in even[0]], [r[:3] for r in odd[0]])
        self.assertEqual([r[:3] for r in even[1]], [r[:3] for r in odd[1]])

    def test_the_same_log_gives_the_same_bytes_gzipped_or_not(self):
        log = self.write(drive(1))
        with gzip.open(self.path("drive.log.gz"), "wt") as file:
            file.write(drive(1))
        self.run_on(log, "a.gz")
        self.run_on(self.path("drive.log.gz"), "b.gz")
        with open(self.path("a.gz"), "rb") as a, open(self.path("b.gz"), "rb") as b:
            self.assertEqual(a.read(), b.read())

    def test_a_line_cut_short(self):
        self.refused(drive(0.1) + "FLASER 181 1.0 1.0\n", ":15: FLASER is cut short")

    def test_a_line_without_a_count(self):
        self.refused("FLASER \n", ":1: FLASER")

    def test_a_range_that_is_no_number(self):
        self.refused("FLASER 2 1.0 nan 0 0 0\n", ":1: FLASER holds what is no number")

    def test_words_for_ranges(self):
        self.refused("FLASER 2 one two 0 0 0\n", ":1: FLASER could not convert")

    def test_a_log_without_a_laser(self):
        self.refused("ODOM 0 0 0\n", "no FLASER line")

    def test_a_damaged_archive(self):
        path = self.write("no archive", "drive.log.gz")
        answer = self.run_on(path)
        self.assertEqual(answer.returncode, 1)
        self.assertNotIn("Traceback", answer.stderr)

    def test_a_log_that_is_not_there(self):
        answer = self.run_on(self.path("nowhere.log"))
        self.assertEqual(answer.returncode, 1)
        self.assertIn("nowhere.log", answer.stderr)


if __name__ == "__main__":
    unittest.main()
