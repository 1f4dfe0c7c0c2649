#!/usr/bin/env python3
"""The simulated robot's node: what it publishes, what it does on cmd_vel, and its services."""

import math
import os
import tempfile
import time
import unittest

import rospy
import rostest
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from place_memory.srv import CarryRobot, MoveChair, SetDoor
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import Imu, Range
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

import live_test
from sim_node import SimNode

# A room of 6 m by 4 m, the robot in its middle; a door in the wall to the east.
WORLD = """
name: room
walls:
  - {material: brick, points: [[-3, -2], [3, -2], [3, 2], [-3, 2], [-3, -2]]}
doors:
  - {name: east, hinge: [3, -0.5], latch: [3, 0.5], swing: 1.5, open: false}
  - {name: across, hinge: [0.9, 0.6], latch: [0.9, 1.6], swing: 1.9, open: false}
chairs:
  - {name: armchair, at: [-2, -1]}
places:
  - {label: middle, at: [0, 0]}
"""
SONARS = 16
RING_RADIUS = 0.22  # [m]
TOP_SPEED = 1.0  # [m/s]
SPEED = 5.0  # simulated time over real time


def yaw(orientation):
    return 2.0 * math.atan2(orientation.z, orientation.w)


class LiveSimTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def world(self, text=WORLD):
        path = os.path.join(self.folder, "room.yaml")
        with open(path, "w") as file:
            file.write(text)
        return path

    def start(self, **parameters):
        if "world" not in parameters:
            parameters["world"] = self.world()
        self.sim = SimNode(self.folder, speed=SPEED, **parameters)
        self.addCleanup(self.sim.stop)

    def wait(self, condition, what, meanwhile=lambda: None):
        deadline = time.monotonic() + live_test.PATIENCE
        while not condition():
            if time.monotonic() > deadline:
                self.fail("waited for %s in vain; the node says:\n%s" % (what, self.sim.output()))
            meanwhile()
            time.sleep(0.01)

    def collected(self, topic, message_type, enough):
        """Messages until there are enough of them."""
        messages = []
        subscriber = rospy.Subscriber(topic, message_type, messages.append, queue_size=1000)
        self.wait(lambda: enough(list(messages)), topic)
        subscriber.unregister()
        return messages

    def ranges(self):
        """Ten readings of each sonar, by frame."""
        def by_frame(messages):
            frames = {}
            for message in messages:
                frames.setdefault(message.header.frame_id, []).append(message)
            return frames
        return by_frame(self.collected(
            self.sim.name("sonar"), Range, lambda messages: len(by_frame(messages)) == SONARS and
            min(map(len, by_frame(messages).values())) >= 10))

    def truth(self):
        return self.sim.message("~ground_truth", Odometry).pose.pose

    def outline(self):
        return self.sim.message("~world", MarkerArray).markers[0].points

    def drive(self, forwards, turn=0.0):
        """Says so again and again until the condition holds that is given to the result."""
        command = Twist()
        command.linear.x, command.angular.z = forwards, turn
        publisher = rospy.Publisher(self.sim.name("cmd_vel"), Twist, queue_size=1)
        self.addCleanup(publisher.unregister)
        return lambda condition, what: self.wait(condition, what,
                                                 lambda: publisher.publish(command))

    # --- what it publishes ---

    def test_sonars_hear_the_walls(self):
        self.start()
        frames = self.ranges()
        self.assertEqual(set(frames), {"sonar_%d" % i for i in range(SONARS)})
        east = frames["sonar_0"]
        for message in east:
            self.assertEqual(message.radiation_type, Range.ULTRASOUND)
            self.assertLess(message.min_range, message.max_range)
            self.assertAlmostEqual(message.field_of_view, 0.436, places=3)
        heard = sorted(message.range for message in east)[len(east) // 2]
        self.assertAlmostEqual(heard, 3.0 - RING_RADIUS, delta=0.15)

    def test_heading_is_the_robots(self):
        self.start(start={"x": 0.5, "y": -0.5, "yaw": 1.0})
        message = self.sim.message("heading", Imu)
        self.assertAlmostEqual(yaw(message.orientation), 1.0, places=6)
        self.assertGreaterEqual(message.orientation_covariance[0], 0.0)
        self.assertEqual(message.angular_velocity_covariance[0], -1.0)

    def test_odometry_begins_at_its_origin_wherever_the_robot_stands(self):
        self.start(start={"x": 0.5, "y": -0.5, "yaw": 1.0})
        odometry = self.sim.message("odom", Odometry)
        self.assertEqual((odometry.header.frame_id, odometry.child_frame_id), ("odom", "base_link"))
        self.assertEqual((odometry.pose.pose.position.x, odometry.pose.pose.position.y), (0.0, 0.0))
        truth = self.truth()
        self.assertEqual((truth.position.x, truth.position.y), (0.5, -0.5))
        self.assertAlmostEqual(yaw(truth.orientation), 1.0, places=6)

    def test_transforms_lead_from_the_world_to_the_sonars(self):
        self.start()
        fixed = self.collected("/tf_static", TFMessage, lambda messages: any(
            len(message.transforms) > SONARS for message in messages))[-1].transforms
        frames = {(t.header.frame_id, t.child_frame_id) for t in fixed}
        self.assertEqual(frames, {("world", "map")} |
                         {("base_link", "sonar_%d" % i) for i in range(SONARS)})
        moving = self.collected("/tf", TFMessage, len)[0].transforms[0]
        self.assertEqual((moving.header.frame_id, moving.child_frame_id), ("odom", "base_link"))

    def test_time_goes_on_and_on(self):
        self.start()
        times = [message.clock for message in
                 self.collected("/clock", Clock, lambda messages: len(messages) > 50)]
        for before, after in zip(times, times[1:]):
            steps = (after - before).to_sec() / 0.05  # more than one where a message was lost
            self.assertGreater(steps, 0.5)
            self.assertAlmostEqual(steps, round(steps), places=6)

    # --- cmd_vel ---

    def test_drives_as_it_is_told_and_stops_without_further_commands(self):
        self.start()
        self.drive(0.5)(lambda: self.truth().position.x > 0.5, "the robot to drive")
        self.wait(lambda: self.sim.message("odom", Odometry).twist.twist.linear.x == 0.0,
                  "the robot to stop")
        stopped = self.truth().position
        self.ranges()
        self.assertEqual(self.truth().position, stopped)
        odometry = self.sim.message("odom", Odometry).pose.pose.position
        self.assertAlmostEqual(odometry.x / stopped.x, 1.0, delta=0.06)

    def test_turns_as_it_is_told(self):
        self.start()
        self.drive(0.0, 0.5)(lambda: yaw(self.truth().orientation) > 0.5, "the robot to turn")
        self.assertAlmostEqual(self.truth().position.x, 0.0, places=6)

    def test_is_no_faster_than_it_can_be(self):
        self.start()
        speeds = []
        subscriber = rospy.Subscriber(self.sim.name("odom"), Odometry,
                                      lambda message: speeds.append(message.twist.twist.linear.x))
        self.addCleanup(subscriber.unregister)
        self.drive(-50.0)(lambda: speeds and speeds[-1] < 0.0, "the robot to drive")
        self.assertEqual(min(speeds), -TOP_SPEED)

    def test_a_command_that_is_not_finite_is_left_out(self):
        self.start()
        self.drive(float("nan"))(lambda: "not finite" in self.sim.output(), "a warning")
        self.assertEqual(self.truth().position.x, 0.0)

    def test_does_not_drive_through_a_wall(self):
        self.start()
        drive = self.drive(1.0)
        drive(lambda: self.truth().position.x > 2.5, "the robot to come to the wall")
        places = []

        def pushed_on():
            places.append(self.truth().position.x)
            return places[-10:].count(places[-1]) == 10
        drive(pushed_on, "the robot to stay where it is")
        self.assertLess(places[-1], 2.8)

    # --- services ---

    def answered(self, response, status):
        self.assertEqual(response.status, status, response.message)
        self.assertGreater(len(response.message), 3)

    def test_a_door_opens_and_shuts(self):
        self.start()
        shut = self.outline()
        response = self.sim.call("set_door", SetDoor, name="east", open=True)
        self.answered(response, response.OK)
        self.assertNotEqual(self.outline(), shut)
        self.sim.call("set_door", SetDoor, name="east", open=False)
        self.assertEqual(self.outline(), shut)

    def test_a_door_that_is_not_there(self):
        self.start()
        response = self.sim.call("set_door", SetDoor, name="attic", open=True)
        self.answered(response, response.UNKNOWN_NAME)
        self.assertIn("attic", response.message)

    def test_a_door_that_would_hit_the_robot(self):
        self.start(start={"x": 0.4, "y": 0.5, "yaw": 0.0})
        before = self.outline()
        response = self.sim.call("set_door", SetDoor, name="across", open=True)
        self.answered(response, response.BLOCKED)
        self.assertEqual(self.outline(), before)

    def move_chair(self, name, x, y, theta=0.0):
        request = MoveChair._request_class(name=name)
        request.pose.x, request.pose.y, request.pose.theta = x, y, theta
        return self.sim.call("move_chair", MoveChair, request)

    def test_a_chair_moves(self):
        self.start()
        before = self.outline()
        response = self.move_chair("armchair", 2.0, 1.0)
        self.answered(response, response.OK)
        self.assertNotEqual(self.outline(), before)

    def test_chairs_that_cannot_move_stay(self):
        self.start()
        before = self.outline()
        refused = MoveChair._response_class
        for name, x, status in (("stool", 1.0, refused.UNKNOWN_NAME),
                                ("armchair", 0.1, refused.BLOCKED),
                                ("armchair", float("nan"), refused.BLOCKED),
                                ("armchair", float("inf"), refused.BLOCKED),
                                ("armchair", 1e12, refused.BLOCKED)):
            with self.subTest(name=name, x=x):
                self.answered(self.move_chair(name, x, 0.0), status)
        self.assertEqual(self.outline(), before)

    def carry(self, x, y, theta):
        request = CarryRobot._request_class()
        request.pose.x, request.pose.y, request.pose.theta = x, y, theta
        return self.sim.call("carry_robot", CarryRobot, request)

    def test_a_robot_is_carried_and_its_odometry_does_not_notice(self):
        self.start()
        response = self.carry(2.0, 1.0, 0.5)
        self.answered(response, response.OK)
        truth, odometry = self.truth(), self.sim.message("odom", Odometry).pose.pose
        self.assertEqual((truth.position.x, truth.position.y), (2.0, 1.0))
        self.assertAlmostEqual(yaw(truth.orientation), 0.5, places=6)
        self.assertEqual((odometry.position.x, odometry.position.y), (0.0, 0.0))

    def test_a_robot_is_not_put_on_anything(self):
        self.start()
        for x in (3.0, float("nan"), 1e12):
            with self.subTest(x=x):
                self.answered(self.carry(x, 0.0, 0.0), CarryRobot._response_class.BLOCKED)
        self.assertEqual(self.truth().position.x, 0.0)

    # --- parameters ---

    def refused(self, *words, **parameters):
        self.start(**parameters)
        self.assertEqual(self.sim.process.wait(live_test.PATIENCE), 1)
        for word in words:
            self.assertIn(word, self.sim.output())

    def test_bad_parameters_are_all_listed(self):
        self.refused("seed", "people", "odometry/turn", "colour", seed=-1, people="many",
                     odometry__turn=2.0, colour="red")

    def test_a_world_is_needed(self):
        self.refused("world", world="")

    def test_a_world_that_is_not_there(self):
        self.refused("/nowhere.yaml", world="/nowhere.yaml")

    def test_a_world_with_an_error(self):
        self.refused("room.yaml:3", world=self.world("name: room\nplaces:\n  - {at: [0, 0]}\n"))

    def test_a_start_where_something_stands(self):
        self.refused("start", start={"x": 3.0, "y": 0.0, "yaw": 0.0})


if __name__ == "__main__":
    rospy.init_node("live_sim_test")
    rostest.rosrun("place_memory", "live_sim_test", LiveSimTest)
