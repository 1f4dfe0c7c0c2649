#!/usr/bin/env python3
"""A live node with a store that it cannot write, or that changes under it."""

import os
import shutil
import subprocess
import unittest

from diagnostic_msgs.msg import DiagnosticStatus

import live_test
import sonar_room
from live_diagnostics_test import Diagnostics

NOBODY = 65534


def mount(*arguments):
    return subprocess.run(["mount", *arguments], check=False, capture_output=True).returncode == 0


class LiveStoreTest(live_test.LiveTestCase):
    def setUp(self):
        super().setUp()
        self.folder = os.path.realpath(self.folder)
        self.store = os.path.join(self.folder, "places.db")

    def learn_hall(self, store):
        self.start_node(store=store)
        self.learn("hall", sonar_room.HALL)

    def assert_known_places_serve(self):
        """Though nothing can be written."""
        self.assertEqual(self.labels(), ["hall"])
        self.robot.enter(sonar_room.HALL)
        self.scan_well()
        found = self.node.call("recognize_place").recognition
        self.assertEqual((found.matches[0].label, found.verdict), ("hall", found.RECOGNIZED))
        diagnostics = Diagnostics(self.node)
        self.addCleanup(diagnostics.close)
        for service, request in (("learn_place", {"label": "study"}),
                                 ("rename_place", {"label": "hall", "new_label": "room"}),
                                 ("clear", {})):
            response = self.node.call(service, **request)
            self.assert_answer(response, response.STORE_FAILED)
            self.assertIn(self.node_store, response.message)
        self.run_robot(lambda: diagnostics.says("memory", DiagnosticStatus.ERROR, self.node_store),
                       "the diagnostics")
        self.assertEqual(self.labels(), ["hall"])

    def test_on_a_read_only_file_system_known_places_are_used(self):
        disk = os.path.join(self.folder, "disk")
        os.mkdir(disk)
        if not mount("-t", "tmpfs", "-o", "size=8m", "tmpfs", disk):
            raise unittest.SkipTest("file systems can be mounted by root alone")
        self.addCleanup(subprocess.run, ["umount", "-l", disk], check=True)
        self.node_store = os.path.join(disk, "places.db")
        self.learn_hall(self.node_store)
        self.assertEqual(self.node.stop(), 0)
        self.assertTrue(mount("-o", "remount,ro", disk))
        self.start_node(store=self.node_store)
        self.assert_known_places_serve()
        # Written again as soon as it can be.
        self.assertTrue(mount("-o", "remount,rw", disk))
        response = self.node.call("learn_place", label="study")
        self.assert_answer(response, response.OK)

    def test_on_a_full_disk_known_places_are_used_and_writing_resumes(self):
        disk = os.path.join(self.folder, "disk")
        os.mkdir(disk)
        if not mount("-t", "tmpfs", "-o", "size=2m", "tmpfs", disk):
            raise unittest.SkipTest("file systems can be mounted by root alone")
        self.addCleanup(subprocess.run, ["umount", "-l", disk], check=True)
        self.node_store = os.path.join(disk, "places.db")
        self.start_node(store=self.node_store, mode="map")
        self.learn("hall", sonar_room.HALL)
        saved = self.node.call("save", path="saved.db")
        self.assert_answer(saved, saved.OK)
        with open(saved.path, "rb") as file:
            before = file.read()
        rubbish = os.path.join(disk, "rubbish")
        with self.assertRaises(OSError), open(rubbish, "wb", buffering=0) as file:
            while True:
                file.write(bytes(4096))
        self.robot.enter(sonar_room.HALL)
        self.scan_well()
        found = self.node.call("recognize_place").recognition
        self.assertEqual((found.matches[0].label, found.verdict), ("hall", found.RECOGNIZED))
        response = self.node.call("learn_place", label="study")
        self.assert_answer(response, response.STORE_FAILED)
        self.assertIn(self.node_store, response.message)
        self.assertEqual(self.labels(), ["hall"])
        response = self.node.call("save", path="saved.db")
        self.assert_answer(response, response.STORE_FAILED)
        with open(saved.path, "rb") as file:
            self.assertEqual(file.read(), before)
        os.remove(rubbish)
        self.robot.enter(sonar_room.STUDY)
        self.scan_well()
        response = self.node.call("learn_place", label="study")
        self.assert_answer(response, response.OK)
        self.assertEqual(self.node.stop(), 0)
        self.assertEqual(sorted(os.listdir(disk)), ["places.db", "saved.db"])

    def test_of_another_user_known_places_are_used(self):
        if os.geteuid() != 0:
            raise unittest.SkipTest("only root can give files to another user")
        program = live_test.executable("place_memory_node")
        may_run = subprocess.run(["test", "-x", program], check=False,
                                 preexec_fn=lambda: os.setuid(NOBODY)).returncode == 0
        if not may_run:
            raise unittest.SkipTest("another user may not run " + program)
        self.learn_hall(self.store)
        self.assertEqual(self.node.stop(), 0)
        self.node_store = self.store
        os.chmod(self.folder, 0o755)
        start = live_test.subprocess.Popen
        self.addCleanup(setattr, live_test.subprocess, "Popen", start)
        live_test.subprocess.Popen = lambda *words, **options: start(
            *words, preexec_fn=lambda: (os.setgid(NOBODY), os.setuid(NOBODY)),
            env=dict(os.environ, ROS_LOG_DIR="/nowhere", HOME="/"), **options)
        self.start_node(store=self.store)
        live_test.subprocess.Popen = start
        self.assert_known_places_serve()

    def test_a_relative_path_is_said_in_full(self):
        here = os.getcwd()
        self.addCleanup(os.chdir, here)
        os.chdir(self.folder)
        self.learn_hall("maps/../places.db")
        self.assertIn("kept in " + self.store, self.node.output())
        self.assertTrue(os.path.exists(self.store))

    def test_a_path_in_the_home_folder_is_said_in_full(self):
        before = os.environ.get("HOME", "/")
        self.addCleanup(os.environ.__setitem__, "HOME", before)
        os.environ["HOME"] = self.folder
        self.learn_hall("~/places.db")
        self.assertIn("kept in " + self.store, self.node.output())
        self.assertTrue(os.path.exists(self.store))

    def test_a_store_that_is_replaced_under_the_node_is_left_alone(self):
        self.node_store = self.store
        self.learn_hall(self.store)
        other = self.store + ".other"
        shutil.copyfile(self.store, other)
        with open(other, "rb") as file:
            before = file.read()
        os.replace(other, self.store)
        self.assert_known_places_serve()
        self.node.stop()
        with open(self.store, "rb") as file:
            self.assertEqual(file.read(), before)

    def test_what_a_killed_creation_left_is_cleared_away(self):
        left = self.store + ".new-1234-5"
        with open(left, "w") as file:
            file.write("half a store")
        self.learn_hall(self.store)
        self.assertFalse(os.path.exists(left))
        self.assertEqual(self.labels(), ["hall"])


if __name__ == "__main__":
    live_test.main("live_store_test", LiveStoreTest)
