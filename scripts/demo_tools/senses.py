"""What the demonstration itself hears of the robot."""
import rospy
from sensor_msgs.msg import Imu

from demo_tools.planar import wrapped, yaw_of
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
