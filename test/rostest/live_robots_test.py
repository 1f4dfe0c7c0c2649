#!/usr/bin/env python3
"""Every robot of launch/robots learns places and recognizes them, by launch file and parameters alone:
the simulator says what that robot's driver would."""

import os
import subprocess
import sys
import tempfile
import time
import unittest

import actionlib
import rospkg
import rospy
import yaml
from place_memory import msg, srv

import live_test

PACKAGE = rospkg.RosPack().get_path("place_memory")
sys.path.insert(0, os.path.join(PACKAGE, "scripts"))
from demo_tools.driver import Driver  # noqa: E402

SPEED = 4  # simulated time over real time
PLACES = 3  # the first ones of the world
ASIDE = 0.25  # so far off the robot recognizes a place along x [m]


def load(*path):
    with open(os.path.join(PACKAGE, *path)) as file:
        return yaml.safe_load(file)


class LiveRobotsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.processes = []

    def launch(self, file, *arguments):
        log = os.path.join(self.folder, file + ".log")
        with open(log, "w") as output:
            process = subprocess.Popen(["roslaunch", "--wait", "place_memory", file, *arguments],
                                       stdout=output, stderr=subprocess.STDOUT)
        self.processes.append((process, log))
        self.addCleanup(self.stop, process)

    def stop(self, process):
        if process.poll() is None:
            process.terminate()
        process.wait(live_test.PATIENCE)

    def check(self):
        for process, log in self.processes:
            if process.poll() is not None:
                with open(log) as output:
                    self.fail("%s ended: %s" % (log, output.read()))

    def said(self):
        text = ""
        for _, log in self.processes:
            with open(log) as output:
                text += output.read()
        return text

    def start(self, robot):
        self.launch("robot_sim.launch", "robot:=" + robot, "speed:=%g" % SPEED)
        self.launch(robot + ".launch")
        driver = load("config", "robots", "sim_%s.yaml" % robot).get("robot", {})
        self.driver = Driver(self.check, driver.get("command_topic", "cmd_vel"))
        self.driver.pose()  # from then on simulated time runs
        self.scanner = actionlib.SimpleActionClient("place_memory/scan", msg.ScanPlaceAction)
        self.wait(lambda: self.scanner.wait_for_server(rospy.Duration(0.5)), "the action")

    def wait(self, condition, what):
        deadline = time.monotonic() + live_test.PATIENCE
        while not condition():
            self.check()
            if time.monotonic() > deadline:
                self.fail("waited for %s in vain: %s" % (what, self.said()))
            time.sleep(0.02)

    def scan(self):
        self.scanner.send_goal(msg.ScanPlaceGoal())
        self.wait(lambda: self.scanner.get_result() is not None, "a scan")
        result = self.scanner.get_result()
        self.assertEqual(result.status, result.SUCCEEDED, result.message + self.said())

    def call(self, service, service_type, **request):
        answer = rospy.ServiceProxy("place_memory/" + service, service_type)(**request)
        self.assertEqual(answer.status, 0, answer.message)
        return answer

    def walk(self, robot):
        self.start(robot)
        world = load("config", "worlds", "rooms.yaml")
        places = [(place["label"], place["at"]) for place in world["places"][:PLACES]]
        for label, (x, y) in places:
            self.driver.go_to(x, y)
            self.scan()
            self.call("learn_place", srv.LearnPlace, label=label)
        for label, (x, y) in reversed(places):
            self.driver.go_to(x + ASIDE, y)
            self.scan()
            found = self.call("recognize_place", srv.RecognizePlace)
            best = found.recognition.matches[0]
            rospy.loginfo("%s at %s: %s, %.3f", robot, label, found.message, best.probability)
            self.assertEqual((best.label, found.recognition.verdict),
                             (label, found.recognition.RECOGNIZED), found.message)

    def test_pioneer3dx(self):
        self.walk("pioneer3dx")

    def test_hcsr04(self):
        self.walk("hcsr04")

    def test_nomad200(self):
        self.walk("nomad200")

    def test_crazyflie(self):
        self.walk("crazyflie")

    def test_laser(self):
        self.walk("laser")


if __name__ == "__main__":
    live_test.main("live_robots_test", LiveRobotsTest)
