#!/usr/bin/env python3
"""Maps that go from one live node to another, and changes that are undone."""

import os
import subprocess

from place_memory import srv

import live_test
import sonar_room

SERVICES = {"save": srv.Save, "load": srv.Load, "merge": srv.Merge, "export": srv.Export,
            "undo": srv.Undo}


class LiveTravelTest(live_test.LiveTestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        live_test.SERVICES.update(SERVICES)

    def setUp(self):
        super().setUp()
        self.folder = os.path.realpath(self.folder)
        self.start_node(store_directory=self.folder)
        self.learn("hall", sonar_room.HALL)
        self.learn("study", sonar_room.STUDY)

    def path(self, name):
        return os.path.join(self.folder, name)

    def test_a_saved_map_is_loaded_and_merged(self):
        saved = self.node.call("save", path="copy.db")
        self.assert_answer(saved, saved.OK)
        self.assertEqual(saved.path, self.path("copy.db"))
        self.node.call("rename_place", label="hall", new_label="lobby")
        self.node.call("remove_place", label="study")

        merged = self.node.call("merge", path="copy.db")
        self.assert_answer(merged, merged.OK)
        self.assertEqual((merged.known, merged.added, merged.joined), (1, 1, 1))
        self.assertEqual(self.labels(), ["lobby", "study"])

        loaded = self.node.call("load", path="copy.db")
        self.assert_answer(loaded, loaded.OK)
        self.assertEqual(loaded.places, 2)
        self.assertEqual(self.labels(), ["hall", "study"])
        self.robot.enter(sonar_room.STUDY)
        self.scan_well()
        found = self.node.call("recognize_place").recognition
        self.assertEqual(found.matches[0].label, "study")

    def test_changes_are_undone(self):
        self.node.call("rename_place", label="hall", new_label="lobby")
        self.node.call("clear")
        looked = self.node.call("undo", count=2, look=True)
        self.assertEqual(looked.changes, ["removed all 2 places", 'renamed "hall" to "lobby"'])
        self.assertEqual(self.labels(), [])
        undone = self.node.call("undo")
        self.assert_answer(undone, undone.OK)
        self.assertEqual(undone.changes, looked.changes[:1])
        self.assertEqual(self.labels(), ["lobby", "study"])
        self.node.call("undo")
        self.assertEqual(self.labels(), ["hall", "study"])
        too_many = self.node.call("undo", count=100)
        self.assert_answer(too_many, too_many.NOTHING)

    def test_a_map_is_exported(self):
        exported = self.node.call("export", path="map")
        self.assert_answer(exported, exported.OK)
        for name in ("places.csv", "links.csv", "map.graphml", "building.pgm", "building.yaml", "places/1.pgm", "places/1.yaml"):
            self.assertIn(self.path("map/" + name), exported.files)
            self.assertTrue(os.path.exists(self.path("map/" + name)))

    def test_nothing_outside_of_the_folder_is_touched(self):
        os.symlink("/", self.path("root"))
        with open(self.path("diary.txt"), "w") as file:
            file.write("dear diary")
        for service in ("save", "load", "merge", "export"):
            for path in ("", "../a.db", "/etc/a.db", "root/etc/a.db"):
                response = self.node.call(service, path=path)
                self.assert_answer(response, response.INVALID_PATH)
        for service in ("load", "merge"):
            for path in ("none.db", "diary.txt"):
                response = self.node.call(service, path=path)
                self.assert_answer(response, response.UNREADABLE)
        refused = self.node.call("save", path="diary.txt")
        self.assert_answer(refused, refused.STORE_FAILED)
        refused = self.node.call("export", path="diary.txt")
        self.assert_answer(refused, refused.INVALID_PATH)
        with open(self.path("diary.txt")) as file:
            self.assertEqual(file.read(), "dear diary")
        self.assertEqual(self.labels(), ["hall", "study"])

    def test_the_command_line_speaks_with_the_node(self):
        tool = live_test.executable("place_memory")

        def run(*arguments):
            return subprocess.run((tool,) + arguments + ("--node", self.node.name),
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                  universal_newlines=True, timeout=60, check=False)

        listed = run("list")
        self.assertEqual(listed.returncode, 0, listed.stderr)
        self.assertIn("study", listed.stdout)
        self.assertIn("study", run("history").stdout)
        self.assertEqual(run("undo").returncode, 0)
        self.assertEqual(self.labels(), ["hall"])
        self.assertEqual(run("export", "map").returncode, 0)
        self.assertTrue(os.path.exists(self.path("map/places.csv")))
        found = run("recognize")
        self.assertIn(found.returncode, (0, 2), found.stderr)
        self.assertIn("hall", found.stdout)
        nobody = subprocess.run((tool, "list", "--node", "/nobody"), check=False, timeout=60,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual(nobody.returncode, 3)


if __name__ == "__main__":
    live_test.main("live_travel_test", LiveTravelTest)
