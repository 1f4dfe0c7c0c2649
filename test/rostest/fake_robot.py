"""A robot that turns by cmd_vel in a room, and says what a real one does on its topics."""

import math
import threading

import rospy
from geometry_msgs.msg import TransformStamped, Twist
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import Imu, Range
from tf2_msgs.msg import TFMessage

import sonar_room

STEP = 0.1  # simulated time between two messages of a sensor [s]
PACE = 0.05  # of the wall's clock, at least, for a step in which no velocity came [s]


def transform(parent, child, pose, stamp):
    message = TransformStamped()
    message.header.stamp = stamp
    message.header.frame_id = parent
    message.child_frame_id = child
    message.transform.translation.x, message.transform.translation.y = pose[:2]
    message.transform.rotation.z = math.sin(0.5 * pose[2])
    message.transform.rotation.w = math.cos(0.5 * pose[2])
    return message


def range_message(sensor, distance, stamp):
    message = Range()
    message.header.stamp = stamp
    message.header.frame_id = "sonar_%d" % sensor
    message.radiation_type = Range.ULTRASOUND
    message.field_of_view = sonar_room.FIELD_OF_VIEW
    message.min_range = sonar_room.MIN_RANGE
    message.max_range = sonar_room.MAX_RANGE
    message.range = distance
    return message


def heading_message(yaw, stamp):
    message = Imu()
    message.header.stamp = stamp
    message.header.frame_id = "base_link"
    message.orientation.z = math.sin(0.5 * yaw)
    message.orientation.w = math.cos(0.5 * yaw)
    return message


def ring_transforms(stamp):
    return TFMessage([transform("base_link", "sonar_%d" % i, sonar_room.sensor_pose(i), stamp)
                      for i in range(sonar_room.SENSORS)])


class World:
    """What all robots of a test program share: simulated time and tf. Time stands still but for
    what the test does, so that a slow machine changes nothing."""

    def __init__(self):
        self.now = 1000.0
        self._clock = rospy.Publisher("/clock", Clock, queue_size=1000)
        self.tf = rospy.Publisher("/tf", TFMessage, queue_size=1000)
        self._static = rospy.Publisher("/tf_static", TFMessage, queue_size=1, latch=True)
        self._static.publish(ring_transforms(rospy.Time.from_sec(self.now)))

    def set_time(self, now):
        self.now = now
        self._clock.publish(Clock(self.stamp()))

    def stamp(self):
        return rospy.Time.from_sec(self.now)

    def is_connected(self, node):
        return all(publisher.impl.has_connection(node)
                   for publisher in (self._clock, self.tf, self._static))


class FakeRobot:
    """Stands in a room. A velocity that it is told holds for one step, as the watchdog of a real
    base has it: when nobody commands it, it stands.

    Attributes to change in a test: `room`, `in_room` (pose there), `odometry` (pose in the odometry
    frame), `spin` (turned from outside [rad/s]), `edit_range` (sensor, message -> message or None),
    `edit_heading` (message -> message or None), `has_odometry`, `heading_offset` [rad].
    """

    def __init__(self, world, namespace, room):
        self.world = world
        self.room = room
        self.in_room = (0.0, 0.0, 0.0)
        self.odometry = (0.0, 0.0, 0.0)
        self.spin = 0.0
        self.heading_offset = 0.0
        self.has_odometry = True
        self.edit_range = lambda sensor, message: message
        self.edit_heading = lambda message: message

        self.commands = []  # every angular velocity that came [rad/s]
        self._new_command = threading.Condition()
        self._obeyed = 0
        self.sonar = rospy.Publisher(namespace + "/sonar", Range, queue_size=1000)
        self.heading = rospy.Publisher(namespace + "/heading", Imu, queue_size=1000)
        self.command_topic = namespace + "/cmd_vel"
        self._commands = rospy.Subscriber(self.command_topic, Twist, self._on_command)

    def close(self):
        for topic in (self.sonar, self.heading, self._commands):
            topic.unregister()

    def is_connected(self, node):
        return (self.world.is_connected(node) and self.sonar.impl.has_connection(node)
                and self.heading.impl.has_connection(node)
                and self._commands.get_num_connections() > 0)

    def enter(self, room, x=0.0, y=0.0):
        """Is carried into a room; odometry does not notice."""
        self.room = room
        self.in_room = (x, y, self.in_room[2])

    def step(self):
        """Obeys a velocity, if one comes soon, and lets time go on."""
        self.turn(STEP * (self._take_command() + self.spin))
        self.world.set_time(self.world.now + STEP)
        self.say()

    def turn(self, angle):
        self.in_room = sonar_room.compose(self.in_room, (0.0, 0.0, angle))
        self.odometry = sonar_room.compose(self.odometry, (0.0, 0.0, angle))

    def say(self):
        """Publishes what every sensor has to say now."""
        stamp = self.world.stamp()
        if self.has_odometry:
            odometry = transform("odom", "base_link", self.odometry, stamp)
            self.world.tf.publish(TFMessage([odometry]))
        self._publish(self.heading, self.edit_heading(
            heading_message(self.in_room[2] + self.heading_offset, stamp)))
        for i in range(sonar_room.SENSORS):
            message = range_message(i, self.room.ping(self.in_room, i), stamp)
            self._publish(self.sonar, self.edit_range(i, message))

    @staticmethod
    def _publish(publisher, message):
        if message is not None:
            publisher.publish(message)

    def _on_command(self, message):
        with self._new_command:
            self.commands.append(message.angular.z)
            self._new_command.notify()

    def _take_command(self):
        with self._new_command:
            self._new_command.wait_for(lambda: len(self.commands) > self._obeyed, PACE)
            if len(self.commands) == self._obeyed:
                return 0.0
            self._obeyed = len(self.commands)
            return self.commands[-1]
