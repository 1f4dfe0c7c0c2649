"""What the robot knew and found at one place."""
import math
from dataclasses import dataclass, field

# Places whose distances from the robot differ by less are equally near [m].
EQUALLY_NEAR = 0.15


@dataclass
class Learned:
    label: str
    pose: tuple            # true x, y [m], yaw [rad]
    compass_error: float   # shown minus true heading [rad]
    grid: object           # nav_msgs/OccupancyGrid


@dataclass
class Answer:
    """One method's answer to one scan."""
    label: str             # of the best match
    verdict: str
    probability: float
    is_right: bool
    error: float           # of the robot's position [m]; nan where the place is wrong
    match_ms: float


@dataclass
class Trial:
    label: str             # of the place beside which the robot scanned
    pose: tuple            # true x, y [m], yaw [rad]
    compass_error: float   # [rad]
    grid: object
    answers: dict = field(default_factory=dict)  # of each method, by its name


def right_labels(places, x, y):
    """Labels of the places nearest to a point."""
    distances = {label: math.hypot(px - x, py - y) for label, (px, py) in places.items()}
    nearest = min(distances.values())
    return {label for label, distance in distances.items() if distance < nearest + EQUALLY_NEAR}


def position_error(learned, transform, pose):
    """How far the robot is from where the learned place and the aligning transform put it [m].

    The place's grid lies along compass east as it was there.
    """
    east = -learned.compass_error
    x = learned.pose[0] + math.cos(east) * transform.x - math.sin(east) * transform.y
    y = learned.pose[1] + math.sin(east) * transform.x + math.cos(east) * transform.y
    return math.hypot(x - pose[0], y - pose[1])
