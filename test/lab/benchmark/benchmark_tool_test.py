#!/usr/bin/env python3
"""place_memory_benchmark and the scripts that read what it writes, on memories of 21 places.

usage: benchmark_tool_test.py PLACE_MEMORY_BENCHMARK [UNITTEST OPTION]...
"""

import json
import os
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..")
sys.path.insert(0, os.path.join(ROOT, "scripts"))
import benchmark_results  # noqa: E402
TOOL = sys.argv.pop(1)


def run(*arguments):
    return subprocess.run(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          universal_newlines=True)


def script(name):
    return ["/usr/bin/python3", "-B", os.path.join(ROOT, "scripts", name)]


class Smoke(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.json = os.path.join(cls.folder.name, "benchmark.json")
        cls.answer = run(TOOL, "--max-places", "21", "--max-full", "21", "--queries", "3",
                         "--benchmark_min_time=0.001", "--benchmark_out=" + cls.json,
                         "--benchmark_out_format=json")
        with open(cls.json) as file:
            cls.rows = {row["run_name"].split("/iterations")[0]: row
                        for row in json.load(file)["benchmarks"]
                        if row.get("aggregate_name", "median") == "median"}

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_measures_every_part(self):
        self.assertEqual(self.answer.returncode, 0, self.answer.stderr)
        for name in ("evaluation/one", "evaluation/portable", "preparation/local",
                     "preparation/any", "grid", "yardstick/local/21", "yardstick/any/21",
                     "recognition/local/21", "recognition/any/21", "full_search/local/21",
                     "full_search/any/21", "fused_map/scratch/21", "fused_map/moved/21",
                     "fused_map/cells/21", "loop/500"):
            self.assertGreater(self.rows[name]["real_time"], 0.0, name)

    def test_reports_accuracy_beside_time(self):
        for name in ("recognition/local/21", "full_search/local/21", "yardstick/local/21"):
            self.assertEqual(self.rows[name]["queries"], 3)
            self.assertIn(round(3 * self.rows[name]["top1"], 6), (0, 1, 2, 3))
        self.assertGreaterEqual(self.rows["recognition/local/21"]["top1"], 0.5)
        self.assertEqual(self.rows["full_search/local/21"]["agree"], 1.0)

    def test_counts_evaluations(self):
        for name in ("recognition/local/21", "recognition/any/21", "yardstick/local/21"):
            self.assertGreater(self.rows[name]["evaluations_per_place"], 1.0, name)

    def test_makes_tables(self):
        answer = run(*script("benchmark_tables.py"), self.folder.name)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        with open(os.path.join(self.folder.name, "recognition.md")) as file:
            self.assertIn("| local   | 21 ", file.read())
        with open(os.path.join(self.folder.name, "targets.md")) as file:
            self.assertIn("same best place as full search, 21 places", file.read())
        with open(os.path.join(self.folder.name, "driving.md")) as file:
            self.assertIn("| a loop of 500 places |", file.read())

    def test_draws(self):
        image = os.path.join(self.folder.name, "growth.png")
        answer = run(*script("plot_benchmark.py"), self.json, image)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertGreater(os.path.getsize(image), 1000)

    def test_writes_a_store(self):
        store = os.path.join(self.folder.name, "places.db")
        answer = run(TOOL, "--max-places", "21", "--write-store", store)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        with open(store, "rb") as file:
            self.assertTrue(file.read(16).startswith(b"SQLite format 3"))


class Names(unittest.TestCase):
    def test_leave_out_how_a_benchmark_was_run(self):
        rows = [{"run_type": "iteration", "run_name": name, "real_time": 2.0, "cpu_time": 1.0,
                 "time_unit": "ms"}
                for name in ("belief/1000/real_time", "drive/compass/iterations:1/real_time",
                             "grid/repeats:9/process_time/real_time", "evaluation/one")]
        with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
            json.dump({"context": {}, "benchmarks": rows}, file)
            file.flush()
            results = benchmark_results.Results(file.name)
        self.assertEqual(results.names(""),
                         ["belief/1000", "drive/compass", "grid", "evaluation/one"])


class WrongArguments(unittest.TestCase):
    def refused(self, words, *arguments):
        answer = run(TOOL, *arguments)
        self.assertEqual(answer.returncode, 1)
        self.assertIn(words, answer.stderr)

    def test_too_few_places(self):
        self.refused("max-places", "--max-places", "20")

    def test_no_queries(self):
        self.refused("queries", "--queries", "0")

    def test_no_times(self):
        self.refused("times", "--times", "0")

    def test_no_number(self):
        self.refused("max-places", "--max-places", "many")

    def test_unknown_option(self):
        self.refused("--magic", "--magic")


if __name__ == "__main__":
    unittest.main()
