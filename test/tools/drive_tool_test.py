#!/usr/bin/env python3
"""What place_memory_bag --mode map|localize makes of a whole drive.

usage: drive_tool_test.py PLACE_MEMORY_BAG [UNITTEST OPTION]...
"""

import csv
import math
import os
import sys
import unittest

import rosbag

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "rostest"))
from corridor_bag import CorridorBag  # noqa: E402
from png_picture import Picture  # noqa: E402
from tool_test import ToolTest  # noqa: E402

START = 1000.0
TABLES = ("trajectory", "final", "map", "answers")
COLUMNS = {
    "trajectory": "t,x,y,yaw,lost",
    "final": "t,x,y,yaw",
    "map": "id,label,t,x,y,yaw",
    "answers": "t,decision,place,dx,dy,dyaw,belief,lost,reason",
}
PLACE, WAY = bytes((32, 96, 192)), bytes((240, 150, 40))
DECISIONS = {"new_place", "tracked", "closed", "candidate", "between", "lost"}


def rows(path):
    with open(path) as file:
        return list(csv.DictReader(file))


def read(path):
    with open(path, "rb") as file:
        return file.read()


class DriveToolTest(ToolTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.bag = os.path.join(cls.shared.name, "drive.bag")
        cls.drive = CorridorBag(cls.bag, START, rounds=3, seed=1)
        cls.later_bag = os.path.join(cls.shared.name, "later.bag")
        cls.later = CorridorBag(cls.later_bag, 5000.0, rounds=1, seed=7)

    def setUp(self):
        super().setUp()
        self.store = self.path("places.db")

    def drive_through(self, bag, mode, *more, name="one", compass=True):
        """Returns the paths of the tables."""
        tables = {table: self.path("%s_%s.csv" % (name, table)) for table in TABLES}
        arguments = ["--bag", bag, "--mode", mode]
        for table, path in tables.items():
            arguments += ["--" + table, path]
        if not compass:
            parameters = self.path("no_compass.yaml")
            with open(parameters, "w") as file:
                file.write('heading_topic: ""\n')
            arguments += ["--params", parameters]
        answer = self.run_tool(*(arguments + list(more)))
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.said = answer.stderr
        return tables

    def assert_refused(self, answer, *words):
        self.assertEqual(answer.returncode, 1, answer.stderr)
        for word in words:
            self.assertIn(word, answer.stderr)
        self.assertEqual(answer.stderr.count("\n"), 1, answer.stderr)

    def named(self, tables, drive, map_rows):
        """Errors [m], [rad] of the scans that name a place that was made another time."""
        born = {row["id"]: float(row["t"]) for row in map_rows}
        errors = []
        for row in rows(tables["answers"]):
            if row["place"] not in born or row["decision"] == "new_place":
                continue
            place = self.drive.at(born[row["place"]])
            robot = drive.at(float(row["t"]))
            c, s = math.cos(place[2]), math.sin(place[2])
            x, y = robot[0] - place[0], robot[1] - place[1]
            true = (c * x + s * y, -s * x + c * y, robot[2] - place[2])
            turn = true[2] - float(row["dyaw"])
            errors.append((math.hypot(true[0] - float(row["dx"]), true[1] - float(row["dy"])),
                           abs(math.atan2(math.sin(turn), math.cos(turn)))))
        return errors

    def check_tables(self, tables):
        for table, path in tables.items():
            with open(path) as file:
                self.assertEqual(file.readline().rstrip("\n"), COLUMNS[table])
        trajectory = rows(tables["trajectory"])
        self.assertEqual(len(trajectory), len(self.drive.truth))
        for row, (t, _) in zip(trajectory, self.drive.truth):
            self.assertAlmostEqual(float(row["t"]), t, delta=0.002)
            self.assertEqual(row["x"] == "", row["yaw"] == "")
            self.assertTrue(0.0 <= float(row["lost"]) <= 1.0)
        self.assertEqual(len(rows(tables["final"])), len(trajectory))
        self.assertLessEqual({row["decision"] for row in rows(tables["answers"])}, DECISIONS)
        places = rows(tables["map"])
        self.assertGreater(len(places), 6)
        self.assertEqual(places[0]["label"], "place_" + places[0]["id"])
        return places

    def check_way(self, tables):
        """That the last round lies on the first one, though odometry has bent by then."""
        way = {round(float(row["t"]), 2): row for row in rows(tables["final"])}
        a_round = len(self.drive.truth) // 3
        gaps = []
        for (t, pose), (later, again) in zip(self.drive.truth[:a_round],
                                             self.drive.truth[2 * a_round:]):
            one, other = way[round(t, 2)], way[round(later, 2)]
            true = math.hypot(pose[0] - again[0], pose[1] - again[1])
            gaps.append(abs(math.hypot(float(one["x"]) - float(other["x"]),
                                       float(one["y"]) - float(other["y"])) - true))
        self.assertLess(max(gaps), 0.3)

    # --- what is made of a drive ---

    def test_a_map_of_a_drive(self):
        for compass in (True, False):
            with self.subTest(compass=compass):
                tables = self.drive_through(self.bag, "map", compass=compass)
                places = self.check_tables(tables)
                self.check_way(tables)
                errors = self.named(tables, self.drive, places)
                self.assertGreater(len(errors), 60)
                self.assertLess(sorted(e for e, _ in errors)[len(errors) // 2], 0.1)
                self.assertLess(max(e for e, _ in errors), 0.5)
                self.assertLess(max(turn for _, turn in errors), math.radians(15.0))

    def test_the_same_drive_gives_the_same_tables(self):
        one = self.drive_through(self.bag, "map", name="one")
        other = self.drive_through(self.bag, "map", name="other")
        for table in TABLES:
            self.assertEqual(read(one[table]), read(other[table]), table)

    def test_the_order_of_recording_does_not_matter(self):
        mixed = self.path("mixed.bag")
        CorridorBag(mixed, START, rounds=3, seed=1, late=0.9)
        one = self.drive_through(self.bag, "map", name="one")
        other = self.drive_through(mixed, "map", name="other")
        for table in TABLES:
            self.assertEqual(read(one[table]), read(other[table]), table)

    def test_a_drive_in_several_bags_is_one_drive(self):
        parts = [self.path("0.bag"), self.path("1.bag")]
        with rosbag.Bag(self.bag) as whole, rosbag.Bag(parts[0], "w") as first, \
                rosbag.Bag(parts[1], "w") as second:
            for topic, message, stamp in whole:
                (first if stamp.to_sec() < START + 50.05 else second).write(topic, message, stamp)
        one = self.drive_through(self.bag, "map", name="one")
        other = self.drive_through(parts[0], "map", "--bag", parts[1], name="other")
        for table in TABLES:
            self.assertEqual(read(one[table]), read(other[table]), table)

    def test_each_table_may_be_left_out(self):
        answer = self.run_tool("--bag", self.bag, "--mode", "map", "--map", self.path("m.csv"))
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertIn("places", answer.stderr)
        self.assertEqual(os.listdir(self.folder), ["m.csv"])

    def test_a_picture_of_the_map(self):
        path = self.path("map.png")
        answer = self.run_tool("--bag", self.bag, "--mode", "map", "--png", path, "--store",
                               self.store)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        picture = Picture(path)
        self.assertEqual(max(picture.width, picture.height), 1400)
        colours = picture.shares()
        self.assertGreater(colours[b"\xff\xff\xff"], 0.05)  # empty
        self.assertGreater(colours[b"\0\0\0"], 0.01)  # occupied
        self.assertGreater(colours[PLACE], 0.0005)
        self.assertGreater(colours[WAY], 0.0005)
        self.assertLess(os.path.getsize(path), 300000)

        later = self.path("later.png")
        answer = self.run_tool("--bag", self.later_bag, "--mode", "localize", "--png", later,
                               "--store", self.store)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertGreater(Picture(later).shares()[WAY], 0.0005)

    def test_odometry_that_starts_anew_begins_a_session_that_joins_by_itself(self):
        bag = self.path("reset.bag")
        CorridorBag(bag, START, rounds=3, seed=1, reset_at=60.0)
        tables = self.drive_through(bag, "map")
        self.assertIn("odometry started anew 1 times", self.said)
        trajectory = rows(tables["trajectory"])
        unknown = [float(row["t"]) - START for row in trajectory if row["x"] == ""]
        self.assertTrue(any(t > 60.0 for t in unknown))
        self.assertNotEqual(trajectory[-1]["x"], "")
        self.assertIn("closed", {row["decision"] for row in rows(tables["answers"])})
        errors = self.named(tables, self.drive, rows(tables["map"]))
        self.assertLess(max(e for e, _ in errors), 0.5)

    # --- the store ---

    def test_a_later_drive_is_localized_in_a_map_that_was_kept(self):
        for compass in (True, False):
            with self.subTest(compass=compass):
                store = self.path("places_%s.db" % compass)
                first = self.drive_through(self.bag, "map", "--store", store, compass=compass)
                places, before = rows(first["map"]), read(store)
                later = self.drive_through(self.later_bag, "localize", "--store", store,
                                           name="later", compass=compass)
                self.assertEqual(read(store), before)
                self.assertEqual([row["id"] for row in rows(later["map"])],
                                 [row["id"] for row in places])
                errors = self.named(later, self.later, places)
                self.assertGreater(len(errors), 0.5 * len(rows(later["answers"])))
                self.assertLess(max(e for e, _ in errors), 0.5)

    def test_a_second_session_goes_on_with_the_map(self):
        first = self.drive_through(self.bag, "map", "--store", self.store)
        second = self.drive_through(self.later_bag, "map", "--store", self.store, name="second")
        ids = {row["id"] for row in rows(first["map"])}
        self.assertLessEqual(ids, {row["id"] for row in rows(second["map"])})
        self.assertLessEqual(len(rows(second["map"])), len(ids) + 2)
        self.assertIn("closed", {row["decision"] for row in rows(second["answers"])})

    def test_places_of_a_drive_are_recognized_like_others(self):
        self.drive_through(self.bag, "map", "--store", self.store)
        events = self.path("events.csv")
        with open(events, "w") as file:
            file.write("start,end,action,label,heading_window\n")
            file.write("5010,5010.5,recognize,,\n")
        answer = self.run_tool("--bag", self.later_bag, "--events", events, "--out",
                               self.path("out.csv"), "--store", self.store)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        result = rows(self.path("out.csv"))[0]
        self.assertEqual(result["status"], "ok")
        self.assertRegex(result["place"], "^place_[0-9]+$")

    # --- what is refused ---

    def test_wrong_arguments(self):
        def refused(*arguments):
            return self.run_tool("--bag", self.bag, *arguments)
        self.assert_refused(refused("--mode", "drive"), "map or localize", "'drive'")
        self.assert_refused(refused("--mode", "map", "--out", self.path("o.csv")), "--out", "--mode")
        self.assert_refused(refused("--out", self.path("o.csv"), "--final", "f.csv"), "--final",
                            "needs --mode")
        self.assert_refused(refused("--mode", "map", "--map", "/nowhere/m.csv"),
                            "cannot write the table /nowhere/m.csv")
        self.assert_refused(refused("--mode", "map", "--png", "/nowhere/m.png"),
                            "cannot write the picture /nowhere/m.png")
        self.assert_refused(refused("--out", self.path("o.csv"), "--png", "m.png"), "--png",
                            "needs --mode")
        self.assert_refused(refused("--mode", "localize"), "needs a map", "--store")
        self.assert_refused(refused("--mode", "localize", "--store", self.store), "needs a map",
                            "there is no store", "--mode map")
        self.assertEqual(os.listdir(self.folder), [])

    def test_a_store_without_a_place(self):
        bag = self.path("short.bag")
        CorridorBag(bag, START, rounds=0, seed=1)
        answer = self.run_tool("--bag", bag, "--mode", "map", "--store", self.store)
        self.assertEqual(answer.returncode, 1)  # a bag without tf
        CorridorBag(bag, START, rounds=1, seed=1)
        self.run_tool("--bag", self.bag, "--events", "/dev/null", "--out", self.path("o.csv"),
                      "--store", self.store)
        answer = self.run_tool("--bag", bag, "--mode", "localize", "--store", self.store)
        self.assertEqual(answer.returncode, 1)
        self.assertIn("needs a map", answer.stderr)

    def test_no_odometry(self):
        parameters = self.path("p.yaml")
        with open(parameters, "w") as file:
            file.write('odom_frame: ""\n')
        answer = self.run_tool("--bag", self.bag, "--mode", "map", "--params", parameters)
        self.assert_refused(answer, "needs odometry", "odom_frame")

    def test_a_bag_without_a_compass(self):
        bag = self.path("no_compass.bag")
        CorridorBag(bag, START, rounds=1, seed=1, compass=False)
        self.assert_refused(self.run_tool("--bag", bag, "--mode", "map"), "has no topic heading")
        self.drive_through(bag, "map", compass=False)


if __name__ == "__main__":
    unittest.main()
