#!/usr/bin/env python3
"""Cuts recorded sonar scans of places from a laser robot's drive.

usage: carmen_scans.py LOG OUT.jsonl.gz

LOG is a CARMEN log, gzipped or not, whose FLASER lines carry poses that a SLAM system has corrected.
OUT gets a scan a line, as `--recorded` of place_memory_experiments takes them (trials/episode_file.h).

Of a laser with a view of 180 degrees remain nine sonars, 22.5 degrees apart and as wide: each returns
the shortest ray of its cone up to 15 feet, with 1 % noise, and loses one echo in a hundred. The robot
takes eleven readings of each, two degrees apart, and a compass that errs by 10 degrees (1 sigma). A
place is learned wherever none is within five feet; where the robot comes by one again, within 2.5 feet
and 45 degrees, its scan is to be recognized, and the way is noted that it took since it last did. The
same log gives the same scans.
"""

import gzip
import json
import math
import random
import sys

FOOT = 0.3048  # [m]
PLACE_SPACING = 5.0 * FOOT
NEAR = 2.5 * FOOT
SAME_HEADING = math.radians(45.0)
# So far must the robot have driven before a scan is a visit, and between two visits [m].
FAR_FROM_LEARNING = 18.0 * FOOT
VISIT_SPACING = 6.0 * FOOT
# Logs have scans every few centimetres, or every metre: of dense ones some are left out.
LEAST_STEP = 0.35  # [m]
LEAST_TURN = 0.4  # [rad]

CONE = math.radians(22.5)
BEARINGS = [math.radians(22.5 * i) for i in range(-4, 5)]
TURNS = [math.radians(2.0 * i) for i in range(-5, 6)]
LEAST_COVER = 0.8  # of a cone within the laser's view
MIN_RANGE, MAX_RANGE = 0.15, 15.0 * FOOT
LEAST_RAY = 0.02  # shorter ones are the laser's faults [m]
RANGE_NOISE, ECHOES_LOST = 0.01, 0.01
COMPASS_ERROR = math.radians(10.0)
CELL = 30.0 * FOOT / 64


def wrapped(angle):
    return (angle + math.pi) % (2.0 * math.pi) - math.pi


def distance(a, b):
    return math.hypot(a[0] - b[0], a[1] - b[1])


def parsed(line):
    """The pose and the rays of a FLASER line: `FLASER n range... x y yaw ...`, [m] and [rad]."""
    words = line.split()
    rays = int(words[1])
    if rays < 2 or len(words) < 2 + rays + 3:
        raise ValueError("is cut short")
    numbers = [float(word) for word in words[2:2 + rays + 3]]
    if not all(math.isfinite(number) for number in numbers):
        raise ValueError("holds what is no number")
    return numbers[rays:], numbers[:rays]


def read(path):
    opened = gzip.open if path.endswith(".gz") else open
    scans = []
    with opened(path, "rt", errors="replace") as log:
        for number, line in enumerate(log, 1):
            if not line.startswith("FLASER "):
                continue
            try:
                scans.append(parsed(line))
            except (ValueError, IndexError) as error:
                raise ValueError(f"{path}:{number}: FLASER {error}") from error
    if not scans:
        raise ValueError(f"{path}: no FLASER line")
    return scans


def thinned(scans):
    kept = scans[:1]
    for scan in scans:
        pose, last = scan[0], kept[-1][0]
        if distance(pose, last) > LEAST_STEP or abs(wrapped(pose[2] - last[2])) > LEAST_TURN:
            kept.append(scan)
    return kept


def readings(rays, rng):
    """[set, bearing, turn, range or null] of every cone that the laser sees enough of."""
    # 181 rays are a degree apart from -90 to 90; 180 are so from -89.5 to 89.5.
    odd = len(rays) % 2
    step = math.pi / (len(rays) - odd)
    first = -math.pi / 2.0 + (0.0 if odd else step / 2.0)
    result = []
    for sweep, turn in enumerate(TURNS):
        for bearing in BEARINGS:
            right = max(bearing + turn - CONE / 2.0, -math.pi / 2.0)
            left = min(bearing + turn + CONE / 2.0, math.pi / 2.0)
            if left - right < LEAST_COVER * CONE:
                continue
            cone = rays[math.ceil((right - first) / step):math.floor((left - first) / step) + 1]
            echoes = [ray for ray in cone if LEAST_RAY < ray < MAX_RANGE]
            lost = rng.random() < ECHOES_LOST
            noise = 1.0 + RANGE_NOISE * rng.gauss(0.0, 1.0)
            echo = min(echoes) * noise if echoes and not lost else math.inf
            heard = None if echo > MAX_RANGE else round(max(echo, MIN_RANGE), 3)
            result.append([sweep, round(bearing, 4), round(turn, 5), heard])
    return result


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
    # Without the time and the name that gzip writes, the file is the same at every run.
    with open(out, "wb") as file, gzip.GzipFile("", "wb", fileobj=file, mtime=0) as packed:
        for scan in scans:
            packed.write((json.dumps(scan) + "\n").encode())


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
