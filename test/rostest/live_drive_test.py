#!/usr/bin/env python3
"""A live node that drives the map along with the robot: it makes one, knows where it is on one, and
says what happens. The robot's drives are played from bags."""

import math
import os
import subprocess
import tempfile
import unittest

import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped
from place_memory.msg import MapEvent, PlaceBelief
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

import live_test
from corridor_bag import CorridorBag
from sonar_room import compose

START = 10000.0  # of the first drive; each test's are later than those before
FAST = 10.0
INPUTS = {"sonar_topics": ["/sonar"], "heading_topic": "/heading"}


def pose_of(pose):
    return (pose.position.x, pose.position.y,
            2.0 * math.atan2(pose.orientation.z, pose.orientation.w))


def where_it_lies(link):
    return link.first_id, link.second_id, link.transform, link.covariance


def travels(graph):
    return sum(link.forward.succeeded + link.backward.succeeded for link in graph.links)


def distance(one, other):
    return math.hypot(one[0] - other[0], one[1] - other[1])


def turn(one, other):
    return abs(math.atan2(math.sin(one[2] - other[2]), math.cos(one[2] - other[2])))


class LiveDriveTest(unittest.TestCase):
    drives = 0

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.store = os.path.join(self.folder, "places.db")

    # --- drives and nodes ---

    def drive(self, rounds, **options):
        LiveDriveTest.drives += 1
        path = os.path.join(self.folder, "drive_%d.bag" % LiveDriveTest.drives)
        drive = CorridorBag(path, START + 1000.0 * LiveDriveTest.drives, rounds, **options)
        drive.path = path
        return drive

    def make_store(self, drive, store):
        """As the bag tool makes it of the drive."""
        parameters = os.path.join(self.folder, "params.yaml")
        with open(parameters, "w") as file:
            file.write("sonar_topics: [/sonar]\nheading_topic: /heading\n")
        subprocess.run([live_test.executable("place_memory_bag"), "--bag", drive.path, "--mode",
                        "map", "--store", store, "--params", parameters], check=True,
                       stderr=subprocess.DEVNULL, timeout=100)

    def start_node(self, **parameters):
        live_test.LiveTestCase.nodes += 1
        namespace = "/drive_%d" % live_test.LiveTestCase.nodes
        given = dict(INPUTS, map_frame="map" + namespace.replace("/", "_"))
        given.update({name.replace("__", "/"): value for name, value in parameters.items()})
        self.frame = given["map_frame"]
        self.node = live_test.Node(namespace, given, os.path.join(self.folder, "log"))
        self.addCleanup(self.node.stop)
        self.node.wait_for_services()
        self.events, self.poses, self.transforms = [], [], []
        for topic, kind, take in (
                (self.node.name + "/events", MapEvent, self.events.append),
                (self.node.name + "/pose", PoseWithCovarianceStamped, self.poses.append),
                ("/tf", TFMessage, self.on_tf)):
            subscriber = rospy.Subscriber(topic, kind, take)
            self.addCleanup(subscriber.unregister)
            if topic != "/tf":
                self.wait(lambda heard=subscriber: heard.get_num_connections() > 0,
                          "the node to be heard")
        return self.node

    def on_tf(self, message):
        self.transforms += [each for each in message.transforms
                            if each.header.frame_id == self.frame]

    def wait(self, condition, what):
        live_test.LiveTestCase._poll(self, condition, what, lambda: rospy.rostime.wallsleep(0.02))

    def play(self, drive, rate=FAST):
        """Plays the drive, and waits until the node has worked out all of it, or is lost."""
        subprocess.run(["rosbag", "play", "--quiet", "--clock", "--wait-for-subscribers", "--delay=1",
                        "--rate=%g" % rate, drive.path], check=True, timeout=200,
                       stdout=subprocess.DEVNULL)
        last = drive.truth[-1][0]
        self.wait(lambda: self.poses and self.poses[-1].header.stamp.to_sec() > last - 0.01,
                  "the pose at the end")

    def set_mode(self, mode):
        return self.node.call("set_mode", mode=mode)

    def mode(self):
        return self.node.latched("mode", String).data

    def kinds(self):
        return [event.kind for event in self.events]

    def assert_ok(self, response):
        self.assertEqual(response.status, 0, response.message)

    def error(self, map_drive, drive):
        """Of the newest pose among the places, which were made on the way of `map_drive`: how far
        the distances to them are off at the most [m]."""
        robot = pose_of(self.poses[-1].pose.pose)
        return max(abs(distance(robot, (place.location.x, place.location.y))
                       - distance(drive.truth[-1][1], map_drive.at(place.learned.to_sec())))
                   for place in self.node.call("list_places").places)

    # --- modes ---

    def test_the_mode_is_off_until_somebody_sets_it(self):
        self.start_node()
        self.assertEqual(self.mode(), "off")
        self.assertEqual(self.set_mode("drive").status, 1)
        response = self.set_mode("localize")
        self.assertEqual(response.status, 3)
        self.assertIn("mode map", response.message)
        self.assertEqual(self.node.call("relocalize").status, 3)
        self.assertEqual(self.mode(), "off")
        self.assert_ok(self.set_mode("map"))
        self.assertEqual(self.mode(), "map")
        self.assert_ok(self.set_mode("off"))
        self.assertEqual(self.mode(), "off")

    # --- a map, and where the robot is on it ---

    def test_a_map_is_made_and_a_later_drive_is_found_on_it(self):
        first = self.drive(2, seed=1)
        self.start_node(mode="map", store=self.store, tf_broadcast=True)
        self.assertEqual(self.mode(), "map")
        self.play(first)
        places = self.node.call("list_places").places
        self.assertGreater(len(places), 6)
        self.assertGreaterEqual(self.kinds().count(MapEvent.NEW_PLACE), len(places))
        self.assertLess(self.error(first, first), 0.3)
        self.assertTrue(self.transforms)
        self.assertEqual(self.transforms[-1].child_frame_id, "odom")
        belief = self.node.latched("belief", PlaceBelief)
        self.assertLess(belief.p_lost, 0.2)
        self.assertGreater(belief.probabilities[0], 0.5)
        self.assertEqual(len(belief.labels), len(belief.ids))
        label = places[0].label
        self.assert_ok(self.node.call("rename_place", label=label, new_label="desk"))
        self.node.stop()

        # The next day: odometry starts anew, elsewhere.
        self.start_node(mode="localize", store=self.store, tf_broadcast=True)
        before = self.node.call("get_graph").graph
        self.assertIn("desk", [place.label for place in before.places])
        # A round, whose ends are linked though no place was made on the way between them.
        self.assertGreaterEqual(len(before.links), len(before.places))
        later = self.drive(1, seed=7, ahead=60)
        self.play(later)
        self.assertIn(MapEvent.JOINED, self.kinds())
        self.assertIn(MapEvent.FOUND, self.kinds())
        self.assertTrue(self.events[self.kinds().index(MapEvent.JOINED)].places)
        self.assertLess(self.error(first, later), 0.3)
        self.assertTrue(self.transforms)
        # But for what links learn from being driven.
        after = self.node.call("get_graph").graph
        self.assertEqual(after.places, before.places)
        self.assertEqual([where_it_lies(link) for link in after.links],
                         [where_it_lies(link) for link in before.links])

        # Somebody says where the robot is, wrongly.
        said = PoseWithCovarianceStamped()
        said.header.frame_id = "elsewhere"
        said.pose.pose.position.x = 100.0
        said.pose.pose.orientation.w = 1.0
        heard = len(self.poses)
        teller = self.initialpose()
        teller.publish(said)
        said.header.frame_id = self.frame
        said.pose.pose.position.x = 3.0
        teller.publish(said)
        self.wait(lambda: len(self.poses) > heard, "the pose that was said")
        self.assertEqual(len(self.poses), heard + 1)
        for value, wanted in zip(pose_of(self.poses[-1].pose.pose), (3.0, 0.0, 0.0)):
            self.assertAlmostEqual(value, wanted, delta=1e-6)

        # It is to be found from nothing, and no word of before counts.
        self.assert_ok(self.node.call("relocalize"))
        self.wait(lambda: self.kinds()[-1] == MapEvent.SESSION, "the event of it")
        del self.events[:]
        again = self.drive(1, seed=9)
        self.play(again)
        self.assertIn(MapEvent.FOUND, self.kinds())
        self.assertLess(self.error(first, again), 0.3)

        # What links learn is kept when the drive ends, at the latest.
        self.assert_ok(self.set_mode("off"))
        self.assertGreater(travels(self.node.call("get_graph").graph), travels(before))

    def initialpose(self):
        publisher = rospy.Publisher(self.node.name.rsplit("/", 1)[0] + "/initialpose",
                                    PoseWithCovarianceStamped, queue_size=2)
        self.addCleanup(publisher.unregister)
        self.wait(lambda: publisher.get_num_connections() > 0, "the node to listen")
        return publisher

    def test_a_robot_that_is_carried_is_lost_and_found(self):
        first = self.drive(2, seed=1)
        self.make_store(first, self.store)
        later = self.drive(3, seed=5, carried_at=50.0)
        self.start_node(mode="localize", store=self.store, drive__initialpose=True)
        told = []
        subscriber = rospy.Subscriber(self.node.name.rsplit("/", 1)[0] + "/initialpose",
                                      PoseWithCovarianceStamped, told.append)
        self.addCleanup(subscriber.unregister)
        self.wait(lambda: subscriber.get_num_connections() > 0, "the node to be heard")
        self.play(later)
        self.assertEqual([kind for kind in self.kinds()
                          if kind in (MapEvent.FOUND, MapEvent.LOST)],
                         [MapEvent.FOUND, MapEvent.LOST, MapEvent.FOUND],
                         [event.sentence for event in self.events])
        # For amcl, each time that it was found; it does not listen to itself.
        self.assertEqual(len(told), 2)
        self.assertEqual(told[0].header.frame_id, self.frame)
        self.assertLess(self.error(first, later), 0.3)

    # --- the same whatever the rate ---

    def test_node_and_bag_tool_agree_whatever_the_rate(self):
        drive = self.drive(2, seed=3)
        self.make_store(drive, self.store)
        self.start_node(store=self.store)
        wanted = self.places()
        self.assertGreater(len(wanted), 6)
        self.node.stop()
        for rate in (3.0, 20.0):
            with self.subTest(rate=rate):
                self.start_node(mode="map")
                self.play(drive, rate)
                self.assert_ok(self.set_mode("off"))  # all is kept then
                self.compare(self.places(), wanted)
                self.node.stop()

    def places(self):
        """Where the robot stood at each of them; their own axes are those of the map as it was when
        they were kept first."""
        return {place.id: compose((place.location.x, place.location.y, place.location.theta),
                                  (place.robot.x, place.robot.y, place.robot.theta))
                for place in self.node.call("list_places").places}

    def compare(self, places, wanted):
        self.assertEqual(sorted(places), sorted(wanted))
        for number, robot in wanted.items():
            self.assertLess(distance(places[number], robot), 0.05)
            self.assertLess(turn(places[number], robot), math.radians(1.0))


if __name__ == "__main__":
    live_test.main("live_drive_test", LiveDriveTest)
