#!/usr/bin/env python3
"""A live node that has a server of MoveBaseAction drive: what the server does not manage, or does not
say."""

import math
import threading

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from move_base_msgs.msg import MoveBaseAction, MoveBaseActionGoal
from place_memory.msg import GoToPlaceResult

import live_test
from driving_robot import ORIGIN, SOUTH_EAST, GoTestCase
from sonar_room import compose

TURN, WAY = 0.4, 0.15  # of the robot in one step [rad], [m]


class MoveBase:
    """A server that puts the robot where it is asked to, but for what a test has it do instead:
    `answers` are called with one goal each, in their order."""

    def __init__(self, namespace, robot):
        self.robot = robot
        self.goals = []
        self.canceled = []
        self.answers = []
        self._lock = threading.Lock()
        self._server = actionlib.ActionServer(namespace + "/move_base", MoveBaseAction,
                                              self._on_goal, self._on_cancel, auto_start=False)
        self._server.start()

    def _on_goal(self, goal):
        goal.set_accepted()
        with self._lock:
            self.goals.append(goal)
            answer = self.answers.pop(0) if self.answers else self.drive
        answer(goal)

    def _on_cancel(self, goal):
        self.canceled.append(goal)
        goal.set_canceled()

    def drive(self, goal):
        pose = goal.get_goal().target_pose.pose
        yaw = 2.0 * math.atan2(pose.orientation.z, pose.orientation.w)
        target = compose(ORIGIN, (pose.position.x, pose.position.y, yaw))
        self.robot.on_arrival = goal.set_succeeded
        self.robot.targets.append(target)

    @staticmethod
    def abort(goal):
        goal.set_aborted(text="no path")

    @staticmethod
    def wait(goal):
        pass


class LiveMoveBaseTest(GoTestCase):
    def start_with(self, server=True, **parameters):
        self.start_at(drive__by="move_base", **parameters)
        self.robot.targets = []
        self.robot.on_arrival = None
        namespace = self.node.name.rsplit("/", 1)[0]
        self.goal_topic = namespace + "/move_base/goal"
        if server:
            self.move_base = MoveBase(namespace, self.robot)
        self.place = self.place_near(SOUTH_EAST)

    def _step(self):
        """The robot goes a step nearer to where the server wants it, or is there."""
        targets = getattr(self.robot, "targets", None)
        target = targets[0] if targets else self.robot.in_room
        if self.distance(target) > 0.05:
            x, y, yaw = self.robot.in_room
            bearing = math.atan2(target[1] - y, target[0] - x) - yaw
            bearing = math.atan2(math.sin(bearing), math.cos(bearing))
            self.robot.move(0.0, max(-TURN, min(TURN, bearing)))
            if abs(bearing) <= TURN:
                self.robot.move(min(self.distance(target), WAY), 0.0)
        super()._step()
        if targets and targets[0] is target and self.distance(target) < 0.05:
            targets.pop(0)
            self.robot.on_arrival()

    def test_the_server_drives_leg_by_leg(self):
        self.start_with()
        result = self.end(self.go(label=self.place.label), GoToPlaceResult.REACHED)
        self.assert_at(self.place)
        self.assertEqual(len(self.move_base.goals), result.legs)
        frames = {goal.get_goal().target_pose.header.frame_id for goal in self.move_base.goals}
        self.assertEqual(frames, {"map"})
        self.assertEqual(set(self.robot.velocities), set())

    def test_what_the_server_gives_up_is_gone_round(self):
        self.start_with()
        self.move_base.answers = [self.move_base.drive, self.move_base.drive, MoveBase.abort]
        result = self.end(self.go(label=self.place.label), GoToPlaceResult.REACHED)
        self.assert_at(self.place)
        self.assertEqual(len(result.tried), 1)
        self.assertIn("no path", result.failed_leg)
        failed = [direction.failed for link in self.graph().links
                  for direction in (link.forward, link.backward)]
        self.assertEqual(sum(failed), 1)

    def test_a_server_that_is_not_there_when_it_says_so_is_not_believed(self):
        self.start_with()
        self.move_base.answers = [lambda goal: goal.set_succeeded()] * 100
        result = self.end(self.go(id=self.place.id), GoToPlaceResult.NO_ROUTE)
        self.assertIn("same map", result.failed_leg)

    def test_somebody_else_drives_through_the_server(self):
        self.start_with()
        self.move_base.answers = [lambda goal: goal.set_canceled(text="another goal")]
        result = self.end(self.go(label=self.place.label), GoToPlaceResult.PREEMPTED)
        self.assertIn("another goal", result.message)

    def test_a_cancel_goes_on_to_the_server(self):
        self.start_with()
        self.move_base.answers = [MoveBase.wait]
        goal = self.go(label=self.place.label)
        self.run_robot(lambda: self.move_base.goals, "the server's goal")
        goal.cancel()
        self.end(goal, GoToPlaceResult.CANCELED)
        self.run_robot(lambda: self.move_base.canceled, "the server's cancel")

    def test_a_robot_that_is_lost_is_not_driven_on(self):
        self.start_with()
        self.move_base.answers = [MoveBase.wait]
        goal = self.go(label=self.place.label)
        self.run_robot(lambda: self.move_base.goals, "the server's goal")
        self.run_for(0.5)
        self.robot.odometry = (30.0, 0.0, 0.0)
        self.end(goal, GoToPlaceResult.LOST)
        self.run_robot(lambda: self.move_base.canceled, "the server's cancel")

    def test_nobody_listens(self):
        self.start_with(server=False, drive__timeout=1.0)
        result = self.end(self.go(label=self.place.label), GoToPlaceResult.SILENT)
        self.assertIn("start the server", result.message)

    def test_a_server_that_says_nothing(self):
        self.start_with(server=False, drive__timeout=1.0)
        goals = []
        deaf = rospy.Subscriber(self.goal_topic, MoveBaseActionGoal, goals.append)
        self.addCleanup(deaf.unregister)
        self.run_robot(lambda: deaf.get_num_connections() > 0, "the node to connect")
        goal = self.go(label=self.place.label)
        result = self.end(goal, GoToPlaceResult.SILENT)
        self.assertEqual(goal.state(), GoalStatus.ABORTED)
        self.assertEqual(len(goals), 1)
        self.assertIn("said nothing", result.message)
        self.assertEqual(self.robot.velocities[-1], (0.0, 0.0))


if __name__ == "__main__":
    live_test.main("live_move_base_test", LiveMoveBaseTest)
