"""Drives the simulated robot, as a person who sees the hallway would: by its true pose."""
import contextlib
import math
import threading

import rospy
from geometry_msgs.msg import Twist, Vector3
from nav_msgs.msg import Odometry

from demo_tools.planar import pose_of, wrapped
from demo_tools.waiting import wait_until

TOP_SPEED = 0.8        # [m/s]
TOP_TURN_RATE = 1.0    # [rad/s]
SPEED_GAIN = 1.5       # [1/s]
TURN_GAIN = 2.5        # [1/s]
TURN_FIRST = 0.4       # the robot turns on the spot where it looks further off than this [rad]
NEAR_ENOUGH = 0.02     # [m]
SWEEP_RATE = 0.036     # a little less than two degrees between firings of the sonars [rad/s]
LEG_LIMIT = 120.0      # of real time [s]


class Driver:
    """Follows a target while there is one; all in the frame world."""

    def __init__(self, check, command_topic="cmd_vel"):
        self._check = check
        self._lock = threading.Lock()
        self._target = None
        self._is_sweeping = False
        self._pose = None
        self._command = rospy.Publisher(command_topic, Twist, queue_size=1)
        self._subscriber = rospy.Subscriber("sonar_sim/ground_truth", Odometry, self._on_truth,
                                            queue_size=1)

    def pose(self):
        """x, y [m] and yaw [rad]; waits for the first one."""
        return wait_until(lambda: self._pose, "the simulated robot's true pose", 60.0, self._check)

    def go_to(self, x, y):
        with self._lock:
            self._target = (x, y)
        wait_until(lambda: self._target is None, f"the robot's way to ({x:.2f}, {y:.2f})",
                   LEG_LIMIT, self._check)

    def follow(self, points, until):
        """From point to point [m], until `until()` holds; then the robot stands. Whether it did."""
        for point in points:
            with self._lock:
                self._target = point
            wait_until(lambda: self._target is None or until(), f"the robot's way to {point}",
                       LEG_LIMIT, self._check)
            if until():
                break
        with self._lock:
            self._target = None
            self._command.publish(Twist())
        return until()

    @contextlib.contextmanager
    def sweep(self):
        """Turns slowly on the spot while the context lasts."""
        self._set_sweeping(True)
        try:
            yield
        finally:
            self._set_sweeping(False)

    def _set_sweeping(self, is_sweeping):
        with self._lock:
            self._is_sweeping = is_sweeping
            if not is_sweeping:
                self._command.publish(Twist())

    def _on_truth(self, message):
        self._pose = pose_of(message.pose.pose)
        with self._lock:
            if self._is_sweeping:
                self._command.publish(Twist(angular=Vector3(z=SWEEP_RATE)))
            elif self._target is not None:
                self._command.publish(self._steer(*self._pose))

    def _steer(self, x, y, yaw):
        command = Twist()
        dx, dy = self._target[0] - x, self._target[1] - y
        distance = math.hypot(dx, dy)
        if distance < NEAR_ENOUGH:
            self._target = None
            return command
        aside = wrapped(math.atan2(dy, dx) - yaw)
        command.angular.z = max(-TOP_TURN_RATE, min(TOP_TURN_RATE, TURN_GAIN * aside))
        if abs(aside) < TURN_FIRST:
            command.linear.x = min(TOP_SPEED, SPEED_GAIN * distance)
        return command
