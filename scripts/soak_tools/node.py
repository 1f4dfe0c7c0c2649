"""The node that is put under load."""

import os
import resource
import signal
import subprocess
import threading
import time

import rospy
from roslib.packages import find_node

NAME = "/place_memory"
PARAMETERS = {"sonar_topics": ["sonar_%d" % i for i in range(16)], "tf_broadcast": True,
              "scan/headings": 1, "places/adapt": True, "scan/timeout": 10.0}
LONGEST_END = 90.0  # of a node that is asked to end [s]
DISK_TAKES = 2.0  # until the node finds that there is room again [s]


class Node:
    """May be killed and started anew; its store stays. Thread-safe."""

    def __init__(self, folder, mode):
        self.folder = folder
        self.starts = []  # as time.monotonic() [s]
        self.disturbed_until = 0.0  # calls may fail, and tf may pause [s]
        self.disk_full_until = 0.0
        self.is_spared = False  # it is not killed, so that it lives long enough to show what it leaks
        self._lock = threading.Lock()
        self._process = None
        self.begin_with(mode)
        rospy.set_param(NAME + "/store", os.path.join(folder, "places.db"))
        for name, value in PARAMETERS.items():
            rospy.set_param(NAME + "/" + name, value)

    @staticmethod
    def begin_with(mode):
        """From the next start on."""
        rospy.set_param(NAME + "/mode", mode)

    def start(self):
        log = open(os.path.join(self.folder, "node-%d.log" % len(self.starts)), "w")
        with self._lock:
            self._process = subprocess.Popen(
                [find_node("place_memory", "place_memory_node")[0], "__name:=" + NAME[1:]],
                stdout=log, stderr=subprocess.STDOUT, restore_signals=False)
            self.starts.append(time.monotonic())
        log.close()

    def disturb(self, seconds):
        self.disturbed_until = max(self.disturbed_until, time.monotonic() + seconds)

    def is_disturbed(self, since):
        """Whether it was, at any time since then."""
        return since < self.disturbed_until

    def disk_was_full(self, since):
        return since < self.disk_full_until

    def check(self):
        """Says why it has ended by itself, or nothing."""
        status = self._process.poll()
        if status is None or self.is_disturbed(time.monotonic()):
            return ""
        return "the node ended with status %s" % status

    def kill_and_start(self):
        self.disturb(60.0)
        self._process.send_signal(signal.SIGKILL)
        self._process.wait()
        self.start()
        rospy.wait_for_service(NAME + "/get_graph", 60.0)
        self.disturbed_until = time.monotonic() + 3.0

    def stop_and_start(self):
        """As a person does at the keyboard, while clients ask. Returns its exit status."""
        status = self.stop()
        self.start()
        rospy.wait_for_service(NAME + "/get_graph", 60.0)
        self.disturbed_until = time.monotonic() + 3.0
        return status

    def pause(self, seconds):
        self.disturb(seconds + 3.0)
        self._process.send_signal(signal.SIGSTOP)
        time.sleep(seconds)
        self._process.send_signal(signal.SIGCONT)

    def fill_disk(self, seconds):
        self.disk_full_until = time.monotonic() + seconds + DISK_TAKES
        for limit in (0, resource.RLIM_INFINITY):
            resource.prlimit(self._process.pid, resource.RLIMIT_FSIZE,
                             (limit, resource.RLIM_INFINITY))
            if limit == 0:
                time.sleep(seconds)

    def memory(self):
        """Resident [bytes]."""
        with open("/proc/%d/statm" % self._process.pid) as file:
            return int(file.read().split()[1]) * resource.getpagesize()

    def stop(self):
        """Returns its exit status."""
        self.disturb(LONGEST_END + 60.0)
        if self._process.poll() is None:
            self._process.terminate()
        return self._process.wait(LONGEST_END)
