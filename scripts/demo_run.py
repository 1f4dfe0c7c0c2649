#!/usr/bin/python3
"""The demonstration: a simulated robot learns a hallway, the hallway changes, the robot comes back.

Two place memories hear the same sonars: one with the default parameters and one by the paper's
method. ROS_MASTER_URI says where the demonstration runs a master of its own.
"""
import argparse
import contextlib
import math
import os
import sys
import time

import rospy

from demo_tools import report
from demo_tools.changes import apply_changes
from demo_tools.contact_sheet import write_contact_sheet
from demo_tools.driver import Driver
from demo_tools.memory import VERDICTS, Memory
from demo_tools.processes import Process, VirtualDisplay
from demo_tools.screenshot import Rviz, write_overview_config
from demo_tools.senses import Compass
from demo_tools.session import (end_with_status, launched, load_yaml, make_folder,
                                package_folder, say)
from demo_tools.trial import (EQUALLY_NEAR, Answer, Learned, Trial, position_error,
                              right_labels)

OURS, PAPER = "default", "paper"
NODES = {PAPER: "place_memory_paper", OURS: "place_memory"}
DISPLAY_SIZE = (1600, 900)  # [pixels]
POSE_TOPIC = "/place_memory/pose"
RVIZ_TOPICS = ["/place_memory/map", "/place_memory/scan_cells", "/place_memory/matched_cells",
               "/place_memory/answer_markers", "/place_memory/place_markers", POSE_TOPIC, "/sonar"]
PICTURE_FROM = 9  # trials before the picture of rviz: then the open area is in view
OUTPUTS = ["map.png", "rviz.png", "grids.png", "results.csv"]


class Demonstration:
    """Runs on a master where demo.launch has been started."""

    def __init__(self, places, changes, check):
        self._places = places
        self._changes = changes
        self._driver = Driver(check)
        self._driver.pose()  # from then on simulated time runs
        self._compass = Compass(check)
        self._memories = {method: Memory(node, check) for method, node in NODES.items()}
        self.learned = {}
        self.trials = []

    def _scan(self):
        with self._driver.sweep():
            finish = {method: memory.begin_scan() for method, memory in self._memories.items()}
            finish[PAPER]()
            return finish[OURS]()

    def learn_all(self):
        for count, (label, (x, y)) in enumerate(self._places.items(), 1):
            self._driver.go_to(x, y)
            grid = self._scan()
            for memory in self._memories.values():
                memory.learn(label)
            pose = self._driver.pose()
            error = self._compass.error(pose[2])
            self.learned[label] = Learned(label, pose, error, grid)
            say(f"learned place {label:>2} ({count} of {len(self._places)}) "
                f"at ({x:5.2f}, {y:5.2f})")

    def change_world(self):
        say("the world changes: " + apply_changes(self._changes))

    def recognize_all(self, after_each):
        """The way back, from the last place to the first; after_each(count of trials, trial)."""
        say(report.heading(NODES))
        dx, dy = self._changes["offset"]
        for label, (x, y) in reversed(self._places.items()):
            self._driver.go_to(x + dx, y + dy)
            grid = self._scan()
            pose = self._driver.pose()
            trial = Trial(label, pose, self._compass.error(pose[2]), grid)
            for method in NODES:
                trial.answers[method] = self._ask(method, pose)
            self.trials.insert(0, trial)
            say(report.row(trial, self.learned[label]))
            after_each(len(self.trials), trial)

    def _ask(self, method, pose):
        found = self._memories[method].recognize()
        best = found.matches[0]
        is_right = best.label in right_labels(self._places, pose[0], pose[1])
        error = (position_error(self.learned[best.label], best.transform, pose)
                 if is_right else math.nan)
        return Answer(best.label, VERDICTS[found.verdict], best.probability, is_right, error,
                      1000.0 * found.match_duration.to_sec())


def take_overview(options, config, display, check):
    """A picture of the whole map, by a second rviz."""
    overview = os.path.join(options.out, "overview.rviz")
    write_overview_config(overview, config, focus=(19.4, 0.0), scale=36, height=540)
    command = ["rviz", "--splash-screen", "", "-d", overview, "__name:=rviz_overview"]
    with Process(command, os.path.join(options.out, "overview.log")) as process:
        def check_both():
            check()
            process.check()

        rviz = Rviz(display, overview, check_both)
        rviz.wait_until_it_hears(set(RVIZ_TOPICS) - {POSE_TOPIC}, "/rviz_overview")
        rviz.write(os.path.join(options.out, "map.png"))


def demonstrate(options, share, display, check):
    started = time.monotonic()
    rospy.init_node("place_memory_demo", disable_signals=True)
    world = load_yaml(os.path.join(share, "config", "worlds", "hallway.yaml"))
    places = {place["label"]: tuple(place["at"]) for place in world["places"]}
    config = os.path.join(share, "rviz", "place_memory.rviz")
    changes = load_yaml(os.path.join(share, "config", "demo", "changes.yaml"))
    demonstration = Demonstration(places, changes, check)
    demonstration.learn_all()
    take_overview(options, config, display, check)
    demonstration.change_world()

    picture = os.path.join(options.out, "rviz.png")
    rviz = Rviz(display, config, check)
    rviz.wait_until_it_hears(RVIZ_TOPICS, "/rviz")

    def after_each(count, trial):
        """One picture, of the first place from there on that is recognized."""
        answer = trial.answers[OURS]
        is_good = count > PICTURE_FROM and answer.is_right and answer.verdict == "recognized"
        if (is_good or count == len(places)) and not os.path.exists(picture):
            rviz.write(picture)

    demonstration.recognize_all(after_each)

    report.write_csv(os.path.join(options.out, "results.csv"), demonstration.trials,
                     demonstration.learned)
    write_contact_sheet(os.path.join(options.out, "grids.png"), demonstration.learned,
                        demonstration.trials,
                        "Learned grids and those of the way back (black occupied, white empty, "
                        "grey unsensed); below: the place each method found")
    say(report.legend(rospy.get_param(f"/{NODES[OURS]}/match/confidence"), EQUALLY_NEAR))
    for method in NODES:
        say(report.total(method, demonstration.trials))
    say(f"{time.monotonic() - started:.0f} s; pictures and results.csv are in {options.out}")


def run(options):
    make_folder(options.out, OUTPUTS)
    arguments = [f"speed:={options.speed}", f"seed:={options.seed}"]
    with contextlib.ExitStack() as processes:
        if not os.environ.get("DISPLAY"):
            say("there is no display: rviz draws into memory")
            screen = processes.enter_context(VirtualDisplay(options.out, *DISPLAY_SIZE))
            os.environ.update(DISPLAY=screen.display, LIBGL_ALWAYS_SOFTWARE="1")
        check = processes.enter_context(launched("demo.launch", arguments, options.out))
        demonstrate(options, package_folder(), os.environ["DISPLAY"], check)


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", default="demo_output", help="folder for what is written")
    parser.add_argument("--speed", type=float, default=5.0, help="simulated over real time")
    parser.add_argument("--seed", type=int, default=1, help="of the simulation")
    return parser.parse_args()


if __name__ == "__main__":
    sys.exit(end_with_status(run, parse_options()))
