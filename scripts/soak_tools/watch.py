"""What is measured during the run, and what must not be."""

import collections
import math
import threading
import time

import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped
from tf2_msgs.msg import TFMessage

from soak_tools import robot
from soak_tools.node import NAME
from soak_tools.upheavals import Upheavals

LONGEST_PAUSE = 1.0  # of tf map -> odom, which comes ten times a second [s]
WARM_UP = 180.0  # after each start, until the heap has what it needs for so many clients [s]
LONG_LIFE = 180.0  # after that, for memory to be compared [s]
BYTES_FOR_A_PLACE = 64 << 10
BYTES_FOR_NOTHING = 3 << 20  # that the heap may grow for whatever reason


def quantile(values, share):
    values = sorted(values)
    return values[min(len(values) - 1, int(share * len(values)))] if values else math.nan


class Watch:
    """Thread-safe."""

    def __init__(self, node, start):
        self.begin = time.monotonic()
        self.latencies = collections.defaultdict(list)  # by call: (when [s], how long [s])
        self.counts = collections.Counter()
        self.problems = []
        self.memory = []  # (when [s], start of the node, bytes, places)
        self._offsets = []  # of ~pose from odometry (when [s], x, y [m])
        self.pauses = []  # of tf [s]
        self.links = []  # of the newest map that a client saw
        self.upheavals = Upheavals()
        self._newest_places = 0
        self._node = node
        self._robot_start = start
        self._lock = threading.Lock()
        self._last_transform = None
        rospy.Subscriber("/tf", TFMessage, self._on_tf, queue_size=1000)
        rospy.Subscriber(NAME + "/pose", PoseWithCovarianceStamped, self._on_pose, queue_size=100)

    def now(self):
        return time.monotonic() - self.begin

    def fail(self, sentence):
        with self._lock:
            self.problems.append("%.1f s: %s" % (self.now(), sentence))

    def took(self, name, seconds):
        with self._lock:
            self.latencies[name].append((self.now(), seconds))

    def count(self, what):
        with self._lock:
            self.counts[what] += 1

    def graph(self, graph):
        self._newest_places = len(graph.places)
        self.links = graph.links

    def sample_memory(self):
        try:
            size = self._node.memory()
        except OSError:  # between two lives
            return
        self.memory.append((self.now(), len(self._node.starts), size, self._newest_places))

    def _on_tf(self, message):
        if not any(transform.header.frame_id == "map" for transform in message.transforms):
            return
        now = time.monotonic()
        last, self._last_transform = self._last_transform, now
        if last is None or self._node.is_disturbed(last):
            return
        self.pauses.append(now - last)

    def _on_pose(self, message):
        pose = message.pose.pose.position
        x, y, _ = robot.pose_at(message.header.stamp.to_sec() - self._robot_start)
        self._offsets.append((self.now(), pose.x - x, pose.y - y))

    def errors(self):
        """Of ~pose (when [s], metres): by the place of the map's origin that most of them agree on,
        as a drive begins its map where it is."""
        offsets = list(self._offsets)
        x, y = (quantile([offset[i] for offset in offsets], 0.5) for i in (1, 2))
        return [(when, math.hypot(dx - x, dy - y)) for when, dx, dy in offsets]

    def growths(self):
        """Of each life of the node that was long enough: (seconds, bytes beyond what its new places
        take)."""
        lives = collections.defaultdict(list)
        for when, life, size, places in self.memory:
            lives[life].append((when, size, places))
        found = []
        for samples in lives.values():
            warm = [sample for sample in samples if sample[0] > samples[0][0] + WARM_UP]
            if not warm or warm[-1][0] - warm[0][0] < LONG_LIFE:
                continue
            most_places = max(sample[2] for sample in warm)
            grown = warm[-1][1] - warm[0][1] - BYTES_FOR_A_PLACE * (most_places - warm[0][2])
            found.append((warm[-1][0] - warm[0][0], grown))
        return found

    def has_seen_all(self):
        return bool(self._last_transform and self._offsets and self.counts["looked whether all is there"])

    def judge(self, is_lenient):
        """Adds to the problems what shows in the whole run alone; to be lenient: but how fast the
        machine is, and how memory grows."""
        if self._last_transform is None:
            self.fail("map -> odom was never on tf")
        if not self._offsets:
            self.fail("the robot was never localized")
        if not self.counts["looked whether all is there"]:
            self.fail("nobody ever saw whether all is there")
        if is_lenient:
            return
        if not self.pauses:
            self.fail("map -> odom was never twice on tf between two faults")
        for seconds, grown in self.growths():
            if grown > BYTES_FOR_NOTHING:
                self.fail("in %.0f s memory grew by %.1f MB beyond its places" %
                          (seconds, grown / 1e6))
        late = quantile(self.pauses, 0.99)
        if late > LONGEST_PAUSE:
            self.fail("map -> odom paused for %.2f s" % late)
