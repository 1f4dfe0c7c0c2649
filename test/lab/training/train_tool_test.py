"""place_memory_train: what it writes, and what it refuses.

usage: train_tool_test.py PLACE_MEMORY_TRAIN [UNITTEST OPTION]...
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest

TOOL = sys.argv.pop(1)
PRESETS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "config", "presets")


def train(*options, **environment):
    """Runs the tool; what it wrote, or None, and the finished process."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "preset.yaml")
        done = subprocess.run([TOOL, "--out", path, *options], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, universal_newlines=True,
                              env=dict(os.environ, **environment))
        if not os.path.exists(path):
            return None, done
        with open(path) as file:
            return file.read(), done


def options_of(preset):
    """Those that the head of a preset says it was written with."""
    return re.match(r"# Written by place_memory_train (.*)\n", preset).group(1).split()


def numbers(preset):
    return [float(number) for line in preset.splitlines()
            for number in re.findall(r"-?\d+(?:\.\d+)?(?:e-?\d+)?", line.split("#")[0])]


class ShippedPresets(unittest.TestCase):
    def check(self, name):
        with open(os.path.join(PRESETS, name)) as file:
            shipped = file.read()
        written, done = train(*options_of(shipped))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len(numbers(written)), len(numbers(shipped)))
        # Other processors and compilers round otherwise.
        for now, then in zip(numbers(written), numbers(shipped)):
            self.assertAlmostEqual(now, then, delta=0.001 + 0.02 * abs(then))
        self.assertEqual(written.splitlines()[0], shipped.splitlines()[0])

    def test_evidence_is_what_the_command_at_its_head_writes(self):
        self.check("evidence.yaml")

    def test_paper_is_what_the_command_at_its_head_writes(self):
        self.check("paper.yaml")


class Failing(unittest.TestCase):
    def test_what_fails_in_a_worker_is_said_and_ends_the_tool(self):
        written, done = train("--seeds", "3", "--held-back", "2", PLACE_MEMORY_ISA="abacus")
        self.assertEqual(done.returncode, 1)
        self.assertIn("place_memory_train: PLACE_MEMORY_ISA is 'abacus'", done.stderr)
        self.assertIsNone(written)


class Refused(unittest.TestCase):
    def check(self, complaint, *options):
        written, done = train(*options)
        self.assertEqual(done.returncode, 1)
        self.assertIn(complaint, done.stderr)
        self.assertIsNone(written)

    def test_too_few_seeds(self):
        self.check("--seeds must be at least 3", "--seeds", "2")

    def test_too_few_held_back(self):
        self.check("--held-back must be at least 2", "--held-back", "1")

    def test_negative_ridge(self):
        self.check("--ridge must be at least 0", "--ridge", "-1")

    def test_ridge_that_is_no_number(self):
        self.check("--ridge must be at least 0", "--ridge", "nan")

    def test_episodes_where_no_metric_is_fitted(self):
        self.check("do not go with it", "--calibrate", "paper", "--episodes", "any.gz")

    def test_ridge_where_no_metric_is_fitted(self):
        self.check("do not go with it", "--calibrate", "paper", "--ridge", "0.003")

    def test_no_such_episodes(self):
        self.check("cannot be opened", "--seeds", "3", "--episodes", "/nowhere/any.gz")

    def test_unknown_preset(self):
        self.check("nothing_like_it", "--calibrate", "nothing_like_it")


if __name__ == "__main__":
    unittest.main()
