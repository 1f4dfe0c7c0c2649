#!/usr/bin/env python3
"""The map of a live node as its clients have it: by its changes, as a whole, and in tf."""

import io
import math
import os
import time

import rospy
from place_memory.msg import MapChange, PlaceGraph, Recognition
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

import live_test
import sonar_room

RENAMES = 40
CALLS = 8


class MapClient:
    """Follows ~map_changes as MapChange.msg says."""

    def __init__(self, node):
        self._node = node
        self._changes = []
        self._subscriber = rospy.Subscriber(node.name + "/map_changes", MapChange,
                                            self._changes.append)
        self.graph = None
        self.whole = 0  # how often the whole map was asked for

    def close(self):
        self._subscriber.unregister()

    def hears(self):
        return bool(self._changes)

    def sizes(self):
        """Of every message that came [bytes]."""
        sizes = []
        for change in self._changes:
            buffer = io.BytesIO()
            change.serialize(buffer)
            sizes.append(len(buffer.getvalue()))
        return sizes

    def has(self, version):
        if self.graph is None:
            self._ask()
        for change in self._changes:
            if change.version == self.graph.version + 1:
                self._apply(change)
            elif change.version > self.graph.version:
                self._ask()
        return self.graph.version >= version

    def _ask(self):
        self.graph = self._node.call("get_graph").graph
        self.whole += 1

    def _apply(self, change):
        places = {place.id: place for place in self.graph.places}
        links = {(link.first_id, link.second_id): link for link in self.graph.links}
        if change.cleared:
            places, links = {}, {}
        for number in change.removed:
            places.pop(number)
        gone = set(change.removed)
        links = {ends: link for ends, link in links.items() if not gone & set(ends)}
        for ends in zip(change.unlinked_first, change.unlinked_second):
            links.pop(ends)
        places.update((place.id, place) for place in change.added)
        for number, location, session in zip(change.moved, change.moved_locations,
                                             change.moved_sessions):
            places[number].location = location
            places[number].session = session
        for number, label in zip(change.renamed, change.new_labels):
            places[number].label = label
        links.update(((link.first_id, link.second_id), link) for link in change.linked)
        for start, end, traversals in zip(change.travelled_from, change.travelled_to,
                                          change.travelled):
            link = links[(min(start, end), max(start, end))]
            if start < end:
                link.forward = traversals
            else:
                link.backward = traversals
        self.graph.header.stamp = change.header.stamp
        self.graph.version = change.version
        self.graph.places = [places[number] for number in sorted(places)]
        self.graph.links = [links[ends] for ends in sorted(links)]


class LiveMapTest(live_test.LiveTestCase):
    def follow(self):
        client = MapClient(self.node)
        self.addCleanup(client.close)
        self.wait(client.hears, "the newest change")
        self.assertTrue(client.has(0))
        return client

    def recognize(self, room, label, **position):
        self.robot.enter(room, **position)
        self.scan_well()
        response = self.node.call("recognize_place")
        self.assertEqual(response.recognition.verdict, Recognition.RECOGNIZED, response.message)
        self.assertEqual(response.recognition.matches[0].label, label)
        return response

    def edit_map(self):
        """Learns, goes to and fro, renames, removes, clears."""
        self.learn("hall", sonar_room.HALL)
        self.robot.odometry = (6.0, 0.0, 0.0)
        self.learn("study", sonar_room.STUDY)
        self.robot.odometry = (0.0, 0.0, 0.0)
        self.recognize(sonar_room.HALL, "hall")
        self.node.call("rename_place", label="hall", new_label="lobby")
        self.node.call("remove_place", label="study")
        self.node.call("clear")
        self.learn("attic", sonar_room.STUDY)
        self.learn("loft", sonar_room.HALL)

    def test_who_follows_the_changes_has_the_map(self):
        self.start_node()
        client = self.follow()
        self.edit_map()
        graph = self.graph()
        self.wait(lambda: client.has(graph.version), "the last change")
        self.assertEqual(client.graph, graph)
        self.assertEqual(client.whole, 1)
        self.assertLess(max(client.sizes()), 1000)

    def test_who_comes_late_gets_the_newest_version(self):
        self.start_node()
        self.edit_map()
        version = self.graph().version
        self.assertEqual(self.node.latched("map_changes", MapChange).version, version)
        client = self.follow()
        self.assertEqual(client.graph, self.graph())
        self.learn("cellar", sonar_room.HALL)
        self.wait(lambda: client.has(version + 1), "the next change")
        self.assertEqual(client.graph, self.graph())
        self.assertEqual(client.whole, 1)

    def test_the_whole_map_comes_once_a_second_at_most(self):
        self.start_node()
        self.learn("hall", sonar_room.HALL)
        graphs, markers = [], []
        for topic, kind, came in (("place_graph", PlaceGraph, graphs),
                                  ("place_markers", MarkerArray, markers)):
            subscriber = rospy.Subscriber(self.node.name + "/" + topic, kind, came.append)
            self.addCleanup(subscriber.unregister)
        self.wait(lambda: graphs and graphs[-1].places and markers, "the map")
        begin = time.monotonic()
        label = "hall"
        for i in range(RENAMES):
            self.node.call("rename_place", label=label, new_label="hall %d" % i)
            label = "hall %d" % i
        self.wait(lambda: graphs[-1].places[0].label == label, "the last label")
        self.wait(lambda: markers[-1].markers[-1].text == label, "the marker of it")
        most = 3 + (time.monotonic() - begin)
        self.assertLess(len(graphs), most)
        self.assertLess(len(markers), most)

    def test_markers_have_labels_near_the_robot_only(self):
        self.start_node(markers__labels=1)
        self.learn("hall", sonar_room.HALL)
        self.robot.odometry = (20.0, 0.0, 0.0)
        self.learn("study", sonar_room.STUDY)

        def texts():
            markers = self.node.latched("place_markers", MarkerArray).markers
            return [marker.text for marker in markers if marker.text]

        self.wait(lambda: texts() == ["study"], "the label of the study")
        # It drives back, and nothing changes in the map.
        self.robot.odometry = (1.0, 0.0, 0.0)
        self.run_robot(lambda: texts() == ["hall"], "the label of the hall")

    def test_the_stamp_of_the_map_survives_a_restart(self):
        store = os.path.join(self.folder, "places.db")
        self.start_node(store=store)
        self.learn("hall", sonar_room.HALL)
        graph = self.graph()
        self.assertGreater(graph.header.stamp.to_sec(), 1000.0)
        self.node.stop()
        self.start_node(store=store)
        self.assertEqual(self.graph(), graph)
        latched = self.node.latched("place_graph", PlaceGraph)
        self.assertEqual((latched.header.stamp, latched.version, latched.places),
                         (graph.header.stamp, graph.version, graph.places))
        change = self.node.latched("map_changes", MapChange)
        self.assertEqual((change.version, change.header.stamp, change.added),
                         (graph.version, graph.header.stamp, []))

    def test_what_was_overtaken_stays_with_who_asked(self):
        """However answers and places that are learned overtake each other, the newest label is that
        of the place which the next one is linked to, or the newest answer was not sure."""
        self.start_node()
        self.learn("hall", sonar_room.HALL)
        self.learn("study", sonar_room.STUDY)
        for turn in range(4):
            scans = []
            for room in (sonar_room.STUDY, sonar_room.HALL):
                self.robot.enter(room)
                scans.append(self.scan_well().scan_id)

            def recognize(scan):
                for _ in range(CALLS):
                    self.node.call("recognize_place", heading_window=3.14, scan_id=scan)

            def learn():
                self.node.call("learn_place", label="learned %d" % turn, scan_id=scans[0])

            threads = live_test.InThreads(lambda: recognize(scans[0]),
                                          lambda: recognize(scans[1]), learn)
            self.addCleanup(threads.join)
            self.run_robot(threads.are_over, "every client to be answered")
            label = self.node.latched("current_place", String).data
            newest = self.learn("next %d" % turn, sonar_room.HALL).place_id
            graph = self.graph()
            labels = {place.id: place.label for place in graph.places}
            linked = [labels[link.first_id] for link in graph.links if link.second_id == newest]
            if label:
                self.assertEqual(linked, [label])
            self.assertEqual(self.node.latched("current_place", String).data, "next %d" % turn)


class LiveFrameTest(live_test.LiveTestCase):
    """Where the map lies to odometry, by answers and in tf."""

    def setUp(self):
        super().setUp()
        self.store = os.path.join(self.folder, "places.db")
        # No other test has it.
        self.map_frame = "map_%d" % (live_test.LiveTestCase.nodes + 1)
        self.transforms = []
        subscriber = rospy.Subscriber("/tf", TFMessage, self._on_tf)
        self.addCleanup(subscriber.unregister)

    def _on_tf(self, message):
        self.transforms += [each for each in message.transforms
                            if each.header.frame_id == self.map_frame]

    def start(self, **parameters):
        parameters.setdefault("tf_broadcast", True)
        self.start_node(store=self.store, map_frame=self.map_frame, **parameters)
        del self.transforms[:]

    def broadcast(self):
        """The newest transform that the node sends from now on."""
        del self.transforms[:]
        self.run_robot(lambda: len(self.transforms) > 2, "the transform")
        newest = self.transforms[-1]
        self.assertEqual(newest.child_frame_id, "odom")
        rotation = newest.transform.rotation
        return (newest.transform.translation.x, newest.transform.translation.y,
                2.0 * math.atan2(rotation.z, rotation.w))

    def assert_pose(self, pose, expected, delta=1e-6):
        for value, wanted in zip(pose, expected):
            self.assertAlmostEqual(value, wanted, delta=delta)

    def place(self, label):
        return next(place for place in self.graph().places if place.label == label)

    def recognize(self, room, **position):
        self.robot.enter(room, **position)
        self.scan_well()
        response = self.node.call("recognize_place")
        self.assertEqual(response.recognition.verdict, Recognition.RECOGNIZED, response.message)
        return response

    def restart(self, **parameters):
        """The robot is switched off and on again: odometry begins anew."""
        self.node.stop()
        self.start(**parameters)
        self.robot.odometry = (0.0, 0.0, 0.0)

    def test_without_the_parameter_nothing_is_sent(self):
        self.start(tf_broadcast=False)
        self.learn("hall", sonar_room.HALL)
        self.run_for(2.0)
        self.assertEqual(self.transforms, [])

    def test_an_empty_map_begins_where_odometry_does(self):
        self.start()
        self.assert_pose(self.broadcast(), (0.0, 0.0, 0.0))
        self.robot.odometry = (3.0, -2.0, 0.5)
        self.learn("hall", sonar_room.HALL)
        self.assert_pose(self.broadcast(), (0.0, 0.0, 0.0))

    def test_after_a_restart_the_frame_is_known_once_a_place_is_recognized(self):
        self.start()
        self.robot.odometry = (3.0, -2.0, 0.5)
        self.learn("hall", sonar_room.HALL)
        self.restart()
        self.run_for(2.0)
        self.assertEqual(self.transforms, [])

        response = self.recognize(sonar_room.HALL, x=0.4, y=-0.2)
        pose = response.recognition.pose.pose
        robot = (pose.position.x, pose.position.y,
                 2.0 * math.atan2(pose.orientation.z, pose.orientation.w))
        self.assert_pose(robot, sonar_room.compose((3.0, -2.0, 0.5), (0.4, -0.2, 0.0)), 0.2)
        # Odometry had the robot at its origin.
        self.assert_pose(self.broadcast(), robot)

        # What is learned now lies in the same map.
        self.robot.odometry = (5.0, 0.0, 0.0)
        self.learn("study", sonar_room.STUDY)
        location = self.place("study").location
        self.assert_pose((location.x, location.y, location.theta),
                         sonar_room.compose(robot, (5.0, 0.0, 0.0)), 1e-6)
        self.assertEqual(self.place("study").session, 1)

    def test_what_is_learned_apart_moves_to_where_it_belongs(self):
        self.start()
        self.robot.odometry = (3.0, -2.0, 0.5)
        self.assertFalse(self.learn("hall", sonar_room.HALL).apart)
        self.restart()
        self.robot.odometry = (2.0, 0.0, 0.0)
        response = self.learn("study", sonar_room.STUDY)
        self.assertTrue(response.apart)
        self.assertEqual(response.session, 2)
        self.assertIn("recognise", response.message)
        self.assertEqual(self.place("study").session, 2)
        # Where the robot is in the map is not known yet.
        self.run_for(2.0)
        self.assertEqual(self.transforms, [])

        self.robot.odometry = (0.0, 0.0, 0.0)
        response = self.recognize(sonar_room.HALL)
        self.assertIn("1 place learned before", response.message)
        study = self.place("study")
        self.assertEqual(study.session, 1)
        frame = self.broadcast()
        self.assert_pose(frame, (3.0, -2.0, 0.5), 0.2)
        self.assert_pose((study.location.x, study.location.y, study.location.theta),
                         sonar_room.compose(frame, (2.0, 0.0, 0.0)))
        self.assertFalse(self.learn("attic", sonar_room.STUDY).apart)


if __name__ == "__main__":
    live_test.main("live_map_test", "live_map_test")
