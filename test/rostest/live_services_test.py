#!/usr/bin/env python3
"""Every service of a live node: what it does, and each of its refusals."""

import math
import os

from place_memory.msg import Recognition
from place_memory.srv import (ClearResponse, LearnPlaceResponse, RecognizePlaceResponse,
                              RemovePlaceResponse, RenamePlaceResponse)

import live_test
import sonar_room


def silenced(_sensor, message):
    message.range = math.inf
    return message


class LiveServicesTest(live_test.LiveTestCase):
    def recognize(self, window=0.0):
        return self.node.call("recognize_place", heading_window=window)

    def test_before_time_runs_the_answer_is_no_time(self):
        self.start_node()
        self.assert_answer(self.node.call("learn_place", label="a"), LearnPlaceResponse.NO_TIME)
        self.assert_answer(self.recognize(), RecognizePlaceResponse.NO_TIME)

    def test_a_scan_is_named_by_its_id(self):
        self.start_node()
        scans = {}
        for label, room in (("hall", sonar_room.HALL), ("study", sonar_room.STUDY)):
            self.robot.enter(room)
            scans[label] = self.scan_well().scan_id
        self.assertEqual(len(set(scans.values()) | {0}), 3)
        for label in ("hall", "study"):
            response = self.node.call("learn_place", label=label, scan_id=scans[label])
            self.assert_answer(response, LearnPlaceResponse.OK)
        for label in ("hall", "study"):
            found = self.node.call("recognize_place", scan_id=scans[label]).recognition
            self.assertEqual(found.matches[0].label, label)
        newest = self.node.call("recognize_place").recognition
        self.assertEqual(newest.matches[0].label, "study")

    def test_a_scan_that_is_not_kept_is_refused(self):
        self.start_node()
        unknown = self.scan_well().scan_id + 1000
        self.assert_answer(self.node.call("learn_place", label="a", scan_id=unknown),
                           LearnPlaceResponse.UNKNOWN_SCAN)
        self.assert_answer(self.node.call("recognize_place", scan_id=unknown),
                           RecognizePlaceResponse.UNKNOWN_SCAN)
        self.assertEqual(self.labels(), [])

    def test_a_scan_that_ended_long_ago_is_not_here(self):
        self.start_node(scan__max_age=5.0)
        self.scan_well()
        self.assert_answer(self.recognize(), RecognizePlaceResponse.OK)
        self.run_for(6.0)
        self.assert_answer(self.node.call("learn_place", label="a"),
                           LearnPlaceResponse.SCAN_TOO_OLD)
        self.assert_answer(self.recognize(), RecognizePlaceResponse.SCAN_TOO_OLD)
        self.assertEqual(self.labels(), [])

    def test_a_scan_is_learned_once(self):
        self.start_node()
        self.learn("hall", sonar_room.HALL)
        response = self.node.call("learn_place", label="twin")
        self.assert_answer(response, LearnPlaceResponse.ALREADY_LEARNED)
        self.assertIn("hall", response.message)
        self.assertEqual((response.place_id, response.label, response.session), (0, "", 0))
        self.assertEqual(self.labels(), ["hall"])

    def test_get_graph_is_the_whole_map(self):
        self.start_node()
        response = self.node.call("get_graph")
        self.assert_answer(response, response.OK)
        self.assertEqual((response.graph.places, response.graph.links), ([], []))
        self.learn("hall", sonar_room.HALL)
        self.robot.odometry = (3.0, 0.0, 0.0)
        self.robot.turn(0.5)
        self.learn("study", sonar_room.STUDY)
        graph = self.graph()
        self.assertEqual(graph.places, self.node.call("list_places").places)
        self.assertGreater(graph.version, response.graph.version)
        self.assertEqual([place.session for place in graph.places], [1, 1])
        self.assertEqual(len({bytes(place.identity) for place in graph.places}), 2)
        link = graph.links[0]
        self.assertEqual((link.first_id, link.second_id),
                         tuple(place.id for place in graph.places))
        self.assertAlmostEqual(link.transform.x, 3.0, places=6)
        self.assertGreater(link.covariance[0], 0.0)
        self.assertEqual((link.forward.succeeded, link.backward.succeeded), (1, 0))
        # The robot looked 0.5 to the left of compass east.
        self.assertAlmostEqual(graph.places[1].robot.theta, 0.5, places=6)

    def test_before_a_scan_the_answer_is_no_scan(self):
        self.start_node()
        self.run_for(0.5)
        self.assert_answer(self.node.call("learn_place", label="a"), LearnPlaceResponse.NO_SCAN)
        self.assert_answer(self.recognize(), RecognizePlaceResponse.NO_SCAN)
        self.assertEqual(self.labels(), [])

    def test_learn_makes_a_place_where_odometry_is(self):
        self.start_node()
        self.robot.odometry = (3.0, -2.0, 0.5)
        response = self.learn("hall", sonar_room.HALL)
        self.assertEqual(response.label, "hall")
        place = self.node.call("list_places").places[0]
        self.assertEqual((place.id, place.label), (response.place_id, "hall"))
        self.assertAlmostEqual(place.location.x, 3.0, places=6)
        self.assertAlmostEqual(place.location.y, -2.0, places=6)
        # Compass east: the robot looks there by its compass, and to 0.5 by its odometry.
        self.assertAlmostEqual(place.location.theta, 0.5, places=6)
        self.assertGreater(place.learned.to_sec(), 1000.0)

    def test_learn_refuses_labels_and_makes_one_up(self):
        self.start_node()
        self.learn("hall", sonar_room.HALL)
        self.scan_well()
        for label, status in (("hall", LearnPlaceResponse.LABEL_TAKEN),
                              ("new\nline", LearnPlaceResponse.INVALID_LABEL),
                              ("nul\0", LearnPlaceResponse.INVALID_LABEL),
                              ("\u00e9" * 128, LearnPlaceResponse.INVALID_LABEL)):
            response = self.node.call("learn_place", label=label)
            self.assert_answer(response, status)
            self.assertEqual((response.place_id, response.label), (0, ""))
        self.assertEqual(self.labels(), ["hall"])

        made_up = []
        for _ in range(2):
            self.scan_well()
            made_up.append(self.node.call("learn_place", label=""))
        for response in made_up:
            self.assert_answer(response, LearnPlaceResponse.OK)
        labels = [response.label for response in made_up]
        self.assertEqual(self.labels(), ["hall"] + labels)
        self.assertEqual(len(set(labels + [""])), 3)

        self.scan_well()
        longest = "\u00e9" * 127 + "e"
        self.assert_answer(self.node.call("learn_place", label=longest), LearnPlaceResponse.OK)
        self.assertIn(longest, self.labels())

    def test_recognize_ranks_every_place(self):
        self.start_node()
        self.learn("hall", sonar_room.HALL)
        self.learn("study", sonar_room.STUDY)
        self.robot.enter(sonar_room.STUDY, 0.4, -0.2)
        self.scan_well()
        response = self.recognize()
        self.assert_answer(response, RecognizePlaceResponse.OK)
        found = response.recognition
        self.assertEqual(found.verdict, Recognition.RECOGNIZED)
        self.assertEqual([match.label for match in found.matches], ["study", "hall"])
        best, other = found.matches
        self.assertGreater(best.score, other.score)
        self.assertGreater(best.probability, other.probability)
        self.assertLessEqual(best.probability + other.probability, 1.0)
        self.assertAlmostEqual(best.transform.x, 0.4, delta=0.2)
        self.assertAlmostEqual(best.transform.y, -0.2, delta=0.2)
        # The study was learned where odometry is 0.
        self.assertAlmostEqual(found.pose.pose.position.x, best.transform.x, places=6)
        self.assertEqual(found.header.frame_id, "map")
        self.assertGreater(found.match_duration.to_sec(), 0.0)

    def test_a_scan_without_an_echo_is_no_place_unless_forced(self):
        self.start_node()
        self.learn("study", sonar_room.STUDY)
        self.robot.enter(sonar_room.Room(100.0, 100.0))
        result = self.scan_well()
        self.assertEqual(result.echoes, 0)
        self.assertIn("none with an echo in the grid", result.message)

        refused = self.node.call("learn_place", label="yard")
        self.assert_answer(refused, LearnPlaceResponse.NO_ECHO)
        self.assertIn("force", refused.message)
        self.assertEqual(self.labels(), ["study"])
        self.assert_answer(self.node.call("learn_place", label="yard", force=True), LearnPlaceResponse.OK)

        # The ring unplugged in the study: as empty as the yard, which is known.
        self.robot.enter(sonar_room.STUDY)
        self.robot.edit_range = silenced
        self.scan_well()
        response = self.recognize()
        self.assert_answer(response, RecognizePlaceResponse.OK)
        self.assertEqual(response.recognition.verdict, Recognition.UNKNOWN)
        self.assertIn("no echo lies in the scan's grid", response.message)
        self.assertEqual([match.probability for match in response.recognition.matches], [0.0, 0.0])

    def test_a_scan_says_how_many_echoes_lie_in_its_grid(self):
        self.start_node()
        self.robot.enter(sonar_room.STUDY)
        result = self.scan_well()
        self.assertGreater(result.echoes, 0)
        self.assertLessEqual(result.echoes, result.readings)
        self.assertIn("%d with an echo in the grid" % result.echoes, result.message)

    def test_recognize_says_unknown_where_nothing_was_learned(self):
        self.start_node()
        self.scan_well()
        response = self.recognize()
        self.assert_answer(response, RecognizePlaceResponse.OK)
        self.assertEqual(response.recognition.verdict, Recognition.UNKNOWN)
        self.assertEqual(response.recognition.matches, [])

    def test_recognize_refuses_windows(self):
        self.start_node()
        self.learn("hall", sonar_room.HALL)
        for window in (math.nan, math.inf, -math.inf, -0.1, 3.2, 7.0):
            self.assert_answer(self.recognize(window), RecognizePlaceResponse.INVALID_WINDOW)
        for window in (0.0, 1e-9, math.pi, 3.142):
            self.assert_answer(self.recognize(window), RecognizePlaceResponse.OK)

    def test_any_heading_is_found_in_a_window_of_pi(self):
        self.start_node()
        self.learn("hall", sonar_room.HALL)
        self.learn("study", sonar_room.STUDY)
        self.robot.heading_offset = 2.0
        self.robot.enter(sonar_room.STUDY)
        self.run_for(0.5)
        self.scan_well()
        found = self.recognize(math.pi).recognition
        self.assertEqual(found.matches[0].label, "study")
        self.assertAlmostEqual(abs(found.matches[0].transform.theta), 2.0, delta=0.15)

    def test_rename(self):
        self.start_node()
        first = self.learn("hall", sonar_room.HALL)
        self.learn("study", sonar_room.STUDY)

        def rename(label, new_label):
            return self.node.call("rename_place", label=label, new_label=new_label)

        for label, new_label, status in (
                ("attic", "loft", RenamePlaceResponse.UNKNOWN_PLACE),
                ("", "loft", RenamePlaceResponse.UNKNOWN_PLACE),
                ("hall", "study", RenamePlaceResponse.LABEL_TAKEN),
                ("hall", "", RenamePlaceResponse.INVALID_LABEL),
                ("hall", "a\tb", RenamePlaceResponse.INVALID_LABEL),
                ("hall", "x" * 256, RenamePlaceResponse.INVALID_LABEL)):
            self.assert_answer(rename(label, new_label), status)
        self.assertEqual(self.labels(), ["hall", "study"])
        self.assert_answer(rename("hall", "hall"), RenamePlaceResponse.OK)
        self.assert_answer(rename("hall", "corridor"), RenamePlaceResponse.OK)
        places = self.node.call("list_places").places
        self.assertEqual([place.label for place in places], ["corridor", "study"])
        self.assertEqual(places[0].id, first.place_id)

    def test_remove_and_clear_never_give_an_id_again(self):
        self.start_node()
        ids = [self.learn("hall", sonar_room.HALL).place_id]
        ids.append(self.learn("study", sonar_room.STUDY).place_id)

        def remove(label):
            return self.node.call("remove_place", label=label)

        self.assert_answer(remove("attic"), RemovePlaceResponse.UNKNOWN_PLACE)
        self.assert_answer(remove(""), RemovePlaceResponse.UNKNOWN_PLACE)
        self.assert_answer(remove("study"), RemovePlaceResponse.OK)
        self.assert_answer(remove("study"), RemovePlaceResponse.UNKNOWN_PLACE)
        self.assertEqual(self.labels(), ["hall"])
        ids.append(self.learn("study", sonar_room.STUDY).place_id)

        response = self.node.call("clear")
        self.assert_answer(response, ClearResponse.OK)
        self.assertIn("2 places", response.message)
        self.assertEqual(self.labels(), [])
        self.assert_answer(self.node.call("clear"), ClearResponse.OK)
        ids.append(self.learn("hall", sonar_room.HALL).place_id)
        self.assertEqual(len(set(ids)), 4)
        self.assertEqual(ids, sorted(ids))

    def test_what_cannot_be_stored_does_not_change_the_map(self):
        self.start_node(store=os.path.join(self.folder, "places.db"))
        self.learn("hall", sonar_room.HALL)
        self.learn("study", sonar_room.STUDY)
        self.scan_well()
        self.node.allow_writes(False)
        for service, request in (("learn_place", {"label": "attic"}),
                                 ("rename_place", {"label": "hall", "new_label": "loft"}),
                                 ("remove_place", {"label": "hall"}),
                                 ("clear", {})):
            response = self.node.call(service, **request)
            self.assert_answer(response, response.STORE_FAILED)
        self.assertEqual(self.labels(), ["hall", "study"])
        self.assertEqual(self.recognize().recognition.matches[0].label, "study")
        self.node.allow_writes(True)
        self.assert_answer(self.node.call("learn_place", label="attic"), LearnPlaceResponse.OK)
        self.assertEqual(self.labels(), ["hall", "study", "attic"])


if __name__ == "__main__":
    live_test.main("live_services_test", LiveServicesTest)
