#!/usr/bin/env python3
"""Makes a drive with sonars of a laser robot's.

usage: carmen_drive.py LOG OUT.jsonl.gz

LOG is a CARMEN log, gzipped or not; what nine sonars would have heard there is told in carmen_log.py.
OUT gets a moment a line, as trials/drive_file.h has them: corrected poses are both odometry and truth,
since such a log keeps no other; `recorded` of place_memory_mapping makes odometry err, and adds a
compass. Stamps are those of a robot that drives at walking pace for a cheap one, 0.35 m/s, and turns
by 0.6 rad/s. The same log gives the same drive.
"""

import random
import sys

from carmen_log import CONE, MAX_RANGE, distance, ranges, read, thinned, wrapped, write

SPEED = 0.35  # [m/s]
TURN_RATE = 0.6  # [rad/s]
HALF = 0.49  # the outermost cones look out of the laser's view by half
LEAST_TIME = 0.1  # from moment to moment [s]


def moments(scans, rng):
    t, before = 0.0, scans[0][0]
    for pose, rays in scans:
        t += max(LEAST_TIME, distance(pose, before) / SPEED, abs(wrapped(pose[2] - before[2])) / TURN_RATE)
        before = pose
        at = [round(p, 4) for p in pose[:3]]
        yield {"t": round(t, 3), "odom": at, "truth": at, "fov": round(CONE, 4),
               "readings": [[bearing, 0.0, 0.0, heard, MAX_RANGE] for bearing, heard in ranges(rays, 0.0, HALF, rng)]}


def main(log, out):
    try:
        drive = list(moments(thinned(read(log)), random.Random(1)))
    except (OSError, ValueError, EOFError) as error:
        sys.exit(f"carmen_drive: {error}")
    way = sum(distance(a["truth"], b["truth"]) for a, b in zip(drive, drive[1:]))
    print(f"carmen_drive: {log}: {way:.0f} m, {len(drive)} moments")
    write(drive, out)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
