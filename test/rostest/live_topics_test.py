#!/usr/bin/env python3
"""What a live node publishes, as a subscriber gets it who comes late."""

import math

import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped
from nav_msgs.msg import OccupancyGrid
from place_memory.msg import PlaceGraph, Recognition
from std_msgs.msg import String
from visualization_msgs.msg import Marker, MarkerArray

import live_test
import sonar_room

UNSENSED = -1


def middle(grid):
    """Pose of the middle of a grid in the frame of its header."""
    origin = grid.info.origin
    yaw = 2.0 * math.atan2(origin.orientation.z, origin.orientation.w)
    half = 0.5 * grid.info.width * grid.info.resolution
    return sonar_room.compose((origin.position.x, origin.position.y, yaw), (half, half, 0.0))


def cell(grid, x, y):
    """Value at a point of the grid's own frame, where the robot stands in the middle."""
    column = int((x / grid.info.resolution) + 0.5 * grid.info.width)
    row = int((y / grid.info.resolution) + 0.5 * grid.info.height)
    return grid.data[row * grid.info.width + column]


class LiveTopicsTest(live_test.LiveTestCase):
    def markers(self):
        return self.node.latched("place_markers", MarkerArray).markers

    def marker_texts(self):
        return sorted(marker.text for marker in self.markers() if marker.text)

    def latched_graph(self, labels):
        """Once it has these places: it comes once a second at most."""
        def is_there():
            graph = self.node.latched("place_graph", PlaceGraph)
            return [place.label for place in graph.places] == labels

        self.wait(is_there, "the graph of " + ", ".join(labels))
        self.wait(lambda: self.marker_texts() == labels, "the markers of " + ", ".join(labels))
        return self.node.latched("place_graph", PlaceGraph)

    def current_place(self):
        return self.node.latched("current_place", String).data

    def test_an_empty_map_is_there_from_the_start(self):
        self.start_node()
        graph = self.node.latched("place_graph", PlaceGraph)
        self.assertEqual((graph.header.frame_id, graph.places, graph.links), ("map", [], []))
        self.assertEqual([marker.action for marker in self.markers()], [Marker.DELETEALL])
        self.assertEqual(self.current_place(), "")

    def test_scan_grid_shows_the_room(self):
        self.start_node()
        self.robot.odometry = (5.0, 1.0, 0.0)
        self.robot.spin = 0.3
        self.scan_well(headings=11)
        grid = self.node.latched("scan_grid", OccupancyGrid)
        self.assertEqual((grid.header.frame_id, grid.info.width, grid.info.height),
                         ("odom", 64, 64))
        self.assertAlmostEqual(grid.info.resolution, 0.142875, places=6)
        self.assertAlmostEqual(middle(grid)[0], 5.0, places=6)
        self.assertAlmostEqual(middle(grid)[1], 1.0, places=6)
        for x in (-2.5, -1.0, 1.0):
            self.assertIn(cell(grid, x, 0.0), range(0, 50))
            self.assertGreater(cell(grid, x, -1.5), 50)
        self.assertEqual(cell(grid, 0.0, 4.0), UNSENSED)

        cells = self.node.latched("scan_cells", Marker)
        self.assertEqual((cells.header.frame_id, cells.action), ("odom", Marker.ADD))
        self.assertAlmostEqual(cells.pose.position.x, 5.0, places=6)
        self.assertTrue(any(abs(point.y + 1.5) < 0.2 for point in cells.points))
        self.assertFalse(any(math.hypot(point.x, point.y) < 0.5 for point in cells.points))

    def test_scan_grid_shows_a_scan_under_way(self):
        self.start_node()
        grids = []
        subscriber = rospy.Subscriber(self.node.name + "/scan_grid", OccupancyGrid, grids.append)
        self.addCleanup(subscriber.unregister)
        scan = self.begin_scan(headings=11)
        self.run_robot(lambda: len(grids) > 1, "grids of a scan under way")
        self.assertFalse(scan.is_over())

    def test_map_topics_follow_every_change(self):
        self.start_node()
        self.learn("hall", sonar_room.HALL)
        self.assertEqual(self.current_place(), "hall")
        self.robot.odometry = (6.0, 0.0, 0.0)
        self.learn("study", sonar_room.STUDY)
        graph = self.latched_graph(["hall", "study"])
        ids = [place.id for place in graph.places]
        self.assertEqual([(link.first_id, link.second_id) for link in graph.links], [tuple(ids)])
        newest = self.graph()
        self.assertEqual((graph.header.stamp, graph.version, graph.places, graph.links),
                         (newest.header.stamp, newest.version, newest.places, newest.links))
        lines = [marker for marker in self.markers() if marker.type == Marker.LINE_LIST]
        self.assertEqual([len(marker.points) for marker in lines], [2])
        self.assertEqual(self.current_place(), "study")

        self.node.call("rename_place", label="study", new_label="library")
        self.latched_graph(["hall", "library"])
        self.assertEqual(self.current_place(), "library")

        self.node.call("remove_place", label="library")
        self.assertEqual(self.latched_graph(["hall"]).links, [])
        self.assertEqual(self.current_place(), "")

        self.node.call("clear")
        self.latched_graph([])

    def test_markers_of_a_removed_place_vanish(self):
        self.start_node()
        self.learn("hall", sonar_room.HALL)
        self.robot.odometry = (6.0, 0.0, 0.0)
        study = self.learn("study", sonar_room.STUDY).place_id
        shown = set()  # as rviz keeps it: namespace, id

        def show(array):
            for marker in array.markers:
                if marker.action == Marker.DELETEALL:
                    shown.clear()
                elif marker.action == Marker.DELETE:
                    shown.discard((marker.ns, marker.id))
                else:
                    shown.add((marker.ns, marker.id))

        subscriber = rospy.Subscriber(self.node.name + "/place_markers", MarkerArray, show)
        self.addCleanup(subscriber.unregister)
        self.wait(lambda: ("labels", study) in shown, "the marker of the study")
        self.node.call("remove_place", label="study")
        self.wait(lambda: ("labels", study) not in shown, "the marker to vanish")
        self.assertFalse([ns for ns, number in shown if number == study])
        self.assertTrue(shown)

    def test_what_was_recognized_before_time_jumped_is_withdrawn(self):
        self.start_node()
        self.learn("hall", sonar_room.HALL)
        self.assertEqual(self.current_place(), "hall")
        self.world.set_time(self.world.now - 50.0)
        self.wait(lambda: self.current_place() == "", "the label to be withdrawn")
        # The next place is linked to none.
        self.run_for(0.5)
        self.learn("study", sonar_room.STUDY)
        self.assertEqual(self.graph().links, [])

    def test_recognition_topics_say_what_was_answered(self):
        self.start_node()
        self.learn("hall", sonar_room.HALL)
        self.learn("study", sonar_room.STUDY)
        self.robot.enter(sonar_room.STUDY, 0.4, 0.1)
        self.robot.odometry = (20.0, 0.0, 0.0)
        scan = self.scan_well()
        answer = self.node.call("recognize_place").recognition
        self.assertEqual(answer.verdict, Recognition.RECOGNIZED)
        self.assertEqual(self.node.latched("recognition", Recognition), answer)
        pose = self.node.latched("pose", PoseWithCovarianceStamped)
        self.assertEqual((pose.header, pose.pose), (answer.header, answer.pose))
        self.assertEqual(pose.header.frame_id, "map")
        self.assertAlmostEqual((pose.header.stamp - scan.end).to_sec(), 0.0, places=6)
        self.assertEqual(self.current_place(), "study")

        # The recalled grid lies over the scan as the alignment has it.
        scan_grid = self.node.latched("scan_grid", OccupancyGrid)
        matched = self.node.latched("matched_grid", OccupancyGrid)
        self.assertEqual(matched.header.frame_id, "odom")
        transform = answer.matches[0].transform
        self.assertAlmostEqual(transform.x, 0.4, delta=0.2)
        aligned = sonar_room.inverse((transform.x, transform.y, transform.theta))
        for is_, should_be in zip(middle(matched), sonar_room.compose(middle(scan_grid), aligned)):
            self.assertAlmostEqual(is_, should_be, places=6)
        self.assertGreater(max(matched.data), 50)
        cells = self.node.latched("matched_cells", Marker)
        self.assertEqual((cells.header.frame_id, cells.action), ("odom", Marker.ADD))
        likely, percent = self.node.latched("answer_markers", MarkerArray).markers
        self.assertEqual(likely.header.frame_id, "map")
        self.assertAlmostEqual(likely.colors[0].a, answer.matches[0].probability, places=5)
        self.assertRegex(percent.text, r"^\d+ %$")

    def test_an_unknown_place_clears_what_was_recalled(self):
        self.start_node()
        self.learn("hall", sonar_room.HALL)
        self.scan_well()
        self.node.call("recognize_place")
        self.node.call("clear")
        answer = self.node.call("recognize_place").recognition
        self.assertEqual(answer.verdict, Recognition.UNKNOWN)
        self.assertEqual(self.current_place(), "")
        matched = self.node.latched("matched_grid", OccupancyGrid)
        self.assertEqual(set(matched.data), {UNSENSED})
        self.assertEqual(self.node.latched("matched_cells", Marker).action, Marker.DELETE)
        for marker in self.node.latched("answer_markers", MarkerArray).markers:
            self.assertEqual(marker.action, Marker.DELETE)


if __name__ == "__main__":
    live_test.main("live_topics_test", LiveTopicsTest)
