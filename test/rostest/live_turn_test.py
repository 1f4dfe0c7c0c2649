#!/usr/bin/env python3
"""The action ~scan of a live node while the node turns the robot through cmd_vel."""

import math
import os

from place_memory.msg import ScanPlaceGoal, ScanPlaceResult
from place_memory.srv import LearnPlaceResponse, RecognizePlaceResponse
import rosnode
import rospy

import fake_robot
import live_test
from live_test import GoalStatus
import sonar_room

DEGREE = math.pi / 180.0


class LiveTurnTest(live_test.LiveTestCase):
    def turned(self):
        """From where the robot began [rad]."""
        return abs(self.robot.in_room[2])

    def begin_turn(self, **goal):
        return self.begin_scan(turn=ScanPlaceGoal.TURN_CMD_VEL, **goal)

    def begin_turn_under_way(self, **goal):
        scan = self.begin_turn(**goal)
        self.run_robot(lambda: self.turned() > 2 * DEGREE, "the robot to turn")
        return scan

    def assert_stopped(self, scan, state, status, *words):
        """The scan ended so, and the robot was told to stand, once and for all."""
        result = self.finish(scan)
        self.assertEqual(result.status, status, result.message)
        self.assertEqual(scan.state(), state)
        for word in words:
            self.assertIn(word, result.message)
        self.run_robot(lambda: self.robot.commands[-1:] == [0.0], "a velocity of zero")
        said = len(self.robot.commands)
        self.run_for(1.0)
        self.assertEqual(self.robot.commands[said:], [])
        return result

    def test_a_sweep_ends_where_it_began(self):
        for odom_frame in ("odom", ""):
            with self.subTest(odom_frame=odom_frame):
                self.start_node(odom_frame=odom_frame, scan__turn_rate=0.5)
                self.robot.has_odometry = bool(odom_frame)
                swept = []
                scan = self.begin_turn(headings=11)

                def is_over():
                    swept.append(self.robot.in_room[2])
                    return scan.is_over()

                self.run_robot(is_over, "a sweep")
                result = self.assert_stopped(scan, GoalStatus.SUCCEEDED,
                                             ScanPlaceResult.SUCCEEDED)
                self.assertGreaterEqual(result.headings, 11)
                self.assertAlmostEqual(min(swept), -10 * DEGREE, delta=2 * DEGREE)
                self.assertAlmostEqual(max(swept), 10 * DEGREE, delta=2 * DEGREE)
                self.assertLess(self.turned(), 2 * DEGREE)
                self.assertLessEqual(max(map(abs, self.robot.commands)), 0.5 + 1e-9)
                self.assertEqual(self.node.call("learn_place", label="here").status, 0)

    def test_a_full_turn(self):
        self.start_node(scan__turn_rate=2.0)
        scan = self.begin_turn(headings=12, step=30 * DEGREE)
        self.assert_stopped(scan, GoalStatus.SUCCEEDED, ScanPlaceResult.SUCCEEDED)
        full_turns = self.turned() / (2.0 * math.pi)
        self.assertAlmostEqual(full_turns, round(full_turns), delta=0.01)

    def test_turn_is_a_parameter_too(self):
        self.start_node(scan__turn="cmd_vel", scan__turn_rate=2.0)
        scan = self.begin_scan(headings=3)
        self.assert_stopped(scan, GoalStatus.SUCCEEDED, ScanPlaceResult.SUCCEEDED)

    def test_cancel_stops_the_robot(self):
        self.start_node()
        scan = self.begin_turn_under_way()
        scan.cancel()
        self.assert_stopped(scan, GoalStatus.PREEMPTED, ScanPlaceResult.CANCELED)

    def test_a_newer_goal_turns_from_where_the_robot_is(self):
        self.start_node(scan__turn_rate=0.5)
        first = self.begin_turn_under_way()
        second = self.begin_turn(headings=3)
        self.assertEqual(self.finish(first).status, ScanPlaceResult.CANCELED)
        self.assertEqual(first.state(), GoalStatus.PREEMPTED)
        self.assert_stopped(second, GoalStatus.SUCCEEDED, ScanPlaceResult.SUCCEEDED)

    def test_timeout_stops_the_robot(self):
        self.start_node(scan__turn_rate=0.05)
        scan = self.begin_turn_under_way(timeout=rospy.Duration(4))
        self.assert_stopped(scan, GoalStatus.ABORTED, ScanPlaceResult.TIMEOUT,
                            "of 11 headings")

    def test_a_robot_that_does_not_obey_times_out(self):
        self.start_node()
        self.robot.turn = lambda angle: None
        scan = self.begin_turn(timeout=rospy.Duration(2))
        self.assert_stopped(scan, GoalStatus.ABORTED, ScanPlaceResult.TIMEOUT, "first heading")

    def test_who_asks_while_a_scan_runs_is_told(self):
        self.start_node()
        scan = self.begin_turn_under_way()
        answer = self.node.call("recognize_place")
        self.assertEqual(answer.status, RecognizePlaceResponse.NO_SCAN, answer.message)
        self.assertIn("one is under way", answer.message)
        self.assertEqual(self.finish(scan).status, ScanPlaceResult.SUCCEEDED)
        self.assertNotIn("under way", self.node.call("recognize_place").message)

    def test_a_base_that_turns_the_other_way_is_stopped(self):
        self.start_node()
        turn = self.robot.turn
        self.robot.turn = lambda angle: turn(-angle)
        result = self.assert_stopped(self.begin_turn(), GoalStatus.ABORTED,
                                     ScanPlaceResult.BASE_DISOBEYS, "turns the other way",
                                     "swap the sign of angular.z", self.robot.command_topic)
        self.assertLess(self.turned(), 0.5, result.message)

    def test_a_base_that_does_not_turn_is_named(self):
        self.start_node()
        self.robot.turn = lambda angle: None
        self.assert_stopped(self.begin_turn(), GoalStatus.ABORTED, ScanPlaceResult.BASE_DISOBEYS,
                            "does not turn", "1.00 rad/s", self.robot.command_topic)

    def test_a_base_with_a_dead_band(self):
        self.start_node(scan__turn_rate=0.3, scan__least_turn_rate=0.1)
        turn = self.robot.turn
        self.robot.turn = lambda angle: turn(angle if abs(angle) >= 0.1 * fake_robot.STEP else 0.0)
        self.assert_stopped(self.begin_turn(), GoalStatus.SUCCEEDED, ScanPlaceResult.SUCCEEDED)

    def test_a_scan_plans_its_turn_by_the_sensors(self):
        self.start_node(scan__headings=0)
        self.run_for(2.0)
        scan = self.begin_turn()
        self.assert_stopped(scan, GoalStatus.SUCCEEDED, ScanPlaceResult.SUCCEEDED, "sensors leave",
                            "headings")
        self.assertIn("sensors leave", scan.feedback[-1].message)

    def test_a_compass_that_stands_still_makes_a_scan_doubtful(self):
        self.start_node(scan__turn_rate=0.5)
        self.robot.edit_heading = lambda message: fake_robot.heading_message(
            0.3, message.header.stamp)
        scan = self.begin_turn()
        result = self.finish(scan)
        self.assertEqual(result.status, ScanPlaceResult.SUCCEEDED, result.message)
        self.assertIn("stands still", result.message)
        answer = self.node.call("learn_place", label="here")
        self.assertEqual(answer.status, LearnPlaceResponse.DOUBTFUL_SCAN, answer.message)
        self.assertIn("stands still", answer.message)
        self.assertEqual(self.labels(), [])

    def test_a_heading_that_goes_stale_stops_the_robot(self):
        self.start_node(odom_frame="", scan__heading_timeout=1.0)
        scan = self.begin_turn_under_way()
        self.robot.edit_heading = lambda message: None
        self.assert_stopped(scan, GoalStatus.ABORTED, ScanPlaceResult.NO_HEADING, "heading")

    def test_odometry_that_goes_stale_stops_the_robot(self):
        self.start_node(scan__heading_timeout=1.0)
        scan = self.begin_turn_under_way()
        self.robot.has_odometry = False
        self.assert_stopped(scan, GoalStatus.ABORTED, ScanPlaceResult.NO_ODOMETRY, "base_link",
                            "odom")

    def test_without_any_yaw_the_robot_is_not_moved(self):
        for odom_frame, status in (("odom", ScanPlaceResult.NO_ODOMETRY),
                                   ("", ScanPlaceResult.NO_HEADING)):
            with self.subTest(odom_frame=odom_frame):
                self.start_node(odom_frame=odom_frame)
                self.robot.has_odometry = False
                self.robot.edit_heading = lambda message: None
                result = self.finish(self.begin_turn())
                self.assertEqual(result.status, status, result.message)
                self.assertEqual(self.robot.commands, [])

    def test_an_odometry_jump_stops_the_robot(self):
        self.start_node()
        scan = self.begin_turn_under_way()
        self.run_robot(lambda: scan.feedback and scan.feedback[-1].readings, "readings")
        self.robot.odometry = sonar_room.compose(self.robot.odometry, (4.0, 0.0, 0.0))
        self.assert_stopped(scan, GoalStatus.ABORTED, ScanPlaceResult.ODOMETRY_JUMP)

    def test_time_that_runs_backwards_stops_the_robot(self):
        self.start_node()
        scan = self.begin_turn_under_way()
        self.world.set_time(self.world.now - 50.0)
        self.assert_stopped(scan, GoalStatus.ABORTED, ScanPlaceResult.TIME_JUMP)

    def test_a_node_that_is_stopped_stops_the_robot(self):
        for stop in (lambda: self.node.process.terminate(),
                     lambda: rosnode.kill_nodes([self.node.name])):
            with self.subTest():
                self.start_node()
                scan = self.begin_turn_under_way()
                stop()
                self.assert_stopped(scan, GoalStatus.ABORTED, ScanPlaceResult.SHUTDOWN)
                self.assertEqual(self.node.process.wait(live_test.PATIENCE), 0)

    def test_a_node_that_is_killed_leaves_the_robot_to_its_watchdog(self):
        store = os.path.join(self.folder, "places.db")
        self.start_node(store=store)
        self.learn("hall", sonar_room.HALL)
        self.begin_turn_under_way()
        self.node.kill()
        robot = self.robot
        self.run_for(0.5)  # a velocity that was on its way
        angle, said = robot.in_room[2], len(robot.commands)
        self.run_for(1.0)
        self.assertEqual((robot.in_room[2], len(robot.commands)), (angle, said))

        self.start_node(store=store)
        self.assertEqual(self.labels(), ["hall"])
        self.scan_well()


if __name__ == "__main__":
    live_test.main("live_turn_test", LiveTurnTest)
