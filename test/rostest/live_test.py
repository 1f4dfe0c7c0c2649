"""What tests beside a live place_memory_node share."""

import contextlib
import os
import resource
import subprocess
import tempfile
import threading
import time
import unittest

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from nav_msgs.srv import GetPlan
from place_memory import msg, srv
from roslib.packages import find_node

from fake_robot import FakeRobot, World
import sonar_room

PATIENCE = 60.0  # with a slow machine [s]
# Simulated time is so much ahead of the node's at most: a heading that seems to come from the
# future is left out [s].
LEAD = 0.5

SERVICES = {
    "learn_place": srv.LearnPlace,
    "recognize_place": srv.RecognizePlace,
    "list_places": srv.ListPlaces,
    "rename_place": srv.RenamePlace, "remove_place": srv.RemovePlace,
    "clear": srv.Clear,
    "get_graph": srv.GetGraph,
    "plan_route": srv.PlanRoute,
    "report_traversal": srv.ReportTraversal,
    "set_link": srv.SetLink,
    "make_plan": GetPlan,
    "suggest_view": srv.SuggestView,
    "set_mode": srv.SetMode,
    "relocalize": srv.Relocalize,
    "judge_closure": srv.JudgeClosure,
    "undo": srv.Undo, "save": srv.Save, "load": srv.Load,
}


def executable(name):
    return find_node("place_memory", name)[0]


class Node:
    """A place_memory_node in a namespace of its own, and its services."""

    def __init__(self, namespace, parameters, log, arguments=()):
        self.name = namespace + "/place_memory"
        for name, value in parameters.items():
            rospy.set_param(self.name + "/" + name, value)
        self.log = log
        with open(log, "w") as file:
            self.process = subprocess.Popen(
                [executable("place_memory_node"), "__ns:=" + namespace, "__name:=place_memory",
                 *arguments],
                stdout=file, stderr=subprocess.STDOUT,
                restore_signals=False)  # a write beyond a limit is to fail, not to kill

    def wait_for_services(self):
        for name in SERVICES:
            rospy.wait_for_service(self.name + "/" + name, PATIENCE)

    def call(self, service, **request):
        return rospy.ServiceProxy(self.name + "/" + service, SERVICES[service])(**request)

    def latched(self, topic, message_type):
        """What a subscriber gets who comes now."""
        return rospy.wait_for_message(self.name + "/" + topic, message_type, PATIENCE)

    def allow_writes(self, allowed):
        """Not allowed: as with a disk that is full."""
        resource.prlimit(self.process.pid, resource.RLIMIT_FSIZE,
                         (resource.RLIM_INFINITY if allowed else 0, resource.RLIM_INFINITY))

    def stop(self):
        """As a person does at the keyboard. Returns the exit code."""
        if self.process.poll() is None:
            self.process.terminate()
        return self.process.wait(PATIENCE)

    def kill(self):
        self.process.kill()
        self.process.wait(PATIENCE)

    def output(self):
        with open(self.log) as file:
            return file.read()


class ActionGoal:
    """A goal of one of the node's actions on its way."""

    action, action_type = None, None  # by whoever derives from it

    def __init__(self, node, goal):
        self.feedback = []
        self._client = actionlib.ActionClient(node.name + self.action, self.action_type)
        self._client.wait_for_server()
        self._goal = self._client.send_goal(
            goal, feedback_cb=lambda _, feedback: self.feedback.append(feedback))

    def cancel(self):
        self._goal.cancel()

    def leave(self):
        """The client goes away without a word."""
        self._client.stop()

    def is_over(self):
        return self._goal.get_comm_state() == actionlib.CommState.DONE

    def state(self):
        """Once it is over, a constant of GoalStatus."""
        return self._goal.get_goal_status()

    def result(self):
        return self._goal.get_result()


class Scan(ActionGoal):
    """A goal of ~scan on its way."""

    action, action_type = "/scan", msg.ScanPlaceAction

    def __init__(self, node, goal, now):
        self.begun = now  # [s]
        self.node_time = 0.0  # at the newest feedback [s]
        self._subscriber = rospy.Subscriber(node.name + "/scan/feedback",
                                            msg.ScanPlaceActionFeedback, self._on_stamped_feedback)
        super().__init__(node, goal)

    def _on_stamped_feedback(self, message):
        self.node_time = message.header.stamp.to_sec()

    def leave(self):
        self._subscriber.unregister()
        super().leave()


class LiveTestCase(unittest.TestCase):
    """A test starts a fresh node, and has a robot in a hall whose messages reach it."""

    world = None
    nodes = 0
    robot_type = FakeRobot

    @classmethod
    def setUpClass(cls):
        if LiveTestCase.world is None:
            LiveTestCase.world = World()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.newest_scan = None
        self.world.now += 100.0  # no test sees the time of another one

    @contextlib.contextmanager
    def subTest(self, *message, **parameters):
        """The first part that fails ends its test and says which it was: what unittest's own finds,
        rosunit counts and does not tell."""
        try:
            yield
        except AssertionError as error:
            raise AssertionError("with %s: %s" % (parameters or message, error)) from error

    def start_node(self, **parameters):
        """Starts a node, by names that no node had before, and a robot for it; waits until it hears
        the robot. Parameters within tables have two underscores."""
        LiveTestCase.nodes += 1
        namespace = "/test_%d" % LiveTestCase.nodes
        # Readings wait as long as a slow machine needs to bring their transforms.
        given = {"scan/tf_timeout": 3.0, "scan/heading_timeout": 3.0, "scan/turn_rate": 1.0,
                 "scan/headings": 11}
        given.update({name.replace("__", "/"): value for name, value in parameters.items()})
        self.robot = self.robot_type(self.world, namespace, sonar_room.HALL)
        self.addCleanup(self.robot.close)
        self.node = Node(namespace, given, os.path.join(self.folder, namespace[1:] + ".log"))
        self.addCleanup(self.node.stop)
        self.node.wait_for_services()
        self.wait(lambda: self.robot.is_connected(self.node.name), "the node to connect")

    def wait(self, condition, what):
        """While time stands still."""
        self._poll(condition, what, lambda: time.sleep(0.01))

    def run_robot(self, condition, what):
        """Lets simulated time go on until the condition holds."""
        self._poll(condition, what, self._step)

    def hold(self, condition, what):
        """While time stands still, which is said again and again."""
        self._poll(condition, what, self._say_time)

    def _say_time(self):
        self.world.set_time(self.world.now)
        time.sleep(0.01)

    def _step(self):
        """While a scan runs, time does not get far ahead of the node's."""
        if self._node_is_behind():
            self._say_time()
        else:
            self.robot.step()

    def _node_is_behind(self):
        scan = self.newest_scan
        return (scan is not None and not scan.is_over() and self.node.process.poll() is None
                and max(scan.begun, scan.node_time) < self.world.now - LEAD)

    def _poll(self, condition, what, meanwhile):
        deadline = time.monotonic() + PATIENCE
        while not condition():
            if time.monotonic() > deadline:
                self.fail("waited for " + what + " in vain; the node says:\n" + self.node.output())
            meanwhile()

    def run_for(self, seconds):
        end = self.world.now + seconds
        self.run_robot(lambda: self.world.now >= end, "time")

    def begin_scan(self, **goal):
        self.newest_scan = Scan(self.node, msg.ScanPlaceGoal(**goal), self.world.now)
        self.addCleanup(self.newest_scan.leave)
        return self.newest_scan

    def finish(self, scan):
        self.run_robot(scan.is_over, "a scan to end")
        return scan.result()

    def scan(self, **goal):
        """The result of a scan, by default one at a standstill."""
        goal.setdefault("headings", 1)
        return self.finish(self.begin_scan(**goal))

    def scan_well(self, **goal):
        result = self.scan(**goal)
        self.assertEqual(result.status, msg.ScanPlaceResult.SUCCEEDED, result.message)
        return result

    def learn(self, label, room, **position):
        """Carries the robot into the room and learns the place there."""
        self.robot.enter(room, **position)
        self.scan_well()
        response = self.node.call("learn_place", label=label)
        self.assertEqual(response.status, response.OK, response.message)
        return response

    def graph(self):
        """The whole map, as it is now."""
        return self.node.call("get_graph").graph

    def labels(self):
        return [place.label for place in self.node.call("list_places").places]

    def assert_answer(self, response, status):
        """The status, and a sentence with it."""
        self.assertEqual(response.status, status, response.message)
        self.assertGreater(len(response.message), 3)


class InThreads:
    """Calls that run beside the test; what they raise is raised again by join()."""

    def __init__(self, *calls):
        self.errors = []
        self.threads = [threading.Thread(target=self._run, args=(call,)) for call in calls]
        for thread in self.threads:
            thread.start()

    def _run(self, call):
        try:
            call()
        except Exception as error:  # passed on to the test
            self.errors.append(error)

    def are_over(self):
        return not any(thread.is_alive() for thread in self.threads)

    def join(self):
        for thread in self.threads:
            thread.join()
        if self.errors:
            raise self.errors[0]


def main(name, test_case):
    import rostest
    rospy.init_node(name)
    rostest.rosrun("place_memory", name, test_case)


__all__ = ["GoalStatus", "InThreads", "LiveTestCase", "Node", "PATIENCE", "executable", "main"]
