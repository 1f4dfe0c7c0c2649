"""Recognition on every instruction set of this processor: the same answers to the last digit.

usage: instruction_sets_test.py PRINT_RECOGNITIONS [UNITTEST OPTION]...
"""

import os
import subprocess
import sys
import unittest

PROGRAM = sys.argv.pop(1)


def run(*arguments, isa=None):
    environment = dict(os.environ)
    environment.pop("PLACE_MEMORY_ISA", None)
    if isa is not None:
        environment["PLACE_MEMORY_ISA"] = isa
    return subprocess.run([PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          universal_newlines=True, env=environment)


class InstructionSets(unittest.TestCase):
    def setUp(self):
        self.sets = run("--sets").stdout.split()
        self.assertIn("portable", self.sets)

    def test_all_give_the_same_answers(self):
        fastest = run()
        self.assertEqual(fastest.returncode, 0, fastest.stderr)
        self.assertGreater(fastest.stdout.count("recognized"), 3)
        for isa in self.sets:
            answer = run(isa=isa)
            self.assertEqual(answer.returncode, 0, answer.stderr)
            self.assertTrue(answer.stdout == fastest.stdout, isa + " answers otherwise")

    def test_another_value_is_refused_with_the_possible_ones(self):
        for isa in ("abacus", "AVX2", "portable,popcnt"):
            answer = run(isa=isa)
            self.assertEqual(answer.returncode, 1)
            self.assertEqual(answer.stdout, "")
            self.assertIn("PLACE_MEMORY_ISA is '%s'" % isa, answer.stderr)
            for possible in self.sets:
                self.assertIn(possible, answer.stderr)


if __name__ == "__main__":
    unittest.main()
