"""What the demonstration itself hears of the robot."""
import math

import rospy
import tf2_ros
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import Imu

from demo_tools.driver import wrapped, yaw_of
from demo_tools.waiting import wait_until

START_LIMIT = 60.0  # of real time [s]


class Compass:
    """The heading that the robot's compass shows [rad]."""

    def __init__(self, check):
        self._check = check
        self._yaw = None
        self._subscriber = rospy.Subscriber("heading", Imu, self._on_heading, queue_size=1)

    def _on_heading(self, message):
        self._yaw = yaw_of(message.orientation)

    def error(self, true_yaw):
        wait_until(lambda: self._yaw is not None, "a heading", START_LIMIT, self._check)
        return wrapped(self._yaw - true_yaw)


class MapFrame:
    """Places odometry in the map: where it began, until a recognition says better."""

    def __init__(self, check):
        self._check = check
        self._odometry = None
        self._subscriber = rospy.Subscriber("odom", Odometry, self._on_odometry, queue_size=1)
        self._broadcaster = tf2_ros.StaticTransformBroadcaster()
        self._publish(0.0, 0.0, 0.0)

    def _on_odometry(self, message):
        self._odometry = message.pose.pose

    def correct(self, pose):
        """By the robot's pose in the map; the robot stands still."""
        wait_until(lambda: self._odometry is not None, "odometry", START_LIMIT, self._check)
        seen = self._odometry
        turn = wrapped(yaw_of(pose.orientation) - yaw_of(seen.orientation))
        x, y = seen.position.x, seen.position.y
        self._publish(pose.position.x - math.cos(turn) * x + math.sin(turn) * y,
                      pose.position.y - math.sin(turn) * x - math.cos(turn) * y, turn)

    def _publish(self, x, y, yaw):
        transform = TransformStamped()
        transform.header.stamp = rospy.Time.now()
        transform.header.frame_id = "map"
        transform.child_frame_id = "odom"
        transform.transform.translation.x = x
        transform.transform.translation.y = y
        transform.transform.rotation.z = math.sin(0.5 * yaw)
        transform.transform.rotation.w = math.cos(0.5 * yaw)
        self._broadcaster.sendTransform(transform)
