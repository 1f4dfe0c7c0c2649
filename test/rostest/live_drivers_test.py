#!/usr/bin/env python3
"""What the simulated robot's node says as the drivers of other robots do."""

import math
import os
import tempfile
import unittest

import rospy
import rostest
from sensor_msgs.msg import LaserScan, PointCloud, PointCloud2, Range
from sensor_msgs.point_cloud2 import read_points
from std_msgs.msg import Float64

import live_test
from sim_node import SimNode

# A room of 6 m by 4 m, the robot in its middle.
WORLD = """
name: room
walls:
  - {material: brick, points: [[-3, -2], [3, -2], [3, 2], [-3, 2], [-3, -2]]}
places:
  - {label: middle, at: [0, 0]}
"""


class LiveDriversTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.world = os.path.join(self.folder, "room.yaml")
        with open(self.world, "w") as file:
            file.write(WORLD)

    def start(self, **parameters):
        self.sim = SimNode(self.folder, world=self.world, **parameters)
        self.addCleanup(self.sim.stop)

    def refused(self, *words, **parameters):
        self.start(**parameters)
        self.assertEqual(self.sim.process.wait(live_test.PATIENCE), 1)
        for word in words:
            self.assertIn(word, self.sim.output())

    def test_a_cloud_has_a_point_for_each_sonar(self):
        self.start(robot={"message": "point_cloud", "topics": ["points"], "no_echo": "max_range",
                          "max_range": 2.5, "mounts": [[0.1, 0.0, 0.0], [0.0, 0.1, math.pi / 2.0]]})
        cloud = self.sim.message("points", PointCloud)
        self.assertEqual(cloud.header.frame_id, "base_link")
        ahead, left = cloud.points
        self.assertAlmostEqual(ahead.x, 2.6, places=3)  # the wall is 3 m off
        self.assertAlmostEqual(ahead.y, 0.0, places=3)
        self.assertAlmostEqual(left.x, 0.0, places=3)
        self.assertAlmostEqual(left.y, 2.0, delta=0.1)

    def test_the_newer_kind_of_cloud_has_the_same(self):
        self.start(robot={"message": "point_cloud2", "mounts": [[0.0, 0.1, math.pi / 2.0]] * 3,
                          "frames": ["ring"]})
        cloud = self.sim.message("sonar", PointCloud2)
        self.assertEqual((cloud.header.frame_id, cloud.width * cloud.height), ("ring", 3))
        for point in read_points(cloud, ("x", "y", "z")):
            self.assertAlmostEqual(point[1], 2.0, delta=0.1)

    def test_a_laser_sees_all_around(self):
        self.start(robot={"message": "laser_scan", "frames": ["laser"], "rays": 360,
                          "max_range": 2.5})
        scan = self.sim.message("sonar", LaserScan)
        self.assertEqual((scan.header.frame_id, len(scan.ranges)), ("laser", 360))
        self.assertTrue(math.isinf(scan.ranges[0]))  # the wall is 3 m off
        self.assertAlmostEqual(scan.ranges[90], 2.0, delta=0.1)
        self.assertAlmostEqual(scan.angle_min + 90 * scan.angle_increment, math.pi / 2.0, places=4)

    def test_sensors_may_have_a_topic_each(self):
        self.start(robot={"topics": ["left", "right"], "frames": ["l", "r"], "no_echo": "zero",
                          "mounts": [[0.0, 0.1, math.pi / 2.0], [0.0, -0.1, -math.pi / 2.0]]})
        self.assertEqual(self.sim.message("left", Range).header.frame_id, "l")
        right = self.sim.message("right", Range)
        self.assertEqual(right.header.frame_id, "r")
        self.assertAlmostEqual(right.range, 1.9, delta=0.1)

    def test_a_bearing_counts_clockwise_from_north(self):
        self.start(robot={"compass": "bearing"}, start={"x": 0.0, "y": 0.0, "yaw": -0.5})
        bearing = self.sim.message("heading", Float64).data
        self.assertAlmostEqual(bearing, 90.0 + math.degrees(0.5), delta=1.0)

    def test_a_driver_that_makes_no_sense_is_refused(self):
        self.refused("robot/topics", robot={"topics": ["a", "b"]})
        self.refused("robot/frames", robot={"message": "laser_scan", "frames": ["a", "b"]})
        self.refused("robot/message", "robot/compass", robot={"message": "smell", "compass": "sun"})


if __name__ == "__main__":
    rospy.init_node("live_drivers_test")
    rostest.rosrun("place_memory", "live_drivers_test", LiveDriversTest)
