#!/usr/bin/env python3
"""What is installed is whole: all that others use of the package, and each file that a launch file, a
document or the panel names; and Debian's packages leave nothing out.

usage: installed_files_test.py BUILD_DIRECTORY|PREFIX [ARGUMENT_OF_UNITTEST]...

Installs from a build directory into a folder of its own, or looks at what was unpacked of Debian's
packages below a prefix.
"""

import fnmatch
import os
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
GIVEN = sys.argv.pop(1)
# Folders of the tree, and where what is in them is installed.
FOLDERS = {"action": "share/place_memory/action", "config": "share/place_memory/config",
           "include/place_memory": "include/place_memory", "launch": "share/place_memory/launch",
           "msg": "share/place_memory/msg", "rviz": "share/place_memory/rviz",
           "scripts/demo_tools": "lib/place_memory/demo_tools", "srv": "share/place_memory/srv",
           "urdf": "share/place_memory/urdf"}
# The packages of Debian in which a ROS package's programs are.
DEBIAN_NAMES = {"rviz": "place-memory-rviz", "rosbag": "python3-rosbag", "tf": "tf-tools"}
# catkin's own, which a package for /usr leaves out.
OF_WORKSPACES = re.compile(r"(\.catkin|\.rosinstall|_setup_util\.py|env\.sh|(local_)?setup\.\w+)$")
# What this one takes is built only where rviz can be built against.
PANEL = "debian/place-memory-rviz.install"


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def patterns(path):
    """Of files below the prefix, in one of debian's lists, as they lie in any other prefix than /usr:
    there catkin has a folder for the processor's libraries, and another one for pkg-config."""
    return [line[len("usr/"):].replace("lib/*/", "lib/").replace("share/pkgconfig", "lib/pkgconfig")
            for line in read(os.path.join(ROOT, path)).split("\n") if line]


def is_taken(file, pattern):
    """As dh_install takes a folder, with all that is in it, or what a pattern matches."""
    return file.startswith(pattern + "/") or fnmatch.fnmatchcase(file, pattern)


class InstalledFilesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.is_build = os.path.exists(os.path.join(GIVEN, "cmake_install.cmake"))
        cls.prefix = cls.folder.name if cls.is_build else GIVEN
        if cls.is_build:
            subprocess.run(["cmake", "--install", GIVEN, "--prefix", cls.prefix], check=True,
                           stdout=subprocess.DEVNULL)
        cls.files = sorted(os.path.relpath(os.path.join(folder, file), cls.prefix)
                           for folder, _, files in os.walk(cls.prefix) for file in files)
        cls.launch_files = [file for file in cls.files if file.endswith(".launch")]

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def assert_there(self, path):
        self.assertTrue(path in self.files, path + " is not installed")

    def text(self, file):
        return read(os.path.join(self.prefix, file))

    def test_what_the_tree_has_for_others_is_there(self):
        for source, target in FOLDERS.items():
            top = os.path.join(ROOT, source)
            paths = [os.path.relpath(os.path.join(folder, name), top)
                     for folder, _, names in os.walk(top) for name in names
                     if not name.endswith(".pyc")]
            self.assertTrue(paths, source)
            for path in paths:
                with self.subTest(folder=source, file=path):
                    self.assert_there(os.path.join(target, path))

    def test_programs_that_are_made_to_be_installed_are_there(self):
        programs = set()
        for folder in ("src", "examples"):
            for where, _, names in os.walk(os.path.join(ROOT, folder)):
                if "CMakeLists.txt" in names:
                    text = read(os.path.join(where, "CMakeLists.txt"))
                    programs.update(re.findall(r"place_memory_(?:install|add_tool)\((\w+)", text))
                    for target, name in re.findall(r"\((\w+) PROPERTIES OUTPUT_NAME (\w+)\)", text):
                        programs.discard(target)
                        programs.add(name)
        self.assertGreater(len(programs), 3)
        for name in programs:
            with self.subTest(program=name):
                self.assert_there("lib/place_memory/" + name)

    def test_what_find_package_reads_is_there(self):
        for name in ("place_memoryConfig.cmake", "place_memoryConfig-version.cmake",
                     "place_memory-extras.cmake", "place_memory-targets.cmake"):
            self.assert_there("share/place_memory/cmake/" + name)
        for part in ("core", "config"):
            found = [file for file in self.files
                     if re.fullmatch(rf"lib/(.*/)?libplace_memory_{part}\.so", file)]
            self.assertEqual(len(found), 1, part)

    def test_what_launch_files_name_is_there(self):
        self.assertGreaterEqual(len(self.launch_files), 10)
        for file in self.launch_files:
            text = self.text(file)
            named = re.findall(r"\$\(find place_memory\)/([\w./-]+\.\w+)", text)
            beside = re.findall(r"\$\(dirname\)/([\w./-]+\.\w+)", text)
            paths = (["share/place_memory/" + path for path in named]
                     + [os.path.normpath(os.path.join(os.path.dirname(file), path))
                        for path in beside])
            for path in paths:
                with self.subTest(file=file, names=path):
                    self.assert_there(path)

    def test_programs_that_launch_files_start_are_there(self):
        for file in self.launch_files:
            for node in ElementTree.fromstring(self.text(file)).iter("node"):
                if node.get("pkg") != "place_memory":
                    continue
                with self.subTest(file=file, starts=node.get("type")):
                    path = os.path.join("lib/place_memory", node.get("type"))
                    self.assert_there(path)
                    self.assertTrue(os.access(os.path.join(self.prefix, path), os.X_OK))

    def test_programs_of_the_documents_are_there(self):
        pages = ["README.md"] + [os.path.join("doc", page)
                                 for page in os.listdir(os.path.join(ROOT, "doc"))
                                 if page.endswith(".md")]
        programs = {name for page in pages for name in
                    re.findall(r"rosrun place_memory ([\w.]+)", read(os.path.join(ROOT, page)))}
        self.assertGreater(len(programs), 3)
        for name in programs:
            with self.subTest(program=name):
                self.assert_there("lib/place_memory/" + name)

    def test_python_modules_of_messages_are_there(self):
        for kind in ("msg", "srv"):
            found = [file for file in self.files
                     if re.fullmatch(rf"lib/python3.*/place_memory/{kind}/__init__\.py", file)]
            self.assertEqual(len(found), 1, kind)

    def test_the_panel_that_is_described_is_there(self):
        description = "share/place_memory/plugin_description.xml"
        if description not in self.files:
            self.skipTest("no panel was built: rviz's development files are not installed")
        library = ElementTree.fromstring(self.text(description)).get("path")
        found = [file for file in self.files
                 if re.fullmatch(rf"lib/(.*/)?{re.escape(os.path.basename(library))}\.so", file)]
        self.assertEqual(len(found), 1)
        package = ElementTree.fromstring(self.text("share/place_memory/package.xml"))
        named = package.find("export").find("rviz").get("plugin")
        self.assertEqual(named.replace("${prefix}", "share/place_memory"), description)

    def test_debian_packages_leave_nothing_out_and_take_nothing_twice(self):
        if not self.is_build:
            self.skipTest("dpkg-buildpackage has seen to it")
        lists = [os.path.join("debian", name) for name in os.listdir(os.path.join(ROOT, "debian"))
                 if name.endswith(".install")]
        self.assertEqual(len(lists), 3)
        for file in self.files:
            if OF_WORKSPACES.search(file):
                continue
            with self.subTest(file=file):
                takers = [name for name in lists
                          if any(is_taken(file, pattern) for pattern in patterns(name))]
                self.assertEqual(len(takers), 1, takers)

    def test_debian_packages_take_only_what_is_there(self):
        if not self.is_build:
            self.skipTest("dpkg-buildpackage has seen to it")
        for name in os.listdir(os.path.join(ROOT, "debian")):
            path = os.path.join("debian", name)
            if not name.endswith(".install") or (path == PANEL and not self.has_panel()):
                continue
            for pattern in patterns(path):
                with self.subTest(list=path, takes=pattern):
                    self.assertTrue(any(is_taken(file, pattern) for file in self.files))

    def has_panel(self):
        return "share/place_memory/plugin_description.xml" in self.files

    def test_debian_packages_ask_for_what_launch_files_start(self):
        control = read(os.path.join(ROOT, "debian", "control"))
        package = control.split("\n\n")[1]
        for file in self.launch_files:
            for node in ElementTree.fromstring(self.text(file)).iter("node"):
                if node.get("pkg") == "place_memory":
                    continue
                with self.subTest(file=file, starts=node.get("pkg")):
                    self.assertRegex(package, rf"\b{DEBIAN_NAMES[node.get('pkg')]}\b")


if __name__ == "__main__":
    unittest.main()
