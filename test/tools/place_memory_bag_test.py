#!/usr/bin/env python3
"""The command line of place_memory_bag, what it says of bags and tables, and its exit status.

usage: place_memory_bag_test.py PLACE_MEMORY_BAG [UNITTEST OPTION]...
"""

import csv
import html.parser
import os
import random
import subprocess
import sys
import tempfile
import unittest

import rosbag
import rospy

TOOL = sys.argv.pop(1)
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "rostest"))
from room_bag import RoomBag  # noqa: E402

START = 1000.0
HEADER = "start,end,action,label,heading_window\n"
ALL, NOTHING, SOME = 0, 1, 3


class Outline(html.parser.HTMLParser):
    """Counts elements, checks that they are nested, and finds what a page would load."""

    def __init__(self):
        super().__init__()
        self.open = []
        self.count = {}
        self.links = []

    def handle_starttag(self, tag, attrs):
        self.count[tag] = self.count.get(tag, 0) + 1
        self.links += [value for name, value in attrs if name in ("src", "href")]
        if tag not in ("meta", "br"):
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.count[tag] = self.count.get(tag, 0) + 1

    def handle_endtag(self, tag):
        if self.open.pop() != tag:
            raise AssertionError("</%s> closes another element" % tag)


class BagToolTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.shared = tempfile.TemporaryDirectory()
        cls.bag = os.path.join(cls.shared.name, "rooms.bag")
        cls.rooms = RoomBag(cls.bag, START, seed=3)

    @classmethod
    def tearDownClass(cls):
        cls.shared.cleanup()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.out = self.path("results.csv")

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        return self.path(name)

    def run_tool(self, *arguments, **options):
        return subprocess.run((TOOL,) + arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              universal_newlines=True, timeout=120, **options)

    def run_events(self, events, *more, bag=None, **options):
        table = self.write("events.csv", events)
        return self.run_tool("--bag", bag or self.bag, "--events", table, "--out", self.out, *more,
                             **options)

    def rows(self):
        with open(self.out) as file:
            return list(csv.DictReader(file))

    def learn(self, event, label="a"):
        return "%.3f,%.3f,learn,%s,\n" % (event.start, event.end, label)

    def assert_refused(self, answer, *words):
        """With a sentence, and nothing done."""
        self.assertEqual(answer.returncode, NOTHING, answer.stderr)
        for word in words:
            self.assertIn(word, answer.stderr)
        self.assertEqual(answer.stderr.count("\n"), 1, answer.stderr)
        self.assertFalse(os.path.exists(self.out))

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

    # --- tables and parameters ---

    def test_relative_times_count_from_the_first_header_stamp(self):
        skewed = self.skewed(30.0)
        first = self.rooms.events[0]
        begin = START - 1.0
        events = HEADER + "+%.3f,+%.3f,learn,a,\n" % (first.start - begin, first.end - begin)
        answer = self.run_events(events, bag=skewed)
        self.assertEqual(answer.returncode, ALL, answer.stderr)
        self.assertEqual(float(self.rows()[0]["start"]), first.start)

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

    def copy_bag(self, name, change, source=None):
        """A copy of the bag of rooms, or of another: `change` of topic, message and time of the
        record gives those to write, or None."""
        with rosbag.Bag(self.path(name), "w") as bag:
            for record in rosbag.Bag(source or self.bag).read_messages():
                changed = change(*record)
                if changed is not None:
                    bag.write(*changed)
        return self.path(name)

    def skewed(self, offset):
        """As a recorder whose clock is so far ahead has it [s]."""
        return self.copy_bag("skewed.bag", lambda topic, message, stamp:
                             (topic, message, stamp + rospy.Duration.from_sec(offset)))

    def answers_of(self, *bags, said=()):
        """Everything but how long it took, where each event was answered."""
        self.rooms.write_events(self.path("all.csv"))
        answer = self.run_tool("--bag", *bags, "--events", self.path("all.csv"), "--out", self.out)
        self.assertEqual(answer.returncode, ALL, answer.stderr)
        for words in said:
            self.assertIn(words, answer.stderr)
        self.assertEqual(answer.stderr.count("\n"), 1 + len(said), answer.stderr)
        rows = self.rows()
        for row in rows:
            del row["match_ms"]
        return rows

    def test_the_clock_of_the_recorder_makes_no_difference(self):
        right = self.answers_of(self.bag)
        for offset in (-300.0, -30.0, -8.0, -1.2, -0.9, 1.0, 1.6, 4.0, 30.0, 1e6):
            with self.subTest(offset=offset):
                said = "%.2f s %s the header stamps" % (
                    abs(offset), "ahead of" if offset > 0.0 else "behind")
                self.assertEqual(self.answers_of(self.skewed(offset), said=[said]), right)

    def test_a_recorder_that_is_held_up_makes_no_difference(self):
        """As where a slow disk or network delivers in bursts of four seconds."""
        def hold_up(topic, message, stamp):
            seconds = stamp.to_sec()
            return topic, message, rospy.Time.from_sec(4.0 * (seconds // 4.0 + 1.0))
        right = self.answers_of(self.bag)
        rng = random.Random(5)
        records = [hold_up(*record) for record in rosbag.Bag(self.bag).read_messages()]
        bursts = self.path("bursts.bag")
        with rosbag.Bag(bursts, "w") as bag:
            # Of each burst each topic comes in its own order.
            order = {"/sonar": rng.random(), "/heading": rng.random(), "/tf": rng.random()}
            for record in sorted(records, key=lambda record: (record[2], order.get(record[0], 0))):
                bag.write(*record)
        self.rooms.write_events(self.path("all.csv"))
        answer = self.run_tool("--bag", bursts, "--events", self.path("all.csv"), "--out", self.out)
        self.assertEqual(answer.returncode, ALL, answer.stderr)
        rows = self.rows()
        for row, expected in zip(rows, right):
            del row["match_ms"]
            self.assertEqual(row, expected)

    def test_tf_of_the_old_type_and_topics_without_slash(self):
        def change(topic, message, stamp):
            return topic.lstrip("/"), message, stamp
        right = self.answers_of(self.bag)
        self.assertEqual(self.answers_of(self.copy_bag("plain.bag", change)), right)
        old = self.path("old.bag")
        with rosbag.Bag(old, "w") as bag:
            for topic, message, stamp in rosbag.Bag(self.bag).read_messages(raw=True):
                kind, data, md5sum, position, cls = message
                if topic == "/tf":
                    kind = "tf/tfMessage"
                header = {"topic": topic, "type": kind, "md5sum": md5sum,
                          "message_definition": cls._full_text}
                bag.write(topic, (kind, data, md5sum, position, cls), stamp, raw=True,
                          connection_header=header)
        self.assertEqual(rosbag.Bag(old).get_type_and_topic_info().topics["/tf"].msg_type,
                         "tf/tfMessage")
        self.assertEqual(self.answers_of(old), right)
        parameters = self.write("my.yaml", "sonar_topics: [/sonar]\nheading_topic: /heading\n")
        answer = self.run_events(HEADER + self.learn(self.rooms.events[0]), "--params", parameters)
        self.assertEqual(answer.returncode, ALL, answer.stderr)

    def test_one_stale_stamp_is_left_out_and_its_sensor_named(self):
        first = self.rooms.events[0]
        changed = []

        def change(topic, message, stamp):
            if topic == "/sonar" and stamp.to_sec() > first.start + 1.0 and not changed:
                changed.append(message.header.frame_id)
                message.header.stamp = rospy.Time(2)
            return topic, message, stamp
        bag = self.copy_bag("stale.bag", change)
        answer = self.run_events(HEADER + self.learn(first), bag=bag)
        self.assertEqual(answer.returncode, ALL, answer.stderr)
        self.assertIn("reading of %s left out" % changed[0], answer.stderr)
        self.assertNotIn("recorder", answer.stderr)

    def test_a_sensor_with_a_clock_of_its_own_is_named(self):
        def change(topic, message, stamp):
            if topic == "/sonar" and message.header.frame_id == "sonar_3":
                message.header.stamp += rospy.Duration(5)
            return topic, message, stamp
        answer = self.run_events(HEADER + self.learn(self.rooms.events[0]),
                                 bag=self.copy_bag("stray.bag", change))
        self.assertEqual(answer.returncode, ALL, answer.stderr)
        self.assertIn("on /sonar of frame 'sonar_3' is stamped 5.00 s after the others",
                      answer.stderr)

    def test_several_bags_are_read_as_one(self):
        right = self.answers_of(self.bag)
        # Cut within a scan; the second part is recorded by another clock.
        middle = self.rooms.events[4].start + 2.0
        first = self.copy_bag("first.bag", lambda topic, message, stamp:
                              (topic, message, stamp) if stamp.to_sec() < middle else None)
        second = self.copy_bag("second.bag", lambda topic, message, stamp:
                               (topic, message, stamp + rospy.Duration(7))
                               if stamp.to_sec() >= middle else None)
        said = ["second.bag the recorder's clock is 7.00 s ahead of"]
        self.assertEqual(self.answers_of(first, second, said=said), right)
        self.assertEqual(self.answers_of(second, first, said=said), right)
        # The second begins before the first ends.
        early = self.rooms.events[3].start
        second = self.copy_bag("second.bag", lambda topic, message, stamp:
                               (topic, message, stamp)
                               if topic == "/tf_static" or stamp.to_sec() >= early else None)
        self.assertEqual(self.answers_of(first, second, said=["overlap by"]), right)
        events = HEADER + self.learn(self.rooms.events[0])
        os.remove(self.out)
        answer = self.run_events(events, "--bag", self.path("none.bag"))
        self.assert_refused(answer, "none.bag")

    # --- the report ---

    def test_the_report_has_a_section_an_event_and_needs_nothing_else(self):
        self.rooms.write_events(self.path("all.csv"))
        with open(self.path("all.csv"), "a") as table:
            table.write("1.0,2.0,learn,beyond,\n")
        page = self.path("report.html")
        answer = self.run_tool("--bag", self.bag, "--events", self.path("all.csv"),
                               "--out", self.out, "--report", page)
        self.assertEqual(answer.returncode, SOME, answer.stderr)
        with open(page, encoding="utf-8") as file:
            text = file.read()
        outline = Outline()
        outline.feed(text)
        outline.close()
        self.assertEqual(outline.open, [])
        rows = self.rows()
        self.assertEqual(outline.count["section"], len(rows))
        learned = sum(row["action"] == "learn" and row["status"] == "ok" for row in rows)
        recognized = sum(row["action"] == "recognize" for row in rows)
        # Of a recognition scan, place and both; the map.
        self.assertEqual(outline.count["svg"], learned + 3 * recognized + 1)
        self.assertEqual(outline.links, [])
        for row in rows[:-1]:
            self.assertIn("<b>%s</b>" % row["place"], text)
        self.assertIn("it lies before what the bag holds", text)
        answer = self.run_tool("--bag", self.bag, "--events", self.path("all.csv"),
                               "--out", self.path("other.csv"), "--report", "/nowhere/r.html")
        self.assertEqual(answer.returncode, NOTHING)
        self.assertIn("cannot write the report /nowhere/r.html", answer.stderr)

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
