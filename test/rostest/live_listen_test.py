#!/usr/bin/env python3
"""The action ~scan of a live node while something else turns the robot, or nothing does."""

import math

from place_memory.msg import ScanPlaceGoal, ScanPlaceResult
from place_memory.srv import LearnPlaceResponse
import rospy

import live_test
from live_test import GoalStatus
import sonar_room


def rejected(message):
    return {count.reason: count.count for count in message.rejected}


class LiveListenTest(live_test.LiveTestCase):
    def assert_ended(self, scan, state, status, *words):
        """An action that ended has a status and a sentence that says `words`."""
        result = self.finish(scan)
        self.assertEqual(result.status, status, result.message)
        self.assertEqual(scan.state(), state)
        for word in words:
            self.assertIn(word, result.message)
        return result

    def test_a_robot_that_stands_is_scanned(self):
        self.start_node()
        result = self.scan_well(headings=1, turn=ScanPlaceGoal.TURN_LISTEN)
        self.assertEqual(result.headings, 1)
        self.assertGreaterEqual(result.readings, sonar_room.SENSORS)
        self.assertEqual(result.rejected, [])
        self.assertGreater(result.begin.to_sec(), 1000.0)
        self.assertGreater(result.end, result.begin)
        self.assertEqual(self.robot.commands, [])
        self.assertGreater(result.scan_id, 0)
        self.assertGreater(self.scan_well(headings=1).scan_id, result.scan_id)
        self.assertIn("scan %d: " % result.scan_id, self.node.output())

    def test_a_sweep_is_over_at_its_last_heading(self):
        self.start_node()
        self.robot.spin = 0.2
        scan = self.begin_scan(headings=11)
        result = self.assert_ended(scan, GoalStatus.SUCCEEDED, ScanPlaceResult.SUCCEEDED)
        self.assertGreaterEqual(result.headings, 11)
        self.assertTrue(scan.feedback)
        fractions = [feedback.fraction for feedback in scan.feedback]
        self.assertEqual(fractions, sorted(fractions))
        self.assertTrue(0.0 <= fractions[0] and fractions[-1] <= 1.0)
        self.assertGreater(scan.feedback[-1].readings, 0)

    def test_without_odometry_the_heading_alone_is_used(self):
        self.start_node(odom_frame="")
        self.robot.has_odometry = False
        self.robot.spin = 0.2
        self.assertGreaterEqual(self.scan_well(headings=11).headings, 11)

    def test_cancel(self):
        self.start_node()
        scan = self.begin_scan(headings=11)
        self.run_robot(lambda: scan.feedback, "a scan to begin")
        scan.cancel()
        self.assert_ended(scan, GoalStatus.PREEMPTED, ScanPlaceResult.CANCELED, "cancel")
        self.scan_well()

    def test_a_newer_goal_ends_the_one_that_runs(self):
        self.start_node()
        first = self.begin_scan(headings=11)
        self.run_robot(lambda: first.feedback, "a scan to begin")
        second = self.begin_scan(headings=1)
        self.assert_ended(first, GoalStatus.PREEMPTED, ScanPlaceResult.CANCELED, "newer goal")
        self.assert_ended(second, GoalStatus.SUCCEEDED, ScanPlaceResult.SUCCEEDED)

    def test_a_sweep_without_a_turn_times_out(self):
        self.start_node()
        scan = self.begin_scan(headings=11, timeout=rospy.Duration(2))
        result = self.assert_ended(scan, GoalStatus.ABORTED, ScanPlaceResult.TIMEOUT,
                                   "1 of 11 headings", "nothing turned the robot")
        self.assertGreaterEqual((result.end - result.begin).to_sec(), 2.0)

    def test_a_sweep_without_sonar_times_out(self):
        self.start_node()
        self.robot.edit_range = lambda sensor, message: None
        scan = self.begin_scan(timeout=rospy.Duration(2))
        self.assert_ended(scan, GoalStatus.ABORTED, ScanPlaceResult.TIMEOUT, "sonar?")

    def test_too_few_readings(self):
        self.start_node(scan__min_readings=1000)
        scan = self.begin_scan(headings=1, timeout=rospy.Duration(2))
        self.assert_ended(scan, GoalStatus.ABORTED, ScanPlaceResult.TOO_FEW_READINGS,
                          "1000 are needed")

    def test_few_sensors_are_heard_until_there_are_readings_enough(self):
        self.start_node(scan__min_readings=8)
        self.robot.edit_range = lambda sensor, message: message if sensor < 3 else None
        result = self.assert_ended(self.begin_scan(headings=1), GoalStatus.SUCCEEDED,
                                   ScanPlaceResult.SUCCEEDED)
        self.assertGreaterEqual(result.readings, 8)

    def test_a_sensor_whose_clock_is_behind_is_named(self):
        def behind(sensor, message):
            message.header.stamp -= rospy.Duration(500)
            return message
        self.start_node()
        self.robot.edit_range = behind
        scan = self.begin_scan(headings=1, timeout=rospy.Duration(2))
        self.assert_ended(scan, GoalStatus.ABORTED, ScanPlaceResult.TIMEOUT, "stamped", "clock")

    def test_no_heading(self):
        for odom_frame in ("odom", ""):
            with self.subTest(odom_frame=odom_frame):
                self.start_node(odom_frame=odom_frame, scan__tf_timeout=0.5)
                self.robot.edit_heading = lambda message: None
                scan = self.begin_scan(headings=1, timeout=rospy.Duration(2))
                self.assert_ended(scan, GoalStatus.ABORTED, ScanPlaceResult.NO_HEADING,
                                  "no heading", "on " + self.robot.heading.resolved_name)

    def test_where_nothing_is_heard_the_topic_is_named_as_it_is_remapped(self):
        self.start_node()
        self.robot.edit_range = lambda sensor, message: None
        scan = self.begin_scan(headings=1, timeout=rospy.Duration(2))
        self.assert_ended(scan, GoalStatus.ABORTED, ScanPlaceResult.TIMEOUT,
                          "is anything published on %s?" % self.robot.sonar.resolved_name)

    def test_headings_that_are_none(self):
        self.start_node()

        def zero(message):
            message.orientation.z = message.orientation.w = 0.0
            return message

        def nan(message):
            message.orientation.z = math.nan
            return message

        def none(message):
            message.orientation_covariance[0] = -1.0
            return message

        def unstamped(message):
            message.header.stamp = rospy.Time()
            return message

        for edit in (zero, nan, none, unstamped):
            self.robot.edit_heading = edit
            scan = self.begin_scan(headings=1)
            self.assert_ended(scan, GoalStatus.ABORTED, ScanPlaceResult.NO_HEADING, "no heading")

    def test_no_transform_of_a_sensor_names_both_frames(self):
        self.start_node(scan__tf_timeout=0.5)
        self.run_for(6.0)  # a warning comes only every five seconds, and one may have come already

        def edit(sensor, message):
            message.header.frame_id = "ghost"
            return message

        self.robot.edit_range = edit
        scan = self.begin_scan(headings=1, timeout=rospy.Duration(2))
        result = self.assert_ended(scan, GoalStatus.ABORTED, ScanPlaceResult.TIMEOUT,
                                   "no transform", "ghost", "base_link")
        self.assertGreaterEqual(rejected(result)["no transform"], sonar_room.SENSORS)
        self.assertIn("from ghost to base_link", self.node.output())

    def test_no_odometry_names_both_frames(self):
        self.start_node(scan__tf_timeout=0.5)
        self.robot.has_odometry = False
        scan = self.begin_scan(headings=1, timeout=rospy.Duration(2))
        self.assert_ended(scan, GoalStatus.ABORTED, ScanPlaceResult.NO_ODOMETRY, "odom",
                          "base_link")

    def test_readings_without_use_are_counted_by_reason(self):
        self.start_node()
        limits = sonar_room.MIN_RANGE, sonar_room.MAX_RANGE
        ranges = {0: math.nan, 1: -math.inf, 2: limits[0] / 2, 3: limits[1] + 1, 4: math.inf}

        def edit(sensor, message):
            message.range = ranges.get(sensor, message.range)
            if sensor == 5:
                message.field_of_view = -1.0
            if sensor == 6:
                message.min_range = message.max_range
            if sensor == 7:
                message.header.stamp = rospy.Time()
            return message

        self.robot.edit_range = edit
        self.robot.spin = 0.2
        scan = self.begin_scan(headings=5)
        result = self.assert_ended(scan, GoalStatus.SUCCEEDED, ScanPlaceResult.SUCCEEDED,
                                   "range is NaN")
        counts = rejected(result)
        self.assertEqual(set(counts), {"range is NaN", "too close", "below min_range",
                                       "above max_range", "bad sensor", "fixed distance",
                                       "no stamp"})
        self.assertGreaterEqual(min(counts.values()), 5)
        self.assertGreaterEqual(result.readings, 5 * (sonar_room.SENSORS - len(counts)))

    def test_a_range_beyond_the_limit_may_count_as_no_echo(self):
        self.start_node(scan__over_range_is_no_echo=True)

        def edit(sensor, message):
            message.range = sonar_room.MAX_RANGE + 1.0
            return message

        self.robot.edit_range = edit
        self.assertEqual(self.scan_well().rejected, [])

    def test_an_odometry_jump_ends_the_scan(self):
        self.start_node()
        scan = self.begin_scan(headings=11)
        self.run_robot(lambda: scan.feedback and scan.feedback[-1].readings, "readings")
        self.robot.odometry = (5.0, 0.0, 0.0)
        self.assert_ended(scan, GoalStatus.ABORTED, ScanPlaceResult.ODOMETRY_JUMP, "odom",
                          "jumped")
        self.scan_well()

    def test_time_that_runs_backwards_costs_the_scan_but_no_place(self):
        self.start_node()
        self.learn("hall", sonar_room.HALL)
        scan = self.begin_scan(headings=11)
        self.run_robot(lambda: scan.feedback and scan.feedback[-1].readings, "readings")
        self.world.set_time(self.world.now - 50.0)
        self.assert_ended(scan, GoalStatus.ABORTED, ScanPlaceResult.TIME_JUMP,
                          "backwards by", "/clock")
        self.assert_answer(self.node.call("learn_place", label="study"),
                           LearnPlaceResponse.NO_SCAN)
        self.assertEqual(self.labels(), ["hall"])
        self.run_for(0.5)
        self.scan_well()
        self.assertEqual(self.node.call("recognize_place").recognition.matches[0].label, "hall")

    def test_goals_out_of_range_are_refused(self):
        self.start_node()
        for field, value in (("headings", 3601), ("step", math.nan), ("step", -0.1),
                             ("step", 3.2), ("step", math.inf), ("turn", 3),
                             ("timeout", rospy.Duration(-1)), ("timeout", rospy.Duration(3601))):
            with self.subTest(field=field, value=value):
                scan = self.begin_scan(**{field: value})
                self.assert_ended(scan, GoalStatus.REJECTED, ScanPlaceResult.INVALID_GOAL, field)

    def test_a_goal_out_of_range_leaves_the_scan_that_runs(self):
        self.start_node()
        scan = self.begin_scan(headings=11)
        self.run_robot(lambda: scan.feedback, "a scan to begin")
        self.assert_ended(self.begin_scan(headings=3601), GoalStatus.REJECTED,
                          ScanPlaceResult.INVALID_GOAL, "headings")
        self.robot.spin = 0.2
        self.assert_ended(scan, GoalStatus.SUCCEEDED, ScanPlaceResult.SUCCEEDED)

    def test_time_that_stands_still_ends_the_scan(self):
        self.start_node()
        for stands_at in ("zero", "a time"):
            with self.subTest(stands_at=stands_at):
                scan = self.begin_scan(timeout=rospy.Duration(1))
                self.wait(scan.is_over, "a scan to end without time")
                self.assertEqual(scan.result().status, ScanPlaceResult.NO_TIME)
                self.assertIn("/clock", scan.result().message)
                self.run_for(0.2)


if __name__ == "__main__":
    live_test.main("live_listen_test", LiveListenTest)
