"""What the tests of place_memory_bag share: a bag of rooms, and a tool that is run on it."""

import csv
import os
import sys

import rosbag
import rospy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "rostest"))
from room_bag import RoomBag  # noqa: E402
from tool_test import ToolTest  # noqa: E402

START = 1000.0
HEADER = "start,end,action,label,heading_window\n"
ALL, NOTHING, SOME = 0, 1, 3


class BagToolTest(ToolTest):
    """Its tests are those of the classes made from it."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.bag = os.path.join(cls.shared.name, "rooms.bag")
        cls.rooms = RoomBag(cls.bag, START, seed=3)

    def setUp(self):
        super().setUp()
        self.out = self.path("results.csv")

    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        return self.path(name)

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

    def copy_bag(self, name, change):
        """A copy of the bag of rooms: `change` of topic, message and time of the record gives those
        to write, or None."""
        with rosbag.Bag(self.path(name), "w") as bag:
            for record in rosbag.Bag(self.bag).read_messages():
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
