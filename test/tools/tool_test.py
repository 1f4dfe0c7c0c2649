"""What the tests of command line tools share: folders, and a tool that is run."""

import os
import subprocess
import sys
import tempfile
import unittest

TOOL = sys.argv.pop(1)


class ToolTest(unittest.TestCase):
    """Its tests are those of the classes made from it."""

    @classmethod
    def setUpClass(cls):
        cls.shared = tempfile.TemporaryDirectory()

    @classmethod
    def tearDownClass(cls):
        cls.shared.cleanup()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def run_tool(self, *arguments, **options):
        return subprocess.run((TOOL,) + arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              universal_newlines=True, timeout=120, **options)
