#!/usr/bin/env python3
"""What a live node does with what it is started with: parameters and the store of places."""

import os
import shutil
import sqlite3

from place_memory.msg import Recognition

import live_test
import sonar_room


class LiveStartTest(live_test.LiveTestCase):
    def setUp(self):
        super().setUp()
        self.store = os.path.join(self.folder, "places.db")

    def start(self, **parameters):
        self.start_node(store=self.store, **parameters)

    def learn_two(self):
        self.learn("hall", sonar_room.HALL)
        self.robot.odometry = (6.0, 1.0, 0.0)
        self.learn("study", sonar_room.STUDY)
        return self.node.call("list_places").places

    def assert_recognized(self, label, room):
        self.robot.enter(room)
        self.scan_well()
        found = self.node.call("recognize_place").recognition
        self.assertEqual(found.verdict, Recognition.RECOGNIZED)
        self.assertEqual(found.matches[0].label, label)

    def refused_parameters(self, parameters):
        """What a node prints that is started with them."""
        node = live_test.Node("/bad_%d" % len(parameters), parameters,
                              os.path.join(self.folder, "bad.log"))
        self.addCleanup(node.stop)
        self.assertEqual(node.process.wait(live_test.PATIENCE), 1)
        return node.output()

    def test_bad_parameters_are_all_listed(self):
        parameters = {
            "grid/cell_size": -0.1, "scan/headings": 2.5, "scan/turn": "sideways",
            "match/confidence": "high", "match/preset": "/nowhere.yaml", "base_frame": "",
            "sonar_topics": [], "sonar/occupied": 1.2, "scan/setp": 0.1, "colour": "red",
        }
        output = self.refused_parameters(parameters)
        for name in parameters:
            lines = [line for line in output.splitlines() if line.startswith("  " + name)]
            self.assertEqual(len(lines), 1, name + " in " + output)

    def test_parameters_that_do_not_go_together_are_refused(self):
        self.assertIn("occupied", self.refused_parameters({"sonar/occupied": 0.3}))

    def test_it_says_what_it_listens_to(self):
        node = live_test.Node("/telling", {"sonar_topics": ["front", "/rear"],
                                           "heading_topic": "imu/data", "odom_frame": "wheels"},
                              os.path.join(self.folder, "telling.log"))
        self.addCleanup(node.stop)
        node.wait_for_services()
        self.wait(lambda: "turns by" in node.output(), "the line at start")
        for word in ("sonar /telling/front, /rear", "heading /telling/imu/data",
                     "wheels -> base_link", "/telling/cmd_vel"):
            self.assertIn(word, node.output())

    def test_a_name_that_is_remapped_in_vain_is_said(self):
        log = os.path.join(self.folder, "remapped.log")
        for parameters, is_vain in (({}, False), ({"sonar_topics": ["rear", "sonar"]}, False),
                                    ({"sonar_topics": ["rear"]}, True)):
            with self.subTest(parameters=parameters):
                node = live_test.Node("/remapped_%d" % len(parameters.get("sonar_topics", "")),
                                      parameters, log,
                                      ["sonar:=/ring", "heading:=heading"])
                self.addCleanup(node.stop)
                node.wait_for_services()
                self.wait(lambda: "turns by" in node.output(), "the line at start")
                node.stop()
                self.assertEqual("sonar is remapped to /ring" in node.output(), is_vain)
                self.assertNotIn("heading is remapped", node.output())

    def test_places_outlive_the_node(self):
        self.start()
        places = self.learn_two()
        self.assertEqual(self.node.stop(), 0)
        self.assertIn("0 places known, kept in " + self.store, self.node.output())
        self.assertIn('learned "hall"', self.node.output())
        self.start()
        self.assertEqual(self.node.call("list_places").places, places)
        self.assert_recognized("hall", sonar_room.HALL)
        self.assert_recognized("study", sonar_room.STUDY)
        newest = self.node.call("learn_place", label="")
        self.assertGreater(newest.place_id, places[-1].id)
        self.assertEqual(self.node.stop(), 0)
        self.assertIn("2 places known, kept in " + self.store, self.node.output())

    def test_places_outlive_a_node_that_is_killed(self):
        self.start()
        places = self.learn_two()
        self.node.kill()
        self.start()
        self.assertEqual(self.node.call("list_places").places, places)
        self.assert_recognized("study", sonar_room.STUDY)

    def test_edits_outlive_the_node(self):
        self.start()
        self.learn_two()
        self.node.call("rename_place", label="hall", new_label="corridor")
        self.node.call("remove_place", label="study")
        self.node.stop()
        self.start()
        self.assertEqual(self.labels(), ["corridor"])
        self.node.call("clear")
        self.node.stop()
        self.start()
        self.assertEqual(self.labels(), [])

    def refuse(self, *words):
        """Starts a node that has to leave the store as it is and go on without it."""
        with open(self.store, "rb") as file:
            before = file.read()
        beside = sorted(os.listdir(self.folder))
        self.start()
        self.assertIn("in memory only", self.node.output())
        for word in (self.store,) + words:
            self.assertIn(word, self.node.output())
        self.assertEqual(self.labels(), [])
        response = self.learn("attic", sonar_room.HALL)
        self.assertIn("in memory only", response.message)
        self.assert_recognized("attic", sonar_room.HALL)
        self.assertEqual(self.node.stop(), 0)
        with open(self.store, "rb") as file:
            self.assertEqual(file.read(), before)
        left = sorted(os.path.basename(name) for name in os.listdir(self.folder)
                      if not name.endswith(".log"))
        self.assertEqual(left, [name for name in beside if not name.endswith(".log")])

    def test_files_that_are_no_store_are_refused_and_left_as_they_are(self):
        def diary():
            with open(self.store, "w") as file:
                file.write("this is a diary\n" * 1000)

        def empty():
            open(self.store, "w").close()

        def foreign():
            with sqlite3.connect(self.store) as database:
                database.execute("CREATE TABLE song(title TEXT)")
            database.close()

        for make, word in ((diary, "not a place store"), (empty, "cut short"),
                           (foreign, "not a place store")):
            with self.subTest(store=make.__name__):
                make()
                self.refuse(word)
                os.remove(self.store)

    def test_stores_that_are_damaged_are_refused_and_left_as_they_are(self):
        self.start()
        self.learn_two()
        self.node.stop()
        good = self.store + ".good"
        shutil.copyfile(self.store, good)
        size = os.path.getsize(good)

        def truncated():
            os.truncate(self.store, size // 2)

        def newer():
            database = sqlite3.connect(self.store)
            database.execute("PRAGMA user_version = 99")
            database.close()

        def overwritten():
            with open(self.store, "r+b") as file:
                file.seek(4096)
                file.write(b"\xff" * (size - 4096))

        for damage, word in ((truncated, "cut short"), (newer, "newer"),
                             (overwritten, "damaged")):
            with self.subTest(store=damage.__name__):
                shutil.copyfile(good, self.store)
                damage()
                self.refuse(word)
        shutil.copyfile(good, self.store)
        self.start()
        self.assertEqual(self.labels(), ["hall", "study"])

    def test_a_second_node_does_not_take_the_store(self):
        self.start()
        self.learn_two()
        first = self.node
        self.start()
        self.assertIn("in memory only", self.node.output())
        self.assertEqual(self.labels(), [])
        self.node = first
        self.assertEqual(self.labels(), ["hall", "study"])


if __name__ == "__main__":
    live_test.main("live_start_test", LiveStartTest)
