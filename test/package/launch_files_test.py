#!/usr/bin/env python3
"""What a person relies on who starts a launch file: it forgets what an earlier start left on the
parameter server, and `roslaunch --ros-args` says truly which arguments have to be given."""

import functools
import glob
import os
import re
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
FILES = sorted(glob.glob(os.path.join(ROOT, "launch", "*.launch"))
               + glob.glob(os.path.join(ROOT, "lab", "*", "*.launch")))


def nodes_that_keep_old_parameters(root):
    """Names of the nodes that are given parameters, and keep those that are there already."""
    return [node.get("name") for node in root.iter("node")
            if node.findall("param") + node.findall("rosparam")
            and node.get("clear_params") != "true"]


@functools.lru_cache()
def listed_arguments(file):
    """{"Required": {name: doc}, "Optional": {name: doc}}, as roslaunch lists them."""
    with tempfile.TemporaryDirectory() as folder:
        output = subprocess.run(["roslaunch", "--ros-args", file], check=True, encoding="utf-8",
                                env=dict(os.environ, ROS_LOG_DIR=folder),
                                stdout=subprocess.PIPE).stdout
    listed = {"Required": {}, "Optional": {}}
    kind = None
    for line in output.splitlines():
        heading = re.match(r"(Required|Optional) Arguments:", line)
        argument = re.match(r'  (\w+)(?: \(default ".*"\))?: (.*)', line)
        if heading:
            kind = heading.group(1)
        elif argument:
            listed[kind][argument.group(1)] = argument.group(2)
    return listed


def read_lines(path):
    with open(path, encoding="utf-8") as file:
        return file.read().splitlines()


class LaunchFilesTest(unittest.TestCase):
    def test_a_node_that_keeps_old_parameters_is_noticed(self):
        text = ('<launch><node name="a"/><node name="b"><param name="x" value="1"/></node>'
                '<node name="c" clear_params="true"><rosparam/></node></launch>')
        self.assertEqual(nodes_that_keep_old_parameters(ElementTree.fromstring(text)), ["b"])

    def test_no_node_keeps_old_parameters(self):
        self.assertGreaterEqual(len(FILES), 4)
        for file in FILES:
            with self.subTest(file=file):
                root = ElementTree.parse(file).getroot()
                self.assertEqual(nodes_that_keep_old_parameters(root), [])

    def test_arguments_are_listed_as_what_they_are(self):
        for file in FILES:
            with self.subTest(file=file):
                arguments = ElementTree.parse(file).getroot().findall("arg")
                optional = {arg.get("name") for arg in arguments if "default" in arg.keys()}
                listed = listed_arguments(file)
                self.assertEqual(set(listed["Optional"]), optional)
                self.assertEqual(set(listed["Required"]),
                                 {arg.get("name") for arg in arguments} - optional)

    def test_every_argument_is_documented(self):
        for file in FILES:
            with self.subTest(file=file):
                for kind in listed_arguments(file).values():
                    for name, doc in kind.items():
                        self.assertNotEqual(doc, "undocumented", name)

    def test_rviz_shows_the_same_by_day_and_by_night(self):
        day, night = (read_lines(os.path.join(ROOT, "rviz", name))
                      for name in ("place_memory.rviz", "place_memory_night.rviz"))
        self.assertEqual(len(day), len(night))
        differ = {line.split(":")[0].strip(" -") for pair in zip(day, night)
                  for line in pair if pair[0] != pair[1]}
        self.assertEqual(differ, {"Alpha", "Background Color"})


if __name__ == "__main__":
    unittest.main()
