#!/usr/bin/env python3
"""Standing scans, and people who edit the map, while a live node drives the map along."""

import os

import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped
from place_memory.msg import MapEvent, Recognition
from place_memory.srv import JudgeClosureRequest, JudgeClosureResponse
from std_msgs.msg import String

import live_test
import sonar_room
from fake_robot import STEP

SPEED = 0.4  # [m/s]


class LiveDriveEditsTest(live_test.LiveTestCase):
    def setUp(self):
        super().setUp()
        self.store = os.path.join(self.folder, "places.db")

    def start(self, **parameters):
        self.start_node(store=self.store, **parameters)
        self.events = []
        subscriber = rospy.Subscriber(self.node.name + "/events", MapEvent, self.events.append)
        self.addCleanup(subscriber.unregister)
        self.wait(lambda: subscriber.get_num_connections() > 0, "the node to be heard")

    def drive(self, way):
        """Straight on; odometry notices."""
        steps = int(round(abs(way) / (SPEED * STEP)))
        for _ in range(steps):
            move = (way / steps, 0.0, 0.0)
            self.robot.in_room = sonar_room.compose(self.robot.in_room, move)
            self.robot.odometry = sonar_room.compose(self.robot.odometry, move)
            self.robot.step()

    def place_in_hall(self, x, y=0.0):
        self.robot.enter(sonar_room.HALL, x=x, y=y)

    def kinds(self):
        return [event.kind for event in self.events]

    def newest_pose(self):
        return self.node.latched("pose", PoseWithCovarianceStamped)

    def test_a_scan_of_a_robot_that_stands_becomes_a_place_of_the_drive(self):
        self.start(mode="map")
        self.place_in_hall(-1.0)
        self.scan_well(headings=11, turn=2)
        response = self.node.call("learn_place", label="hall")
        self.assert_answer(response, response.OK)
        self.assertFalse(response.apart)
        self.assertEqual(self.node.latched("current_place", String).data, "hall")
        # A place that the drive makes there would double it.
        self.drive(3.0)
        self.drive(-3.0)
        self.run_for(2.0)
        places = self.graph().places
        self.assertIn("hall", [place.label for place in places])
        hall = next(place for place in places if place.label == "hall")
        for place in places:
            if place.id != hall.id:
                self.assertGreater(abs(place.location.x - hall.location.x), 0.6)
        self.scan_well(headings=11, turn=2)
        response = self.node.call("recognize_place")
        self.assertEqual(response.recognition.verdict, Recognition.RECOGNIZED, response.message)
        self.assertTrue(response.belief.ids)
        self.assertGreaterEqual(1.0 + 1e-6, sum(response.belief.probabilities)
                                + response.belief.off_map)
        self.node.stop()

        # The next day a few scans at a standstill are enough to know where it is.
        self.start(mode="localize")
        self.robot.odometry = (0.0, 0.0, 0.0)
        self.place_in_hall(-1.2)
        for _ in range(3):
            self.scan_well(headings=11, turn=2)
            self.drive(0.3)
        self.run_robot(lambda: MapEvent.FOUND in self.kinds(), "the robot to be found")
        self.run_for(1.0)
        pose = self.newest_pose().pose.pose.position
        self.assertAlmostEqual(pose.x - hall.location.x, self.robot.in_room[0] + 1.0, delta=0.25)
        self.assertAlmostEqual(pose.y - hall.location.y, self.robot.in_room[1], delta=0.25)

    def start_the_next_day(self):
        """Beside a place that is known, where two scans say so; the node maps, and does not know where
        it is."""
        self.start(mode="map")
        self.place_in_hall(-1.0)
        self.scan_well(headings=11, turn=2)
        self.node.call("learn_place", label="hall")
        self.node.stop()
        self.start(mode="map")
        self.robot.odometry = (0.0, 0.0, 0.0)
        self.place_in_hall(-1.2)
        for _ in range(2):
            self.scan_well(headings=11, turn=2)
            self.drive(0.3)
        self.run_robot(lambda: self.judge("LIST").waiting, "a question")

    def judge(self, action, label=""):
        return self.node.call("judge_closure", label=label,
                              action=getattr(JudgeClosureRequest, action))

    def test_a_person_confirms_where_the_robot_is(self):
        self.start_the_next_day()
        waiting = self.judge("LIST").waiting
        self.assertEqual([candidate.label for candidate in waiting], ["hall"])
        self.assertGreaterEqual(waiting[0].scans, 2)
        self.assertIn("scans", waiting[0].sentence)
        self.assert_answer(self.judge("CONFIRM", "hall"), JudgeClosureResponse.OK)
        self.run_robot(lambda: MapEvent.JOINED in self.kinds(), "the join")
        self.assertFalse(self.judge("LIST").waiting)
        hall = next(place for place in self.graph().places if place.label == "hall")
        self.run_for(1.0)
        pose = self.newest_pose().pose.pose.position
        self.assertAlmostEqual(pose.x - hall.location.x, self.robot.in_room[0] + 1.0, delta=0.3)

    def test_nothing_comes_of_what_a_person_cuts(self):
        self.start_the_next_day()
        self.assert_answer(self.judge("CUT", "hall"), JudgeClosureResponse.OK)
        self.scan_well(headings=11, turn=2)
        self.assertFalse(self.judge("LIST").waiting)
        self.assertNotIn(MapEvent.JOINED, self.kinds())
        self.assert_answer(self.judge("CUT", "hall"), JudgeClosureResponse.NO_CANDIDATE)
        self.assert_answer(self.judge("CONFIRM", "nowhere"), JudgeClosureResponse.UNKNOWN_PLACE)
        response = self.node.call("judge_closure", label="hall", action=9)
        self.assert_answer(response, JudgeClosureResponse.INVALID)
        self.assert_answer(self.node.call("set_mode", mode="off"), 0)
        self.assert_answer(self.judge("CUT", "hall"), JudgeClosureResponse.OFF)

    def test_what_people_remove_is_gone_for_the_drive_too(self):
        self.start(mode="map")
        self.place_in_hall(-3.0)
        self.drive(6.0)
        self.run_robot(lambda: len(self.labels()) >= 2, "some places")
        first = self.labels()[0]
        ids = [place.id for place in self.graph().places]
        response = self.node.call("remove_place", label=first)
        self.assert_answer(response, response.OK)
        self.assert_answer(self.node.call("rename_place", label=self.labels()[0],
                                          new_label="desk"), 0)
        self.assert_answer(self.node.call("set_mode", mode="off"), 0)
        self.assertNotIn(first, self.labels())
        self.assertIn("desk", self.labels())
        self.assert_answer(self.node.call("set_mode", mode="map"), 0)
        response = self.node.call("clear")
        self.assert_answer(response, response.OK)
        self.assertEqual(self.labels(), [])
        self.drive(-6.0)
        self.run_robot(lambda: self.labels(), "new places")
        self.assertGreater(min(place.id for place in self.graph().places), max(ids))
        self.assertEqual(self.node.latched("mode", String).data, "map")

    def test_a_drive_goes_on_with_a_map_that_is_loaded_or_undone(self):
        self.start(mode="map")
        self.place_in_hall(-3.0)
        self.drive(6.0)
        self.run_robot(lambda: len(self.labels()) >= 2, "some places")
        self.assert_answer(self.node.call("set_mode", mode="off"), 0)
        self.assert_answer(self.node.call("set_mode", mode="map"), 0)
        known = self.labels()
        self.assert_answer(self.node.call("save", path="copy.db"), 0)
        self.assert_answer(self.node.call("clear"), 0)
        self.drive(-6.0)
        self.run_robot(lambda: self.labels(), "new places")
        self.assert_answer(self.node.call("load", path="copy.db"), 0)
        self.assertEqual(self.labels(), known)
        ids = [place.id for place in self.graph().places]
        # What is made from here on has ids that nobody had, and so is kept.
        self.drive(6.0)
        self.run_robot(lambda: len(self.labels()) > len(known), "places of the drive")
        self.assertGreater(max(place.id for place in self.graph().places), max(ids))
        self.assert_answer(self.node.call("rename_place", label=known[0], new_label="desk"), 0)
        self.assert_answer(self.node.call("undo"), 0)
        self.assertIn(known[0], self.labels())
        self.assertEqual(self.node.latched("mode", String).data, "map")
        self.assertIsNone(self.node.process.poll())

    def test_without_a_place_there_is_nothing_to_localize_by(self):
        self.start(mode="map")
        self.scan_well()
        self.node.call("learn_place", label="hall")
        self.assert_answer(self.node.call("set_mode", mode="localize"), 0)
        self.node.call("clear")
        self.assertEqual(self.node.latched("mode", String).data, "off")
        response = self.node.call("relocalize")
        self.assert_answer(response, response.NO_PLACES)

    def test_where_time_runs_backwards_a_session_begins(self):
        self.start(mode="map")
        self.drive(4.0)
        self.run_robot(lambda: MapEvent.NEW_PLACE in self.kinds(), "a place")
        count = len(self.labels())
        self.world.set_time(self.world.now - 50.0)
        self.run_robot(lambda: MapEvent.SESSION in self.kinds(), "the event of it")
        self.drive(-4.0)
        self.run_for(2.0)
        self.assertGreaterEqual(len(self.labels()), count)
        self.assertIsNone(self.node.process.poll())


if __name__ == "__main__":
    live_test.main("live_drive_edits_test", LiveDriveEditsTest)
