#!/usr/bin/env python3
"""place_memory_film and place_memory_draw_world write the pictures of doc/mapping.md.

usage: pictures_test.py FILM DRAW_WORLD SIMULATE_DRIVE [UNITTEST OPTION]...
"""

import os
import subprocess
import sys
import tempfile
import unittest

FILM, DRAW_WORLD, SIMULATE = (sys.argv.pop(1) for _ in range(3))
WORLD = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "config",
                     "worlds", "office.yaml")


def run(*arguments):
    return subprocess.run(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          universal_newlines=True, timeout=300)


class PicturesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def assert_picture(self, name):
        with open(self.path(name), "rb") as file:
            self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")

    def test_a_film_of_a_loop(self):
        drive = self.path("drive.jsonl.gz")
        answer = run(SIMULATE, "--world", WORLD, "--way", "90", "--out", drive)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        answer = run(FILM, "--drive", drive, "--out", self.path("office"))
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assert_picture("office.png")
        panels = [name for name in os.listdir(self.folder) if "_film_" in name]
        if "no loop was closed" in answer.stdout:
            self.assertEqual(panels, [])
        else:
            self.assertEqual(len(panels), 3)
            for name in panels:
                self.assert_picture(name)

    def test_a_world_as_it_is(self):
        for more in (["--world", WORLD], ["--kind", "1", "--seed", "3"]):
            answer = run(DRAW_WORLD, "--out", self.path("world.png"), *more)
            self.assertEqual(answer.returncode, 0, answer.stderr)
            self.assert_picture("world.png")

    def test_what_is_wrong_is_said(self):
        answer = run(DRAW_WORLD, "--world", WORLD, "--out", "/nowhere/world.png")
        self.assertEqual(answer.returncode, 1)
        self.assertIn("cannot write the picture /nowhere/world.png", answer.stderr)
        answer = run(FILM, "--drive", self.path("none.jsonl"), "--out", self.path("x"))
        self.assertEqual(answer.returncode, 1)
        self.assertIn("none.jsonl", answer.stderr)


if __name__ == "__main__":
    unittest.main()
