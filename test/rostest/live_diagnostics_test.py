#!/usr/bin/env python3
"""What a live node says of itself on /diagnostics."""

import os

import rospy
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus

import live_test
import sonar_room


class Diagnostics:
    """What a node says of itself on /diagnostics, by the name of the part."""

    def __init__(self, node):
        self.statuses = {}
        self._prefix = node.name.strip("/") + ": "
        self._subscriber = rospy.Subscriber("/diagnostics", DiagnosticArray, self._on_array)

    def close(self):
        self._subscriber.unregister()

    def _on_array(self, array):
        for status in array.status:
            if status.name.startswith(self._prefix):
                self.statuses[status.name[len(self._prefix):]] = status

    def says(self, part, level, *words):
        status = self.statuses.get(part)
        return (status is not None and status.level == level
                and all(word in status.message for word in words))


class LiveDiagnosticsTest(live_test.LiveTestCase):
    def start_node(self, **parameters):
        super().start_node(**parameters)
        self.diagnostics = Diagnostics(self.node)
        self.addCleanup(self.diagnostics.close)

    def wait_for(self, part, level, *words):
        self.run_robot(lambda: self.diagnostics.says(part, level, *words),
                       "%s of %s: %s" % (level, part, ", ".join(words)))

    def test_sensors_and_places_are_well(self):
        self.start_node()
        self.wait_for("sensors", DiagnosticStatus.OK, "16 sensors")
        self.learn("hall", sonar_room.HALL)
        self.wait_for("memory", DiagnosticStatus.OK, "1 place")

    def test_values_are_numbers_and_the_robot_is_named(self):
        self.start_node()
        self.wait_for("sensors", DiagnosticStatus.OK, "16 sensors")
        self.wait_for("compass", DiagnosticStatus.OK, "Hz")
        for part in ("sensors", "compass", "transforms"):
            status = self.diagnostics.statuses[part]
            self.assertEqual(status.hardware_id, self.node.name.strip("/").split("/")[0])
            units = [pair for pair in status.values if "[" in pair.key]
            self.assertTrue(units, part)
            for pair in units:
                float(pair.value)

    def test_before_a_reading_came_there_is_a_warning(self):
        self.start_node()
        self.robot.edit_range = lambda sensor, message: None
        self.wait_for("sensors", DiagnosticStatus.WARN, "no sensor")

    def test_a_sensor_without_sense_is_named(self):
        self.start_node()
        for field, value in (("field_of_view", 0.0), ("field_of_view", float("nan")),
                             ("min_range", 7.0), ("max_range", float("inf"))):
            with self.subTest(field=field, value=value):
                def edit(sensor, message):
                    if sensor == 5:
                        setattr(message, field, value)
                    return message

                self.robot.edit_range = edit
                self.wait_for("sensors", DiagnosticStatus.ERROR, "sonar_5", field)
                self.robot.edit_range = lambda sensor, message: message
                self.wait_for("sensors", DiagnosticStatus.OK)

    def test_centimetres_are_named(self):
        def centimetres(sensor, message):
            for field in ("range", "min_range", "max_range"):
                setattr(message, field, 100.0 * getattr(message, field))
            return message

        self.start_node()
        self.robot.edit_range = centimetres
        self.wait_for("sensors", DiagnosticStatus.WARN, "sonar_5 has a max_range", "in metres")
        self.robot.edit_range = lambda sensor, message: message
        self.wait_for("sensors", DiagnosticStatus.OK)

    def test_a_silent_sensor_is_named(self):
        self.start_node()
        self.wait_for("sensors", DiagnosticStatus.OK, "16 sensors")
        self.robot.edit_range = lambda sensor, message: None if sensor == 3 else message
        self.wait_for("sensors", DiagnosticStatus.WARN, "sonar_3", "silent")

    def test_a_sensor_that_says_only_nan_is_named(self):
        self.start_node()

        def edit(sensor, message):
            if sensor == 9:
                message.range = float("nan")
            return message

        self.robot.edit_range = edit
        self.wait_for("sensors", DiagnosticStatus.WARN, "sonar_9", "rejected")

    def test_a_sensor_falls_silent_though_time_was_set_back(self):
        self.start_node()
        self.wait_for("sensors", DiagnosticStatus.OK, "16 sensors")
        self.world.set_time(self.world.now - 500.0)
        self.robot.edit_range = lambda sensor, message: None if sensor == 3 else message
        self.wait_for("sensors", DiagnosticStatus.WARN, "sonar_3", "silent")

    def test_nan_after_a_good_while_shows(self):
        self.start_node()
        self.run_for(30.0)
        self.wait_for("sensors", DiagnosticStatus.OK, "16 sensors")

        def edit(sensor, message):
            message.range = float("nan")
            return message

        self.robot.edit_range = edit
        self.wait_for("sensors", DiagnosticStatus.WARN, "sonar_0", "rejected")

    def test_a_sensor_that_is_corrected_is_well_again(self):
        def wrong(sensor, message):
            if sensor == 4:
                message.header.frame_id = "ghost"
            return message

        self.start_node()
        self.robot.edit_range = wrong
        self.wait_for("transforms", DiagnosticStatus.WARN, "from ghost to base_link")
        self.robot.edit_range = lambda sensor, message: message
        self.run_for(6.0)
        self.wait_for("sensors", DiagnosticStatus.OK, "16 sensors")
        self.wait_for("transforms", DiagnosticStatus.OK)

    def test_the_compass_speaks_for_itself(self):
        self.start_node()
        self.wait_for("compass", DiagnosticStatus.OK, "Hz")

        def zero(message):
            message.orientation.z = message.orientation.w = 0.0
            return message

        self.robot.edit_heading = zero
        self.wait_for("compass", DiagnosticStatus.WARN, "left out", "quaternion")
        self.robot.edit_heading = lambda message: None
        self.wait_for("compass", DiagnosticStatus.WARN, "silent", "heading")

    def test_odometry_that_is_missing_is_said_without_a_scan(self):
        self.start_node()
        self.wait_for("transforms", DiagnosticStatus.OK)
        self.robot.has_odometry = False
        self.wait_for("transforms", DiagnosticStatus.WARN, "base_link to odom", "old")

    def test_a_store_that_fails_later_is_an_error_until_it_is_well(self):
        store = os.path.join(self.folder, "places.db")
        self.start_node(store=store)
        self.learn("hall", sonar_room.HALL)
        self.wait_for("memory", DiagnosticStatus.OK, "1 place")
        self.node.allow_writes(False)
        response = self.node.call("clear")
        self.assert_answer(response, response.STORE_FAILED)
        self.wait_for("memory", DiagnosticStatus.ERROR, store, "again")
        self.node.allow_writes(True)
        response = self.node.call("clear")
        self.assert_answer(response, response.OK)
        self.wait_for("memory", DiagnosticStatus.OK, "0 places")

    def test_a_store_that_is_not_used_is_an_error(self):
        store = os.path.join(self.folder, "places.db")
        with open(store, "w") as file:
            file.write("this is a diary\n" * 100)
        self.start_node(store=store)
        self.wait_for("memory", DiagnosticStatus.ERROR, store)


if __name__ == "__main__":
    live_test.main("live_diagnostics_test", LiveDiagnosticsTest)
