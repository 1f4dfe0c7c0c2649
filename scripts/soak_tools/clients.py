"""Clients that ask the node for something again and again, and remember what it acknowledged."""

import random
import threading
import time

import actionlib
import rospy
from place_memory import msg, srv

from soak_tools.node import NAME

PATIENCE = 60.0  # a call that takes longer is not answered [s]
OWN_PLACES = 4  # of each client that learns, at the most


class Client(threading.Thread):
    """`watch` is told what came of each call."""

    def __init__(self, number, node, watch, pace):
        super().__init__(daemon=True)
        self.number = number
        self.node = node
        self.watch = watch
        self.pace = pace  # mean time between two calls [s]
        self.random = random.Random(number)
        self.busy_since = None
        self.is_over = False

    def run(self):
        while not self.is_over:
            time.sleep(min(self.random.expovariate(1.0 / self.pace), 5.0 * self.pace))
            if not self.is_over:
                self.act()

    def waits_for_ever(self):
        since = self.busy_since
        return since is not None and time.monotonic() - since > PATIENCE

    def call(self, name, service, **request):
        """The response, or None where the node was being killed."""
        self.busy_since = begin = time.monotonic()
        try:
            response = rospy.ServiceProxy(NAME + "/" + name, service)(**request)
        except (rospy.ServiceException, rospy.ROSException, OSError) as error:
            if not self.node.is_disturbed(begin):
                self.watch.fail("%s: %s" % (name, error))
            return None
        finally:
            self.busy_since = None
        self.watch.took(name, time.monotonic() - begin)
        if hasattr(response, "status"):
            self.judge(name, response, begin)
        return response

    def judge(self, name, response, begin):
        """Whatever is asked for, nothing fails in the node itself, nor on a disk with room."""
        self.watch.count("%s status %d" % (name, response.status))
        failures = {getattr(response, "FAILED", None)}
        if not self.node.disk_was_full(begin):
            failures.add(getattr(response, "STORE_FAILED", None))
        if response.status in failures:
            self.watch.fail("%s: %s" % (name, response.message))

    def act(self):
        raise NotImplementedError


class Scanner(Client):
    """Has the node scan; a goal of another scanner may end its own."""

    def act(self):
        self.busy_since = begin = time.monotonic()
        client = actionlib.SimpleActionClient(NAME + "/scan", msg.ScanPlaceAction)
        try:
            if not client.wait_for_server(rospy.Duration(20.0)):
                return
            client.send_goal(msg.ScanPlaceGoal(headings=1))
            ended = client.wait_for_result(rospy.Duration(PATIENCE))
            if not ended and not self.node.is_disturbed(begin):
                self.watch.fail("a goal of ~scan did not end")
            if ended and client.get_result() is not None:
                self.watch.took("scan", time.monotonic() - begin)
                self.watch.count("scan status %d" % client.get_result().status)
        finally:
            client.stop_tracking_goal()
            self.busy_since = None


class Recognizer(Client):
    def act(self):
        self.call("recognize_place", srv.RecognizePlace)


class Reader(Client):
    def act(self):
        if self.random.random() < 0.5:
            self.call("list_places", srv.ListPlaces)
            return
        response = self.call("get_graph", srv.GetGraph)
        if response is not None:
            self.watch.graph(response.graph)


class Learner(Client):
    """Learns places under labels of its own, and forgets the oldest."""

    def __init__(self, *arguments):
        super().__init__(*arguments)
        self.known = []
        self.in_doubt = set()  # where the node was killed before it answered
        self.count = 0
        self.epoch = 0  # of upheavals, since when it knows of all its places

    def act(self):
        chance = self.random.random()
        if chance < 0.2:
            self.check()
        elif len(self.known) >= OWN_PLACES or (self.known and chance < 0.3):
            self.change("remove_place", srv.RemovePlace, [self.known[0]], [], label=self.known[0])
        elif self.known and chance < 0.4:
            label, new_label = self.known[-1], self.label()
            self.change("rename_place", srv.RenamePlace, [label], [new_label], label=label,
                        new_label=new_label)
        else:
            label = self.label()
            self.change("learn_place", srv.LearnPlace, [], [label], label=label)

    def label(self):
        self.count += 1
        return "%d: %d" % (self.number, self.count)

    def change(self, name, service, gone, new, **request):
        response = self.call(name, service, **request)
        if response is None:
            self.in_doubt.update(gone + new)
            self.known = [label for label in self.known if label not in gone]
        elif response.status == response.OK:
            self.known = [label for label in self.known if label not in gone] + new

    def check(self):
        """What was acknowledged is there, and nothing else of this client; but for upheavals."""
        before = self.watch.upheavals.epoch()
        response = self.call("list_places", srv.ListPlaces)
        if response is None or before is None or before != self.watch.upheavals.epoch():
            return
        own = [place.label for place in response.places
               if place.label.startswith("%d: " % self.number)]
        if before == self.epoch:
            lost = set(self.known) - set(own)
            strange = set(own) - set(self.known) - self.in_doubt
            if lost or strange:
                self.watch.fail("lost %s, not learned %s" % (sorted(lost), sorted(strange)))
            self.watch.count("looked whether all is there")
        self.epoch = before
        self.known = own
        self.in_doubt.clear()
