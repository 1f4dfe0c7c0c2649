#!/usr/bin/env python3
"""The command line of place_memory_bag, what it says of bags and tables, and its exit status.

usage: place_memory_bag_test.py PLACE_MEMORY_BAG [UNITTEST OPTION]...
"""

import os
import random
import unittest

from geometry_msgs.msg import Point32
from nav_msgs.msg import Odometry
import rosbag
from sensor_msgs.msg import PointCloud

import bag_tool
from bag_tool import ALL, HEADER, NOTHING, SOME, START
import sonar_room  # found by bag_tool


class CommandLineTest(bag_tool.BagToolTest):
    # --- exit status and what is written ---

    def test_all_answered(self):
        self.rooms.write_events(self.path("events.csv"))
        answer = self.run_tool("--bag", self.bag, "--events", self.path("events.csv"),
                               "--out", self.out)
        self.assertEqual(answer.returncode, ALL, answer.stderr)
        self.assertEqual([row["status"] for row in self.rows()], ["ok"] * len(self.rooms.events))

    def test_some_failed(self):
        first = self.rooms.events[0]
        answer = self.run_events(HEADER + self.learn(first) + "1.0,2.0,learn,b,\n"
                                 + "99999,100000,recognize,,\n")
        self.assertEqual(answer.returncode, SOME, answer.stderr)
        statuses = [row["status"] for row in self.rows()]
        self.assertEqual(statuses[0], "ok")
        self.assertNotIn("ok", statuses[1:])
        self.assertIn("it lies before what the bag holds, which is from 999.000", answer.stderr)
        self.assertIn("it lies after what the bag holds", answer.stderr)

    def test_pipes_get_no_progress(self):
        answer = self.run_events(HEADER + self.learn(self.rooms.events[0]))
        self.assertNotIn("\r", answer.stderr)
        self.assertNotIn("[", answer.stderr)
        self.assertEqual(answer.stderr.count("\n"), 1, answer.stderr)

    def test_help_and_stray_arguments(self):
        answer = self.run_tool("--help")
        self.assertEqual(answer.returncode, ALL)
        self.assertIn("Exit status", answer.stdout)
        self.assert_refused(self.run_events(HEADER, "stray.yaml"), "stray.yaml", "--help")
        self.assert_refused(self.run_events(HEADER, "--parms", "a.yaml"), "--parms")
        self.assert_refused(self.run_tool("--bag", self.bag), "--out")

    def test_results_that_cannot_be_written(self):
        table = self.write("events.csv", HEADER)
        answer = self.run_tool("--bag", self.bag, "--events", table, "--out", "/nowhere/r.csv")
        self.assert_refused(answer, "cannot write the results /nowhere/r.csv")

    def test_without_a_table_it_takes_the_stretches_where_the_robot_stands(self):
        answer = self.run_tool("--bag", self.bag, "--out", self.out)
        self.assertEqual(answer.returncode, ALL, answer.stderr)
        rows = self.rows()
        self.assertEqual(len(rows), len(self.rooms.events))
        for row, event in zip(rows, self.rooms.events):
            self.assertLess(abs(float(row["start"]) - event.start), 1.0)
        # The first room is new to it.
        self.assertEqual(rows[0]["action"], "learn")
        labels = {row["place"]: row for row in rows if row["action"] == "learn"}
        for row in rows:
            self.assertEqual(row["status"], "ok")
            if row["action"] == "recognize":
                self.assertIn(row["verdict"], ("recognized", "ambiguous"))
                self.assertIn(row["place"], labels)
        self.assertIn("recognize", [row["action"] for row in rows])
        parameters = self.write("my.yaml", "odom_frame: world\n")
        os.remove(self.out)
        answer = self.run_tool("--bag", self.bag, "--out", self.out, "--params", parameters)
        self.assert_refused(answer, "no tf from the frame world")

    # --- what topics carry ---

    def as_pioneer(self, path):
        """The same bag as a Pioneer's driver has it: a cloud of points in the robot's frame, those
        without an echo at max_range, odometry on a topic, no compass and no tf."""
        with rosbag.Bag(self.bag) as rooms, rosbag.Bag(path, "w") as pioneer:
            for topic, message, stamp in rooms.read_messages(topics=["/sonar", "/tf"]):
                if topic == "/tf":
                    for moved in message.transforms:
                        odometry = Odometry(header=moved.header, child_frame_id="base_link")
                        odometry.pose.pose.position.x = moved.transform.translation.x
                        odometry.pose.pose.position.y = moved.transform.translation.y
                        odometry.pose.pose.orientation = moved.transform.rotation
                        pioneer.write("/pose", odometry, stamp)
                    continue
                sensor = int(message.header.frame_id.split("_")[1])
                if sensor == 0:
                    cloud = PointCloud(header=message.header)
                    cloud.header.frame_id = "/base_link"
                distance = min(message.range, message.max_range)
                x, y, _ = sonar_room.compose(sonar_room.sensor_pose(sensor), (distance, 0.0, 0.0))
                cloud.points.append(Point32(x, y, 0.0))
                if len(cloud.points) == sonar_room.SENSORS:
                    pioneer.write("/cloud", cloud, stamp)
        return path

    def test_a_bag_of_clouds_without_a_compass(self):
        bag = self.as_pioneer(self.path("pioneer.bag"))
        parameters = self.write("my.yaml", """
sonar_topics: [cloud]
heading_topic: ""
odom_topic: pose
cloud: {max_range: 6.0, field_of_view: 0.436}
""")
        # Each with the window that the tool has without a compass.
        events = "".join("%.3f,%.3f,%s,%s\n" % (event.start, event.end, event.action, event.label)
                         for event in self.rooms.events)
        answer = self.run_events(HEADER + events, "--params", parameters, bag=bag)
        self.assertEqual(answer.returncode, ALL, answer.stderr)
        right = [row["place"] == event.label and row["verdict"] == "recognized"
                 for row, event in zip(self.rows(), self.rooms.events)
                 if event.action == "recognize"]
        self.assertGreaterEqual(sum(right), 4, self.rows())

    def test_a_topic_of_a_wrong_type_is_named(self):
        parameters = self.write("my.yaml", "{sonar_topics: [heading], heading_topic: sonar}")
        answer = self.run_tool("--bag", self.bag, "--out", self.out, "--params", parameters)
        self.assert_refused(answer, "sensor_msgs/", "needed is")

    # --- tables and parameters ---

    def test_relative_times(self):
        first = self.rooms.events[0]
        begin = START - 1.0
        answer = self.run_events(HEADER + "+%.3f,+%.3f,learn,a,\n" % (first.start - begin,
                                                                     first.end - begin))
        self.assertEqual(answer.returncode, ALL, answer.stderr)
        self.assertEqual(float(self.rows()[0]["start"]), first.start)

    def test_wrong_tables_are_named(self):
        for text, word in (("start;end\n", "line 1: must be the header"),
                           (HEADER + "0,4294967295,learn,a,\n", "line 2: end must be"),
                           ((HEADER + "1,2,learn,a,\n").encode("utf-16"), "is UTF-16")):
            self.assert_refused(self.run_events(text), "events.csv", word)
        answer = self.run_tool("--bag", self.bag, "--events", self.path("none.csv"),
                               "--out", self.out)
        self.assert_refused(answer, "none.csv: cannot be read")

    def test_wrong_parameters_are_named(self):
        for content, word in (("scan: &a {b: *a}\n", "contains itself"),
                              ("scan: {headings: 5}\n---\n{}\n", "2 YAML documents"),
                              (b"# \xfc\n", "is not UTF-8"), ("base_frame: .nan\n", "a text")):
            parameters = self.write("my.yaml", content)
            answer = self.run_events(HEADER, "--params", parameters)
            self.assertEqual(answer.returncode, NOTHING)
            self.assertIn(word, answer.stderr)
            self.assertIn("my.yaml", answer.stderr)

    def test_the_store_is_said_from_the_root(self):
        events = HEADER + self.learn(self.rooms.events[0])
        home = dict(os.environ, HOME=self.folder)
        answer = self.run_events(events, "--store", "~/places.db", env=home)
        self.assertEqual(answer.returncode, ALL, answer.stderr)
        self.assertIn("kept in " + self.path("places.db"), answer.stderr)
        answer = self.run_events(events, "--store", "mine.db", cwd=self.folder)
        self.assertEqual(answer.returncode, ALL, answer.stderr)
        self.assertIn("kept in " + os.path.join(os.path.realpath(self.folder), "mine.db"),
                      answer.stderr)
        os.remove(self.out)
        self.assert_refused(self.run_events(events, "--store", "~other/places.db"), "--store")

    # --- bags ---

    def test_bags_that_cannot_be_read(self):
        with open(self.bag, "rb") as file:
            content = file.read()
        bags = ((self.write("text.bag", "a diary\n"), "text.bag"),
                (self.write("empty.bag", ""), "is an empty file"),
                (self.folder, "is a folder"), (self.path("none.bag"), "none.bag"),
                (self.write("short.bag", content[:len(content) // 2]), "short.bag"))
        for bag, word in bags:
            self.assert_refused(self.run_events(HEADER, bag=bag), word)

    def test_a_bag_without_index(self):
        path = self.path("cut.bag")
        bag = rosbag.Bag(path, "w")
        for topic, message, stamp in rosbag.Bag(self.bag).read_messages():
            bag.write(topic, message, stamp)
        bag.flush()
        self.addCleanup(bag.close)
        copy = self.path("copy.bag")
        with open(path, "rb") as file:
            self.write("copy.bag", file.read())
        self.assert_refused(self.run_events(HEADER, bag=copy), "rosbag reindex " + copy)

    def test_another_definition_of_a_message(self):
        path = self.path("other.bag")
        with rosbag.Bag(path, "w") as bag:
            for topic, message, stamp in rosbag.Bag(self.bag).read_messages(raw=True):
                kind, data, md5sum, position, cls = message
                if topic == "/sonar":
                    md5sum = "0123456789abcdef0123456789abcdef"
                header = None
                if topic == "/sonar":
                    header = {"topic": topic, "type": kind, "md5sum": md5sum,
                              "message_definition": cls._full_text}
                bag.write(topic, (kind, data, md5sum, position, cls), stamp, raw=True,
                          connection_header=header)
        self.assert_refused(self.run_events(HEADER, bag=path), "/sonar", "sensor_msgs/Range",
                            "0123456789abcdef", "rosbag fix")

    def test_damaged_bags_end_in_a_sentence(self):
        events = HEADER + "".join(self.learn(event, event.label)
                                  for event in self.rooms.events[:5])
        for compression in ("bz2", "lz4"):
            good = self.path(compression + ".bag")
            with rosbag.Bag(good, "w", compression=compression, chunk_threshold=16384) as bag:
                for topic, message, stamp in rosbag.Bag(self.bag).read_messages():
                    bag.write(topic, message, stamp)
            with open(good, "rb") as file:
                content = file.read()
            rng = random.Random(7)
            for trial in range(25):
                damaged = bytearray(content)
                at = rng.randrange(4200, len(content) - 4)
                damaged[at:at + 4] = bytes(rng.randrange(256) for _ in range(4))
                bag = self.write("damaged.bag", bytes(damaged))
                with self.subTest(compression=compression, at=at):
                    answer = self.run_events(events, bag=bag)
                    self.assertIn(answer.returncode, (ALL, NOTHING, SOME), answer.stderr)
                    if answer.returncode == NOTHING:
                        self.assertIn("place_memory_bag: ", answer.stderr)
                        self.assertIn("bag", answer.stderr.split("place_memory_bag: ")[1])


if __name__ == "__main__":
    unittest.main()
