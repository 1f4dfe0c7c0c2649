#!/usr/bin/env python3
"""The examples and the relocalizer beside a live node."""

import os
import subprocess

import actionlib
import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped
from place_memory import msg, srv

import live_test
import sonar_room


class LiveExamplesTest(live_test.LiveTestCase):
    def setUp(self):
        super().setUp()
        self.start_node(scan__headings=1)

    def start(self, program, *arguments):
        with open(os.path.join(self.folder, program + ".log"), "w") as log:
            process = subprocess.Popen((live_test.executable(program),) + arguments, stdout=log,
                                       stderr=subprocess.STDOUT)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def run_example(self, program, *words):
        process = self.start(program, *words, "_node:=" + self.node.name, "_turn:=1")
        self.run_robot(lambda: process.poll() is not None, program + " to end")
        with open(os.path.join(self.folder, program + ".log")) as log:
            output = log.read()
        self.assertEqual(process.returncode, 0, output)
        return output

    def test_the_examples_learn_and_recognize(self):
        self.assertIn('learned "hall"', self.run_example("visit_place", "learn", "hall"))
        self.robot.enter(sonar_room.STUDY)
        self.assertIn('learned "study"', self.run_example("visit_place.py", "learn", "study"))
        self.assertEqual(self.labels(), ["hall", "study"])
        self.assertRegex(self.run_example("visit_place", "recognize"), r"study\n.*hall\n")
        self.robot.enter(sonar_room.HALL)
        self.assertRegex(self.run_example("visit_place.py", "recognize"), r"hall\n.*study\n")
        for program in ("visit_place", "visit_place.py"):
            self.assertIn('reached "hall"', self.run_example(program, "go", "hall"))

    def test_the_relocalizer_tells_a_navigation_stack_where_the_robot_is(self):
        self.learn("hall", sonar_room.HALL)
        self.learn("study", sonar_room.STUDY)
        name = self.node.name + "_relocalizer"
        self.start("relocalizer.py", "__name:=" + name.split("/")[-1],
                   "__ns:=" + self.node.name.rsplit("/", 1)[0], "_turn:=1", "_tries:=1")
        poses = []
        namespace = self.node.name.rsplit("/", 1)[0]
        subscriber = rospy.Subscriber(namespace + "/initialpose", PoseWithCovarianceStamped,
                                      poses.append)
        self.addCleanup(subscriber.unregister)
        client = actionlib.SimpleActionClient(name + "/relocalize", msg.RelocalizeAction)
        self.hold(lambda: client.wait_for_server(rospy.Duration(0.01)), "the action")
        self.wait(lambda: subscriber.get_num_connections() > 0, "the relocalizer's topic")
        client.send_goal(msg.RelocalizeGoal())
        self.run_robot(lambda: client.get_state() in (3, 4), "the action to end")
        result = client.get_result()
        self.assertEqual((result.status, result.place), (result.FOUND, "study"), result.message)
        self.wait(lambda: poses, "the pose")
        self.assertEqual(poses[0].header.frame_id, "map")
        self.assertEqual(poses[0].pose, result.pose.pose)

        answers = []
        ask = rospy.ServiceProxy(name + "/relocalize", srv.RecognizePlace)
        asking = live_test.InThreads(lambda: answers.append(ask()))
        self.run_robot(asking.are_over, "the service to answer")
        asking.join()
        self.assertEqual(answers[0].recognition.matches[0].label, "study")


if __name__ == "__main__":
    live_test.main("live_examples_test", LiveExamplesTest)
