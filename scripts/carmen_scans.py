#!/usr/bin/env python3
"""Cuts recorded sonar scans of places from a laser robot's drive.

usage: carmen_scans.py LOG OUT.jsonl.gz

LOG is a CARMEN log, gzipped or not; what nine sonars would have heard there is told in carmen_log.py.
OUT gets a scan a line, as `--recorded` of place_memory_experiments takes them (trials/episode_file.h).

The robot takes eleven readings of each sonar, two degrees apart, and a compass that errs by 10 degrees
(1 sigma). A place is learned wherever none is within five feet; where the robot comes by one again, within 2.5 feet
and 45 degrees, its scan is to be recognized, and the way is noted that it took since it last did. The
same log gives the same scans.
"""

import math
import random
import sys

from carmen_log import (CONE, FOOT, MAX_RANGE, MIN_RANGE, distance, ranges, read, thinned, wrapped,
                        write)

PLACE_SPACING = 5.0 * FOOT
NEAR = 2.5 * FOOT
SAME_HEADING = math.radians(45.0)
# So far must the robot have driven before a scan is a visit, and between two visits [m].
FAR_FROM_LEARNING = 18.0 * FOOT
VISIT_SPACING = 6.0 * FOOT

LEAST_COVER = 0.8  # of a cone within the laser's view
TURNS = [math.radians(2.0 * i) for i in range(-5, 6)]
COMPASS_ERROR = math.radians(10.0)
CELL = 30.0 * FOOT / 64


def readings(rays, rng):
    """[set, bearing, turn, range or null] of every cone that the laser sees enough of."""
    return [[sweep, bearing, round(turn, 5), heard] for sweep, turn in enumerate(TURNS)
            for bearing, heard in ranges(rays, turn, LEAST_COVER, rng)]


def episodes(scans, rng):
    """All that is learned, then all that is to be recognized."""

    def episode(role, pose, rays, place, accept):
        return {"role": role, "place": place, "accept": accept, "pose": [round(p, 4) for p in pose],
                "compass": round(COMPASS_ERROR * rng.gauss(0.0, 1.0), 5), "any_heading": False,
                "ring_radius": 0.0, "fov": round(CONE, 4), "r_min": MIN_RANGE, "r_max": MAX_RANGE,
                "cell": round(CELL, 5), "readings": readings(rays, rng)}

    places, learned, visits, way = [], [], [], []
    driven, last_visit = 0.0, -math.inf
    previous = scans[0][0]
    for pose, rays in scans:
        driven += distance(pose, previous)
        previous = pose
        way.append([round(p, 4) for p in pose])
        if all(distance(pose, place) >= PLACE_SPACING for place, _ in places):
            learned.append(episode("learn", pose, rays, f"P{len(places)}", []))
            places.append((pose, driven))
            continue
        again = [i for i, (place, since) in enumerate(places)
                 if distance(pose, place) <= NEAR and driven - since > FAR_FROM_LEARNING
                 and abs(wrapped(pose[2] - place[2])) <= SAME_HEADING]
        if not again or driven - last_visit < VISIT_SPACING:
            continue
        last_visit = driven
        accept = [f"P{i}" for i, (place, _) in enumerate(places) if distance(pose, place) <= NEAR]
        visits.append(dict(episode("recognize", pose, rays, "", accept), way=way))
        way = []
    return learned + visits


def main(log, out):
    try:
        scans = episodes(thinned(read(log)), random.Random(1))
    except (OSError, ValueError, EOFError) as error:
        sys.exit(f"carmen_scans: {error}")
    visits = sum(scan["role"] == "recognize" for scan in scans)
    print(f"carmen_scans: {log}: {len(scans) - visits} places, {visits} scans to be recognized")
    write(scans, out)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
