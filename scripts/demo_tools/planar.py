"""Poses in the plane: (x [m], y [m], yaw [rad])."""
import math


def yaw_of(orientation):
    return 2.0 * math.atan2(orientation.z, orientation.w)


def wrapped(angle):
    return math.remainder(angle, 2.0 * math.pi)


def pose_of(message):
    """Of a geometry_msgs/Pose."""
    return message.position.x, message.position.y, yaw_of(message.orientation)


def compose(first, second):
    x, y, yaw = first
    c, s = math.cos(yaw), math.sin(yaw)
    return (x + c * second[0] - s * second[1], y + s * second[0] + c * second[1],
            wrapped(yaw + second[2]))


def inverse(pose):
    x, y, yaw = pose
    c, s = math.cos(yaw), math.sin(yaw)
    return -c * x - s * y, s * x - c * y, wrapped(-yaw)


def distance(one, other):
    return math.hypot(one[0] - other[0], one[1] - other[1])


def aligning(pairs):
    """The rigid motion that brings the first points of the pairs next to the second ones, by the
    sum of squares of what is left."""
    count = len(pairs)
    ax, ay = (sum(pair[0][i] for pair in pairs) / count for i in (0, 1))
    bx, by = (sum(pair[1][i] for pair in pairs) / count for i in (0, 1))
    along = across = 0.0
    for one, other in pairs:
        ux, uy, vx, vy = one[0] - ax, one[1] - ay, other[0] - bx, other[1] - by
        along += ux * vx + uy * vy
        across += ux * vy - uy * vx
    yaw = math.atan2(across, along)
    c, s = math.cos(yaw), math.sin(yaw)
    return bx - c * ax + s * ay, by - s * ax - c * ay, yaw


def crosses(one, other, first, second):
    """Whether the straight way from one point to another leads between two others."""
    def side(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    return (side(one, other, first) * side(one, other, second) < 0.0 and
            side(first, second, one) * side(first, second, other) < 0.0)
