#!/usr/bin/env python3
"""The examples of README.md and doc/node.md that are marked as live work as printed, in their order."""

import os
import re
import subprocess

import rosgraph

import live_test

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
PAGES = ("README.md", os.path.join("doc", "node.md"))
EXAMPLES = re.compile(r"<!-- live -->\n```bash\n(.*?)```", re.DOTALL)
NODE = "/place_memory/"  # as the pages name it


def read_commands(node):
    """Every command, a string, with the node's own name."""
    examples = ""
    for page in PAGES:
        with open(os.path.join(ROOT, page), encoding="utf-8") as file:
            examples += "".join(EXAMPLES.findall(file.read()))
    commands = re.sub(r"\\\n\s*", "", examples).splitlines()
    return [command.replace(NODE, node + "/") for command in commands]


def has_subscriber(topic, prefix):
    _, subscriptions, _ = rosgraph.Master("/live_readme_test").getSystemState()
    return any(name.startswith(prefix) for subscribed, names in subscriptions
               for name in names if subscribed == topic)


class LiveReadmeTest(live_test.LiveTestCase):
    def start(self, command):
        process = subprocess.Popen(["bash", "-c", command], stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, universal_newlines=True)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def finish_command(self, command, process):
        self.run_robot(lambda: process.poll() is not None, command)
        output = process.stdout.read()
        self.assertEqual(process.returncode, 0, command + "\n" + output)
        self.assertNotIn("ERROR", output, command)
        if command.startswith("rosservice call") and "/make_plan " not in command:
            # A robot that is sure where it is needs no view: that is an answer.
            right = "[01]" if command.endswith("/suggest_view") else "0"
            self.assertRegex(output, r"(?m)^status: %s$" % right, command)
        return output

    def test_every_example_works_as_printed(self):
        self.start_node(store_directory=self.folder)
        commands = read_commands(self.node.name)
        called = {command.split()[2].rsplit("/", 1)[1] for command in commands
                  if command.startswith("rosservice call")}
        self.assertEqual(called, set(live_test.SERVICES))

        beside = None
        for command in commands:
            if command.endswith(" &"):
                command = "exec " + command[:-2]
                beside = command, self.start(command)
                topic = command.split()[-1]
                self.run_robot(lambda: has_subscriber(topic, "/rostopic"), command)
            elif command == "wait":
                self.assertIn("\n  status: 0\n", self.finish_command(*beside))
            else:
                self.finish_command(command, self.start("exec " + command))
        self.assertEqual(self.labels(), [])


if __name__ == "__main__":
    live_test.main("live_readme_test", LiveReadmeTest)
