"""Actions and services of other nodes, waited for until they are there."""
import threading

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus

from demo_tools.errors import DemoError
from demo_tools.waiting import wait_until

START_LIMIT = 60.0  # of real time [s]


def action(name, kind, check):
    client = actionlib.ActionClient(name, kind)
    # The client's own limit is one of simulated time, which stands still if the simulator ends.
    there = threading.Event()

    def wait():
        if client.wait_for_server():
            there.set()

    threading.Thread(target=wait, daemon=True).start()
    wait_until(there.is_set, name, START_LIMIT, check)
    return client


def service(name, kind, check):
    def is_there():
        try:
            rospy.wait_for_service(name, timeout=0.2)
            return True
        except rospy.ROSException:
            return False

    wait_until(is_there, name, START_LIMIT, check)
    return rospy.ServiceProxy(name, kind)


def expect(answer, what):
    """The answer of a service; DemoError with what it says where it is not OK."""
    if answer.status != answer.OK:
        raise DemoError(f"{what}: {answer.message}")
    return answer


class Goal:
    """A goal of an action, on its way."""

    def __init__(self, client, goal, what, check):
        self.feedback = None  # the newest
        self._what = what
        self._check = check
        self._handle = client.send_goal(goal, feedback_cb=self._on_feedback)
        wait_until(lambda: self._handle.get_goal_status() != GoalStatus.PENDING,
                   f"the start of {what}", START_LIMIT, check)

    def _on_feedback(self, _, feedback):
        self.feedback = feedback

    def is_over(self):
        return self._handle.get_result() is not None

    def result(self, limit):
        """Once it is over, within `limit` seconds of real time."""
        return wait_until(self._handle.get_result, f"the end of {self._what}", limit, self._check)
