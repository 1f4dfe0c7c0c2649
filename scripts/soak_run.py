#!/usr/bin/env python3
"""Puts a node under load: see scripts/soak, which builds what this needs."""

import argparse
import multiprocessing
import os
import socket
import sys
import time

import rosgraph
import rospy
from place_memory import srv

from demo_tools.processes import Process
from demo_tools.waiting import wait_until
from soak_tools import report, robot
from soak_tools.faults import Faults
from soak_tools.map_clients import clients
from soak_tools.node import NAME, Node
from soak_tools.watch import Watch

SPARED = 0.6  # of each mode's time, after which the node is not killed
EXTRA_TIME = 120.0  # for a machine so slow that something was not seen yet [s]


def use_own_master(folder):
    """This process and its children talk to a master that does not run yet. Returns its port."""
    with socket.socket() as probe:
        probe.bind(("", 0))
        port = probe.getsockname()[1]
    os.environ.pop("ROS_IP", None)
    os.environ.update(ROS_MASTER_URI="http://localhost:%d" % port, ROS_HOSTNAME="localhost",
                      ROS_HOME=folder, ROS_LOG_DIR=os.path.join(folder, "log"))
    return port


def change_mode(mode, node, watch):
    """From now on, and where the node is killed and starts anew."""
    node.begin_with(mode)
    try:
        response = rospy.ServiceProxy(NAME + "/set_mode", srv.SetMode)(mode=mode)
    except rospy.ServiceException:  # it is between two lives, and begins so
        return
    # Where no place is left there is nothing to localize by: one is made first.
    if response.status not in (response.OK, response.NO_PLACES, response.STORE_FAILED):
        watch.fail("set_mode %s: %s" % (mode, response.message))


def run(arguments, node, watch, blind_until):
    workers = clients(arguments.clients, node, watch, arguments.pace)
    faults = Faults(node, watch, blind_until, arguments.fault_pace)
    for thread in workers + [faults]:
        thread.start()
    begin = time.monotonic()
    length = 60.0 * arguments.minutes
    modes = list(arguments.modes)
    while len(watch.problems) < 100:
        passed = time.monotonic() - begin
        if passed > length and (watch.has_seen_all() or passed > length + EXTRA_TIME):
            break
        time.sleep(1.0)
        shares_over = passed / length * len(arguments.modes)
        if len(modes) > 1 and shares_over > len(arguments.modes) - len(modes) + 1:
            modes.pop(0)
            change_mode(modes[0], node, watch)
        node.is_spared = shares_over % 1.0 > SPARED
        watch.sample_memory()
        problem = node.check()
        if problem:
            watch.fail(problem)
            break
        for worker in workers:
            if worker.waits_for_ever():
                watch.fail("client %d, %s, waits for ever" % (worker.number, type(worker).__name__))
    faults.is_over = True
    faults.join(90.0)
    # While everybody asks for something.
    status = node.stop_and_start()
    if status != 0:
        watch.fail("asked to end, the node did so with status %d" % status)
    for worker in workers:
        worker.is_over = True
    for worker in workers:
        worker.join(90.0)
        if worker.is_alive():
            watch.fail("client %d, %s, never ended" % (worker.number, type(worker).__name__))
    for worker in workers:
        if hasattr(worker, "known"):
            worker.check()


def parsed_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--out", required=True, help="folder for report, pictures, logs and store")
    parser.add_argument("--clients", type=int, default=50)
    parser.add_argument("--pace", type=float, default=1.5, help="mean time between calls of each [s]")
    parser.add_argument("--fault-pace", type=float, default=3.0, help="time between faults [s]")
    parser.add_argument("--rate", type=float, default=200.0, help="of each sonar's topic [Hz]")
    parser.add_argument("--modes", nargs="+", choices=["off", "map", "localize"],
                        default=["map", "localize"], help="one after the other, as long each")
    parser.add_argument("--lenient", action="store_true",
                        help="report how fast the machine is and how memory grows, and do not judge it")
    parser.add_argument("--no-pictures", action="store_true")
    return parser.parse_args()


def main():
    arguments = parsed_arguments()
    arguments.out = os.path.abspath(arguments.out)
    os.makedirs(arguments.out, exist_ok=True)
    for name in os.listdir(arguments.out):
        if ".db" in name or name.endswith(".log"):
            os.remove(os.path.join(arguments.out, name))
    port = use_own_master(arguments.out)
    with Process(["rosmaster", "--core", "-p", str(port)],
                 os.path.join(arguments.out, "master.log")) as master:
        wait_until(rosgraph.is_master_online, "the ROS master", 60.0, master.check)
        rospy.init_node("soak", disable_signals=True)
        start = time.time()
        # A process of its own, so that the clients do not hold it up.
        context = multiprocessing.get_context("spawn")
        blind_until = context.Value("d", 0.0)
        driver = context.Process(target=robot.run, args=(start, blind_until, arguments.rate),
                                 daemon=True)
        driver.start()
        node = Node(arguments.out, arguments.modes[0])
        node.start()
        rospy.wait_for_service(NAME + "/get_graph", 60.0)
        watch = Watch(node, start)
        run(arguments, node, watch, blind_until)
        node.stop()
        driver.terminate()
    watch.judge(arguments.lenient)
    print(report.write(watch, arguments.out, not arguments.no_pictures))
    sys.exit(1 if watch.problems else 0)


if __name__ == "__main__":
    main()
