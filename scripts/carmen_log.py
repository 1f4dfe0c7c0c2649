"""What a laser robot's drive in a CARMEN log would have been for one with cheap sonars.

The FLASER lines carry poses that a SLAM system has corrected. Of a laser with a view of 180 degrees
remain nine sonars, 22.5 degrees apart and as wide: each returns the shortest ray of its cone up to
15 feet, with 1 % noise, and loses one echo in a hundred.
"""

import gzip
import json
import math

FOOT = 0.3048  # [m]
CONE = math.radians(22.5)
BEARINGS = [math.radians(22.5 * i) for i in range(-4, 5)]
MIN_RANGE, MAX_RANGE = 0.15, 15.0 * FOOT
LEAST_RAY = 0.02  # shorter ones are the laser's faults [m]
RANGE_NOISE, ECHOES_LOST = 0.01, 0.01
# Logs have scans every few centimetres, or every metre: of dense ones some are left out.
LEAST_STEP = 0.35  # [m]
LEAST_TURN = 0.4  # [rad]


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


def ranges(rays, turn, least_cover, rng):
    """(bearing, range or None where nothing is heard) of every sonar of whose cone the laser sees
    that share, where all of them are turned by `turn` [rad]."""
    # 181 rays are a degree apart from -90 to 90; 180 are so from -89.5 to 89.5.
    odd = len(rays) % 2
    step = math.pi / (len(rays) - odd)
    first = -math.pi / 2.0 + (0.0 if odd else step / 2.0)
    result = []
    for bearing in BEARINGS:
        right = max(bearing + turn - CONE / 2.0, -math.pi / 2.0)
        left = min(bearing + turn + CONE / 2.0, math.pi / 2.0)
        if left - right < least_cover * CONE:
            continue
        cone = rays[math.ceil((right - first) / step):math.floor((left - first) / step) + 1]
        echoes = [ray for ray in cone if LEAST_RAY < ray < MAX_RANGE]
        lost = rng.random() < ECHOES_LOST
        noise = 1.0 + RANGE_NOISE * rng.gauss(0.0, 1.0)
        echo = min(echoes) * noise if echoes and not lost else math.inf
        heard = None if echo > MAX_RANGE else round(max(echo, MIN_RANGE), 3)
        result.append((round(bearing, 4), heard))
    return result


def write(rows, out):
    """JSON lines, gzipped; without the time and the name that gzip writes, the same at every run."""
    with open(out, "wb") as file, gzip.GzipFile("", "wb", fileobj=file, mtime=0) as packed:
        for row in rows:
            packed.write((json.dumps(row) + "\n").encode())
