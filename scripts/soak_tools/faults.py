"""What goes wrong around the node while it works."""

import random
import threading
import time

import rospy
from actionlib_msgs.msg import GoalID
from geometry_msgs.msg import PoseWithCovarianceStamped
from place_memory.msg import ScanPlaceActionGoal
from sensor_msgs.msg import Range
from tf2_msgs.msg import TFMessage

from place_memory import srv

from soak_tools import robot
from soak_tools.map_clients import END_OF_TIME
from soak_tools.node import NAME


class Faults(threading.Thread):
    """One after the other; the hard ones, which kill, pause or fill the disk, by turns."""

    def __init__(self, node, watch, blind_until, pace):
        super().__init__(daemon=True)
        self._node = node
        self._watch = watch
        self._blind_until = blind_until
        self._pace = pace
        self._random = random.Random(1)
        self._count = 0
        self.is_over = False
        self._tf = rospy.Publisher("/tf", TFMessage, queue_size=10)
        self._sonar = rospy.Publisher("sonar_0", Range, queue_size=10)
        self._cancel = rospy.Publisher(NAME + "/scan/cancel", GoalID, queue_size=10)
        self._goal = rospy.Publisher(NAME + "/scan/goal", ScanPlaceActionGoal, queue_size=10)
        self._pose = rospy.Publisher("initialpose", PoseWithCovarianceStamped, queue_size=10)

    def run(self):
        soft = [self.far_ahead, self.ancient, self.without_sense, self.new_frames, self.odd_ranges,
                self.blind, self.cancel_unknown, self.impossible_goal, self.nowhere, self.mode_storm]
        hard = [lambda: self._node.fill_disk(3.0), lambda: self._node.pause(1.0), self.kill]
        while not self.is_over:
            time.sleep(self._pace)
            self._count += 1
            fault = self._random.choice(soft)
            if self._count % 10 == 0:
                fault = hard[self._count // 10 % len(hard)]
            fault()
            self._watch.count("faults")

    def kill(self):
        if not self._node.is_spared:
            self._node.kill_and_start()

    def _send_tf(self, stamp, child="base_link", **translation):
        message = robot.transform("odom", child, (0.0, 0.0, 0.0), stamp)
        for name, value in translation.items():
            setattr(message.transform.translation, name, value)
        self._tf.publish(TFMessage([message]))

    def far_ahead(self):
        for stamp in (END_OF_TIME, rospy.Time.now() + rospy.Duration(20.0)):
            self._send_tf(stamp)

    def ancient(self):
        self._send_tf(rospy.Time(1))
        self._send_tf(rospy.Time(0))

    def without_sense(self):
        self._send_tf(rospy.Time.now(), x=float("nan"))
        self._send_tf(rospy.Time.now(), x=float("inf"))

    def new_frames(self):
        for _ in range(50):
            number = self._random.randrange(10 ** 9)
            self._send_tf(rospy.Time.now(), "frame_%d" % number)
            message = robot.range_message(number)
            message.header.stamp = rospy.Time.now()
            message.range = 1.0
            self._sonar.publish(message)
        self._send_tf(rospy.Time.now(), "x" * 100000)

    def odd_ranges(self):
        for value in (float("nan"), -1.0, 1e30, float("-inf"), 0.0):
            message = robot.range_message(0)
            message.header.stamp = self._random.choice([rospy.Time.now(), rospy.Time(0), END_OF_TIME])
            message.range = message.max_range = value
            self._sonar.publish(message)

    def blind(self):
        self._blind_until.value = time.time() + 2.0

    def cancel_unknown(self):
        self._cancel.publish(GoalID(END_OF_TIME, "nobody knows it"))

    def impossible_goal(self):
        goal = ScanPlaceActionGoal()
        goal.goal_id.id = "impossible %d" % self._count
        goal.goal.headings = 4000000000
        goal.goal.step = float("nan")
        self._goal.publish(goal)

    def nowhere(self):
        for value in (float("nan"), 1e300):
            message = PoseWithCovarianceStamped()
            message.header.frame_id = "map"
            message.pose.pose.orientation.w = 1.0
            message.pose.pose.position.x = value
            self._pose.publish(message)

    def mode_storm(self):
        """Others ask for things meanwhile."""
        modes = ["off", "map", "localize"] * 3 + [rospy.get_param(NAME + "/mode")]
        for mode in modes:
            begin = time.monotonic()
            try:
                response = rospy.ServiceProxy(NAME + "/set_mode", srv.SetMode)(mode=mode)
            except rospy.ServiceException as error:
                if not self._node.is_disturbed(begin):
                    self._watch.fail("set_mode: %s" % error)
                return
            if response.status == response.FAILED:
                self._watch.fail("set_mode: " + response.message)
