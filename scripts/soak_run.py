#!/usr/bin/env python3
"""Puts a node under load: see scripts/soak, which builds and sets up what this needs."""

import argparse
import multiprocessing
import os
import sys
import time

import rosgraph
import rospy

from demo_tools.processes import Process
from demo_tools.waiting import wait_until
from soak_tools import report, robot
from soak_tools.clients import clients
from soak_tools.faults import Faults
from soak_tools.node import NAME, Node
from soak_tools.watch import Watch


def set_mode(mode):
    """Where the node knows modes. False: it does not."""
    try:
        from place_memory.srv import SetMode
    except ImportError:
        return False
    rospy.wait_for_service(NAME + "/set_mode", 60.0)
    response = rospy.ServiceProxy(NAME + "/set_mode", SetMode)(mode=mode)
    return response.status == 0


def run(arguments, node, watch, blind_until):
    workers = clients(arguments.clients, node, watch, arguments.pace)
    faults = Faults(node, watch, blind_until, arguments.fault_pace)
    for thread in workers + [faults]:
        thread.start()
    end = time.monotonic() + 60.0 * arguments.minutes
    while time.monotonic() < end and len(watch.problems) < 100:
        time.sleep(1.0)
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
    for worker in workers:
        worker.is_over = True
    for worker in workers:
        worker.join(90.0)
        if worker.is_alive():
            watch.fail("client %d, %s, never ended" % (worker.number, type(worker).__name__))
    for worker in workers:
        if hasattr(worker, "known"):
            worker.check()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--out", required=True, help="folder for report, pictures, logs and store")
    parser.add_argument("--clients", type=int, default=50)
    parser.add_argument("--pace", type=float, default=1.5, help="mean time between calls of each [s]")
    parser.add_argument("--fault-pace", type=float, default=3.0, help="time between faults [s]")
    parser.add_argument("--mode", choices=["off", "map", "localize"], default="off")
    parser.add_argument("--no-pictures", action="store_true")
    arguments = parser.parse_args()
    os.makedirs(arguments.out, exist_ok=True)
    for name in os.listdir(arguments.out):
        if name.startswith("places.db") or name.endswith(".log"):
            os.remove(os.path.join(arguments.out, name))
    port = os.environ["ROS_MASTER_URI"].rsplit(":", 1)[1].strip("/")
    with Process(["rosmaster", "--core", "-p", port],
                 os.path.join(arguments.out, "master.log")) as master:
        wait_until(rosgraph.is_master_online, "the ROS master", 60.0, master.check)
        rospy.init_node("soak", disable_signals=True)
        start = time.time()
        # A process of its own, so that the clients do not hold it up.
        context = multiprocessing.get_context("spawn")
        blind_until = context.Value("d", 0.0)
        driver = context.Process(target=robot.run, args=(start, blind_until), daemon=True)
        driver.start()
        node = Node(arguments.out)
        node.start()
        rospy.wait_for_service(NAME + "/get_graph", 60.0)
        if arguments.mode != "off" and not set_mode(arguments.mode):
            sys.exit("soak: the node knows no mode " + arguments.mode)
        watch = Watch(node, start)
        run(arguments, node, watch, blind_until)
        status = node.stop()
        if status != 0:
            watch.fail("asked to end, the node did so with status %d" % status)
        driver.terminate()
    watch.judge()
    print(report.write(watch, arguments.out, not arguments.no_pictures))
    sys.exit(1 if watch.problems else 0)


if __name__ == "__main__":
    main()
