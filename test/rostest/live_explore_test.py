#!/usr/bin/env python3
"""A live node that explores a small building of two rooms with an empty map, and how a goal of
~explore ends otherwise."""

from actionlib_msgs.msg import GoalStatus
from place_memory import msg
from place_memory.msg import ExploreResult, GoToPlaceResult, ScanPlaceGoal

import driving_robot
import live_test
from sonar_room import Room

# Two rooms, and a door of 1.6 m between them.
BUILDING = Room(8.0, 4.0, [(0.0, 1.4, 0.2, 1.2), (0.0, -1.4, 0.2, 1.2), (-3.4, 1.5, 0.8, 0.7),
                           (2.9, -1.4, 1.4, 0.8)])
START = (-2.4, -0.2, 0.0)


class Exploration(driving_robot.Goal):
    """A goal of ~explore on its way."""

    action, action_type, goal_type = "/explore", msg.ExploreAction, msg.ExploreGoal


class LiveExploreTest(driving_robot.DriveTestCase):
    def start(self, **parameters):
        given = {"mode": "map", "drive__speed": 1.0, "drive__turn_rate": 1.5,
                 "drive__patience": 1.0, "drive__radius": 0.25}
        given.update(parameters)
        self.start_node(**given)
        self.robot.room = BUILDING
        self.robot.in_room = START
        self.run_for(0.5)

    def explore(self, **goal):
        sent = Exploration(self.node, **goal)
        self.addCleanup(sent.leave)
        return sent

    def assert_rejected(self, goal, status, word):
        self.assertIn(word, self.end(goal, status).message)
        self.assertEqual(goal.state(), GoalStatus.REJECTED)

    # --- what it is for ---

    def test_it_explores_all_that_it_reaches_and_comes_home(self):
        self.start()
        goal = self.explore()
        furthest = [0.0]

        def is_over():
            furthest[0] = max(furthest[0], self.robot.in_room[0])
            return goal.is_over()
        self.run_robot(is_over, "the exploration to end")
        result = goal.result()
        self.assertEqual(result.status, ExploreResult.DONE, result)
        self.assertEqual(goal.state(), GoalStatus.SUCCEEDED)
        self.assertTrue(result.home, result)
        self.assertLess(self.distance(START[:2]), 1.0)
        self.assertGreater(furthest[0], 0.5)  # it was in the other room
        self.assertGreater(result.places, 0)
        self.assertEqual(len(self.node.call("list_places").places), result.places)
        self.assertGreater(result.distance, 4.0)
        self.assertEqual(len(result.left), len(result.why))
        self.assert_stands()
        said = " ".join(feedback.message for feedback in goal.feedback)
        self.assertIn("free space opens", said)
        self.assertIn("home", said)
        self.assertGreater(max(feedback.frontiers for feedback in goal.feedback), 0)

    def test_no_further_than_it_may_and_home(self):
        self.start()
        result = self.end(self.explore(most_distance=1.5), ExploreResult.BOUND_REACHED)
        self.assertLess(self.distance(START[:2]), 1.0)
        self.assertTrue(result.home)
        self.assertIn("again", result.message)
        self.assert_stands()

    # --- ends under way ---

    def under_way(self, **goal):
        sent = self.explore(**goal)
        self.go_on(0.4, sent)
        return sent

    def test_a_cancel_stops_the_robot(self):
        self.start()
        goal = self.under_way()
        goal.cancel()
        result = self.end(goal, ExploreResult.CANCELED)
        self.assertEqual(goal.state(), GoalStatus.PREEMPTED)
        self.assertGreater(result.distance, 0.3)
        self.assert_stands()

    def test_a_newer_goal_takes_the_place_of_the_one_that_runs(self):
        self.start()
        first = self.under_way()
        second = self.explore()
        self.end(first, ExploreResult.PREEMPTED)
        self.go_on(0.3, second)

    def test_a_mode_that_is_set_on_the_way_ends_the_goal(self):
        self.start()
        goal = self.under_way()
        self.assertEqual(self.node.call("set_mode", mode="off").status, 0)
        self.assertIn("mode", self.end(goal, ExploreResult.WRONG_MODE).message)
        self.assert_stands()

    def test_odometry_that_jumps_stops_the_robot(self):
        self.start()
        goal = self.under_way()
        self.robot.odometry = (40.0, 0.0, 0.0)
        self.assertIn("odometry", self.end(goal, ExploreResult.LOST).message)
        self.assert_stands()

    def test_without_a_sonar_that_looks_ahead_it_does_not_drive(self):
        self.start()
        goal = self.under_way()
        self.robot.edit_range = lambda sensor, message: message if 5 <= sensor <= 11 else None
        self.assertIn("sonar", self.end(goal, ExploreResult.SILENT).message)
        self.assert_stands()

    def test_a_robot_that_is_walled_in_says_that_it_is_done_there(self):
        self.start()
        self.robot.room = Room(1.2, 1.2)
        self.robot.in_room = (0.0, 0.0, 0.0)
        goal = self.explore()
        self.run_robot(goal.is_over, "the goal to end")
        self.assertIn(goal.result().status, (ExploreResult.DONE, ExploreResult.BLOCKED))
        self.assertLess(self.distance((0.0, 0.0)), 0.3)

    def test_a_node_that_is_stopped_stops_the_robot(self):
        self.start()
        goal = self.under_way()
        self.assertEqual(self.node.stop(), 0)
        self.end(goal, ExploreResult.SHUTDOWN)
        self.assertEqual(self.robot.velocities[-1], (0.0, 0.0))

    # --- what is not taken ---

    def test_a_goal_out_of_range_is_rejected_and_leaves_the_one_that_runs(self):
        self.start()
        running = self.under_way()
        for wrong in (float("nan"), float("inf"), -1.0):
            self.assert_rejected(self.explore(most_distance=wrong), ExploreResult.INVALID_GOAL,
                                 "most_distance")
            self.assertFalse(running.is_over())
        running.cancel()
        self.end(running, ExploreResult.CANCELED)

    def test_it_explores_in_mode_map_alone(self):
        self.start(mode="off")
        self.assert_rejected(self.explore(), ExploreResult.WRONG_MODE, "set_mode")
        self.assertEqual(self.robot.velocities.count((0.0, 0.0)), len(self.robot.velocities))

    def test_one_at_a_time_moves_the_robot(self):
        self.start()
        goal = self.under_way()
        going = driving_robot.Goal(self.node, pose=driving_robot.pose_at(0.5, 0.0))
        self.addCleanup(going.leave)
        self.assert_rejected(going, GoToPlaceResult.BUSY, "explore")
        self.assertFalse(goal.is_over())
        goal.cancel()
        self.end(goal, ExploreResult.CANCELED)
        self.begin_scan(turn=ScanPlaceGoal.TURN_CMD_VEL, headings=11, step=0.1)
        self.run_robot(lambda: self.robot.commands[-1] != 0.0, "the robot to turn")
        self.assert_rejected(self.explore(), ExploreResult.BUSY, "scan")

    def test_while_the_robot_goes_to_a_place_it_does_not_explore(self):
        self.start()
        goal = self.explore()
        self.go_on(2.0, goal)
        goal.cancel()
        self.end(goal, ExploreResult.CANCELED)
        first = min(place.id for place in self.node.call("list_places").places)
        going = driving_robot.Goal(self.node, id=first)
        self.addCleanup(going.leave)
        self.go_on(0.3, going)
        self.assert_rejected(self.explore(), ExploreResult.BUSY, "go_to_place")
        self.assertFalse(going.is_over())
        self.end(going, GoToPlaceResult.REACHED)


if __name__ == "__main__":
    live_test.main("live_explore_test", LiveExploreTest)
