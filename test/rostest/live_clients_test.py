#!/usr/bin/env python3
"""Several clients of a live node at once: every one of them is answered."""

from nav_msgs.msg import OccupancyGrid
from place_memory.msg import PlaceGraph, Recognition, ScanPlaceResult
from place_memory.srv import LearnPlaceResponse, RenamePlaceResponse
import rospy

import live_test
import sonar_room

CALLS = 12


class LiveClientsTest(live_test.LiveTestCase):
    def setUp(self):
        super().setUp()
        self.start_node()
        self.learn("hall", sonar_room.HALL)
        self.learn("study", sonar_room.STUDY)

    def run_beside(self, *calls):
        """Runs the calls in threads, and the robot meanwhile."""
        threads = live_test.InThreads(*calls)
        self.addCleanup(threads.join)
        self.run_robot(threads.are_over, "every client to be answered")

    def recognize(self):
        for _ in range(CALLS):
            response = self.node.call("recognize_place", heading_window=3.1415)
            self.assertEqual(response.status, response.OK, response.message)
            self.assertEqual(response.recognition.verdict, Recognition.RECOGNIZED)
            self.assertEqual(response.recognition.matches[0].label, "study")

    def learn_and_forget(self, name, scan):
        for i in range(CALLS):
            learned = self.node.call("learn_place", label="%s %d" % (name, i), scan_id=scan)
            self.assertEqual(learned.status, learned.OK, learned.message)
            removed = self.node.call("remove_place", label=learned.label)
            self.assertEqual(removed.status, removed.OK, removed.message)

    def list_places(self):
        for _ in range(CALLS):
            labels = self.labels()
            self.assertEqual(labels[:2], ["hall", "study"])
            self.assertEqual(len(set(labels)), len(labels))

    def test_two_clients_recognize_at_once(self):
        self.run_beside(self.recognize, self.recognize)

    def test_the_map_is_changed_while_places_are_recognized(self):
        graphs = []
        subscriber = rospy.Subscriber(self.node.name + "/place_graph", PlaceGraph, graphs.append)
        self.addCleanup(subscriber.unregister)
        self.wait(lambda: graphs, "the graph")

        def recognize_anything():
            for _ in range(CALLS):
                response = self.node.call("recognize_place")
                self.assertEqual(response.status, response.OK, response.message)
                labels = [match.label for match in response.recognition.matches]
                self.assertTrue({"hall", "study"} <= set(labels), labels)

        first, second = (self.scan_well().scan_id for _ in range(2))
        self.run_beside(recognize_anything, lambda: self.learn_and_forget("a", first),
                        lambda: self.learn_and_forget("b", second), self.list_places)
        self.assertEqual(self.labels(), ["hall", "study"])
        self.wait(lambda: [place.label for place in graphs[-1].places] == ["hall", "study"],
                  "the last graph")

    def test_one_of_two_gets_the_label(self):
        answers = []

        def rename():
            answers.append(self.node.call("rename_place", label="hall", new_label="lobby").status)

        scans = [self.scan_well().scan_id for _ in range(2)]

        def learn():
            answers.append(self.node.call("learn_place", label="attic",
                                          scan_id=scans.pop()).status)

        self.run_beside(rename, rename)
        self.assertEqual(sorted(answers),
                         [RenamePlaceResponse.OK, RenamePlaceResponse.UNKNOWN_PLACE])
        answers.clear()
        self.run_beside(learn, learn)
        self.assertEqual(sorted(answers),
                         [LearnPlaceResponse.OK, LearnPlaceResponse.LABEL_TAKEN])

    def test_scans_go_on_while_places_are_recognized(self):
        grids = []
        subscriber = rospy.Subscriber(self.node.name + "/scan_grid", OccupancyGrid, grids.append)
        self.addCleanup(subscriber.unregister)
        self.robot.spin = 0.2
        threads = live_test.InThreads(self.recognize, self.recognize)
        self.addCleanup(threads.join)
        scans = 0
        while scans < 2 or not threads.are_over():
            self.scan_well(headings=5)
            scans += 1
        self.wait(lambda: len(grids) >= scans, "the grid of every scan")

    def test_each_of_two_action_clients_hears_of_its_own_goal(self):
        first = self.begin_scan(headings=11)
        self.run_robot(lambda: first.feedback, "a scan to begin")
        second = self.begin_scan(headings=1)
        self.assertEqual(self.finish(second).status, ScanPlaceResult.SUCCEEDED)
        self.assertEqual(self.finish(first).status, ScanPlaceResult.CANCELED)

    def test_a_client_cancels_its_own_goal_alone(self):
        over = self.begin_scan(headings=1)
        self.finish(over)
        running = self.begin_scan(headings=11)
        self.run_robot(lambda: running.feedback, "a scan to begin")
        over.cancel()
        self.run_for(1.0)
        self.assertFalse(running.is_over())
        self.robot.spin = 0.2
        self.assertEqual(self.finish(running).status, ScanPlaceResult.SUCCEEDED)

    def test_a_client_that_goes_away_does_not_hold_up_the_next(self):
        gone = self.begin_scan(headings=11)
        self.run_robot(lambda: gone.feedback, "a scan to begin")
        gone.leave()
        self.scan_well()
        self.recognize()


if __name__ == "__main__":
    live_test.main("live_clients_test", LiveClientsTest)
