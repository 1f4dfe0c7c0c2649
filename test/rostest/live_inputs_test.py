#!/usr/bin/env python3
"""A live node beside robots whose drivers say things each in its own way."""

import math
import struct

from geometry_msgs.msg import Point32
from nav_msgs.msg import Odometry
from place_memory.msg import Recognition, ScanPlaceGoal, ScanPlaceResult
import rospy
from sensor_msgs.msg import (LaserScan, MagneticField, PointCloud, PointCloud2, PointField, Range)
from std_msgs.msg import Float64, String
from tf2_msgs.msg import TFMessage

import fake_robot
import live_test
import sonar_room

BEAMS = 181


class AnyRobot(fake_robot.FakeRobot):
    """Publishes what a test gives it: `outputs`, topic -> (type, message of the robot)."""

    def __init__(self, world, namespace, room):
        super().__init__(world, namespace, room)
        self.namespace = namespace
        self.outputs = {}
        self.publishers = {}
        self.says_tf = True

    def give(self, **outputs):
        for topic, (message_type, make) in outputs.items():
            self.publishers[topic] = rospy.Publisher(self.namespace + "/" + topic, message_type,
                                                     queue_size=1000)
            self.outputs[topic] = make

    def close(self):
        super().close()
        for publisher in self.publishers.values():
            publisher.unregister()

    def is_connected(self, node):
        return (self.world.is_connected(node) and self._commands.get_num_connections() > 0
                and all(publisher.impl.has_connection(node)
                        for publisher in self.publishers.values()))

    def say(self):
        stamp = self.world.stamp()
        if self.says_tf:
            self.world.tf.publish(TFMessage([
                fake_robot.transform("odom", "base_link", self.odometry, stamp)]))
        for topic, make in self.outputs.items():
            message = make(self)
            if hasattr(message, "header"):
                message.header.stamp = stamp
            self.publishers[topic].publish(message)


def ring_points(robot):
    """As RosAria has them: in the robot's frame, no echo at the end of the cone."""
    points = []
    for i in range(sonar_room.SENSORS):
        distance = min(robot.room.ping(robot.in_room, i), sonar_room.MAX_RANGE)
        points.append(sonar_room.compose(sonar_room.sensor_pose(i), (distance, 0.0, 0.0)))
    return points


def cloud(robot):
    message = PointCloud()
    message.header.frame_id = "/base_link"
    message.points = [Point32(x, y, 0.0) for x, y, _ in ring_points(robot)]
    return message


def cloud2(robot):
    points = ring_points(robot)
    message = PointCloud2()
    message.header.frame_id = "base_link"
    message.height, message.width, message.point_step = 1, len(points), 12
    message.row_step = 12 * len(points)
    message.fields = [PointField(name, 4 * k, PointField.FLOAT32, 1)
                      for k, name in enumerate("xyz")]
    message.data = b"".join(struct.pack("<fff", x, y, 0.0) for x, y, _ in points)
    return message


def laser(robot):
    message = LaserScan()
    message.header.frame_id = "sonar_0"
    message.angle_min, message.angle_max = -math.pi / 2, math.pi / 2
    message.angle_increment = math.pi / (BEAMS - 1)
    message.range_min, message.range_max = 0.05, 6.0
    x, y, yaw = sonar_room.compose(robot.in_room, sonar_room.sensor_pose(0))
    for k in range(BEAMS):
        distance = robot.room.distance(x, y, yaw + message.angle_min + k * message.angle_increment)
        message.ranges.append(distance if distance < message.range_max else math.inf)
    return message


def magnetic_field(robot):
    """Magnetic north lies 0.1 rad east of north."""
    north = math.pi / 2 - 0.1 - robot.in_room[2]
    message = MagneticField()
    message.header.frame_id = "base_link"
    message.magnetic_field.x = 2e-5 * math.cos(north)
    message.magnetic_field.y = 2e-5 * math.sin(north)
    message.magnetic_field.z = -4e-5
    return message


def bearing(robot):
    return Float64(math.degrees(math.pi / 2 - robot.in_room[2]) % 360.0)


def odometry(robot):
    x, y, yaw = robot.odometry
    message = Odometry()
    message.header.frame_id, message.child_frame_id = "odom", "base_link"
    message.pose.pose.position.x, message.pose.pose.position.y = x, y
    message.pose.pose.orientation.z = math.sin(0.5 * yaw)
    message.pose.pose.orientation.w = math.cos(0.5 * yaw)
    return message


def hc_sr04(sensor, frames):
    """Says max_range, 3 m, where it hears nothing."""
    def make(robot):
        distance = min(robot.room.ping(robot.in_room, sensor), 3.0)
        message = fake_robot.range_message(sensor, distance, rospy.Time())
        message.max_range = 3.0
        message.header.frame_id = frames(sensor)
        return message
    return (Range, make)


RING = {"cloud__max_range": sonar_room.MAX_RANGE, "cloud__field_of_view": sonar_room.FIELD_OF_VIEW}


class LiveInputsTest(live_test.LiveTestCase):
    robot_type = AnyRobot

    def start(self, outputs, **parameters):
        self.start_node(**parameters)
        self.robot.give(**outputs)
        self.wait(lambda: self.robot.is_connected(self.node.name), "the node to hear the robot")

    def walk(self, **goal):
        """Learns two rooms, and is carried back into both, otherwise turned."""
        for label, room in (("hall", sonar_room.HALL), ("study", sonar_room.STUDY)):
            self.robot.enter(room)
            self.scan_well(**goal)
            learned = self.node.call("learn_place", label=label)
            self.assertEqual(learned.status, learned.OK, learned.message)
        answers = []
        for label, room in (("hall", sonar_room.HALL), ("study", sonar_room.STUDY)):
            self.robot.turn(0.4)
            self.robot.enter(room, 0.1, -0.1)
            self.scan_well(**goal)
            answer = self.node.call("recognize_place")
            self.assertEqual(answer.recognition.verdict, Recognition.RECOGNIZED, answer.message)
            self.assertEqual(answer.recognition.matches[0].label, label)
            answers.append(answer)
        return answers

    def test_a_pioneer_with_a_cloud_and_no_compass(self):
        self.start({"cloud": (PointCloud, cloud)}, sonar_topics=["cloud"], heading_topic="", **RING)
        for answer in self.walk():
            self.assertIn("any heading was tried", answer.message)
        # Odometry begins anew, with another yaw.
        self.robot.odometry = (0.0, 0.0, 2.0)
        self.robot.enter(sonar_room.HALL)
        self.scan_well()
        answer = self.node.call("recognize_place")
        self.assertEqual(answer.recognition.verdict, Recognition.RECOGNIZED, answer.message)
        self.assertEqual(answer.recognition.matches[0].label, "hall")

    def test_mounts_that_are_given(self):
        mounts = [list(sonar_room.sensor_pose(i)) for i in range(sonar_room.SENSORS)]
        self.start({"cloud2": (PointCloud2, cloud2), "bearing": (Float64, bearing)},
                   sonar_topics=["cloud2"], heading_topic="bearing", cloud__mounts=mounts, **RING)
        self.walk()

    def test_a_laser_and_a_magnetometer(self):
        self.start({"scan_in": (LaserScan, laser), "field": (MagneticField, magnetic_field)},
                   sonar_topics=["scan_in"], heading_topic="field", heading__declination=0.1)
        self.walk()

    def test_odometry_on_a_topic(self):
        self.start({"cloud": (PointCloud, cloud), "wheels": (Odometry, odometry)},
                   sonar_topics=["cloud"], heading_topic="", odom_topic="wheels",
                   odom_frame="/wheel_odom", **RING)
        self.robot.says_tf = False
        self.walk()
        self.assertIn("taken as from wheel_odom", self.node.output())

    def test_three_ultrasonics_with_wrong_frames_at_first(self):
        frames = {"of": lambda sensor: "ultrasound"}
        sensors = {"left": 4, "front": 0, "right": 12}
        self.start({topic: hc_sr04(sensor, lambda s: frames["of"](s))
                    for topic, sensor in sensors.items()},
                   sonar_topics=sorted(sensors), heading_topic="", scan__tf_timeout=0.5)
        self.run_for(6.0)  # what is warned of once is said by now
        scan = self.begin_scan(headings=1, timeout=rospy.Duration(2))
        result = self.finish(scan)
        self.assertNotEqual(result.status, ScanPlaceResult.SUCCEEDED)
        self.assertIn("no frame ultrasound", result.message)
        self.assertIn("it knows base_link, odom, sonar_0", result.message)
        self.assertIn("have the same frame ultrasound", self.node.output())
        frames["of"] = lambda sensor: "/sonar_%d" % sensor
        self.run_for(6.0)
        self.robot.spin = 1.0
        self.walk(headings=32, step=0.2, turn=ScanPlaceGoal.TURN_LISTEN)
        self.assertIn("its max_range: taken as no echo", self.node.output())

    def test_a_wrong_type_is_named(self):
        self.start({"text": (String, lambda robot: String("7")), "bearing": (Float64, bearing)},
                   sonar_topics=["text"], heading_topic="bearing")
        result = self.scan(timeout=rospy.Duration(2))
        self.assertEqual(result.status, ScanPlaceResult.TIMEOUT, result.message)
        for word in (self.robot.namespace + "/text", "std_msgs/String", "sensor_msgs/Range"):
            self.assertIn(word, result.message)


if __name__ == "__main__":
    live_test.main("live_inputs_test", LiveInputsTest)
