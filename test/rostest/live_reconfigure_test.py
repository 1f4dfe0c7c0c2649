#!/usr/bin/env python3
"""Parameters that change while the node runs, by dynamic_reconfigure, and what it leaves for the
next start."""

import os
import subprocess

import rospy
from dynamic_reconfigure.client import Client

import live_test
import sonar_room

NEARLY_SURE = 1.0 - 1e-12


class LiveReconfigureTest(live_test.LiveTestCase):
    def client(self, table):
        client = Client(self.node.name + "/" + table, timeout=live_test.PATIENCE)
        self.addCleanup(client.close)
        return client

    def param(self, name):
        return rospy.get_param(self.node.name + "/" + name)

    def test_what_holds_at_the_start_is_what_clients_see(self):
        self.start_node(match__confidence=0.505, match__method="hill_climbing",
                        places__retention=0.25, match__heading_window=1)
        match = self.client("match").get_configuration()
        self.assertEqual(match["confidence"], 0.505)
        self.assertEqual(match["method"], "hill_climbing")
        self.assertEqual(match["heading_window"], 1.0)
        self.assertEqual(match["position_window"], 1.2)
        places = self.client("places").get_configuration()
        self.assertEqual((places["adapt"], places["retention"]), (False, 0.25))

    def test_a_scan_is_recognized_by_what_holds_then(self):
        self.start_node(match__confidence=0.51)
        self.learn("hall", sonar_room.HALL)
        self.learn("study", sonar_room.STUDY)
        self.robot.enter(sonar_room.HALL)
        self.scan_well()
        before = self.node.call("recognize_place").recognition
        self.assertEqual(before.verdict, before.RECOGNIZED)
        best = before.matches[0].probability
        self.assertLess(best, NEARLY_SURE)
        self.client("match").update_configuration({"confidence": NEARLY_SURE})
        after = self.node.call("recognize_place").recognition
        self.assertNotEqual(after.verdict, after.RECOGNIZED)

    def test_places_adapt_from_then_on(self):
        self.start_node(match__confidence=0.51)
        self.learn("hall", sonar_room.HALL)
        self.client("places").update_configuration({"adapt": True, "retention": 0.4})
        self.scan_well()
        self.node.call("recognize_place")
        self.wait(lambda: "folded" in self.node.output() or "adapted" in self.node.output(),
                  "the scan to be folded")

    def test_a_word_for_no_echo_holds_from_the_next_message_on(self):
        self.start_node(match__confidence=0.51, sonar__top_is_no_echo=False)
        self.assertFalse(self.client("sonar").get_configuration()["top_is_no_echo"])
        self.client("sonar").update_configuration({"top_is_no_echo": True})
        self.assertTrue(self.param("sonar/top_is_no_echo"))
        self.robot.edit_range = lambda sensor, message: (
            setattr(message, "range", message.max_range) or message)
        self.scan_well()
        self.wait(lambda: "sonar/top_is_no_echo" in self.node.output(), "the warning")

    def test_without_a_compass_any_heading_is_sought(self):
        self.node = live_test.Node("/compassless", {"heading_topic": ""},
                                   os.path.join(self.folder, "compassless.log"))
        self.addCleanup(self.node.stop)
        self.node.wait_for_services()
        match = self.client("match")
        answer = match.update_configuration({"heading_window": 0.5, "confidence": 0.9})
        self.assertGreater(answer["heading_window"], 3.14)
        self.assertEqual(answer["confidence"], 0.82)
        self.wait(lambda: "heading_topic" in self.node.output(), "the reason")

    def test_what_a_start_would_refuse_is_refused_with_the_reason(self):
        self.start_node()
        match, places = self.client("match"), self.client("places")
        for client, change, word in ((match, {"confidence": 1.0}, "match/confidence"),
                                     (match, {"confidence": 0.9, "method": "guess"},
                                      "match/method"),
                                     (match, {"position_window": 0.0}, "match/position_window"),
                                     (places, {"retention": 1.0}, "places/retention")):
            with self.subTest(change=change):
                kept = client.get_configuration()
                answer = client.update_configuration(change)
                for name in change:
                    self.assertEqual(answer[name], kept[name])
                self.wait(lambda: word in self.node.output(), "the reason")
        self.assertEqual(self.param("match/confidence"), 0.82)
        self.assertEqual(self.param("match/method"), "restarts")

    def test_a_dump_starts_the_same_node(self):
        self.start_node(match__heading_window="pi/2")
        self.client("match").update_configuration({"confidence": 0.93, "heading_window": 3.1415926})
        self.client("places").update_configuration({"adapt": True})
        dump = os.path.join(self.folder, "dump.yaml")
        subprocess.run(["rosparam", "dump", dump, self.node.name], check=True)
        subprocess.run(["rosparam", "load", dump, "/again/place_memory"], check=True)
        again = live_test.Node("/again", {}, os.path.join(self.folder, "again.log"))
        self.addCleanup(again.stop)
        again.wait_for_services()
        self.assertEqual(rospy.get_param("/again/place_memory"), rospy.get_param(self.node.name))
        self.node.stop()
        self.assertEqual(rospy.get_param("/again/place_memory/match/confidence"), 0.93)


if __name__ == "__main__":
    live_test.main("live_reconfigure_test", LiveReconfigureTest)
