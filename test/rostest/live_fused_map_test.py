#!/usr/bin/env python3
"""The building's map of a live node, as move_base's static layer and map_saver take it."""

import os
import subprocess
import unittest

import rospy
from diagnostic_msgs.msg import DiagnosticStatus
from nav_msgs.msg import MapMetaData, OccupancyGrid
from nav_msgs.srv import GetMap
from roslib.packages import find_node
from rospkg import ResourceNotFound

import live_test
import sonar_room
from live_diagnostics_test import Diagnostics

OCCUPIED, EMPTY, UNKNOWN = 100, 0, -1


def value_at(message, x, y):
    """Of the cell at a point of the map frame; unknown outside."""
    info = message.info
    column = int((x - info.origin.position.x) / info.resolution // 1)
    row = int((y - info.origin.position.y) / info.resolution // 1)
    if 0 <= column < info.width and 0 <= row < info.height:
        return message.data[row * info.width + column]
    return UNKNOWN


def has_wall(message, x, y):
    """Whether something is occupied within a cell of a place's grid from there."""
    steps = [0.05 * i for i in range(-4, 5)]
    return any(value_at(message, x + dx, y + dy) == OCCUPIED for dx in steps for dy in steps)


def unnumbered(message):
    """Only a topic counts its messages."""
    message.header.seq = 0
    return message


def without_map(message):
    return len(message.data) == 1


class LiveFusedMapTest(live_test.LiveTestCase):
    def start(self, **parameters):
        # Two of each sensor: a scan may begin in the middle of a round, and what one reading alone
        # tells is not enough for a cell to be empty.
        self.start_node(map__pause=0.1, scan__min_readings=2 * sonar_room.SENSORS, **parameters)

    def map(self):
        """As a subscriber gets it who comes now."""
        return unnumbered(self.node.latched("map", OccupancyGrid))

    def wait_for_map(self, condition, what):
        newest = []

        def holds():
            newest[:] = [self.map()]
            return condition(newest[0])

        self.wait(holds, what)
        return newest[0]

    def static_map(self):
        return unnumbered(rospy.ServiceProxy(self.node.name + "/static_map", GetMap)().map)

    def test_without_a_place_it_is_a_single_unknown_cell(self):
        self.start()
        message = self.map()
        self.assertEqual((message.info.width, message.info.height), (1, 1))
        self.assertEqual(list(message.data), [UNKNOWN])
        self.assertEqual(message.header.frame_id, "map")
        self.assertEqual(self.static_map(), message)

    def test_places_that_come_and_go_change_it(self):
        self.start()
        self.learn("hall", sonar_room.HALL)
        hall = self.wait_for_map(lambda message: not without_map(message), "the hall's map")
        self.assertEqual(value_at(hall, 0.6, 0.0), EMPTY, self.node.output())
        self.assertTrue(has_wall(hall, 0.0, 1.5) and has_wall(hall, 0.0, -1.5))
        self.assertEqual(value_at(hall, 20.0, 0.0), UNKNOWN)
        self.assertEqual(len(hall.data), hall.info.width * hall.info.height)
        self.assertEqual(set(hall.data), {OCCUPIED, EMPTY, UNKNOWN})
        self.assertAlmostEqual(hall.info.resolution, 0.05)

        self.robot.odometry = (20.0, 0.0, 0.0)
        self.learn("study", sonar_room.STUDY)
        self.node.call("rename_place", label="hall", new_label="lobby")
        both = self.wait_for_map(lambda message: value_at(message, 20.6, 0.0) == EMPTY,
                                 "the study on the map")
        self.assertEqual(value_at(both, 0.6, 0.0), EMPTY)

        self.node.call("remove_place", label="lobby")
        study = self.wait_for_map(lambda message: value_at(message, 0.6, 0.0) == UNKNOWN,
                                  "the hall to go")
        self.assertEqual(value_at(study, 20.6, 0.0), EMPTY)
        self.node.call("clear")
        self.wait_for_map(without_map, "everything to go")

    def test_the_service_and_the_metadata_say_what_the_topic_does(self):
        store = os.path.join(self.folder, "places.db")
        self.start(store=store)
        self.learn("hall", sonar_room.HALL)
        self.wait_for_map(lambda message: not without_map(message), "the hall's map")
        self.assertEqual(self.static_map(), self.map())
        self.assertEqual(self.node.latched("map_metadata", MapMetaData), self.map().info)
        before = self.map()
        self.node.stop()

        self.start(store=store)
        kept = self.static_map()  # waits until it is made
        self.assertEqual(kept.data, before.data)
        self.assertEqual(kept.info.origin, before.info.origin)

    def test_a_place_astray_makes_no_huge_map(self):
        self.start()
        diagnostics = Diagnostics(self.node)
        self.addCleanup(diagnostics.close)
        self.learn("hall", sonar_room.HALL)
        self.robot.odometry = (3.0, 0.0, 0.0)
        self.learn("study", sonar_room.STUDY)
        self.robot.odometry = (1e6, 0.0, 0.0)
        self.learn("moon", sonar_room.STUDY)
        self.run_robot(lambda: diagnostics.says("building map", DiagnosticStatus.WARN,
                                                "1 places lie too far off", "map/max_cells"),
                       "a warning")
        self.assertIn("too far off", self.node.output())
        # The warning may be said before the map that it is about is published.
        message = self.wait_for_map(lambda fused: value_at(fused, 0.6, 0.0) == EMPTY,
                                    "the map of what lies together")
        self.assertLess(len(message.data), 1000000)

    def test_map_saver_takes_it(self):
        try:
            found = find_node("map_server", "map_saver")
        except ResourceNotFound:
            raise unittest.SkipTest("there is no map_saver here")
        self.start()
        self.learn("hall", sonar_room.HALL)
        message = self.wait_for_map(lambda each: not without_map(each), "the hall's map")
        name = os.path.join(self.folder, "saved")
        subprocess.run([found[0], "-f", name, "map:=" + self.node.name + "/map"], check=True,
                       timeout=live_test.PATIENCE)
        with open(name + ".pgm", "rb") as file:
            pixels = file.read()[-len(message.data):]
        shades = {OCCUPIED: 0, EMPTY: 254, UNKNOWN: 205}
        rows = [message.data[i * message.info.width:(i + 1) * message.info.width]
                for i in reversed(range(message.info.height))]
        self.assertEqual(list(pixels), [shades[value] for row in rows for value in row])


class LivePublicMapTest(unittest.TestCase):
    def test_by_the_launch_file_it_has_the_names_of_map_server(self):
        words = ["roslaunch", "--wait", "place_memory", "place_memory.launch",
                 "name:=public_memory", "public_map:=true"]
        process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(process.wait, live_test.PATIENCE)
        self.addCleanup(process.terminate)
        rospy.wait_for_service("/static_map", live_test.PATIENCE)
        message = rospy.wait_for_message("/map", OccupancyGrid, live_test.PATIENCE)
        metadata = rospy.wait_for_message("/map_metadata", MapMetaData, live_test.PATIENCE)
        self.assertEqual(metadata, message.info)
        static = rospy.ServiceProxy("/static_map", GetMap)().map
        self.assertEqual(unnumbered(static), unnumbered(message))
        published = [name for name, _ in rospy.get_published_topics("/public_memory")]
        self.assertNotIn("/public_memory/map", published)


if __name__ == "__main__":
    live_test.main("live_fused_map_test", "live_fused_map_test")
