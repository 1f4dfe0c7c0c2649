#!/usr/bin/env python3
"""Every launch file says of each argument what it is and what it is without one."""

import glob
import os
import unittest
import xml.etree.ElementTree

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "launch")


class LaunchFilesTest(unittest.TestCase):
    def setUp(self):
        self.files = glob.glob(os.path.join(FOLDER, "*.launch"))
        self.assertTrue(self.files)

    def elements(self, tag):
        for path in self.files:
            root = xml.etree.ElementTree.parse(path).getroot()
            # Those of an <include> are given to another file.
            for element in root.findall(tag):
                yield "%s: %s" % (os.path.basename(path), element.get("name")), element

    def test_roslaunch_lists_every_argument_as_optional(self):
        for name, argument in self.elements("arg"):
            with self.subTest(name):
                # To roslaunch --ros-args an argument whose default is empty is a required one.
                self.assertTrue(argument.get("default"))

    def test_every_argument_is_documented(self):
        for name, argument in self.elements("arg"):
            with self.subTest(name):
                self.assertGreater(len(argument.get("doc", "")), 5)


if __name__ == "__main__":
    unittest.main()
