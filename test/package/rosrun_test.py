#!/usr/bin/env python3
"""rosrun finds the executables of a build, also of one in the package's folder `build`."""

import os
import shutil
import subprocess
import unittest


def run(*words):
    return subprocess.run(words, encoding="utf-8", stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


@unittest.skipIf(shutil.which("rosrun") is None, "rosrun is not installed")
class RosrunTest(unittest.TestCase):
    def test_it_runs_the_bag_tool(self):
        answer = run("rosrun", "place_memory", "place_memory_bag", "--help")
        self.assertEqual(answer.returncode, 0, answer.stdout)
        self.assertIn("--bag", answer.stdout)

    def test_it_finds_the_nodes(self):
        for name in ("place_memory_node", "sonar_sim_node"):
            with self.subTest(name=name):
                # With this prefix it says what it would run.
                answer = run("rosrun", "--prefix", "echo", "place_memory", name)
                self.assertEqual(answer.returncode, 0, answer.stdout)
                self.assertTrue(os.access(answer.stdout.strip(), os.X_OK), answer.stdout)


if __name__ == "__main__":
    unittest.main()
