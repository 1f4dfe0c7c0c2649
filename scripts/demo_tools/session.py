"""What every demonstration begins and ends with: a folder, a master of its own with the nodes of a
launch file, and a sentence where it fails."""
import contextlib
import os
import signal
import subprocess
import sys
import urllib.parse

import rospkg
import rospy
import yaml

from demo_tools.errors import DemoError
from demo_tools.processes import Process
from demo_tools.waiting import wait_until

START_LIMIT = 60.0  # [s]


def say(text):
    print(text, flush=True)


def load_yaml(path):
    with open(path, encoding="utf-8") as file:
        return yaml.safe_load(file)


def package_folder():
    """The folder of the package."""
    return rospkg.RosPack().get_path("place_memory")


def make_folder(path, outputs):
    """Without what an earlier demonstration wrote there."""
    os.makedirs(path, exist_ok=True)
    for name in outputs:
        with contextlib.suppress(FileNotFoundError):
            os.remove(os.path.join(path, name))


def master_answers():
    try:
        return rospy.get_master().getPid()[0] == 1
    except OSError:
        return False


@contextlib.contextmanager
def launched(file, arguments, out):
    """The nodes of a launch file of the package, on the master that ROS_MASTER_URI names. Gives a
    function that raises once they have ended."""
    master = os.environ.setdefault("ROS_MASTER_URI", "http://localhost:11311")
    port = str(urllib.parse.urlparse(master).port)
    if master_answers():
        raise DemoError(f"another ROS master runs on port {port}: name a free one, ROS_MASTER_PORT")
    command = ["roslaunch", "-p", port, "place_memory", file] + arguments
    with Process(command, os.path.join(out, "roslaunch.log")) as nodes:
        wait_until(master_answers, "the ROS master", START_LIMIT, nodes.check)
        yield nodes.check


def stop_now(*_):
    raise KeyboardInterrupt


def end_with_status(run, options):
    """Runs `run(options)` and returns the status to exit with. options.out: the folder."""
    # However it is stopped, its processes are too.
    for stop in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(stop, stop_now)
    try:
        run(options)
    except (DemoError, OSError, subprocess.SubprocessError, rospy.ROSException,
            rospy.ServiceException) as error:
        print(f"demo: {error}\ndemo: what the nodes said is in {options.out}/roslaunch.log",
              file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("demo: stopped", file=sys.stderr)
        return 130
    return 0
