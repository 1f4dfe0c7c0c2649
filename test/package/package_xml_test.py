#!/usr/bin/env python3
"""What package.xml asks of a robot, and that it agrees with what is built."""

import os
import re
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
OF_DEMO_AND_TESTS = {"imagemagick", "python3-matplotlib", "python3-numpy", "rviz", "xvfb"}


def read(name):
    with open(os.path.join(ROOT, name)) as file:
        return file.read()


class PackageXmlTest(unittest.TestCase):
    def setUp(self):
        self.package = ElementTree.fromstring(read("package.xml"))

    def names(self, *tags):
        return {element.text for tag in tags for element in self.package.iter(tag)}

    def test_a_robot_installs_nothing_of_demo_and_tests(self):
        self.assertEqual(OF_DEMO_AND_TESTS & self.names("depend", "exec_depend", "build_depend"),
                         set())
        self.assertEqual(OF_DEMO_AND_TESTS - self.names("test_depend"), set())

    def test_a_robot_installs_what_its_launch_file_starts(self):
        packages = set(re.findall(r'<node[^>]* pkg="(\w+)"', read("launch/place_memory.launch")))
        self.assertEqual(packages, {"place_memory"})
        self.assertIn("roslaunch", self.names("exec_depend"))

    def test_its_version_is_that_of_the_libraries(self):
        built = re.search(r"project\(place_memory VERSION ([0-9.]+)", read("CMakeLists.txt"))
        self.assertEqual(self.package.find("version").text, built.group(1))


if __name__ == "__main__":
    unittest.main()
