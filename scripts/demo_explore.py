#!/usr/bin/python3
"""The demonstration of a robot that makes its map: it explores a building of which it knows nothing,
is carried, finds itself, and goes to places while a door closes under way.

ROS_MASTER_URI says where the demonstration runs a master of its own.
"""
import argparse
import os
import sys
import time

import rospy
import yaml

from demo_tools.errors import DemoError
from demo_tools.exploration import Demonstration
from demo_tools.session import (end_with_status, launched, load_yaml, make_folder,
                                package_folder, say)
from demo_tools.stages import HEADING, LEGEND

OUTPUTS = ["explore.gif", "explore.png", "explore.csv"]


def write_world(building, folder, path):
    """The world of the building, with what is added to it, and without ways into other rooms."""
    world = load_yaml(os.path.join(folder, building["world"]))
    for door in world.get("doors", []):
        door["open"] = False
    for what in ("walls", "doors"):
        world[what] = world.get(what, []) + building[what]
    with open(path, "w", encoding="utf-8") as file:
        yaml.safe_dump(world, file)


def run(options):
    started = time.monotonic()
    make_folder(options.out, OUTPUTS)
    path = options.building or os.path.join(package_folder(), "config", "demo",
                                            "explore_office.yaml")
    building = load_yaml(path)
    world = os.path.abspath(os.path.join(options.out, "world.yaml"))
    write_world(building, os.path.dirname(path), world)
    rviz = "true" if os.environ.get("DISPLAY") else "false"
    arguments = [f"world:={world}", f"speed:={options.speed}", f"seed:={options.seed}",
                 f"rviz:={rviz}"]
    demonstration = None
    try:
        with launched("demo_explore.launch", arguments, options.out) as check:
            rospy.init_node("place_memory_demo", disable_signals=True)
            demonstration = Demonstration(building, check)
            say(HEADING)
            demonstration.run()
    except DemoError:
        if demonstration:  # what it came to shows why
            demonstration.write(options.out)
        raise
    demonstration.write(options.out)
    say(f"{LEGEND}\n{time.monotonic() - started:.0f} s; explore.gif, explore.png and explore.csv are "
        f"in {options.out}")


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", default="demo_output", help="folder for what is written")
    parser.add_argument("--building", help="file laid out as config/demo/explore_office.yaml")
    parser.add_argument("--speed", type=float, default=6.0, help="simulated over real time")
    parser.add_argument("--seed", type=int, default=1, help="of the simulation")
    return parser.parse_args()


if __name__ == "__main__":
    sys.exit(end_with_status(run, parse_options()))
