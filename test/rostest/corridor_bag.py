"""A bag of a robot that drives rounds in a room, repeatable by its seed."""

import math
import random

import rosbag
import rospy
from tf2_msgs.msg import TFMessage

import fake_robot
import sonar_room
from sonar_room import SENSORS, Room, compose, inverse

SPEED = 0.5  # [m/s]
STEP = 0.2  # from one moment to the next [s]
WIDTH, DEPTH, CORNER = 7.0, 3.5, 0.8  # of the way, and the radius of its corners [m]
BEND = 0.01  # that odometry makes of a straight way [rad/m]
# From no spot does it look as from another.
ROOM = Room(13.0, 9.0, [(0.6, 0.2, 3.6, 1.4), (-5.4, 2.9, 1.6, 2.4), (5.3, -3.2, 1.0, 1.4),
                        (1.5, 3.6, 2.4, 1.6), (-1.4, 3.9, 0.6, 0.6), (-5.0, -1.4, 0.7, 0.7),
                        (-2.6, -0.6, 0.5, 0.5), (4.9, 1.0, 0.4, 0.4)])


def steps(rounds):
    """Ways and turns, a step each: along the sides of a rectangle with round corners."""
    length = SPEED * STEP
    for _ in range(rounds):
        for side in (WIDTH, DEPTH, WIDTH, DEPTH):
            for _ in range(int(round((side - 2.0 * CORNER) / length))):
                yield length, 0.0
            turns = int(round(0.5 * math.pi * CORNER / length))
            for _ in range(turns):
                yield length, 0.5 * math.pi / turns


class CorridorBag:
    """`truth`: (t, pose in the room) of each moment; of odometry's starting anew `reset_at` [s after
    the start], and `late`: what is recorded is that much out of its order [s]. `carried_at` [s after
    the start]: the robot is carried so many steps along its way, and odometry does not notice;
    `ahead`: it begins so many steps along its way."""

    def __init__(self, path, start, rounds, seed, compass=True, reset_at=None, late=0.0,
                 carried_at=None, carried=100, ahead=0):
        rng = random.Random(seed)
        self.truth = []
        pose = (-0.5 * WIDTH + CORNER, -0.5 * DEPTH, 0.0)
        odometry = (0.0, 0.0, 0.0)
        messages = []
        t = start
        for length, turn in steps(rounds):
            if ahead > 0 or (carried_at is not None and t - start > carried_at and carried > 0):
                ahead, carried = (ahead - 1, carried) if ahead > 0 else (ahead, carried - 1)
                move = (0.5 * length, 0.0, turn)
                pose = compose(compose(pose, move), (0.5 * length, 0.0, 0.0))
                continue
            stamp = rospy.Time.from_sec(t)
            self.truth.append((t, pose))
            messages.append((t, "/tf", TFMessage(
                [fake_robot.transform("odom", "base_link", odometry, stamp)]), stamp))
            if compass:
                messages.append((t, "/heading", fake_robot.heading_message(
                    pose[2] + rng.gauss(0.0, 0.03), stamp), stamp))
            for i in range(SENSORS):
                distance = ROOM.ping(pose, i)
                if math.isfinite(distance):
                    distance = max(sonar_room.MIN_RANGE, distance + rng.gauss(0.0, 0.01))
                    distance = distance if distance < sonar_room.MAX_RANGE else math.inf
                messages.append((t, "/sonar", fake_robot.range_message(i, distance, stamp), stamp))
            move = (0.5 * length, 0.0, turn)
            pose = compose(compose(pose, move), (0.5 * length, 0.0, 0.0))
            measured = (0.5 * length * (1.0 + rng.gauss(0.0, 0.02)), 0.0,
                        turn + BEND * length + rng.gauss(0.0, 0.002))
            odometry = compose(compose(odometry, measured), (0.5 * length, 0.0, 0.0))
            t += STEP
            if reset_at is not None and t - start > reset_at:
                odometry, reset_at = (0.0, 0.0, 0.0), None
        order = random.Random(seed + 1)
        recorded = sorted((t + order.uniform(0.0, late), i) for i, (t, _, _, _) in
                          enumerate(messages))
        with rosbag.Bag(path, "w") as bag:
            first = rospy.Time.from_sec(start - 1.0)
            bag.write("/tf_static", fake_robot.ring_transforms(first), first)
            for when, i in recorded:
                bag.write(messages[i][1], messages[i][2], rospy.Time.from_sec(when))

    def relative(self, t, later):
        """Where the robot stood at one time, in the frame in which it stood at another."""
        return compose(inverse(self.at(t)), self.at(later))

    def at(self, t):
        return min(self.truth, key=lambda moment: abs(moment[0] - t))[1]
