#!/usr/bin/env python3
"""What a start by launch/place_memory.launch leaves behind for the next one: nothing."""

import os
import subprocess
import tempfile
import unittest

import rospy
from place_memory.srv import ListPlaces

import live_test

NAME = "launched_memory"


class LiveLaunchTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.log = os.path.join(self.folder, "log")

    def launch(self, params=None):
        """Starts it with a file of this text; without one, with the default."""
        words = ["roslaunch", "--wait", "place_memory", "place_memory.launch", "name:=" + NAME]
        if params is not None:
            path = os.path.join(self.folder, "params.yaml")
            with open(path, "w") as file:
                file.write(params)
            words.append("params:=" + path)
        with open(self.log, "w") as log:
            process = subprocess.Popen(words, stdout=log, stderr=subprocess.STDOUT)
        self.addCleanup(self.stop, process)
        return process

    def stop(self, process):
        if process.poll() is None:
            process.terminate()
        process.wait(live_test.PATIENCE)

    def assert_runs(self, process):
        name = "/%s/list_places" % NAME
        try:
            rospy.wait_for_service(name, live_test.PATIENCE)
        except rospy.ROSException as error:
            with open(self.log) as log:
                self.fail("%s\n%s" % (error, log.read()))
        self.assertEqual(rospy.ServiceProxy(name, ListPlaces)().status, 0)
        self.stop(process)

    def assert_refused(self, process, parameter):
        process.wait(live_test.PATIENCE)  # roslaunch ends with its last node
        with open(self.log) as log:
            self.assertIn("  " + parameter, log.read())

    def test_a_mended_mistake_is_forgotten(self):
        self.assert_refused(self.launch("scan: {heading: 5}\n"), "scan/heading")
        self.assert_runs(self.launch("scan: {headings: 5}\n"))
        self.assertEqual(rospy.get_param("/%s/scan/headings" % NAME), 5)
        self.assert_refused(self.launch("scan: {heading: 5}\n"), "scan/heading")
        self.assert_runs(self.launch())
        self.assertNotEqual(rospy.get_param("/%s/scan/headings" % NAME), 5)


if __name__ == "__main__":
    live_test.main("live_launch_test", LiveLaunchTest)
