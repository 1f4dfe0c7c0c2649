#!/usr/bin/env python3
"""A live node that drives the robot to places by cmd_vel: reached, other ways round, and how a goal
ends that cannot be reached."""

from actionlib_msgs.msg import GoalStatus
from place_memory.msg import GoToPlaceResult, ScanPlaceGoal, ScanPlaceResult
from place_memory.srv import SetLinkRequest

import live_test
from driving_robot import (NORTH, SOUTH, SOUTH_EAST, SOUTH_WEST, GoTestCase, pose_at, room_with)


class LiveGoTest(GoTestCase):
    # --- reached ---

    def test_a_place_is_reached_by_its_label(self):
        self.start_at()
        goal_place = self.place_near(SOUTH_EAST)
        before = self.travels()
        goal = self.go(label=goal_place.label)
        result = self.end(goal, GoToPlaceResult.REACHED)
        self.assertEqual(goal.state(), GoalStatus.SUCCEEDED)
        self.assertIn(goal_place.label, result.message)
        self.assertEqual((result.failed_leg, result.tried), ("", []))
        self.assert_at(goal_place)
        self.assert_stands()
        self.assertGreater(result.legs, 1)
        # Each way counts once: the first leg may lead to the place where the route begins.
        self.assertIn(self.travels() - before, (result.legs - 1, result.legs))
        first, last = goal.feedback[0], goal.feedback[-1]
        self.assertGreater(first.legs_left, last.legs_left)
        self.assertEqual(last.next_id, goal_place.id)
        self.assertEqual(last.next_label, goal_place.label)
        self.assertGreater(first.time_left, last.time_left)
        self.assertIn(goal_place.label, last.leg)
        self.assertEqual(last.message, "goes")

    def test_a_place_is_reached_by_its_id_and_back_to_a_pose(self):
        self.start_at()
        place = self.place_near((0.0, -1.75))
        self.end(self.go(id=place.id), GoToPlaceResult.REACHED)
        self.assert_at(place)
        x, y, _ = self.on_map(SOUTH_WEST + (0.0,))
        self.end(self.go(pose=pose_at(x, y)), GoToPlaceResult.REACHED)
        self.assertLess(self.distance(SOUTH_WEST), 0.6)

    def test_while_it_drives_along_the_drive_alone_teaches_links(self):
        self.start_at(mode="localize")
        place = self.place_near(SOUTH_EAST)
        before = self.travels()
        result = self.end(self.go(label=place.label), GoToPlaceResult.REACHED)
        self.assert_at(place)
        self.assertEqual(self.node.call("set_mode", mode="off").status, 0)
        self.assertLessEqual(self.travels() - before, result.legs)

    def travels(self, outcome="succeeded"):
        return sum(getattr(direction, outcome) for link in self.graph().links
                   for direction in (link.forward, link.backward))

    # --- doors ---

    def check_that_a_way_that_is_closed_is_gone_round(self, mode):
        self.start_at(mode=mode)
        place = self.place_near(SOUTH_EAST)
        failed = self.travels("failed")
        goal = self.go(label=place.label)
        self.go_on(0.5, goal)
        self.robot.room = room_with(SOUTH)
        result = self.end(goal, GoToPlaceResult.REACHED)
        self.assert_at(place)
        self.assertTrue(result.tried)
        self.assertEqual(result.failed_leg, result.tried[-1])
        self.assertIn("stands in the way", result.failed_leg)
        self.assertEqual(self.travels("failed") - failed, len(result.tried))
        said = {feedback.message for feedback in goal.feedback}
        self.assertIn("waits for what stands in the way to go", said)
        self.node.stop()

    def test_a_way_that_is_closed_is_gone_round_in_mode_off(self):
        self.check_that_a_way_that_is_closed_is_gone_round("off")

    def test_a_way_that_is_closed_is_gone_round_in_mode_localize(self):
        self.check_that_a_way_that_is_closed_is_gone_round("localize")

    def test_where_no_way_is_left_it_says_so(self):
        self.start_at()
        place = self.place_near(SOUTH_EAST)
        goal = self.go(label=place.label)
        self.go_on(0.5, goal)
        self.robot.room = room_with(SOUTH, NORTH)
        result = self.end(goal, GoToPlaceResult.NO_ROUTE)
        self.assertEqual(goal.state(), GoalStatus.ABORTED)
        self.assertGreater(len(result.tried), 1)
        self.assert_stands()

    def test_a_way_that_a_person_forbids_is_not_gone(self):
        self.start_at()
        place = self.place_near(SOUTH_EAST)
        for link in self.graph().links:
            if place.id in (link.first_id, link.second_id):
                self.assertEqual(self.node.call("set_link", from_id=link.first_id,
                                                to_id=link.second_id,
                                                action=SetLinkRequest.FORBID).status, 0)
        self.assertIn("forbid", self.end(self.go(id=place.id), GoToPlaceResult.NO_ROUTE).message)

    # --- ends under way ---

    def test_a_cancel_stops_the_robot(self):
        self.start_at()
        goal = self.go(label=self.place_near(SOUTH_EAST).label)
        self.go_on(0.5, goal)
        goal.cancel()
        self.end(goal, GoToPlaceResult.CANCELED)
        self.assertEqual(goal.state(), GoalStatus.PREEMPTED)
        self.assert_stands()

    def test_a_newer_goal_takes_the_place_of_the_one_that_runs(self):
        self.start_at()
        first = self.go(label=self.place_near(SOUTH_EAST).label)
        self.go_on(1.0, first)
        place = self.place_near(SOUTH_WEST)
        second = self.go(id=place.id)
        self.end(first, GoToPlaceResult.PREEMPTED)
        self.end(second, GoToPlaceResult.REACHED)
        self.assert_at(place)

    def test_a_goal_that_cannot_be_taken_leaves_the_one_that_runs(self):
        self.start_at()
        place = self.place_near(SOUTH_EAST)
        running = self.go(id=place.id)
        self.go_on(0.3, running)
        for wrong, status in ((dict(label="nowhere"), GoToPlaceResult.UNKNOWN_GOAL),
                              (dict(id=4711), GoToPlaceResult.UNKNOWN_GOAL),
                              (dict(pose=pose_at(0, 0, "moon")), GoToPlaceResult.INVALID_GOAL),
                              (dict(pose=pose_at(float("nan"), 0)), GoToPlaceResult.INVALID_GOAL)):
            refused = self.go(**wrong)
            self.end(refused, status)
            self.assertEqual(refused.state(), GoalStatus.REJECTED)
            self.assertFalse(running.is_over())
        self.end(running, GoToPlaceResult.REACHED)
        self.assert_at(place)

    def test_one_at_a_time_moves_the_robot(self):
        self.start_at()
        goal = self.go(label=self.place_near(SOUTH_EAST).label)
        self.go_on(0.3, goal)
        scan = self.begin_scan(turn=ScanPlaceGoal.TURN_CMD_VEL)
        result = self.finish(scan)
        self.assertEqual(scan.state(), GoalStatus.REJECTED)
        self.assertEqual(result.status, ScanPlaceResult.BUSY)
        self.assertIn("go_to_place", result.message)
        self.assertFalse(goal.is_over())
        goal.cancel()
        self.end(goal, GoToPlaceResult.CANCELED)

        scan = self.begin_scan(turn=ScanPlaceGoal.TURN_CMD_VEL, headings=11, step=0.1)
        self.run_robot(lambda: self.robot.commands[-1] != 0.0, "the robot to turn")
        refused = self.go(label=self.place_near(SOUTH_EAST).label)
        self.assertIn("scan", self.end(refused, GoToPlaceResult.BUSY).message)
        self.assertEqual(refused.state(), GoalStatus.REJECTED)
        self.assertEqual(self.finish(scan).status, ScanPlaceResult.SUCCEEDED)
        # And then it may.
        self.end(self.go(label=self.place_near(SOUTH_WEST).label), GoToPlaceResult.REACHED)

    def test_a_place_that_goes_or_is_renamed_on_the_way(self):
        self.start_at()
        place = self.place_near(SOUTH_EAST)
        goal = self.go(label=place.label)
        self.go_on(0.5, goal)
        self.node.call("rename_place", label=place.label, new_label="desk")
        self.run_robot(lambda: goal.feedback[-1].next_label == "desk" or goal.is_over(),
                       "the new name")
        self.assertFalse(goal.is_over())
        self.node.call("remove_place", label="desk")
        self.assertIn("removed", self.end(goal, GoToPlaceResult.UNKNOWN_GOAL).message)
        self.assert_stands()

    # --- where the robot is, is not known ---

    def test_a_robot_that_does_not_know_where_it_is_stays(self):
        self.start()
        result = self.end(self.go(label=self.place_near(SOUTH_EAST).label), GoToPlaceResult.LOST)
        self.assertIn("recognize", result.message)
        self.assertEqual(self.robot.velocities.count((0.0, 0.0)), len(self.robot.velocities))

    def check_that_a_robot_that_is_carried_stops(self, mode):
        self.start_at(mode=mode)
        goal = self.go(label=self.place_near(SOUTH_EAST).label)
        self.go_on(0.5, goal)
        self.robot.odometry = (40.0, 0.0, 0.0)
        self.end(goal, GoToPlaceResult.LOST)
        self.assert_stands()
        self.node.stop()

    def test_a_robot_that_is_carried_stops_in_mode_off(self):
        self.check_that_a_robot_that_is_carried_stops("off")

    def test_a_robot_that_is_carried_stops_in_mode_localize(self):
        self.check_that_a_robot_that_is_carried_stops("localize")

    def test_a_mode_that_is_set_on_the_way_ends_the_goal(self):
        self.start_at(mode="localize")
        goal = self.go(label=self.place_near(SOUTH_EAST).label)
        self.go_on(0.5, goal)
        self.assertEqual(self.node.call("set_mode", mode="off").status, 0)
        self.assertIn("mode", self.end(goal, GoToPlaceResult.LOST).message)
        self.assert_stands()

    # --- what drives fails ---

    def test_without_a_sonar_that_looks_ahead_it_does_not_drive(self):
        self.start_at()
        goal = self.go(label=self.place_near(SOUTH_EAST).label)
        self.go_on(0.5, goal)
        self.robot.edit_range = lambda sensor, message: message if 5 <= sensor <= 11 else None
        self.assertIn("sonar", self.end(goal, GoToPlaceResult.SILENT).message)
        self.assert_stands()

    def test_odometry_that_falls_silent_stops_the_robot(self):
        self.start_at()
        goal = self.go(label=self.place_near(SOUTH_EAST).label)
        self.go_on(0.5, goal)
        self.robot.has_odometry = False
        self.assertIn("transform", self.end(goal, GoToPlaceResult.LOST).message)

    def test_a_node_that_is_stopped_stops_the_robot(self):
        self.start_at()
        goal = self.go(label=self.place_near(SOUTH_EAST).label)
        self.go_on(0.5, goal)
        self.assertEqual(self.node.stop(), 0)
        self.end(goal, GoToPlaceResult.SHUTDOWN)
        self.assertEqual(self.robot.velocities[-1], (0.0, 0.0))


if __name__ == "__main__":
    live_test.main("live_go_test", LiveGoTest)
