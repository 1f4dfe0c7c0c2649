#!/usr/bin/env python3
"""A laser robot's drive as nine sonars would have heard it: a room whose walls are known."""

import gzip
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
SCRIPT = os.path.join(HERE, "..", "..", "scripts", "carmen_drive.py")
sys.path.insert(0, HERE)
from carmen_scans_test import drive, pose_at, ray  # noqa: E402


class CarmenDrive(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.log = os.path.join(folder.name, "drive.log")
        self.out = os.path.join(folder.name, "drive.jsonl.gz")

    def run_on(self, text):
        with open(self.log, "w") as file:
            file.write(text)
        return subprocess.run(["/usr/bin/python3", "-B", SCRIPT, self.log, self.out],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)

    def moments(self, text):
        answer = self.run_on(text)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        with gzip.open(self.out, "rt") as file:
            return [json.loads(row) for row in file]

    def test_poses_are_odometry_and_truth(self):
        moments = self.moments(drive(1))
        self.assertEqual(moments[0]["truth"], [round(p, 4) for p in pose_at(0.0)])
        for moment in moments:
            self.assertEqual(moment["odom"], moment["truth"])

    def test_it_drives_no_faster_than_it_may(self):
        moments = self.moments(drive(2))
        self.assertGreater(len(moments), 40)
        for a, b in zip(moments, moments[1:]):
            way = math.hypot(a["truth"][0] - b["truth"][0], a["truth"][1] - b["truth"][1])
            turn = (b["truth"][2] - a["truth"][2] + math.pi) % (2.0 * math.pi) - math.pi
            self.assertGreaterEqual(b["t"] - a["t"] + 0.002, max(0.1, way / 0.35, abs(turn) / 0.6))

    def test_nine_sonars_hear_the_nearest_of_what_the_laser_sees_of_their_cones(self):
        heard = 0
        for moment in self.moments(drive(1)):
            self.assertEqual(len(moment["readings"]), 9)
            x, y, yaw = moment["truth"]
            for bearing, _, _, echo, most in moment["readings"]:
                cone = [ray(x, y, yaw + math.radians(i - 90)) for i in range(181)
                        if abs(math.radians(i - 90) - bearing) <= moment["fov"] / 2]
                self.assertEqual(most, 15 * 0.3048)
                if echo is None or min(cone) > 4.3:
                    continue
                heard += 1
                self.assertAlmostEqual(echo / min(cone), 1.0, delta=0.06)
        self.assertGreater(heard, 100)

    def test_a_log_that_is_no_good_is_refused_by_its_line(self):
        answer = self.run_on(drive(0.1) + "FLASER 181 1.0 1.0\n")
        self.assertEqual(answer.returncode, 1)
        self.assertIn(":15: FLASER is cut short", answer.stderr)
        self.assertFalse(os.path.exists(self.out))


if __name__ == "__main__":
    unittest.main()
