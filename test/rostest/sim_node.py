"""A live sonar_sim_node for tests."""

import os
import subprocess

import rospy

import live_test


class SimNode:
    """A sonar_sim_node in a namespace of its own, and the newest of what it publishes."""

    count = 0

    def __init__(self, folder, **parameters):
        SimNode.count += 1
        self.namespace = "/sim_%d" % SimNode.count
        for name, value in parameters.items():
            rospy.set_param(self.namespace + "/sonar_sim/" + name.replace("__", "/"), value)
        self.log = os.path.join(folder, self.namespace[1:] + ".log")
        with open(self.log, "w") as file:
            self.process = subprocess.Popen(
                [live_test.executable("sonar_sim_node"), "__ns:=" + self.namespace,
                 "__name:=sonar_sim"], stdout=file, stderr=subprocess.STDOUT)

    def output(self):
        with open(self.log) as file:
            return file.read()

    def name(self, name):
        return self.namespace + "/" + name.replace("~", "sonar_sim/")

    def message(self, name, message_type):
        return rospy.wait_for_message(self.name(name), message_type, live_test.PATIENCE)

    def call(self, service, service_type, *arguments, **named):
        rospy.wait_for_service(self.name("~" + service), live_test.PATIENCE)
        return rospy.ServiceProxy(self.name("~" + service), service_type)(*arguments, **named)

    def stop(self):
        if self.process.poll() is None:
            self.process.terminate()
        return self.process.wait(live_test.PATIENCE)
