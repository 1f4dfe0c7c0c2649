#!/usr/bin/env python3
"""A live node that is to drive a robot which does not know where it is: the robot looks about."""

from place_memory.msg import GoToPlaceResult
from place_memory.srv import SuggestViewResponse

import live_test
import sonar_room
from driving_robot import SOUTH_EAST, GoTestCase

# Somewhere in the room, not at a place of the map's drive.
NORTH_EAST = (2.6, 1.5)


class LiveLostTest(GoTestCase):
    def looked_about(self, goal):
        return any("looks about" in feedback.message for feedback in goal.feedback)

    def test_a_robot_that_starts_lost_finds_itself_and_arrives(self):
        self.start(at=NORTH_EAST, mode="localize")
        self.assertEqual(self.node.call("suggest_view").status, SuggestViewResponse.NO_SCAN)
        place = self.place_near(SOUTH_EAST)
        goal = self.go(label=place.label)
        self.end(goal, GoToPlaceResult.REACHED)
        self.assert_at(place)
        self.assert_stands()
        self.assertTrue(self.looked_about(goal))
        self.assertEqual(self.node.call("suggest_view").status, SuggestViewResponse.NOT_NEEDED)

    def test_a_robot_that_is_carried_unnoticed_finds_that_out_and_itself(self):
        self.start_at(mode="localize")
        place = self.place_near(SOUTH_EAST)
        goal = self.go(label=place.label)
        self.go_on(0.5, goal)
        self.robot.in_room = (2.6, 1.75, 2.0)
        self.end(goal, GoToPlaceResult.REACHED)
        self.assert_at(place)
        self.assert_stands()

    def test_where_it_is_not_on_the_map_it_gives_up(self):
        self.start(mode="localize")
        self.robot.enter(sonar_room.Room(5.5, 5.0))
        goal = self.go(label=self.place_near(SOUTH_EAST).label)
        result = self.end(goal, GoToPlaceResult.LOST)
        self.assertIn("did not tell", result.message)
        self.assertTrue(self.looked_about(goal))
        self.assert_stands()

    def test_a_cancel_ends_the_search(self):
        self.start(at=NORTH_EAST, mode="localize")
        goal = self.go(label=self.place_near(SOUTH_EAST).label)
        self.go_on(0.3, goal)
        goal.cancel()
        self.end(goal, GoToPlaceResult.CANCELED)
        self.assert_stands()

    def test_one_that_can_get_nowhere_says_so(self):
        self.start(mode="localize")
        self.robot.enter(sonar_room.Room(1.0, 1.0))
        result = self.end(self.go(label=self.place_near(SOUTH_EAST).label), GoToPlaceResult.LOST)
        self.assertIn("no way on", result.message)


if __name__ == "__main__":
    live_test.main("live_lost_test", LiveLostTest)
