"""A robot that drives by cmd_vel in a room where a drive has made a map, and goals for it."""

import math
import os
import shutil
import subprocess
import tempfile

import rospy
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from place_memory import msg

import corridor_bag
import live_test
import sonar_room
from fake_robot import STEP, FakeRobot
from sonar_room import Room, compose, inverse

# Across the way along the south side, and along the north side.
SOUTH = (0.6, -2.5, 0.3, 3.9)
NORTH = (0.0, 2.7, 0.3, 3.6)
ROOM = corridor_bag.ROOM
ORIGIN = (-0.5 * corridor_bag.WIDTH + corridor_bag.CORNER, -0.5 * corridor_bag.DEPTH, 0.0)
SOUTH_WEST, SOUTH_EAST = (-2.4, -1.75), (2.4, -1.75)


def room_with(*walls):
    """The room, and more boxes in it."""
    room = Room(1.0, 1.0, walls)
    room.lines = ROOM.lines + room.lines[4:]
    return room


class DrivingRobot(FakeRobot):
    """Follows both parts of a velocity."""

    def __init__(self, *arguments):
        self.velocities = []
        super().__init__(*arguments)

    def _on_command(self, message):
        self.velocities.append((message.linear.x, message.angular.z))
        super()._on_command(message)

    def step(self):
        before = self._obeyed
        turn = self._take_command()
        forward = self.velocities[-1][0] if self._obeyed > before else 0.0
        self.move(forward * STEP, turn * STEP)
        self.world.set_time(self.world.now + STEP)
        self.say()

    def move(self, way, turn):
        for move in ((0.5 * way, 0.0, turn), (0.5 * way, 0.0, 0.0)):
            self.in_room = compose(self.in_room, move)
            self.odometry = compose(self.odometry, move)


class Goal(live_test.ActionGoal):
    """A goal of ~go_to_place on its way."""

    action, action_type, goal_type = "/go_to_place", msg.GoToPlaceAction, msg.GoToPlaceGoal

    def __init__(self, node, **goal):
        super().__init__(node, self.goal_type(**goal))


class DriveTestCase(live_test.LiveTestCase):
    """The node drives the robot."""

    robot_type = DrivingRobot

    def go_on(self, way, goal):
        """Until the robot has driven so far from where it is [m], under way to the goal."""
        start = self.robot.in_room
        self.run_robot(lambda: goal.is_over() or self.distance(start) > way, "the robot to drive")
        self.assertFalse(goal.is_over(), goal.result())

    def end(self, goal, status):
        """Its result."""
        self.run_robot(goal.is_over, "the goal to end")
        result = goal.result()
        self.assertEqual(result.status, status, result)
        self.assertGreater(len(result.message), 3)
        return result

    def distance(self, spot):
        return math.hypot(self.robot.in_room[0] - spot[0], self.robot.in_room[1] - spot[1])

    def assert_stands(self):
        """The newest velocity that the node sent is none."""
        self.run_robot(lambda: self.robot.velocities and self.robot.velocities[-1] == (0.0, 0.0),
                       "the robot to be stopped")
        here = self.robot.in_room
        self.run_for(1.0)
        self.assertLess(self.distance(here), 1e-6)


class GoTestCase(DriveTestCase):
    """The robot stands in a room of which the node has a map, made by a drive round its middle."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.kept = os.path.join(folder.name, "places.db")
        drive = os.path.join(folder.name, "drive.bag")
        cls.map_drive = corridor_bag.CorridorBag(drive, 100.0, 2, seed=1)
        parameters = os.path.join(folder.name, "params.yaml")
        with open(parameters, "w") as file:
            file.write("sonar_topics: [/sonar]\nheading_topic: /heading\n")
        subprocess.run([live_test.executable("place_memory_bag"), "--bag", drive, "--mode", "map",
                        "--store", cls.kept, "--params", parameters], check=True,
                       stderr=subprocess.DEVNULL, timeout=100)

    def start(self, at=SOUTH_WEST, **parameters):
        """The robot stands at that spot of the room; the node does not know so."""
        store = os.path.join(self.folder, "places.db")
        shutil.copy(self.kept, store)
        given = {"store": store, "drive__speed": 1.0, "drive__turn_rate": 1.5,
                 "drive__patience": 1.0}
        given.update(parameters)
        self.start_node(**given)
        self.robot.room = ROOM
        self.robot.in_room = at + (0.0,)
        self.robot.odometry = (0.0, 0.0, 0.0)
        self.run_for(0.5)

    def start_at(self, at=SOUTH_WEST, **parameters):
        """The node knows where the robot is, too."""
        self.start(at, **parameters)
        if parameters.get("mode", "off") == "off":
            self.recognize()
        else:
            self.say_where()

    def recognize(self):
        self.scan_well()
        response = self.node.call("recognize_place")
        self.assertEqual(response.recognition.verdict, msg.Recognition.RECOGNIZED, response.message)

    def say_where(self):
        teller = rospy.Publisher(self.node.name.rsplit("/", 1)[0] + "/initialpose",
                                 PoseWithCovarianceStamped, queue_size=1)
        self.addCleanup(teller.unregister)
        self.wait(lambda: teller.get_num_connections() > 0, "the node to listen")
        poses = []
        subscriber = rospy.Subscriber(self.node.name + "/pose", PoseWithCovarianceStamped,
                                      poses.append)
        self.addCleanup(subscriber.unregister)
        said = PoseWithCovarianceStamped()
        said.header.frame_id = "map"
        x, y, yaw = self.on_map(self.robot.in_room)
        said.pose.pose.position.x, said.pose.pose.position.y = x, y
        said.pose.pose.orientation.z = math.sin(0.5 * yaw)
        said.pose.pose.orientation.w = math.cos(0.5 * yaw)
        # The robot stands, and the node may not have heard of its odometry yet.
        self.run_robot(lambda: poses or teller.publish(said), "the pose that was said")

    @staticmethod
    def on_map(in_room):
        return compose(inverse(ORIGIN), in_room)

    def place_near(self, spot):
        """Of the map, nearest to a spot of the room."""
        x, y, _ = self.on_map(spot + (0.0,))
        return min(self.node.call("list_places").places,
                   key=lambda place: math.hypot(place.location.x - x, place.location.y - y))

    def go(self, **goal):
        sent = Goal(self.node, **goal)
        self.addCleanup(sent.leave)
        return sent

    def assert_at(self, place, tolerance=0.6):
        """By where the robot truly stood when the place was made. The map has that a third of a metre
        beside, since the odometry of its drive was noisy, and a quarter off a robot is there."""
        made = self.map_drive.at(place.learned.to_sec())
        self.assertLess(self.distance(made), tolerance)


def pose_at(x, y, frame="map"):
    pose = PoseStamped()
    pose.header.frame_id = frame
    pose.pose.position.x, pose.pose.position.y = x, y
    pose.pose.orientation.w = 1.0
    return pose
