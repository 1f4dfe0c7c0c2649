#!/usr/bin/env python3
"""The rviz panel beside a live node: what its buttons do, and what it says while the node is away."""

import os
import signal
import time

import live_test
from fake_drive import FakeDrive
from fake_robot import STEP
from panel import Panel, PanelError

HELD = 1.0  # the thread that draws is held no longer, also on a machine with much to do [s]


class LivePanelTest(live_test.LiveTestCase):
    def start(self, **parameters):
        self.start_node(**parameters)
        self.panel = Panel(os.path.join(self.folder, "panel.log"))
        self.addCleanup(self.panel.close)
        self.panel.ask("node", self.node.name)
        self.wait_for_button("scan")

    def _step(self):
        """Nothing holds simulated time back for the panel: it goes no faster than the clock."""
        super()._step()
        time.sleep(STEP)

    def fail(self, message=None):
        super().fail("%s\nthe panel says \"%s\"; %s; greyed: \"%s\", \"%s\"" % (
            message, self.panel.shows("note"), self.panel.shows("progress"),
            self.panel.greyed("scan"), self.panel.greyed("go_to")))

    def wait_for_button(self, name):
        self.hold(lambda: not self.panel.greyed(name), name + " to be enabled")

    def wait_for(self, widget, words):
        self.hold(lambda: words in self.panel.shows(widget), "%s in %s" % (words, widget))

    def scan_by_panel(self):
        """At a standstill, as the parameter says."""
        self.wait_for_button("scan")
        self.panel.click("scan")
        self.run_robot(lambda: "readings" in self.panel.shows("note")
                       and not self.panel.greyed("scan"), "the scan to end")

    def learn_by_panel(self, label):
        self.scan_by_panel()
        self.panel.ask("type", "label", label)
        self.panel.click("learn")
        self.wait_for("note", "learned \"%s\"" % label)

    def start_again(self):
        """The same node by the same name."""
        self.node = live_test.Node(self.node.name.rpartition("/")[0], {}, self.node.log)
        self.addCleanup(self.node.stop)

    def test_a_place_is_learned_recognized_renamed_and_removed(self):
        self.start(scan__headings=1)
        self.learn_by_panel("hall")
        self.wait_for("places", "hall")
        self.assertEqual(self.labels(), ["hall"])

        self.scan_by_panel()
        self.panel.click("recognize")
        self.wait_for("verdict", "\"hall\"")
        self.assertIn("hall", self.panel.shows("matches"))

        self.assertEqual(self.panel.greyed("rename"), "choose a place in the list")
        self.panel.ask("choose", "hall")
        self.panel.click("rename")
        self.panel.ask("edit", "lobby")
        self.wait_for("places", "lobby")
        self.assertEqual(self.labels(), ["lobby"])

        self.panel.ask("choose", "lobby")
        self.panel.click("remove")
        self.panel.ask("yes")
        self.hold(lambda: self.panel.shows("places") == "", "the place to go")
        self.assertEqual(self.labels(), [])
        self.assertEqual(self.panel.close(), 0)

    def test_what_the_node_refuses_is_said(self):
        self.start()
        self.panel.click("learn")
        self.wait_for("note", "scan")
        self.assertEqual(self.panel.greyed("learn"), "")
        self.assertEqual(self.labels(), [])

    def test_a_scan_can_be_canceled(self):
        self.start()
        self.panel.click("scan")
        self.run_robot(lambda: self.panel.shows("progress").startswith("scan"), "the scan")
        self.panel.click("cancel")
        self.run_robot(lambda: not self.panel.greyed("scan"), "the scan to end")
        self.assertIn("scan: ", self.panel.shows("note"))

    def drive(self):
        """The panel beside a node that drives."""
        self.node = drive = FakeDrive("/drive_%d" % os.getpid())
        self.panel = Panel(os.path.join(self.folder, "panel.log"))
        self.addCleanup(self.panel.close)
        self.panel.ask("node", drive.name)
        self.wait_for("places", "hall")
        return drive

    def test_the_robot_is_sent_to_a_place_and_explores(self):
        drive = self.drive()
        self.assertEqual(self.panel.greyed("go_to"), "choose a place in the list")
        self.assertIn("does not offer ~scan", self.panel.greyed("scan"))
        self.panel.ask("choose", "hall")
        self.panel.click("go_to")
        self.wait_for("note", "to the hall; goes; 2 legs and some 30 s left")
        self.assertEqual([goal.label for goal in drive.go_to_place.goals], ["hall"])
        self.assertEqual(self.panel.greyed("go_to"), "~go_to_place is under way")
        drive.go_to_place.finish()
        self.wait_for("note", "go_to_place: the robot is at the hall")
        self.assertEqual(self.panel.greyed("go_to"), "")

        self.panel.click("explore")
        self.wait_for("note", "looks round; 3 places made, 2 openings to be seen, 12 m driven")
        self.panel.click("cancel")
        self.wait_for("note", "explore: it was canceled")
        self.assertEqual(len(drive.explore.goals), 1)

    def test_it_is_greyed_while_the_node_is_away_and_back_after_its_restart(self):
        self.start()
        self.panel.longest_hold()
        self.node.kill()
        self.hold(lambda: self.panel.greyed("scan"), "the panel to be greyed")
        self.assertIn("does not run", self.panel.greyed("learn"))
        self.assertIn("does not run", self.panel.shows("presence"))
        with self.assertRaises(PanelError):
            self.panel.click("recognize")

        self.start_again()
        self.wait_for_button("scan")
        self.wait_for_button("learn")
        self.panel.click("recognize")
        self.wait_for("note", "no scan")
        self.assertLess(self.panel.longest_hold(), HELD)

    def test_a_node_that_hangs_holds_nothing_up(self):
        self.start()
        self.panel.longest_hold()
        self.node.process.send_signal(signal.SIGSTOP)
        try:
            self.panel.click("learn")
            self.wait_for("note", "has not answered within")
            self.assertLess(self.panel.longest_hold(), HELD)
        finally:
            self.node.process.send_signal(signal.SIGCONT)
        self.wait_for_button("learn")

    def test_the_node_is_remembered(self):
        self.start()
        path = os.path.join(self.folder, "panel.yaml")
        self.panel.ask("save", path)
        self.panel.ask("node", "/elsewhere")
        self.wait_for("presence", "/elsewhere does not run")
        self.panel.ask("load", path)
        self.wait_for_button("scan")
        self.assertEqual(self.panel.shows("node"), self.node.name)


if __name__ == "__main__":
    live_test.main("live_panel_test", LivePanelTest)
