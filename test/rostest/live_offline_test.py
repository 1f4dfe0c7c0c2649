#!/usr/bin/env python3
"""A live node and place_memory_bag come to the same from the same bag."""

import csv
import math
import os
import subprocess

from place_memory.msg import Recognition
import rosbag

import live_test
from room_bag import RoomBag

VERDICTS = {Recognition.RECOGNIZED: "recognized", Recognition.AMBIGUOUS: "ambiguous",
            Recognition.UNKNOWN: "unknown"}
# Messages are played in parts no longer than this, since a heading that is stamped a second ahead
# of the clock is left out [s].
PART = 0.8
TF_TIMEOUT = 10.0  # [s]
# Headings have a topic of their own. The newest may be on its way yet when the last reading ends a
# live scan, and is missing in the mean by which the compass lays the grid.
SCORES_DIFFER = 0.01  # at most, as a share
POSES_DIFFER = 0.01   # [m], [rad]


def yaw_of(pose):
    return 2.0 * math.atan2(pose.orientation.z, pose.orientation.w)


class LiveOfflineTest(live_test.LiveTestCase):
    def offline(self, bag, events):
        """What the tool writes: a row for each event."""
        parameters = os.path.join(self.folder, "parameters.yaml")
        with open(parameters, "w") as file:
            file.write("scan: {tf_timeout: %s, heading_timeout: 3.0}\n" % TF_TIMEOUT)
        results = os.path.join(self.folder, "results.csv")
        subprocess.run([live_test.executable("place_memory_bag"), "--bag", bag, "--events", events,
                        "--out", results, "--params", parameters],
                       check=True, timeout=live_test.PATIENCE)
        with open(results) as file:
            return list(csv.DictReader(file))

    def publish(self, topic, message):
        {"/sonar": self.robot.sonar, "/heading": self.robot.heading,
         "/tf": self.world.tf}[topic].publish(message)

    def play(self, messages, scan):
        """Every message at its time. At the end of a part, and before the last message, time waits
        until the node has used what it can."""
        usable = 0
        part_ends = messages[0].timestamp.to_sec() + PART

        def is_used():
            return scan.is_over() or (scan.feedback[-1].readings == usable
                                      and scan.node_time > self.world.now - 1e-6)

        for topic, message, stamp in messages:
            is_next_part = stamp.to_sec() > part_ends and topic == "/tf"
            if is_next_part or message is messages[-1].message:
                self.hold(is_used, "%d readings to be used" % usable)
                part_ends = stamp.to_sec() + PART
            self.world.set_time(stamp.to_sec())
            self.publish(topic, message)
            usable += topic == "/sonar" and not math.isnan(message.range)
        self.hold(is_used, "%d readings to be used" % usable)

    def live_scan(self, bag, event):
        self.world.set_time(event.start)
        scan = self.begin_scan()
        self.hold(lambda: scan.feedback and scan.node_time > event.start - 1e-6,
                  "the scan to begin")
        self.play([message for message in bag.read_messages()
                   if event.start <= message.timestamp.to_sec() <= event.end], scan)
        # Where the last reading was of no use, the sweep ends because nothing comes any more.
        self.world.set_time(event.end)
        self.hold(scan.is_over, "the scan to end")
        self.assertEqual(scan.result().status, scan.result().SUCCEEDED, scan.result().message)

    def compare_recognition(self, event, row):
        response = self.node.call("recognize_place", heading_window=event.window or 0.0)
        self.assertEqual(response.status, response.OK, response.message)
        found = response.recognition
        best = found.matches[0]
        self.assertEqual((best.label, VERDICTS[found.verdict]), (row["place"], row["verdict"]))
        score = float(row["score"])
        self.assertAlmostEqual(best.score, score, delta=SCORES_DIFFER * abs(score))
        self.assertAlmostEqual(best.probability, float(row["probability"]), delta=SCORES_DIFFER)
        pose = found.pose.pose
        self.assertAlmostEqual(pose.position.x, float(row["x"]), delta=POSES_DIFFER)
        self.assertAlmostEqual(pose.position.y, float(row["y"]), delta=POSES_DIFFER)
        turned = math.remainder(yaw_of(pose) - float(row["yaw"]), 2.0 * math.pi)
        self.assertAlmostEqual(turned, 0.0, delta=POSES_DIFFER)
        return best.label == event.label

    def test_places_and_scores_are_the_same(self):
        path = os.path.join(self.folder, "rooms.bag")
        rooms = RoomBag(path, start=self.world.now + 100.0, seed=3)
        events = os.path.join(self.folder, "events.csv")
        rooms.write_events(events)
        rows = self.offline(path, events)
        self.assertEqual([row["status"] for row in rows], ["ok"] * len(rooms.events))

        self.start_node(scan__tf_timeout=TF_TIMEOUT)
        right = []
        with rosbag.Bag(path) as bag:
            for event, row in zip(rooms.events, rows):
                self.live_scan(bag, event)
                if event.action == "learn":
                    learned = self.node.call("learn_place", label=event.label)
                    self.assertEqual((learned.status, learned.label),
                                     (learned.OK, row["place"]))
                else:
                    right.append(self.compare_recognition(event, row))
        self.assertGreaterEqual(sum(right), 4, right)


if __name__ == "__main__":
    live_test.main("live_offline_test", LiveOfflineTest)
