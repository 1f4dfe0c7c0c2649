"""A bag of a robot that learns rooms and comes back to them, repeatable by its seed."""

import math
import random

import rosbag
import rospy
from tf2_msgs.msg import TFMessage

import fake_robot
import sonar_room
from sonar_room import SENSORS, Room, compose

ROOMS = 5
HEADINGS = 11
STEP = math.pi / 90.0  # between headings [rad]
DWELL = 0.16  # at each heading [s]
PERIOD = 0.3  # from one heading to the next [s]
INTERVAL = 20.0  # from one scan to the next [s]


class Event:
    """A scan in the bag and what to do with it; `window` is how far the compass may be off [rad]
    or None."""

    def __init__(self, start, action, label, window=None):
        self.start = start
        self.end = start + HEADINGS * PERIOD + 1.0
        self.action = action
        self.label = label  # of recognitions: the true place
        self.window = window

    def row(self):
        return "%.3f,%.3f,%s,%s,%s\n" % (
            self.start, self.end, self.action, self.label if self.action == "learn" else "",
            "" if self.window is None else self.window)


def random_room(rng):
    boxes = [(rng.uniform(-2.0, 2.0), rng.choice((-1.0, 1.0)) * rng.uniform(1.0, 1.6),
              rng.uniform(0.3, 1.2), rng.uniform(0.3, 0.6)) for _ in range(4)]
    return Room(rng.uniform(3.5, 8.0), rng.uniform(3.0, 6.0), boxes)


class RoomBag:
    def __init__(self, path, start, seed):
        """`start` of the first scan [s]."""
        self.rng = random.Random(seed)
        self.events = []
        rooms = [random_room(self.rng) for _ in range(ROOMS)]
        with rosbag.Bag(path, "w") as self.bag:
            stamp = rospy.Time.from_sec(start - 1.0)
            self.bag.write("/tf_static", fake_robot.ring_transforms(stamp), stamp)
            for i, room in enumerate(rooms):
                self._add(start, room, Event(start, "learn", "room %d" % i), (7.0 * i, 0.5, 0.3))
                start += INTERVAL
            for i in self.rng.sample(range(ROOMS), ROOMS):
                window = self.rng.choice((None, 0.5, 3.1416))
                event = Event(start, "recognize", "room %d" % i, window)
                # Odometry begins afresh, wherever the robot is.
                self._add(start, rooms[i], event, (0.0, 0.0, self.rng.uniform(-3.0, 3.0)))
                start += INTERVAL

    def _add(self, start, room, event, odometry):
        """A sweep a little off the middle of the room, by a compass that is a little off."""
        self.events.append(event)
        in_room = (self.rng.gauss(0.0, 0.15), self.rng.gauss(0.0, 0.15), self.rng.gauss(0.0, 0.5))
        compass_error = self.rng.gauss(0.0, 0.05)
        for i in range(HEADINGS):
            stamp = start + 0.5 + PERIOD * i
            self._add_set(stamp, room, compose(in_room, (0.0, 0.0, i * STEP)),
                          compose(odometry, (0.002 * i, 0.0, i * STEP)), compass_error)
        # What the compass says after the scan is not of the scan.
        after = rospy.Time.from_sec(event.end + 0.2)
        self.bag.write("/heading", fake_robot.heading_message(2.0, after), after)
        self._add_odometry(compose(odometry, (0.002 * i, 0.0, i * STEP)), after,
                           after + rospy.Duration(0.01))

    def _add_set(self, start, room, in_room, odometry, compass_error):
        # Odometry is sent for a little time ahead, as some drivers do.
        first = rospy.Time.from_sec(start)
        for at in (start, start + DWELL):
            self._add_odometry(odometry, rospy.Time.from_sec(at), first)
        yaw = in_room[2] + compass_error + self.rng.gauss(0.0, 0.02)
        self.bag.write("/heading", fake_robot.heading_message(yaw, first), first)
        for i in range(SENSORS):
            stamp = rospy.Time.from_sec(start + 0.009 * (i + 1))
            distance = room.ping(in_room, i) * self.rng.gauss(1.0, 0.01)
            if self.rng.random() < 0.02:
                distance = math.nan
            self.bag.write("/sonar", fake_robot.range_message(i, distance, stamp), stamp)

    def _add_odometry(self, pose, stamp, recorded):
        message = TFMessage([fake_robot.transform("odom", "base_link", pose, stamp)])
        self.bag.write("/tf", message, recorded)

    def write_events(self, path):
        with open(path, "w") as table:
            table.write("start,end,action,label,heading_window\n")
            table.writelines(event.row() for event in self.events)
