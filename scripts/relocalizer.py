#!/usr/bin/python3
"""Finds out where the robot is when a navigation stack asks.

Action and service ~relocalize scan, have the scan recognized, and where a place is RECOGNIZED say on
topic initialpose where the robot is, as amcl takes it. Parameters: ~node, name of the place memory;
~tries, scans until a place is RECOGNIZED; ~turn, of the scans, as in ScanPlace.
"""
import threading

import actionlib
import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped
from place_memory import msg, srv

PATIENCE = 5.0  # until the place memory answers [s]
Result = msg.RelocalizeResult


class Relocalizer:
    def __init__(self):
        self.node = rospy.resolve_name(rospy.get_param("~node", "place_memory"))
        self.tries = rospy.get_param("~tries", 2)
        self.turn = rospy.get_param("~turn", msg.ScanPlaceGoal.TURN_PARAMETER)
        self.one_at_a_time = threading.Lock()
        self.initial_pose = rospy.Publisher("initialpose", PoseWithCovarianceStamped, queue_size=1)
        self.scan = actionlib.SimpleActionClient(self.node + "/scan", msg.ScanPlaceAction)
        self.recognize = rospy.ServiceProxy(self.node + "/recognize_place", srv.RecognizePlace)
        self.action = actionlib.SimpleActionServer("~relocalize", msg.RelocalizeAction,
                                                   self.on_goal, auto_start=False)
        self.action.start()
        self.service = rospy.Service("~relocalize", srv.RecognizePlace, self.on_request)

    def on_goal(self, goal):
        def tell(scan, message):
            self.action.publish_feedback(msg.RelocalizeFeedback(scan=scan, message=message))

        result, _ = self.relocalize(goal.heading_window, goal.tries or self.tries, tell,
                                    self.action.is_preempt_requested)
        if result.status == Result.FOUND:
            self.action.set_succeeded(result, result.message)
        elif result.status == Result.CANCELED:
            self.action.set_preempted(result, result.message)
        else:
            self.action.set_aborted(result, result.message)

    def on_request(self, request):
        result, answer = self.relocalize(request.heading_window, self.tries)
        if answer is None:
            answer = srv.RecognizePlaceResponse(status=srv.RecognizePlaceResponse.FAILED)
        answer.message = result.message
        return answer

    def relocalize(self, heading_window, tries, tell=lambda *_: None, is_canceled=lambda: False):
        """The result, and the newest answer of the place memory or None."""
        result, answer = Result(status=Result.NO_NODE), None
        with self.one_at_a_time:
            for number in range(1, tries + 1):
                if not self.is_memory_there():
                    result.message = "there is no place memory " + self.node
                    break
                tell(number, "scan %d of %d" % (number, tries))
                scanned = self.scan_once(is_canceled)
                if scanned is None:
                    result = Result(status=Result.CANCELED, message="canceled")
                    break
                if scanned.status != msg.ScanPlaceResult.SUCCEEDED:
                    result = Result(status=Result.SCAN_FAILED, message=scanned.message)
                    continue
                try:
                    answer = self.recognize(heading_window=heading_window,
                                            scan_id=scanned.scan_id)
                except rospy.ServiceException as error:
                    result.message = str(error)
                    break
                result = self.read(answer)
                if result.status == Result.FOUND:
                    break
        return result, answer

    def is_memory_there(self):
        try:
            self.recognize.wait_for_service(PATIENCE)  # of the wall clock, simulated or not
        except rospy.ROSException:
            return False
        return self.scan.wait_for_server()  # of a node that is there

    def scan_once(self, is_canceled):
        """Its result; None where it was canceled."""
        self.scan.send_goal(msg.ScanPlaceGoal(turn=self.turn))
        while not self.scan.wait_for_result(rospy.Duration(0.1)):
            if is_canceled() or rospy.is_shutdown():
                self.scan.cancel_goal()
                return None
        return self.scan.get_result()

    def read(self, answer):
        result = Result(status=Result.NOT_FOUND, message=answer.message)
        found = answer.recognition
        if not found.matches:
            return result
        result.place = found.matches[0].label
        result.probability = found.matches[0].probability
        if answer.status == answer.OK and found.verdict == found.RECOGNIZED:
            result.status = Result.FOUND
            result.pose = PoseWithCovarianceStamped(header=found.header, pose=found.pose)
            self.initial_pose.publish(result.pose)
        return result


if __name__ == "__main__":
    rospy.init_node("relocalizer")
    Relocalizer()
    rospy.spin()
