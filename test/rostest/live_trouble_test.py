#!/usr/bin/env python3
"""A live node whose inputs lie about the time or make no sense: it never dies, nor lets the robot turn on."""

import math

from actionlib_msgs.msg import GoalID
from place_memory.msg import PlaceGraph, ScanPlaceGoal, ScanPlaceResult
import rospy
from tf2_msgs.msg import TFMessage

from fake_robot import heading_message, range_message, transform
import live_test
from live_test import GoalStatus
import sonar_room

DEGREE = math.pi / 180.0
END_OF_TIME = rospy.Time(4294967295, 0)


class LiveTroubleTest(live_test.LiveTestCase):
    def begin_turn_under_way(self):
        scan = self.begin_scan(turn=ScanPlaceGoal.TURN_CMD_VEL)
        self.run_robot(lambda: abs(self.robot.in_room[2]) > 2 * DEGREE, "the robot to turn")
        return scan

    def assert_lives(self):
        """The robot stands, and the node answers."""
        self.run_robot(lambda: self.robot.commands[-1:] == [0.0], "a velocity of zero")
        said = len(self.robot.commands)
        self.run_for(1.0)
        self.assertEqual(self.robot.commands[said:], [])
        self.assertIsNone(self.node.process.poll(), self.node.output())
        self.assertEqual(self.labels(), [])
        scan = self.begin_scan(turn=ScanPlaceGoal.TURN_CMD_VEL, headings=3)
        result = self.finish(scan)
        self.assertEqual(result.status, ScanPlaceResult.SUCCEEDED, result.message)

    def send_tf(self, parent, child, stamp, **rotation):
        message = transform(parent, child, (0.0, 0.0, 0.0), stamp)
        for part, value in rotation.items():
            setattr(message.transform.rotation, part, value)
        self.world.tf.publish(TFMessage([message]))

    def assert_goes_on(self, send):
        """What is sent while the robot turns does not even end the scan."""
        scan = self.begin_turn_under_way()
        send()
        result = self.finish(scan)
        self.assertEqual(result.status, ScanPlaceResult.SUCCEEDED, result.message)
        self.assert_lives()

    def test_transforms_at_the_end_of_time(self):
        self.start_node()

        def send():
            for parent, child in (("odom", "base_link"), ("base_link", "sonar_3"), ("a", "b")):
                self.send_tf(parent, child, END_OF_TIME)
            self.send_tf("odom", "base_link", rospy.Time(0))

        self.assert_goes_on(send)
        self.assertIn("transform from base_link to odom left out", self.node.output())

    def test_transforms_without_sense(self):
        self.start_node()

        def send():
            stamp = self.world.stamp()
            self.send_tf("odom", "base_link", stamp, w=0.0, z=0.0)
            self.send_tf("odom", "base_link", stamp, w=math.nan)
            self.send_tf("base_link", "sonar_0", stamp, w=math.inf)

        self.assert_goes_on(send)

    def test_one_transform_ahead_does_not_hide_those_that_follow(self):
        self.start_node()
        self.assert_goes_on(lambda: self.send_tf(
            "odom", "base_link", self.world.stamp() + rospy.Duration(20)))
        self.assertIn("ahead of the clock", self.node.output())

    def test_readings_and_headings_at_the_end_of_time(self):
        self.start_node()

        def send():
            self.robot.sonar.publish(range_message(0, 1.0, END_OF_TIME))
            self.robot.heading.publish(heading_message(0.0, END_OF_TIME))

        self.assert_goes_on(send)

    def test_a_cancel_at_the_end_of_time_cancels_what_there_is(self):
        self.start_node()
        cancel = rospy.Publisher(self.node.name + "/scan/cancel", GoalID, queue_size=1)
        self.addCleanup(cancel.unregister)
        self.wait(lambda: cancel.get_num_connections() > 0, "the node to connect")
        scan = self.begin_turn_under_way()
        cancel.publish(GoalID(END_OF_TIME, "nobody knows it"))
        result = self.finish(scan)
        self.assertEqual(result.status, ScanPlaceResult.CANCELED, result.message)
        self.assert_lives()

    def test_a_clock_at_the_end_of_time(self):
        self.start_node()
        scan = self.begin_turn_under_way()
        before = self.world.now
        self.world.set_time(END_OF_TIME.to_sec())
        self.robot.say()
        self.hold(scan.is_over, "a scan to end at the end of time")
        self.assertEqual(scan.state(), GoalStatus.ABORTED)
        self.assertGreater(len(scan.result().message), 3)
        self.wait(lambda: self.robot.commands[-1:] == [0.0], "a velocity of zero")
        self.world.set_time(before)
        self.wait(lambda: "time ran backwards" in self.node.output(), "the jump to be noticed")
        self.assert_lives()

    def test_a_clock_beyond_half_of_its_range(self):
        self.start_node()
        scan = self.begin_turn_under_way()
        before = self.world.now
        self.world.set_time(before + 2.0 ** 31 + 10.0)
        self.hold(scan.is_over, "a scan to end")
        self.assertEqual(scan.state(), GoalStatus.ABORTED)
        self.world.set_time(before)
        self.wait(lambda: "time ran backwards" in self.node.output(), "the jump to be noticed")
        self.assert_lives()


class LiveStepTest(live_test.LiveTestCase):
    """What lies a little, or once, costs a message and nothing more."""

    def assert_learned_with_a_link(self):
        response = self.node.call("learn_place", label="study")
        self.assertEqual(response.status, response.OK, response.message)
        graph = self.node.latched("place_graph", PlaceGraph)
        self.assertEqual(len(graph.links), 1)

    def test_a_small_step_of_the_clock_costs_nothing(self):
        self.start_node()
        self.learn("hall", sonar_room.HALL)
        scan = self.begin_scan(headings=11)
        self.robot.spin = 0.2
        self.run_robot(lambda: scan.feedback and scan.feedback[-1].readings, "readings")
        self.world.set_time(self.world.now - 0.6)
        self.assertEqual(self.finish(scan).status, ScanPlaceResult.SUCCEEDED)
        self.world.set_time(self.world.now - 0.6)
        self.run_for(0.3)
        self.assert_learned_with_a_link()
        self.assertNotIn("ran backwards", self.node.output())

    def test_how_far_the_clock_may_step_is_a_parameter(self):
        self.start_node(time_jump_tolerance=0.0)
        scan = self.begin_scan(headings=11)
        self.run_robot(lambda: scan.feedback and scan.feedback[-1].readings, "readings")
        self.world.set_time(self.world.now - 0.2)
        result = self.finish(scan)
        self.assertEqual(result.status, ScanPlaceResult.TIME_JUMP, result.message)
        self.assertIn("/clock", result.message)

    def test_one_stale_stamp_of_a_sensor_is_left_out(self):
        self.start_node()
        self.learn("hall", sonar_room.HALL)
        for stamp in (rospy.Time(5), None):
            with self.subTest(stamp=stamp):
                scan = self.begin_scan(headings=11)
                self.robot.spin = 0.2
                self.run_robot(lambda: scan.feedback and scan.feedback[-1].readings, "readings")
                stale = stamp or self.world.stamp() - rospy.Duration(2)
                self.robot.sonar.publish(range_message(7, 1.0, stale))
                self.robot.heading.publish(heading_message(0.0, stale))
                result = self.finish(scan)
                self.assertEqual(result.status, ScanPlaceResult.SUCCEEDED, result.message)
                self.assertIn("1 old stamp", result.message)
                self.assertIn("sonar_7", self.node.output())
        self.assert_learned_with_a_link()


if __name__ == "__main__":
    live_test.main("live_trouble_test", "live_trouble_test")
