#!/usr/bin/env python3
"""Places of a live node that follow lasting changes: a cupboard comes into the hall, and stays."""

import os

from nav_msgs.msg import OccupancyGrid
from place_memory.msg import Recognition
from place_memory.srv import RecognizePlaceResponse
import rosgraph
from rosgraph_msgs.msg import Log
import rospy

import live_test
import sonar_room

CUPBOARD = (-1.4, 1.0, 1.0, 1.0)  # as sonar_room.Room takes it
CHANGED_HALL = sonar_room.Room(9.0, 3.0, [(2.5, 1.0, 0.8, 0.8), CUPBOARD])
VISITS = 6


def occupied(grid, box):
    """How many cells in and before a box are more likely occupied than not. The robot learned in
    the middle of the grid."""
    x, y, width, depth = box
    count = 0
    for row in range(grid.info.height):
        for column in range(grid.info.width):
            in_x = (column + 0.5 - 0.5 * grid.info.width) * grid.info.resolution
            in_y = (row + 0.5 - 0.5 * grid.info.height) * grid.info.resolution
            near = abs(in_x - x) < 0.5 * width + 0.1 and abs(in_y - y) < 0.5 * depth + 0.1
            if near and grid.data[row * grid.info.width + column] > 50:
                count += 1
    return count


class LiveAdaptTest(live_test.LiveTestCase):
    def start_node(self, **parameters):
        super().start_node(**parameters)
        self.robot.spin = 0.3
        self.said = []
        log = rospy.Subscriber("/rosout", Log, self._on_log)
        self.addCleanup(log.unregister)
        uri = rosgraph.Master(rospy.get_name()).lookupNode(self.node.name)
        self.wait(lambda: log.impl.has_connection(uri), "the log of the node")

    def _on_log(self, message):
        if message.name == self.node.name:
            self.said.append(message.msg)

    def wait_for_log(self, *words):
        self.wait(lambda: any(all(word in said for word in words) for said in self.said),
                  "the log to say " + ", ".join(words))

    def learn_both(self):
        for label, room in (("hall", sonar_room.HALL), ("study", sonar_room.STUDY)):
            self.robot.enter(room)
            self.scan_well(headings=11)
            self.assert_answer(self.node.call("learn_place", label=label), 0)

    def recognize_hall(self):
        response = self.node.call("recognize_place")
        self.assert_answer(response, RecognizePlaceResponse.OK)
        self.assertEqual(response.recognition.verdict, Recognition.RECOGNIZED, response.message)
        self.assertEqual(response.recognition.matches[0].label, "hall")
        return response

    def visit(self, room):
        self.robot.enter(room)
        self.scan_well(headings=11)
        return self.recognize_hall()

    def cupboard(self):
        """Cells of the cupboard in the grid that was recalled last."""
        return occupied(self.node.latched("matched_grid", OccupancyGrid), CUPBOARD)

    def test_what_stays_comes_into_the_place(self):
        store = os.path.join(self.folder, "places.db")
        self.start_node(store=store, places__adapt=True)
        self.learn_both()
        self.visit(sonar_room.HALL)
        before = self.cupboard()
        scores = [self.visit(CHANGED_HALL).recognition.matches[0].score for _ in range(VISITS)]
        self.assertGreater(self.cupboard(), before)
        self.assertGreater(scores[-1], scores[0])
        self.wait_for_log('was folded into "hall"')

        self.node.stop()
        self.start_node(store=store)
        self.visit(CHANGED_HALL)
        self.assertGreater(self.cupboard(), before)

    def test_without_the_option_a_place_is_as_it_was_learned(self):
        self.start_node()
        self.learn_both()
        self.visit(sonar_room.HALL)
        before = self.cupboard()
        for _ in range(VISITS):
            self.visit(CHANGED_HALL)
        self.assertEqual(self.cupboard(), before)

    def test_a_scan_is_folded_once_however_often_it_is_asked_about(self):
        self.start_node(places__adapt=True)
        self.learn_both()
        self.visit(CHANGED_HALL)
        once = self.node.latched("matched_grid", OccupancyGrid).data
        for _ in range(VISITS):
            self.recognize_hall()
        self.assertEqual(self.node.latched("matched_grid", OccupancyGrid).data, once)

    def test_what_cannot_be_stored_is_said_and_the_answer_stands(self):
        self.start_node(store=os.path.join(self.folder, "places.db"), places__adapt=True)
        self.learn_both()
        self.visit(sonar_room.HALL)
        before = self.cupboard()
        self.node.allow_writes(False)
        for _ in range(VISITS):
            self.visit(CHANGED_HALL)
        self.wait_for_log('was not folded into "hall"')
        self.assertEqual(self.cupboard(), before)
        self.node.allow_writes(True)
        self.visit(CHANGED_HALL)
        self.wait_for_log('was folded into "hall"')

    def test_a_place_may_go_while_it_follows(self):
        self.start_node(places__adapt=True)
        self.learn_both()
        self.robot.enter(CHANGED_HALL)
        self.scan_well(headings=11)
        answers = []

        def recognize():
            for _ in range(10):
                answers.append(self.node.call("recognize_place").status)

        threads = live_test.InThreads(recognize, recognize, lambda: answers.append(
            self.node.call("remove_place", label="hall").status))
        self.addCleanup(threads.join)
        self.run_robot(threads.are_over, "every client to be answered")
        self.assertEqual(set(answers), {0})
        self.assertEqual(self.labels(), ["study"])


if __name__ == "__main__":
    live_test.main("live_adapt_test", LiveAdaptTest)
