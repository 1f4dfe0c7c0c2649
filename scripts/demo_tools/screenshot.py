"""Pictures of rviz's window."""
import os
import subprocess
import time

import rosgraph
import yaml

from demo_tools.errors import DemoError
from demo_tools.waiting import wait_until

START_LIMIT = 90.0     # of rviz, where it has to draw in software [s]
DRAW_LIMIT = 60.0      # [s]
DRAW_TIME = 1.0        # what rviz has heard is drawn by then [s]
MANY_COLOURS = 200     # a window in which nothing was drawn has fewer
MOVING_SHARE = 0.03    # of the pixels, which people and sonar cones change


class Rviz:
    """The window of an rviz that runs, on a display."""

    def __init__(self, display, config, check):
        title = os.path.basename(config)
        self._titles = [f"{title} - RViz", f"{title}* - RViz"]
        self._display = display
        self._check = check

    def wait_until_it_hears(self, topics, node):
        master = rosgraph.Master("/place_memory_demo")

        def hears_all():
            _, subscribers, _ = master.getSystemState()
            heard = {topic for topic, nodes in subscribers if node in nodes}
            return heard.issuperset(topics)

        wait_until(hears_all, "rviz's subscriptions", START_LIMIT, self._check)

    def write(self, path):
        """Once nothing changes in the window but what moves by itself."""
        previous = path + ".previous.png"
        wait_until(lambda: self._take(previous), "rviz's window", START_LIMIT, self._check)

        def is_settled():
            time.sleep(DRAW_TIME)
            if not self._take(path):
                raise DemoError("rviz's window is gone")
            settled = colours(path) > MANY_COLOURS and changed_share(previous, path) < MOVING_SHARE
            os.replace(path, previous)
            return settled

        wait_until(is_settled, f"a still picture of rviz for {path}", DRAW_LIMIT, self._check)
        os.replace(previous, path)

    def _take(self, path):
        """False where the window is not there."""
        window = self._window()
        return window is not None and subprocess.run(
            ["import", "-display", self._display, "-window", window, path], check=False,
            capture_output=True, timeout=DRAW_LIMIT).returncode == 0

    def _window(self):
        # import itself would wait for a click where it finds no window of a name.
        tree = subprocess.run(["xwininfo", "-display", self._display, "-root", "-tree"], check=True,
                              capture_output=True, text=True, timeout=DRAW_LIMIT).stdout
        for line in tree.splitlines():
            if any(f'"{title}"' in line for title in self._titles):
                return line.split()[0]
        return None


def colours(path):
    result = subprocess.run(["identify", "-format", "%k", path], check=True, capture_output=True,
                            text=True)
    return int(result.stdout)


def changed_share(first, second):
    """Share of the pixels that differ; 1 where the sizes do."""
    sizes = [subprocess.run(["identify", "-format", "%w %h", path], check=True,
                            capture_output=True, text=True).stdout for path in (first, second)]
    if sizes[0] != sizes[1]:
        return 1.0
    width, height = map(int, sizes[0].split())
    # Its status says whether they differ, its error output how many pixels do.
    result = subprocess.run(["compare", "-metric", "AE", "-fuzz", "5%", first, second, "null:"],
                            check=False, capture_output=True, text=True)
    return float(result.stderr.split()[0]) / (width * height)


def write_overview_config(path, source, focus, scale, height):
    """The rviz configuration `source` looking at all of the map: at `focus` (x, y in the frame map
    [m]), at `scale` [pixels/m], in a window of that height without panels."""
    with open(source, encoding="utf-8") as file:
        config = yaml.safe_load(file)
    view = config["Visualization Manager"]["Views"]["Current"]
    view.update({"Target Frame": "map", "X": focus[0], "Y": focus[1], "Scale": scale})
    displays = config["Visualization Manager"]["Displays"]
    # Before the first pose comes rviz draws one at the origin.
    displays[:] = [display for display in displays if display["Class"] != "rviz/PoseWithCovariance"]
    config["Window Geometry"]["Height"] = height
    config["Panels"] = []
    with open(path, "w", encoding="utf-8") as file:
        yaml.safe_dump(config, file)
