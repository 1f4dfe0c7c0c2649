#!/usr/bin/env python3
"""place_memory_experiments and the scripts that draw what it writes, end to end, on one tiny run.

usage: experiments_tool_test.py PLACE_MEMORY_EXPERIMENTS [UNITTEST OPTION]...
"""

import csv
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..")
WORLDS = os.path.join(ROOT, "config", "worlds")
TOOL = sys.argv.pop(1)
TINY = ["--experiments", "1,4", "--seeds", "1", "--methods",
        "nearest_neighbour,hill_climbing,default"]


def run(*arguments):
    return subprocess.run(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          universal_newlines=True)


def script(name):
    return ["/usr/bin/python3", "-B", os.path.join(ROOT, "scripts", name)]


class TinyRun(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = os.path.join(cls.folder.name, "out")
        cls.answer = run(TOOL, "--out", cls.out, "--sweeps", "chairs", "--figures",
                         "--rearrangements", "2", "--sparse",
                         "--worlds", WORLDS, *TINY)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def rows(self, name):
        with open(os.path.join(self.out, name), newline="") as file:
            return list(csv.DictReader(file))

    def test_shows_the_tables_and_into_a_pipe_no_bar(self):
        self.assertEqual(self.answer.returncode, 0, self.answer.stderr)
        self.assertIn("| hallway ", self.answer.stdout)
        self.assertIn("experiments: ", self.answer.stderr)
        self.assertNotIn("\r", self.answer.stderr)

    def test_has_a_row_for_each_case_and_method(self):
        rows = self.rows("summary.csv")
        self.assertEqual(len(rows), 5 * 3)
        hallway = {row["method"]: row for row in rows if row["case"] == "hallway"}
        self.assertEqual(hallway["hill_climbing"]["paper"], "1.0000")
        self.assertEqual(hallway["default"]["paper"], "")
        self.assertEqual(hallway["default"]["trials"], "21")

    def test_keeps_every_answer(self):
        answers = self.rows("answers.csv")
        right = [a for a in answers if a["case"] == "hallway" and a["method"] == "default"
                 and a["right"] == "1"]
        summary = [row for row in self.rows("summary.csv")
                   if row["case"] == "hallway" and row["method"] == "default"]
        self.assertEqual(len(right), int(summary[0]["right"]))
        self.assertGreater(len(right), 10)

    def test_counts_what_adapting_places_took_in(self):
        rows = {(row["method"], row["round"]): row for row in self.rows("rearrangements.csv")}
        self.assertEqual(len(rows), 3 * 3)
        frozen, adapting = rows["default", "all"], rows["default_adapting", "all"]
        self.assertEqual(frozen["folded"], "0")
        self.assertEqual(int(adapting["folded"]),
                         sum(int(adapting[count]) for count in
                             ("recognized", "wrong", "unlearned_accepted")))
        self.assertEqual(rows["default", "1"]["trials"], rows["default_adapting", "1"]["trials"])
        self.assertIn("more than 1 ft astray", self.answer.stdout)

    def test_strangers_are_not_taken_for_places_where_there_is_little_to_go_by(self):
        rows = self.rows("sparse.csv")
        self.assertEqual([row["case"] for row in rows],
                         ["open space", "hall", "dead ring", "wrong units", "few sensors"])
        for row in rows:
            self.assertGreater(int(row["strangers"]), 0)
            self.assertLessEqual(int(row["accepted"]), 1, row["case"])

    def test_draws(self):
        plots = os.path.join(self.folder.name, "plots")
        answer = run(*script("plot_experiments.py"), self.out, plots)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        drawn = set(os.listdir(plots))
        self.assertLessEqual({"experiments.png", "reliability.png", "figure_1.png", "figure_2.png",
                              "figure_3.png", "figure_4.png", "figure_5.png", "figure_6.png",
                              "figure_7.png", "rearrangements.png"}, drawn)

    def test_tables_go_between_the_marks_of_a_document(self):
        document = os.path.join(self.folder.name, "document.md")
        with open(document, "w") as file:
            file.write("before\n<!-- begin accuracy.md -->\nold\n<!-- end accuracy.md -->\nafter\n")
        answer = run(*script("insert_tables.py"), document, self.out)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        with open(document) as file:
            text = file.read()
        self.assertTrue(text.startswith("before\n") and text.endswith("\nafter\n"))
        self.assertNotIn("old", text)
        self.assertIn("| hallway ", text)

    def test_a_document_whose_mark_has_no_end_is_left_alone(self):
        document = os.path.join(self.folder.name, "broken.md")
        with open(document, "w") as file:
            file.write("<!-- begin accuracy.md -->\nold\n")
        self.assertNotEqual(run(*script("insert_tables.py"), document, self.out).returncode, 0)
        with open(document) as file:
            self.assertEqual(file.read(), "<!-- begin accuracy.md -->\nold\n")


class Recorded(unittest.TestCase):
    """Round rooms, each of another radius, five metres apart."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def recording(self, name, radii, cell=0.14288):
        def scan(role, i, radius):
            readings = [[0, 2 * math.pi * k / 24, 0.0, radius] for k in range(24)]
            return {"role": role, "place": f"P{i}", "accept": [f"P{i}"], "pose": [5.0 * i, 0.0, 0.0],
                    "compass": 0.0, "any_heading": False, "ring_radius": 0.1, "fov": 0.4,
                    "r_min": 0.1, "r_max": 4.5, "cell": cell, "readings": readings}
        path = os.path.join(self.folder, name)
        with open(path, "w") as file:
            for role in ("learn", "recognize"):
                for i, radius in enumerate(radii):
                    file.write(json.dumps(scan(role, i, radius)) + "\n")
        return ["--recorded", path]

    def summary(self, *recordings):
        out = os.path.join(self.folder, "out")
        answer = run(TOOL, "--out", out, "--worlds", WORLDS, "--experiments", "none", "--methods",
                     "default", *[word for recording in recordings for word in recording])
        self.assertEqual(answer.returncode, 0, answer.stderr)
        with open(os.path.join(out, "summary.csv"), newline="") as file:
            return {row["case"]: row for row in csv.DictReader(file)}

    def test_places_are_recognized_and_put_to_the_memory_as_if_never_learned(self):
        row = self.summary(self.recording("a", [1.0, 2.0, 3.0]))["a"]
        self.assertEqual((row["trials"], row["right"]), ("3", "3"))
        self.assertEqual((row["unlearned"], row["strangers"]), ("3", "0"))

    def test_the_places_of_one_are_strangers_to_the_one_before(self):
        rows = self.summary(self.recording("a", [1.0, 2.0, 3.0]), self.recording("b", [1.5, 2.5]))
        self.assertEqual((rows["a"]["strangers"], rows["b"]["strangers"]), ("2", "3"))

    def test_recordings_of_other_cells_are_no_strangers(self):
        rows = self.summary(self.recording("a", [1.0, 2.0]), self.recording("b", [1.5], cell=0.06))
        self.assertEqual((rows["a"]["strangers"], rows["b"]["strangers"]), ("0", "0"))


class WrongArguments(unittest.TestCase):
    def refused(self, words, *arguments, worlds=WORLDS):
        with tempfile.TemporaryDirectory() as folder:
            answer = run(TOOL, "--out", folder, "--worlds", worlds, *arguments)
        self.assertEqual(answer.returncode, 1)
        self.assertIn(words, answer.stderr)

    def test_unknown_experiment(self):
        self.refused("'6'", "--experiments", "6")

    def test_unknown_sweep(self):
        self.refused("'weather'", "--sweeps", "weather")

    def test_unknown_method(self):
        self.refused("'magic'", "--methods", "magic")

    def test_no_seeds(self):
        self.refused("seeds", "--seeds", "0")

    def test_negative_seeds(self):
        self.refused("seeds", "--seeds", "-1")

    def test_too_many_threads(self):
        self.refused("threads", "--threads", "100000")

    def test_too_many_rearrangements(self):
        self.refused("rearrangements", "--rearrangements", "-1")

    def test_no_such_worlds(self):
        self.refused("nowhere", "--experiments", "none", worlds="/nowhere")

    def test_no_such_recording(self):
        self.refused("/nowhere.gz", "--experiments", "none", "--recorded", "/nowhere.gz")

    def test_wrong_parameters(self):
        self.refused("match/preset", "--preset", "/nowhere.yaml")

    def test_nowhere_to_write(self):
        answer = run(TOOL, "--out", "/proc/nowhere", "--worlds", WORLDS, *TINY)
        self.assertEqual(answer.returncode, 1)
        self.assertIn("/proc/nowhere", answer.stderr)


if __name__ == "__main__":
    unittest.main()
