#!/usr/bin/env python3
"""What package.xml asks of a robot, and that it agrees with what is built."""

import os
import re
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
OF_DEMO_AND_TESTS = {"imagemagick", "python3-matplotlib", "python3-numpy", "xvfb"}


def read(name):
    with open(os.path.join(ROOT, name)) as file:
        return file.read()


def packages_of_setup(name):
    array = re.search(rf"readonly {name}=\(\n(.*?)\n\)", read("scripts/setup"), re.DOTALL)
    return set(array.group(1).split())


def field(paragraph, name):
    """Package names of a field of debian/control."""
    text = re.search(rf"(?m)^{name}: (.*(?:\n .*)*)", paragraph).group(1)
    return {entry.split()[0] for entry in text.split(",")}


class PackageXmlTest(unittest.TestCase):
    def setUp(self):
        self.package = ElementTree.fromstring(read("package.xml"))

    def names(self, *tags):
        """As with PLACE_MEMORY_RVIZ=0 in the environment."""
        return {element.text for tag in tags for element in self.package.iter(tag)
                if "condition" not in element.keys()}

    def test_a_robot_installs_nothing_of_demo_and_tests(self):
        self.assertEqual((OF_DEMO_AND_TESTS | {"rviz"}) & self.names("depend", "exec_depend", "build_depend"),
                         set())
        self.assertEqual(OF_DEMO_AND_TESTS - self.names("test_depend"), set())

    def test_rviz_finds_the_panel(self):
        self.assertIn("rviz", {element.text for element in self.package.iter("exec_depend")})
        plugins = self.package.find("export").find("rviz").get("plugin")
        self.assertIn("PlaceMemoryPanel", read(os.path.basename(plugins)))

    def test_a_robot_installs_what_its_launch_file_starts(self):
        packages = set(re.findall(r'<node[^>]* pkg="(\w+)"', read("launch/place_memory.launch")))
        self.assertEqual(packages, {"place_memory"})
        self.assertIn("roslaunch", self.names("exec_depend"))

    def test_its_version_is_that_of_the_libraries(self):
        built = re.search(r"project\(place_memory VERSION ([0-9.]+)", read("CMakeLists.txt"))
        self.assertEqual(self.package.find("version").text, built.group(1))

    def test_debian_packages_are_of_the_same_version(self):
        newest = re.match(r"place-memory \(([0-9.]+)\)", read("debian/changelog"))
        self.assertEqual(self.package.find("version").text, newest.group(1))

    def test_debian_packages_depend_on_what_setup_installs(self):
        source, package = read("debian/control").split("\n\n")[:2]
        not_needed = {"build-essential",  # is always there
                      "nlohmann-json3-dev",  # of the lab
                      "libtf-dev", "tf-tools"}  # for people
        built = packages_of_setup("build_packages") - not_needed
        self.assertEqual(built - field(source, "Build-Depends"), set())
        run = packages_of_setup("run_packages") - not_needed
        self.assertEqual(run - field(package, "Depends"), set())


if __name__ == "__main__":
    unittest.main()
