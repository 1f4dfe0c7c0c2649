#!/usr/bin/env python3
"""Tables of a document that are made again by the commands that stand before them."""

import os
import subprocess
import tempfile
import unittest

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "redo_tables.py")
PROGRAM = """#!/bin/sh
[ "$1" = fails ] && exit 3
[ "$1" = silent ] && exit 0
printf '| of |\\n|----|\\n| %s |\\n' "$*"
"""


class RedoTables(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        with open(os.path.join(self.folder, "measure"), "w") as file:
            file.write(PROGRAM)
        os.chmod(os.path.join(self.folder, "measure"), 0o755)
        self.document = os.path.join(self.folder, "page.md")

    def run_on(self, text, *options):
        with open(self.document, "w") as file:
            file.write(text)
        answer = subprocess.run(["/usr/bin/python3", "-B", SCRIPT, self.document, self.folder, *options],
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
        with open(self.document) as file:
            return answer, file.read()

    def test_each_table_is_of_the_command_before_it(self):
        old = "a\n\n    measure one\n\ntext\n\n| old |\n|---|\n| 1 |\n| 2 |\n\nb\n\n    measure two 2\n\n| old |\n|---|\n| 1 |\n"
        answer, text = self.run_on(old)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertEqual(text, "a\n\n    measure one\n\ntext\n\n| of |\n|----|\n| one |\n\nb\n\n    measure two 2\n\n"
                               "| of |\n|----|\n| two 2 |\n")

    def test_other_tables_and_other_commands_stay(self):
        old = "| kept |\n|---|\n| 1 |\n\n    git clone\n\n    measure SUITE [--option]\n\n| kept |\n|---|\n| 2 |\n"
        answer, text = self.run_on(old)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertEqual(text, old)

    def test_only_those_that_are_chosen(self):
        old = "    measure one\n\n| old |\n|---|\n| 1 |\n\n    measure two\n\n| old |\n|---|\n| 1 |\n"
        _, text = self.run_on(old, "--only=two")
        self.assertIn("| old |\n|---|\n| 1 |\n\n    measure two", text)
        self.assertIn("| two |", text)

    def refused(self, old, reason):
        answer, text = self.run_on(old)
        self.assertEqual(answer.returncode, 1)
        self.assertIn(reason, answer.stderr)
        self.assertNotIn("Traceback", answer.stderr)
        self.assertEqual(text, old)

    def test_a_command_that_fails(self):
        self.refused("    measure fails\n\n| old |\n|---|\n| 1 |\n", "exit status 3")

    def test_a_command_that_prints_no_table(self):
        self.refused("    measure silent\n\n| old |\n|---|\n| 1 |\n", "prints no table")

    def test_a_command_without_a_table(self):
        self.refused("    measure one\n\n    measure two\n\n| old |\n|---|\n| 1 |\n", "no table stands behind")
        self.refused("| old |\n|---|\n| 1 |\n\n    measure one\n", "no table stands behind")


if __name__ == "__main__":
    unittest.main()
