"""The commands of a tutorial, run as printed, in the order of the page."""

import os
import re
import subprocess
import tempfile
import time
import unittest

import rosgraph
import rospy

import live_test

DOC = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "doc")
EXAMPLES = re.compile(r"<!-- live -->\n```bash\n(.*?)```", re.DOTALL)
SERVERS = ("roslaunch ", "rosrun place_memory relocalizer.py")  # run until the end of the page
STARTED = "/place_memory/list_places"  # once this is offered, a launch file has started the node
RELOCALIZE = "/relocalizer/relocalize"
RESULT = re.compile(r"rostopic echo \S+ \S+/result$")


def read_commands(page):
    with open(os.path.join(DOC, page), encoding="utf-8") as file:
        return re.sub(r"\\\n\s*", "", "".join(EXAMPLES.findall(file.read()))).splitlines()


class TutorialTestCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.beside = None

    def start(self, command):
        log = open(os.path.join(self.folder, "log.%d" % time.monotonic_ns()), "w+")
        process = subprocess.Popen(["bash", "-c", command], cwd=self.folder, stdout=log,
                                   stderr=subprocess.STDOUT)
        process.log = log
        self.addCleanup(log.close)
        self.addCleanup(self.stop, process)
        return process

    def stop(self, process):
        if process.poll() is None:
            process.terminate()
        process.wait(live_test.PATIENCE)

    def output(self, process):
        process.log.seek(0)
        return process.log.read()

    def finish(self, command, process):
        process.wait(live_test.PATIENCE)
        output = self.output(process)
        self.assertEqual(process.returncode, 0, command + "\n" + output)
        if command.startswith(("rosservice", "rostopic")):
            self.assertNotIn("ERROR", output, command)
        if command.startswith("rosservice call"):
            self.assertRegex(output, r"(?m)^status: 0$", command)
        if RESULT.search(command):
            self.assertIn("\n  status: 0\n", output, command)
        return output

    def run_page(self, page):
        """{command: what it said last}."""
        said = {}
        for command in read_commands(page):
            if command.startswith(SERVERS):
                self.start_server(command)
            elif command.endswith(" &"):
                self.begin_beside(command[:-2])
            elif command == "wait":
                said[self.beside[0]] = self.finish(*self.beside)
            else:
                said[command] = self.finish(command, self.start(command))
        return said

    def start_server(self, command):
        launched = command.startswith("roslaunch ")
        self.start("exec " + command + (" rviz:=false" if launched else ""))
        rospy.wait_for_service(STARTED if launched else RELOCALIZE, live_test.PATIENCE)

    def begin_beside(self, command):
        self.beside = command, self.start("exec " + command)
        topic = re.search(r"rostopic echo \S+ (\S+)", command)
        deadline = time.monotonic() + live_test.PATIENCE
        while topic and not self.is_heard(topic.group(1)):
            self.assertLess(time.monotonic(), deadline, command)
            time.sleep(0.05)

    def is_heard(self, topic):
        _, subscriptions, _ = rosgraph.Master("/tutorial_page").getSystemState()
        return any(name.startswith("/rostopic") for subscribed, names in subscriptions
                   for name in names if subscribed == topic)
