"""What is true of the simulated robot and of the building: what the demonstration knows, and the
place memory does not."""
import bisect

import rospy
from geometry_msgs.msg import Pose2D
from nav_msgs.msg import Odometry
from place_memory.srv import CarryRobot, SetDoor
from visualization_msgs.msg import MarkerArray

from demo_tools.calls import expect, service
from demo_tools.planar import distance, pose_of
from demo_tools.waiting import wait_until

START_LIMIT = 60.0  # of real time [s]
LIFTED = 0.5        # between two poses the robot does not drive so far: it was carried [m]


class Truth:
    """Where the simulated robot was when, in the frame world, and what stands about it."""

    def __init__(self, check):
        self._check = check
        self._stamps = []   # [s], rising
        self.track = []     # pose at each
        self.way = 0.0      # driven [m]
        self.outline = ()   # ends of what stands in the building: x, y of each [m]
        self._subscribers = [
            rospy.Subscriber("sonar_sim/ground_truth", Odometry, self._on_truth, queue_size=100),
            rospy.Subscriber("sonar_sim/world", MarkerArray, self._on_world)]
        self._set_door = service("sonar_sim/set_door", SetDoor, check)
        self._carry = service("sonar_sim/carry_robot", CarryRobot, check)
        wait_until(lambda: self.track and self.outline, "the simulated robot's true pose",
                   START_LIMIT, check)

    def _on_truth(self, message):
        pose = pose_of(message.pose.pose)
        if self.track:
            step = distance(pose, self.track[-1])
            self.way += step if step < LIFTED else 0.0
        self.track.append(pose)
        self._stamps.append(message.header.stamp.to_sec())

    def _on_world(self, message):
        self.outline = [(point.x, point.y) for point in message.markers[0].points]

    def time(self):
        """Simulated [s]."""
        return self._stamps[-1]

    def pose(self):
        return self.track[-1]

    def pose_at(self, stamp):
        """The one nearest to that time [s]."""
        after = min(bisect.bisect_left(self._stamps, stamp), len(self._stamps) - 1)
        before = max(after - 1, 0)
        is_before = stamp - self._stamps[before] < self._stamps[after] - stamp
        return self.track[before if is_before else after]

    def set_door(self, name, is_open):
        expect(self._set_door(name=name, open=is_open), name)

    def carry(self, x, y, yaw):
        expect(self._carry(pose=Pose2D(x, y, yaw)), "the robot is to be carried")
        wait_until(lambda: distance(self.pose(), (x, y)) < LIFTED, "the robot's new pose",
                   START_LIMIT, self._check)
