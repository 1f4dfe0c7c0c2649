"""Clients that go by the links of the map, or change it as a whole; and one who makes no sense."""

import math

import rospy
from geometry_msgs.msg import PoseStamped
from nav_msgs.srv import GetMap, GetPlan
from place_memory import srv

from soak_tools.clients import Client, Learner, Reader, Recognizer, Scanner
from soak_tools.node import NAME

END_OF_TIME = rospy.Time(4294967295, 0)


class Router(Client):
    """Plans, travels and closes links of the newest map that was seen; what it names may be gone."""

    def act(self):
        links = self.watch.links
        if not links:
            return
        link = self.random.choice(links)
        ends = {"from_id": link.first_id, "to_id": link.second_id}
        chance = self.random.random()
        if chance < 0.4:
            self.call("plan_route", srv.PlanRoute, start_id=link.first_id,
                      goal_id=self.random.choice(links).second_id, second=True)
        elif chance < 0.6:
            goal = PoseStamped()
            goal.pose.position.x = self.random.uniform(-6.0, 6.0)
            self.call("make_plan", GetPlan, goal=goal)
        elif chance < 0.8:
            self.call("report_traversal", srv.ReportTraversal, source="soak",
                      succeeded=self.random.random() < 0.7, **ends)
        else:
            action = self.random.choice([srv.SetLinkRequest.BLOCK, srv.SetLinkRequest.UNBLOCK,
                                         srv.SetLinkRequest.FORBID, srv.SetLinkRequest.COST])
            self.call("set_link", srv.SetLink, action=action, cost=3.0,
                      one_way=self.random.random() < 0.5, **ends)


class Keeper(Client):
    """Saves, loads, merges, exports and takes back: seldom, since each holds the others up."""

    def act(self):
        if self.random.random() > 0.25:
            return
        chance = self.random.random()
        if chance < 0.35:
            self.save()
        elif chance < 0.5:
            self.call("export", srv.Export, path="exported")
        elif chance < 0.6:
            self.call("static_map", GetMap)
        else:
            with self.watch.upheavals.one():
                if chance < 0.85:
                    self.call("undo", srv.Undo, count=self.random.randint(1, 3))
                else:
                    self.load_or_merge()

    def save(self):
        self.call("save", srv.Save, path="saved-%d.db" % self.number)

    def load_or_merge(self):
        self.save()
        if self.random.random() < 0.5:
            self.call("load", srv.Load, path="saved-%d.db" % self.number)
        else:
            self.call("merge", srv.Merge, path="saved-%d.db" % self.number)


class Fool(Client):
    """Asks for what makes no sense; each is answered with a status that is not OK."""

    QUESTIONS = [
        ("learn_place", srv.LearnPlace, {"label": "x" * 1000000}),
        ("learn_place", srv.LearnPlace, {"label": " \n\x00"}),
        ("learn_place", srv.LearnPlace, {"label": "a", "scan_id": 2 ** 64 - 1}),
        ("recognize_place", srv.RecognizePlace, {"heading_window": math.nan}),
        ("recognize_place", srv.RecognizePlace, {"heading_window": -1e300}),
        ("rename_place", srv.RenamePlace, {"label": "nowhere", "new_label": ""}),
        ("remove_place", srv.RemovePlace, {"label": "; rm -rf $HOME"}),
        ("remove_place", srv.RemovePlace, {"label": "y" * 1000000}),
        ("plan_route", srv.PlanRoute, {"start_id": -1, "goal_id": 2 ** 63 - 1}),
        ("plan_route", srv.PlanRoute, {"start_label": "z" * 1000000, "goal_label": "\x00"}),
        ("report_traversal", srv.ReportTraversal, {"from_id": -1, "to_id": -1}),
        ("set_link", srv.SetLink, {"from_id": 1, "to_id": 1, "action": 255}),
        ("set_link", srv.SetLink, {"from_label": "\x00", "action": 3, "cost": math.nan}),
        ("set_mode", srv.SetMode, {"mode": "m" * 1000000}),
        ("set_mode", srv.SetMode, {"mode": ""}),
        ("judge_closure", srv.JudgeClosure, {"label": "c" * 1000000, "action": 1}),
        ("judge_closure", srv.JudgeClosure, {"id": -1, "action": 255}),
        ("undo", srv.Undo, {"count": 4294967295}),
        ("load", srv.Load, {"path": "../../etc/passwd"}),
        ("load", srv.Load, {"path": "nothing.db"}),
        ("merge", srv.Merge, {"path": "m" * 1000000}),
        ("save", srv.Save, {"path": "/dev/null"}),
        ("save", srv.Save, {"path": ""}),
        ("export", srv.Export, {"path": "\x00"}),
    ]

    def act(self):
        name, service, request = self.random.choice(self.QUESTIONS)
        response = self.call(name, service, **request)
        if response is not None and (response.status == 0 or len(response.message) > 2000):
            self.watch.fail("%s was answered with %d, %d bytes" % (name, response.status,
                                                                   len(response.message)))


class Moder(Client):
    """Asks for the mode that there is, and sometimes for another one for a moment."""

    def act(self):
        mode = rospy.get_param(NAME + "/mode")
        if self.random.random() < 0.05:
            self.call("set_mode", srv.SetMode, mode=self.random.choice(["off", "map", "localize"]))
        self.call("set_mode", srv.SetMode, mode=mode)


def clients(number, node, watch, pace):
    """So many, of every kind."""
    kinds = [Scanner, Recognizer, Reader, Learner, Router, Keeper, Fool, Learner, Reader, Moder,
             Scanner, Recognizer, Learner, Router, Fool]
    return [kinds[i % len(kinds)](i, node, watch, pace) for i in range(number)]
