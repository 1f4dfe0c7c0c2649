"""Rooms and what a ring of sonars measures in them, by casting rays."""

import math

SENSORS = 16
RING_RADIUS = 0.22  # base to sensor [m]
FIELD_OF_VIEW = 0.436  # [rad]
MIN_RANGE = 0.15  # [m]
MAX_RANGE = 6.0  # [m]
SUBRAYS = 5


def bearing(sensor):
    """Of a sensor in the base frame [rad]."""
    return 2.0 * math.pi * sensor / SENSORS


def compose(pose, other):
    """The pose `other`, given in the frame of `pose`, in the frame of that; (x, y, yaw)."""
    x, y, yaw = pose
    c, s = math.cos(yaw), math.sin(yaw)
    return (x + c * other[0] - s * other[1], y + s * other[0] + c * other[1], yaw + other[2])


def inverse(pose):
    x, y, yaw = pose
    c, s = math.cos(yaw), math.sin(yaw)
    return (-c * x - s * y, s * x - c * y, -yaw)


def sensor_pose(sensor):
    angle = bearing(sensor)
    return (RING_RADIUS * math.cos(angle), RING_RADIUS * math.sin(angle), angle)


class Room:
    """Walls around the origin, and boxes in them. Everything is parallel to the axes, so that a ray
    meets lines of constant x or y."""

    def __init__(self, width, depth, boxes=()):
        """`width` along x, `depth` along y [m]; a box is (x, y, width, depth) by its centre."""
        self.lines = []  # (is_vertical, where, low, high)
        for x, y, w, d in [(0.0, 0.0, width, depth)] + list(boxes):
            for sign in (-0.5, 0.5):
                self.lines.append((True, x + sign * w, y - 0.5 * d, y + 0.5 * d))
                self.lines.append((False, y + sign * d, x - 0.5 * w, x + 0.5 * w))

    def distance(self, x, y, angle):
        """To the first surface [m]; infinite where there is none."""
        c, s = math.cos(angle), math.sin(angle)
        nearest = math.inf
        for is_vertical, where, low, high in self.lines:
            along, across, at, start = (c, s, x, y) if is_vertical else (s, c, y, x)
            if abs(along) < 1e-9:
                continue
            t = (where - at) / along
            if 0.0 < t < nearest and low <= start + t * across <= high:
                nearest = t
        return nearest

    def ping(self, base, sensor):
        """What a sensor measures from the base's pose in the room: the nearest surface in the cone
        [m], infinite beyond its reach."""
        x, y, yaw = compose(base, sensor_pose(sensor))
        echoes = [self.distance(x, y, yaw + FIELD_OF_VIEW * (i / (SUBRAYS - 1.0) - 0.5))
                  for i in range(SUBRAYS)]
        return min(echoes) if MIN_RANGE <= min(echoes) <= MAX_RANGE else math.inf


HALL = Room(9.0, 3.0, [(2.5, 1.0, 0.8, 0.8)])
STUDY = Room(4.0, 5.0, [(-1.2, -1.5, 0.9, 1.6), (1.5, 1.8, 0.8, 0.8)])
