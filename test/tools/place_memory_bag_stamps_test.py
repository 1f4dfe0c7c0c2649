#!/usr/bin/env python3
"""Header stamps rule in place_memory_bag: whatever recorded the bag, and into how many parts.

usage: place_memory_bag_stamps_test.py PLACE_MEMORY_BAG [UNITTEST OPTION]...
"""

import os
import random
import unittest

import rosbag
import rospy

import bag_tool
from bag_tool import ALL, HEADER, START


class StampsTest(bag_tool.BagToolTest):
    def test_relative_times_count_from_the_first_header_stamp(self):
        skewed = self.skewed(30.0)
        first = self.rooms.events[0]
        begin = START - 1.0
        events = HEADER + "+%.3f,+%.3f,learn,a,\n" % (first.start - begin, first.end - begin)
        answer = self.run_events(events, bag=skewed)
        self.assertEqual(answer.returncode, ALL, answer.stderr)
        self.assertEqual(float(self.rows()[0]["start"]), first.start)

    def test_the_clock_of_the_recorder_makes_no_difference(self):
        right = self.answers_of(self.bag)
        for offset in (-300.0, -30.0, -8.0, -1.2, -0.9, 1.0, 1.6, 4.0, 30.0, 1e6):
            with self.subTest(offset=offset):
                said = "%.2f s %s the header stamps" % (
                    abs(offset), "ahead of" if offset > 0.0 else "behind")
                self.assertEqual(self.answers_of(self.skewed(offset), said=[said]), right)

    def test_a_recorder_that_is_held_up_makes_no_difference(self):
        """As where a slow disk or network delivers in bursts of four seconds."""
        def hold_up(topic, message, stamp):
            seconds = stamp.to_sec()
            return topic, message, rospy.Time.from_sec(4.0 * (seconds // 4.0 + 1.0))
        right = self.answers_of(self.bag)
        rng = random.Random(5)
        records = [hold_up(*record) for record in rosbag.Bag(self.bag).read_messages()]
        bursts = self.path("bursts.bag")
        with rosbag.Bag(bursts, "w") as bag:
            # Of each burst each topic comes in its own order.
            order = {"/sonar": rng.random(), "/heading": rng.random(), "/tf": rng.random()}
            for record in sorted(records, key=lambda record: (record[2], order.get(record[0], 0))):
                bag.write(*record)
        self.rooms.write_events(self.path("all.csv"))
        answer = self.run_tool("--bag", bursts, "--events", self.path("all.csv"), "--out", self.out)
        self.assertEqual(answer.returncode, ALL, answer.stderr)
        rows = self.rows()
        for row, expected in zip(rows, right):
            del row["match_ms"]
            self.assertEqual(row, expected)

    def test_tf_of_the_old_type_and_topics_without_slash(self):
        def change(topic, message, stamp):
            return topic.lstrip("/"), message, stamp
        right = self.answers_of(self.bag)
        self.assertEqual(self.answers_of(self.copy_bag("plain.bag", change)), right)
        old = self.path("old.bag")
        with rosbag.Bag(old, "w") as bag:
            for topic, message, stamp in rosbag.Bag(self.bag).read_messages(raw=True):
                kind, data, md5sum, position, cls = message
                if topic == "/tf":
                    kind = "tf/tfMessage"
                header = {"topic": topic, "type": kind, "md5sum": md5sum,
                          "message_definition": cls._full_text}
                bag.write(topic, (kind, data, md5sum, position, cls), stamp, raw=True,
                          connection_header=header)
        self.assertEqual(rosbag.Bag(old).get_type_and_topic_info().topics["/tf"].msg_type,
                         "tf/tfMessage")
        self.assertEqual(self.answers_of(old), right)
        parameters = self.write("my.yaml", "sonar_topics: [/sonar]\nheading_topic: /heading\n")
        answer = self.run_events(HEADER + self.learn(self.rooms.events[0]), "--params", parameters)
        self.assertEqual(answer.returncode, ALL, answer.stderr)

    def test_one_stale_stamp_is_left_out_and_its_sensor_named(self):
        first = self.rooms.events[0]
        changed = []

        def change(topic, message, stamp):
            if topic == "/sonar" and stamp.to_sec() > first.start + 1.0 and not changed:
                changed.append(message.header.frame_id)
                message.header.stamp = rospy.Time(2)
            return topic, message, stamp
        bag = self.copy_bag("stale.bag", change)
        answer = self.run_events(HEADER + self.learn(first), bag=bag)
        self.assertEqual(answer.returncode, ALL, answer.stderr)
        self.assertIn("reading of %s left out" % changed[0], answer.stderr)
        self.assertNotIn("recorder", answer.stderr)

    def test_a_sensor_with_a_clock_of_its_own_is_named(self):
        def change(topic, message, stamp):
            if topic == "/sonar" and message.header.frame_id == "sonar_3":
                message.header.stamp += rospy.Duration(5)
            return topic, message, stamp
        answer = self.run_events(HEADER + self.learn(self.rooms.events[0]),
                                 bag=self.copy_bag("stray.bag", change))
        self.assertEqual(answer.returncode, ALL, answer.stderr)
        self.assertIn("on /sonar of frame 'sonar_3' is stamped 5.00 s after the others",
                      answer.stderr)

    def test_several_bags_are_read_as_one(self):
        right = self.answers_of(self.bag)
        # Cut within a scan; the second part is recorded by another clock.
        middle = self.rooms.events[4].start + 2.0
        first = self.copy_bag("first.bag", lambda topic, message, stamp:
                              (topic, message, stamp) if stamp.to_sec() < middle else None)
        second = self.copy_bag("second.bag", lambda topic, message, stamp:
                               (topic, message, stamp + rospy.Duration(7))
                               if stamp.to_sec() >= middle else None)
        said = ["second.bag the recorder's clock is 7.00 s ahead of"]
        self.assertEqual(self.answers_of(first, second, said=said), right)
        self.assertEqual(self.answers_of(second, first, said=said), right)
        # The second begins before the first ends.
        early = self.rooms.events[3].start
        second = self.copy_bag("second.bag", lambda topic, message, stamp:
                               (topic, message, stamp)
                               if topic == "/tf_static" or stamp.to_sec() >= early else None)
        self.assertEqual(self.answers_of(first, second, said=["overlap by"]), right)
        events = HEADER + self.learn(self.rooms.events[0])
        os.remove(self.out)
        answer = self.run_events(events, "--bag", self.path("none.bag"))
        self.assert_refused(answer, "none.bag")


if __name__ == "__main__":
    unittest.main()
