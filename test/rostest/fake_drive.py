"""A node that offers a map of one place, drives to it and explores as it is told."""

import threading

import actionlib
import rospy
from place_memory import msg, srv


class FakeAction:
    """Says once how far each goal is, and is done with it when finish() says so."""

    def __init__(self, name, action, feedback, result):
        self.goals = []
        self._feedback, self._result = feedback, result
        self._may_end = threading.Event()
        self._server = actionlib.SimpleActionServer(name, action, self._execute, auto_start=False)
        self._server.start()

    def finish(self):
        self._may_end.set()

    def _execute(self, goal):
        self._may_end.clear()
        self.goals.append(goal)
        while not self._may_end.wait(0.05):
            self._server.publish_feedback(self._feedback)
            if self._server.is_preempt_requested():
                return self._server.set_preempted(type(self._result)(message="it was canceled"))
        return self._server.set_succeeded(self._result)


class FakeDrive:
    def __init__(self, name):
        self.name = name
        self._graph = rospy.Service(name + "/get_graph", srv.GetGraph, self._answer)
        self.go_to_place = FakeAction(
            name + "/go_to_place", msg.GoToPlaceAction,
            msg.GoToPlaceFeedback(leg="to the hall", legs_left=2, time_left=30.0, message="goes"),
            msg.GoToPlaceResult(message="the robot is at the hall"))
        self.explore = FakeAction(
            name + "/explore", msg.ExploreAction,
            msg.ExploreFeedback(message="looks round", places=3, frontiers=2, distance=12.0),
            msg.ExploreResult(message="nothing is left"))

    def output(self):
        return "goals: %s, %s" % (self.go_to_place.goals, self.explore.goals)

    @staticmethod
    def _answer(_):
        graph = msg.PlaceGraph(version=1, places=[msg.Place(id=1, label="hall")])
        return srv.GetGraphResponse(graph=graph)
