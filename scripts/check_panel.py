#!/usr/bin/python3
"""Puts the panel of rviz to the test that takes long: the node is restarted again and again while rviz
and the panel watch, and rviz is closed again and again; or a large map is drawn. Needs a build with
tests, and xdotool.

Prints a line for each, and the longest time for which the thread that draws was held. Status 1 where
the panel did not come back, or rviz did not close as it should.
"""
import argparse
import contextlib
import os
import signal
import socket
import subprocess
import sys
import time

import rosgraph
import rospkg
import rospy
import tf2_ros
from geometry_msgs.msg import TransformStamped

from demo_tools.errors import DemoError
from demo_tools.processes import Process, VirtualDisplay
from demo_tools.screenshot import Rviz
from demo_tools.waiting import wait_until

SHARE = rospkg.RosPack().get_path("place_memory")
sys.path.insert(0, os.path.join(SHARE, "test", "rostest"))
from panel import Panel  # noqa: E402

NODE = "/place_memory"
TOPICS = [NODE + "/map_changes", NODE + "/recognition", NODE + "/scan/feedback"]
LIMIT = 60.0       # for anything to happen [s]
EXIT_LIMIT = 20.0  # for rviz to close [s]
SIZE = (1280, 900)  # of the display [pixels]
FRAMES_SIZE = (1280, 720)  # of the window in which frames are counted
FRAMES_TIME = 20           # before they are counted, and while they are [s]
LEAST_RATE = 20.0          # [Hz]


def free_port():
    with socket.socket() as probe:
        probe.bind(("", 0))
        return probe.getsockname()[1]


class Place:
    """Where it all runs: a master with the simulated robot, and a display."""

    def __init__(self, out, contexts):
        os.makedirs(out, exist_ok=True)
        self.out = out
        self.contexts = contexts
        os.environ["ROS_MASTER_URI"] = "http://localhost:%d" % free_port()
        display = contexts.enter_context(VirtualDisplay(out, *SIZE))
        os.environ.update(DISPLAY=display.display, LIBGL_ALWAYS_SOFTWARE="1")
        port = os.environ["ROS_MASTER_URI"].rpartition(":")[2]
        self.sim = contexts.enter_context(Process(
            ["roslaunch", "-p", port, "place_memory", "sim.launch"], self.path("sim.log")))
        self.master = rosgraph.Master("/check_panel")
        wait_until(lambda: self.offers("/sonar_sim/set_door"), "the simulated robot", LIMIT,
                   self.sim.check)

    def path(self, name):
        return os.path.join(self.out, name)

    def offers(self, service):
        try:
            return self.master.lookupService(service)
        except (rosgraph.MasterException, OSError):
            return None

    def hears_all(self, node, topics):
        _, subscribers, _ = self.master.getSystemState()
        return {topic for topic, nodes in subscribers if node in nodes}.issuperset(topics)

    def node(self):
        return Process(["roslaunch", "place_memory", "place_memory.launch",
                        "params:=" + os.path.join(SHARE, "config", "tutorial.yaml")],
                       self.path("node.log"))


class RvizRun:
    """An rviz with the shipped configuration."""

    def __init__(self, place):
        self._config = os.path.join(SHARE, "rviz", "place_memory.rviz")
        self._log = open(place.path("rviz.log"), "w", encoding="utf-8")
        self.process = subprocess.Popen(
            ["rviz", "--splash-screen", "", "-d", self._config, "__name:=rviz"],
            stdout=self._log, stderr=subprocess.STDOUT, start_new_session=True)
        wait_until(lambda: place.hears_all("/rviz", TOPICS), "the panel in rviz", LIMIT, self.check)
        self.window = Rviz(os.environ["DISPLAY"], self._config, self.check)

    def check(self):
        if self.process.poll() is not None:
            raise DemoError(f"rviz ended with status {self.process.returncode}")

    def close(self):
        """By the keyboard. Seconds until it was gone, and its status."""
        begin = time.monotonic()
        window = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "RViz"], check=True,
                                capture_output=True, text=True).stdout.split()[0]
        subprocess.run(["xdotool", "windowfocus", "--sync", window, "key", "ctrl+q"], check=True)
        try:
            status = self.process.wait(EXIT_LIMIT)
        except subprocess.TimeoutExpired:
            os.killpg(self.process.pid, signal.SIGKILL)
            status = "killed"
        self._log.close()
        return time.monotonic() - begin, status


def check_restarts(place, count):
    """Whether the panel came back each time."""
    rviz = RvizRun(place)
    panel = Panel(place.path("panel.log"))
    longest = 0.0
    try:
        for i in range(1, count + 1):
            with place.node():
                begin = time.monotonic()
                wait_until(lambda: not panel.greyed("learn"), "the panel to come back", LIMIT,
                           rviz.check)
                back = time.monotonic() - begin
                if i == count:
                    rviz.window.write(place.path("rviz_panel.png"))
            wait_until(lambda: panel.greyed("learn"), "the panel to be greyed", LIMIT, rviz.check)
            held, worked = panel.longest_holds()
            longest = max(longest, held)
            print(f"restart {i}: back {back:.1f} s after its start, held {1000 * held:.0f} ms, "
                  f"of which {1000 * worked:.0f} ms at work", flush=True)
    finally:
        panel_status = panel.close()
        seconds, status = rviz.close()
    print(f"{count} restarts, held {1000 * longest:.0f} ms at the most; rviz closed in "
          f"{seconds:.1f} s with status {status}")
    return panel_status == 0 and status == 0


def check_exits(place, count):
    """Whether rviz closed well each time, with the node there and, every other time, away."""
    bad = 0
    for i in range(1, count + 1):
        with contextlib.ExitStack() as contexts:
            if i % 2 == 0:
                node = contexts.enter_context(place.node())
                wait_until(lambda: place.offers(NODE + "/get_graph"), "the node", LIMIT, node.check)
            seconds, status = RvizRun(place).close()
        print(f"exit {i}: {seconds:.1f} s, status {status}", flush=True)
        bad += status != 0
    print(f"{count} exits, {bad} of them bad")
    return bad == 0


def lay_map_on_odometry():
    """Where in the map the robot is nobody knows, and rviz draws nothing without a transform."""
    rospy.init_node("check_panel_frames")
    transform = TransformStamped()
    transform.header.frame_id, transform.child_frame_id = "map", "odom"
    transform.transform.rotation.w = 1.0
    broadcaster = tf2_ros.StaticTransformBroadcaster()
    broadcaster.sendTransform(transform)
    return broadcaster


def check_frames(place, store):
    """Whether rviz draws the map of a store fast enough, robot and simulated world beside it."""
    config = place.path("frames.rviz")
    with open(os.path.join(SHARE, "rviz", "place_memory.rviz"), encoding="utf-8") as file:
        text = file.read()
    with open(config, "w", encoding="utf-8") as file:
        file.write(text.replace("Frame Rate: 10", "Frame Rate: 60").replace("Scale: 70", "Scale: 4"))
    picture = place.path("rviz_frames.png")
    broadcaster = lay_map_on_odometry()
    with Process(["roslaunch", "place_memory", "place_memory.launch", "store:=" + store],
                 place.path("node.log")) as node:
        wait_until(lambda: place.offers(NODE + "/get_graph"), "the node", LIMIT, node.check)
        output = subprocess.run(
            [os.path.join(os.environ["CMAKE_PREFIX_PATH"].split(":")[0], "lib", "place_memory",
                          "frame_rate"), config, *map(str, FRAMES_SIZE), str(FRAMES_TIME), picture],
            check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
            universal_newlines=True).stdout
    del broadcaster
    rate, work = [float(number) for number in output.split()[-2:]]
    print(f"{rate:.1f} frames a second in a window of {FRAMES_SIZE[0]} x {FRAMES_SIZE[1]}, "
          f"{100 * work:.0f} % of the time at work; {picture}")
    return rate >= LEAST_RATE


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--restarts", type=int, default=20)
    parser.add_argument("--exits", type=int, default=20)
    parser.add_argument("--store", help="of a large map, e.g. by place_memory_benchmark --write-store: "
                        "how many frames a second rviz draws of it")
    parser.add_argument("--out", default="panel_output", help="folder for logs and a picture")
    options = parser.parse_args()
    with contextlib.ExitStack() as contexts:
        place = Place(options.out, contexts)
        good = options.restarts == 0 or check_restarts(place, options.restarts)
        good = (options.exits == 0 or check_exits(place, options.exits)) and good
        good = (not options.store or check_frames(place, os.path.abspath(options.store))) and good
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
