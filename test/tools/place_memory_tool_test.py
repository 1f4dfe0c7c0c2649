#!/usr/bin/env python3
"""The program place_memory on stores."""

import csv
import json
import os
import sqlite3
import subprocess
import sys
import unittest
import xml.etree.ElementTree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "rostest"))
from png_picture import Picture  # noqa: E402
from room_bag import RoomBag  # noqa: E402
from tool_test import ToolTest  # noqa: E402

BAG_TOOL = sys.argv.pop(1)
START = 1000.0
DONE, FAILED, NO, NO_ANSWER = range(4)


class MapToolTest(ToolTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.bag = os.path.join(cls.shared.name, "rooms.bag")
        cls.rooms = RoomBag(cls.bag, START, seed=3)

    def setUp(self):
        super().setUp()
        self.store = self.path("places.db")
        self.learn(self.store, "hall", "study")

    def learn(self, store, *labels):
        """The rooms of the bag."""
        events = self.path("events.csv")
        with open(events, "w") as file:
            file.write("start,end,action,label,heading_window\n")
            for event, label in zip(self.rooms.events, labels):
                file.write("%.3f,%.3f,learn,%s,\n" % (event.start, event.end, label))
        subprocess.run((BAG_TOOL, "--bag", self.bag, "--events", events, "--out",
                        self.path("results.csv"), "--store", store), check=True,
                       stderr=subprocess.DEVNULL)

    def run_tool(self, *arguments, status=DONE):
        done = super().run_tool(*arguments)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done

    def say(self, *arguments, store=None, status=DONE):
        return self.run_tool(*arguments, "--store", store or self.store, status=status)

    def labels(self, store=None):
        return [place["label"] for place in
                json.loads(self.say("list", "--json", store=store).stdout)]

    def test_places_are_listed_for_people_and_programs(self):
        lines = self.say("list").stdout.splitlines()
        self.assertEqual(lines[0].split()[:3], ["id", "label", "session"])
        self.assertEqual([line.split()[1] for line in lines[1:]], ["hall", "study"])
        self.assertEqual(self.labels(), ["hall", "study"])
        stats = json.loads(self.say("stats", "--json").stdout)[0]
        self.assertEqual((stats["places"], stats["links"], stats["version"]), (2, 1, 2))

    def test_a_place_is_shown_in_words_and_as_a_picture(self):
        picture = self.path("hall.png")
        shown = self.say("show", "hall", "--png", picture).stdout
        self.assertIn("linked to", shown)
        self.assertIn("study", shown)
        drawn = Picture(picture)
        self.assertEqual((drawn.width, drawn.height), (512, 512))
        self.assertGreater(len(set(drawn.bytes)), 3)
        self.say("show", "attic", status=NO)
        self.assertIn("--node", self.say("go", "hall", status=FAILED).stderr)

    def test_scans_of_another_store_are_recognized_and_learned(self):
        other = self.path("other.db")
        self.learn(other, "their hall", "their study")
        found = json.loads(self.say("recognize", "their study", "--from", other, "--json").stdout)
        self.assertEqual((found["verdict"], found["matches"][0]["place"]), ("recognized", "study"))
        empty = self.path("empty.db")
        self.learn(empty)
        self.say("recognize", "their hall", "--from", other, store=empty, status=NO)
        self.say("learn", "their hall", "--from", other, "--label", "new", store=empty)
        self.assertEqual(self.labels(empty), ["new"])
        self.say("learn", "their hall", "--from", other, "--label", "new", store=empty,
                 status=FAILED)

    def test_changes_are_undone(self):
        history = json.loads(self.say("history", "--json").stdout)
        self.assertEqual([change["change"] for change in history],
                         ['learned "study"', 'learned "hall"'])
        self.say("undo")
        self.assertEqual(self.labels(), ["hall"])
        self.say("undo", "--count", "2", status=NO)
        self.assertEqual(self.labels(), ["hall"])

    def test_a_way_is_planned(self):
        legs = json.loads(self.say("plan", "study", "hall", "--json").stdout)
        self.assertEqual([leg["place"] for leg in legs], ["study", "hall"])
        self.say("plan", "hall", "attic", status=NO)

    def test_stores_are_merged(self):
        other = self.path("other.db")
        self.learn(other, "their hall", "their study")
        self.assertIn("2 were known", self.say("merge", other).stdout)
        self.assertEqual(self.labels(), ["hall", "study"])
        self.say("merge", self.path("none.db"), status=FAILED)

    def test_a_map_is_exported(self):
        folder = self.path("export")
        self.say("export", folder)
        with open(os.path.join(folder, "places.csv")) as file:
            self.assertEqual([row["label"] for row in csv.DictReader(file)], ["hall", "study"])
        with open(os.path.join(folder, "links.csv")) as file:
            self.assertEqual([(row["first"], row["second"]) for row in csv.DictReader(file)],
                             [("1", "2")])
        graph = xml.etree.ElementTree.parse(os.path.join(folder, "map.graphml")).getroot()
        names = {"g": "http://graphml.graphdrawing.org/xmlns"}
        self.assertEqual(len(graph.findall("g:graph/g:node", names)), 2)
        self.assertEqual(len(graph.findall("g:graph/g:edge", names)), 1)
        with open(os.path.join(folder, "places", "1.pgm"), "rb") as file:
            header, content = file.read(13), file.read()
        self.assertEqual((header, len(content)), (b"P5\n64 64\n255\n", 64 * 64))
        with open(os.path.join(folder, "building.pgm"), "rb") as file:
            columns, rows = file.read(20).split()[1:3]
        self.assertGreater(int(columns), int(rows))
        with open(os.path.join(folder, "places", "1.yaml")) as file:
            self.assertIn("image: 1.pgm", file.read())

    def test_a_store_is_checked_row_by_row(self):
        self.assertIn("every row", self.say("check").stdout)
        database = sqlite3.connect(self.store)
        database.execute("UPDATE grid SET cells = zeroblob(4096) WHERE place_id = 2")
        database.commit()
        database.close()
        checked = self.say("check", status=NO)
        self.assertIn("grid of place 2", checked.stdout)
        self.assertIn("~save", checked.stderr)

    def test_what_cannot_be_done_is_said(self):
        self.assertIn("which command", self.run_tool(status=FAILED).stderr)
        self.assertIn("no command", self.run_tool("dance", "-s", self.store, status=FAILED).stderr)
        self.assertIn("--store", self.run_tool("list", status=FAILED).stderr)
        self.assertIn("use: place_memory show", self.say("show", status=FAILED).stderr)
        none = self.path("none.db")
        self.assertIn("there is no store", self.say("list", store=none, status=FAILED).stderr)
        self.assertFalse(os.path.exists(none))
        database = sqlite3.connect(self.store)
        database.execute("BEGIN EXCLUSIVE")
        self.assertIn("in use", self.say("check", status=FAILED).stderr)
        database.close()
        help_text = self.run_tool("--help").stdout
        for word in ("list", "recognize", "Exit status", "--json"):
            self.assertIn(word, help_text)


if __name__ == "__main__":
    unittest.main()
