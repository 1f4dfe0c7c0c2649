#!/usr/bin/env python3
"""The command line tool has a live node drive its robot."""

import json
import signal
import subprocess

from place_memory.srv import SetLinkRequest

import live_test
from driving_robot import SOUTH_EAST, GoTestCase

DONE, FAILED, NO, NO_ANSWER = range(4)


class LiveCommandTest(GoTestCase):
    def begin(self, *arguments, node=None):
        process = subprocess.Popen(
            (live_test.executable("place_memory"), "go", *arguments, "--node",
             node or self.node.name),
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
        self.addCleanup(process.kill)
        return process

    def end(self, process, status):
        """What it said as its answer, and on the way."""
        self.run_robot(lambda: process.poll() is not None, "the command to end")
        said, notes = process.communicate()
        self.assertEqual(process.returncode, status, said + notes)
        return said, notes

    def test_the_robot_is_driven_to_a_place(self):
        self.start_at()
        place = self.place_near(SOUTH_EAST)
        said, notes = self.end(self.begin(place.label, "--json"), DONE)
        self.assertIn(place.label, json.loads(said)["message"])
        lines = notes.splitlines()
        self.assertIn(place.label, lines[-1])
        self.assertIn("goes", lines[-1])
        self.assertGreater(len(lines), 1)
        # Each is said once.
        self.assertTrue(all(one != other for one, other in zip(lines, lines[1:])), notes)
        self.assert_at(place)

    def test_where_no_way_leads_the_answer_is_no(self):
        self.start_at()
        _, notes = self.end(self.begin("nowhere"), NO)
        self.assertIn("no place", notes)
        place = self.place_near(SOUTH_EAST)
        for link in self.graph().links:
            if place.id in (link.first_id, link.second_id):
                self.node.call("set_link", from_id=link.first_id, to_id=link.second_id,
                               action=SetLinkRequest.FORBID)
        _, notes = self.end(self.begin(place.label), NO)
        self.assertIn("forbid", notes)

    def test_an_interrupt_stops_the_robot(self):
        self.start_at()
        here = self.robot.in_room
        process = self.begin(self.place_near(SOUTH_EAST).label)
        self.run_robot(lambda: self.distance(here) > 0.5, "the robot to drive")
        process.send_signal(signal.SIGINT)
        _, notes = self.end(process, FAILED)
        self.assertIn("canceled", notes)
        self.assert_stands()

    def test_one_that_does_not_know_where_it_is_says_what_to_do(self):
        self.start()
        _, notes = self.end(self.begin(self.place_near(SOUTH_EAST).label), FAILED)
        self.assertIn("recognize", notes)

    def test_without_a_node_there_is_no_answer(self):
        self.start()
        self.end(self.begin("a", node="/nobody"), NO_ANSWER)


if __name__ == "__main__":
    live_test.main("live_command_test", LiveCommandTest)
