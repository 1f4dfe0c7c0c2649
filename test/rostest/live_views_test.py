#!/usr/bin/env python3
"""What a live node suggests to look at while it is not sure where the robot is."""

import math

from place_memory.msg import Recognition
from place_memory.srv import SuggestViewResponse

import live_test
import sonar_room
from sonar_room import HALL, STUDY

GALLERY = sonar_room.Room(11.0, 2.0)
APART = 8.0  # from one place to the next [m]


class LiveViewsTest(live_test.LiveTestCase):
    def learn_row(self, *rooms):
        """Places in a row, APART each; the labels are their numbers, from 1 on."""
        self.start_node()
        for i, room in enumerate(rooms):
            self.robot.odometry = (APART * i, 0.0, 0.0)
            self.learn(str(i + 1), room)

    def recognize_in(self, room, verdict):
        """Somebody has carried the robot there."""
        self.robot.odometry = (50.0, 20.0, 0.0)
        self.robot.enter(room)
        self.scan_well()
        response = self.node.call("recognize_place")
        self.assertEqual(response.recognition.verdict, verdict, response.message)

    def be_unsure_in(self, room):
        """Likewise, but beside where the places were learned, so that none fits better than the one
        that looks alike."""
        self.robot.odometry = (50.0, 20.0, 0.0)
        self.robot.enter(room, x=0.2, y=0.1)
        self.scan_well()
        recognition = self.node.call("recognize_place").recognition
        self.assertNotEqual(recognition.verdict, Recognition.RECOGNIZED)
        self.assertLess(recognition.matches[0].probability, 0.8)

    def suggest(self, status):
        response = self.node.call("suggest_view")
        self.assert_answer(response, status)
        return response

    def test_the_link_that_parts_two_places_that_look_alike_is_named(self):
        # Halls, and to the east of each something else.
        self.learn_row(HALL, STUDY, HALL, GALLERY)
        self.be_unsure_in(HALL)
        response = self.suggest(SuggestViewResponse.OK)
        self.assertEqual(response.view, SuggestViewResponse.DRIVE)
        self.assertIn(tuple(response.labels), (("1", "2"), ("3", "4")))
        self.assertEqual([str(id) for id in response.ids], response.labels)
        self.assertAlmostEqual(response.turn, 0.0, delta=0.2)
        self.assertAlmostEqual(response.heading_in_odom, 0.0, delta=0.2)
        self.assertAlmostEqual(response.heading_in_map, 0.0, delta=0.2)
        self.assertAlmostEqual(response.distance, APART, delta=0.5)
        self.assertAlmostEqual(response.way[-1].x, 50.0 + APART, delta=0.5)
        self.assertAlmostEqual(response.way[-1].y, 20.0, delta=0.5)
        self.assertEqual(response.candidates, 2)
        self.assertLess(response.probability, 0.9)
        self.assertGreater(response.expected_probability, response.probability + 0.1)
        self.assertGreater(response.information, 0.1)
        self.assertGreater(response.time, 0.0)
        self.assertIn('"%s"' % response.labels[-1], response.message)

        # Spots go by where odometry has the robot now, bearings by how it looks.
        self.robot.odometry = (50.0, 20.0, 0.5 * math.pi)
        self.run_for(0.5)
        turned = self.suggest(SuggestViewResponse.OK)
        self.assertAlmostEqual(turned.turn, -0.5 * math.pi, delta=0.2)
        self.assertAlmostEqual(turned.way[-1].x, 50.0 + APART, delta=0.5)

        # It goes there, and it is clear.
        self.recognize_in(GALLERY, Recognition.RECOGNIZED)
        self.suggest(SuggestViewResponse.NOT_NEEDED)

    def test_where_no_view_parts_them_it_says_so(self):
        self.learn_row(HALL, HALL)
        self.be_unsure_in(HALL)
        response = self.suggest(SuggestViewResponse.NO_VIEW)
        self.assertEqual(response.candidates, 2)
        self.assertEqual(response.expected_probability, response.probability)
        self.assertEqual(list(response.way), [])

    def test_an_empty_map_and_a_robot_that_has_heard_nothing(self):
        self.start_node()
        self.suggest(SuggestViewResponse.EMPTY_MAP)
        self.learn("a", STUDY)
        # What is learned is where the robot is; no scan was matched.
        self.assertIn("scan", self.suggest(SuggestViewResponse.NO_SCAN).message)
        self.recognize_in(STUDY, Recognition.RECOGNIZED)
        self.suggest(SuggestViewResponse.NOT_NEEDED)
        self.node.call("clear")
        self.suggest(SuggestViewResponse.EMPTY_MAP)

    def test_a_place_that_goes_is_no_candidate_any_more(self):
        self.learn_row(HALL, STUDY, HALL, GALLERY)
        self.be_unsure_in(HALL)
        self.assertEqual(self.node.call("remove_place", label="3").status, 0)
        self.assertEqual(self.suggest(SuggestViewResponse.NO_VIEW).candidates, 1)


if __name__ == "__main__":
    live_test.main("live_views_test", LiveViewsTest)
