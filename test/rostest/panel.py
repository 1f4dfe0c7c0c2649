"""The rviz panel in a process of its own, whose buttons a test presses."""

import os
import subprocess

import live_test


class PanelError(Exception):
    """What was asked of the panel could not be done."""


class Panel:
    """No window is shown, and no display is needed."""

    def __init__(self, log):
        self._log = open(log, "w")
        self._process = subprocess.Popen(
            [live_test.executable("panel_driver")], stdin=subprocess.PIPE,
            stdout=subprocess.PIPE, stderr=self._log, universal_newlines=True,
            env=dict(os.environ, QT_QPA_PLATFORM="offscreen"))

    def ask(self, *words):
        self._process.stdin.write(" ".join(words) + "\n")
        self._process.stdin.flush()
        answer = ""
        while not answer.startswith(("ok ", "failed ")):  # ROS writes there too
            answer = self._process.stdout.readline()
            if not answer:
                raise PanelError("the panel is gone, with status %s" % self._process.wait(10))
        verb, _, rest = answer.rstrip("\n").partition(" ")
        if verb == "failed":
            raise PanelError(rest)
        return rest

    def click(self, button):
        self.ask("click", button)

    def greyed(self, widget):
        """Why; empty: it is not."""
        return self.ask("greyed", widget)

    def shows(self, widget):
        return self.ask("show", widget)

    def longest_hold(self):
        """For which its thread did not come to its events, since it was asked last [s]."""
        return self.longest_holds()[0]

    def longest_holds(self):
        """That, and how long at once the thread was at work itself [s]. On a machine with more to
        do than it can, the first has others' work in it."""
        held, worked = self.ask("held").split()
        return int(held) / 1000.0, int(worked) / 1000.0

    def close(self):
        """Its exit status."""
        self._process.stdin.close()
        status = self._process.wait(live_test.PATIENCE)
        self._process.stdout.close()
        self._log.close()
        return status
