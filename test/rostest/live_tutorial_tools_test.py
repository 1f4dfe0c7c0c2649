#!/usr/bin/env python3
"""The commands of the tutorials on navigation stacks and on bags work as printed."""

import live_test
from tutorial_page import TutorialTestCase


class LiveTutorialToolsTest(TutorialTestCase):
    def test_tutorial_3(self):
        said = self.run_page("tutorial_3.md")
        self.assertIn("charger", said["rosservice call /relocalizer/relocalize '{}'"])
        self.assertIn("frame_id: \"map\"", said["rostopic echo -n1 /initialpose"])

    def test_tutorial_4(self):
        said = self.run_page("tutorial_4.md")
        self.assertIn("learn,ok", said["cat results.csv"])
        self.assertIn("recognized,laboratory", said["cat results.csv"])


if __name__ == "__main__":
    live_test.main("live_tutorial_tools_test", LiveTutorialToolsTest)
