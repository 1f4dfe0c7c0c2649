#!/usr/bin/env python3
"""Routes of a live node: what is planned, reported and set, and what is refused."""

from geometry_msgs.msg import PoseStamped
from place_memory.srv import (PlanRouteResponse, ReportTraversalResponse, SetLinkRequest,
                              SetLinkResponse)

import live_test
import sonar_room


def pose_at(x, y, frame="map"):
    pose = PoseStamped()
    pose.header.frame_id = frame
    pose.pose.position.x = x
    pose.pose.position.y = y
    pose.pose.orientation.w = 1.0
    return pose


class LiveRoutesTest(live_test.LiveTestCase):
    def make_row(self):
        """Three places in a row, three metres apart; the robot is at the last one."""
        self.start_node()
        for i, label in enumerate(("a", "b", "c")):
            self.robot.odometry = (3.0 * i, 0.0, 0.0)
            self.learn(label, (sonar_room.HALL, sonar_room.STUDY)[i % 2])

    def plan(self, goal, **request):
        return self.node.call("plan_route", goal_label=goal, **request)

    def set_link(self, action, **request):
        return self.node.call("set_link", from_label="b", to_label="a", action=action, **request)

    def test_a_route_leads_from_place_to_place(self):
        self.make_row()
        response = self.plan("a", second=True)
        self.assert_answer(response, PlanRouteResponse.OK)
        self.assertEqual(response.route.labels, ["c", "b", "a"])
        self.assertAlmostEqual(response.expected_cost, response.route.cost)
        self.assertEqual(response.stranded, 0.0)
        self.assertEqual(response.route.ids, (3, 2, 1))
        xs = [pose.pose.position.x for pose in response.route.path.poses]
        for x, expected in zip(xs, (6.0, 3.0, 0.0)):
            self.assertAlmostEqual(x, expected, places=3)
        self.assertAlmostEqual(abs(response.route.path.poses[0].pose.orientation.z), 1.0, places=3)
        self.assertGreater(response.route.cost, response.route.time)
        self.assertEqual(response.second.labels, [])
        self.assertIn("no other route", response.message)

    def test_goals_are_poses_too_and_other_planners_clients_get_a_path(self):
        self.make_row()
        response = self.node.call("plan_route", goal_pose=pose_at(0.4, 0.3), start_label="b")
        self.assert_answer(response, PlanRouteResponse.OK)
        self.assertEqual(response.route.labels, ["b", "a"])
        plan = self.node.call("make_plan", start=pose_at(3.1, 0.0), goal=pose_at(0.4, 0.3)).plan
        self.assertEqual(plan.header.frame_id, "map")
        self.assertEqual(len(plan.poses), 3)
        self.assertAlmostEqual(plan.poses[-1].pose.position.x, 0.4)
        plan = self.node.call("make_plan", start=pose_at(3.1, 0.0), goal=pose_at(0, 0, "moon")).plan
        self.assertEqual(plan.poses, [])

    def test_what_cannot_be_planned_is_answered(self):
        self.start_node()
        self.assert_answer(self.plan("a"), PlanRouteResponse.NOT_LOCALIZED)
        self.learn("a", sonar_room.HALL)
        self.assert_answer(self.plan("nowhere"), PlanRouteResponse.UNKNOWN_GOAL)
        self.assert_answer(self.plan("a", start_id=77), PlanRouteResponse.UNKNOWN_START)
        self.assert_answer(self.node.call("plan_route", goal_pose=pose_at(0, 0, "moon")),
                           PlanRouteResponse.INVALID_POSE)
        self.assert_answer(self.node.call("plan_route", goal_pose=pose_at(float("nan"), 0)),
                           PlanRouteResponse.INVALID_POSE)
        self.assert_answer(self.plan("a"), PlanRouteResponse.OK)

    def test_links_learn_what_is_reported(self):
        self.make_row()
        before = self.plan("a").route
        response = self.node.call("report_traversal", from_label="c", to_label="b",
                                  succeeded=False, source="teleop")
        self.assert_answer(response, ReportTraversalResponse.OK)
        self.assertLess(response.odds, 0.8)
        self.assertLess(self.plan("a").route.odds, before.odds)
        self.assertEqual(self.graph().links[1].backward.failed, 1)
        for request, status in ((dict(from_label="nowhere"), response.UNKNOWN_PLACE),
                                (dict(to_label="a"), response.UNKNOWN_LINK),
                                (dict(source="\x01"), response.INVALID)):
            asked = dict(from_label="c", to_label="b")
            asked.update(request)
            self.assert_answer(self.node.call("report_traversal", **asked), status)

    def test_a_person_forbids_blocks_and_frees_links(self):
        self.make_row()
        self.assert_answer(self.set_link(SetLinkRequest.FORBID), SetLinkResponse.OK)
        response = self.plan("a")
        self.assert_answer(response, PlanRouteResponse.NO_ROUTE)
        self.assertIn("forbid", response.message)
        self.assert_answer(self.set_link(SetLinkRequest.UNBLOCK), SetLinkResponse.OK)
        # From b on, because the way from c to b takes as long as this machine took to learn c.
        usual = self.plan("a", start_label="b").route
        response = self.set_link(SetLinkRequest.BLOCK)
        self.assertAlmostEqual(response.odds, 0.05, places=3)
        self.assertGreater(self.plan("a", start_label="b").route.cost, 2.0 * usual.cost)
        self.set_link(SetLinkRequest.UNBLOCK)
        self.assert_answer(self.set_link(SetLinkRequest.COST, cost=60.0), SetLinkResponse.OK)
        self.assertAlmostEqual(self.plan("a", start_label="b").route.cost, usual.cost + 60.0,
                               delta=1.0)
        self.assert_answer(self.set_link(SetLinkRequest.COST, cost=-1.0), SetLinkResponse.INVALID)
        self.assert_answer(self.set_link(9), SetLinkResponse.INVALID)


if __name__ == "__main__":
    live_test.main("live_routes_test", LiveRoutesTest)
