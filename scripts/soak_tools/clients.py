"""Clients that ask the node for something again and again, and remember what it acknowledged."""

import math
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
        return response

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
            ended = client.wait_for_result(rospy.Duration(30.0))
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
        response = self.call("recognize_place", srv.RecognizePlace)
        if response is None:
            return
        self.watch.count("recognize status %d" % response.status)
        if response.status == response.FAILED:
            self.watch.fail("recognize_place: " + response.message)


class Reader(Client):
    def act(self):
        if self.random.random() < 0.5:
            self.call("list_places", srv.ListPlaces)
            return
        response = self.call("get_graph", srv.GetGraph)
        if response is not None:
            self.watch.places(len(response.graph.places))


class Learner(Client):
    """Learns places under labels of its own, and forgets the oldest."""

    def __init__(self, *arguments):
        super().__init__(*arguments)
        self.known = []
        self.in_doubt = set()  # where the node was killed before it answered
        self.count = 0

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
        begin = time.monotonic()
        response = self.call(name, service, **request)
        if response is None:
            self.in_doubt.update(gone + new)
            self.known = [label for label in self.known if label not in gone]
            return
        self.watch.count("%s status %d" % (name, response.status))
        if response.status == response.OK:
            self.known = [label for label in self.known if label not in gone] + new
        elif response.status == response.STORE_FAILED and begin > self.node.disk_full_until:
            self.watch.fail("%s: %s" % (name, response.message))

    def check(self):
        """What was acknowledged is there, and nothing else of this client."""
        response = self.call("list_places", srv.ListPlaces)
        if response is None:
            return
        own = {place.label for place in response.places
               if place.label.startswith("%d: " % self.number)}
        lost = set(self.known) - own
        strange = own - set(self.known) - self.in_doubt
        if lost or strange:
            self.watch.fail("lost %s, not learned %s" % (sorted(lost), sorted(strange)))
        self.watch.count("looked whether all is there")
        for label in self.in_doubt & own:
            self.known.insert(0, label)
        self.in_doubt.clear()


class Fool(Client):
    """Asks for what makes no sense; each is answered with a status that is not OK."""

    def act(self):
        asked = self.random.choice([
            ("learn_place", srv.LearnPlace, {"label": "x" * 1000000}),
            ("learn_place", srv.LearnPlace, {"label": " \n\x00"}),
            ("learn_place", srv.LearnPlace, {"label": "a", "scan_id": 2 ** 64 - 1}),
            ("recognize_place", srv.RecognizePlace, {"heading_window": math.nan}),
            ("recognize_place", srv.RecognizePlace, {"heading_window": -1e300}),
            ("rename_place", srv.RenamePlace, {"label": "nowhere", "new_label": ""}),
            ("remove_place", srv.RemovePlace, {"label": "; rm -rf $HOME"}),
        ])
        response = self.call(asked[0], asked[1], **asked[2])
        if response is not None and (response.status == 0 or len(response.message) > 1000):
            self.watch.fail("%s was answered with %d, %d bytes" % (asked[0], response.status,
                                                                   len(response.message)))


def clients(number, node, watch, pace):
    """So many, of every kind."""
    kinds = [Scanner, Recognizer, Reader, Learner, Reader, Recognizer, Fool, Learner, Reader,
             Scanner, Recognizer, Learner]
    return [kinds[i % len(kinds)](i, node, watch, pace) for i in range(number)]
