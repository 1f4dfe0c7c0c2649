#!/usr/bin/env python3
"""The commands of the tutorials on a robot, simulated and one's own, work as printed."""

import live_test
from tutorial_page import TutorialTestCase


class LiveTutorialRobotTest(TutorialTestCase):
    def test_tutorial_1(self):
        said = self.run_page("tutorial_1.md")
        answer = said["rosservice call /place_memory/recognize_place '{}'"]
        first = answer.split("matches:")[1].split("- ")[1]
        self.assertIn('label: "laboratory"', first)
        self.assertGreater(float(first.split("probability:")[1].split()[0]), 0.5)

    def test_tutorial_2(self):
        self.run_page("tutorial_2.md")


if __name__ == "__main__":
    live_test.main("live_tutorial_robot_test", LiveTutorialRobotTest)
