#!/usr/bin/env python3
"""scripts/fuzz gets as far as its build, by a cmake that only notes what it is asked for."""

import os
import subprocess
import tempfile
import unittest

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "fuzz")
# A function of the shell comes before every program.
CMAKE = '() { echo "$*" >> "$NOTES"; [ "$1" != --build ] || exit 7; }'


class FuzzStarts(unittest.TestCase):
    def test_it_builds_the_target_that_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            notes = os.path.join(folder, "notes")
            environment = dict(os.environ, NOTES=notes, CHECK_DIR=folder)
            environment["BASH_FUNC_cmake%%"] = CMAKE
            answer = subprocess.run([SCRIPT, "1", "store"], env=environment, stdout=subprocess.PIPE,
                                    stderr=subprocess.STDOUT, universal_newlines=True)
            self.assertTrue(os.path.exists(notes), answer.stdout)
            with open(notes) as file:
                configured, built = file.read().splitlines()
            self.assertEqual(answer.returncode, 7, answer.stdout)
        self.assertIn("-DPLACE_MEMORY_FUZZ=ON", configured)
        self.assertTrue(built.endswith("--target fuzz_seeds fuzz_store"), built)


if __name__ == "__main__":
    unittest.main()
