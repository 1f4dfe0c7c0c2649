"""The building as it is beside what a place memory knows of it."""
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from PIL import Image  # noqa: E402
from matplotlib.collections import LineCollection  # noqa: E402

from demo_tools.mapper import stand_of  # noqa: E402
from demo_tools.planar import compose, inverse  # noqa: E402

MARGIN = 0.7              # about the building [m]
WIDTH = 8.8               # of the picture [inches]
DOTS, FINE_DOTS = 80, 160  # an inch
HEADER, FOOTER = 0.62, 0.1  # [inches]
NOSE = 0.6                # [m]

WALL, WAY, ROBOT, LOST = "#191e3c", "#7baaf7", "#e8710a", "#9334e6"
PLACE, BARRED, GOAL = "#1a5fc0", "#c5221f", "#137333"
INKS = (WALL, WAY, ROBOT, LOST, PLACE, BARRED, GOAL)
EMPTY, UNKNOWN, OCCUPIED = 1.0, 0.80, 0.15


def shades(grid):
    cells = np.array(grid.data, dtype=np.int8).reshape(grid.info.height, grid.info.width)
    picture = np.full(cells.shape, UNKNOWN, dtype=np.float32)
    picture[cells == 0] = EMPTY
    picture[cells > 50] = OCCUPIED
    return picture


def extent_of(grid):
    origin, side = grid.info.origin.position, grid.info.resolution
    return (origin.x, origin.x + side * grid.info.width,
            origin.y, origin.y + side * grid.info.height)


class Scene:
    """Both are drawn in the map's frame, which lies where the robot's way began."""

    def __init__(self, track, outline):
        self._map_from_world = inverse(track[0])
        self._track = np.array([self._in_map(pose) for pose in track])
        ends = self._points(outline)
        low, high = ends.min(axis=0) - MARGIN, ends.max(axis=0) + MARGIN
        height = 0.5 * WIDTH * (high[1] - low[1]) / (high[0] - low[0])
        self._figure = plt.figure(figsize=(WIDTH, height + HEADER + FOOTER), dpi=DOTS)
        whole = height + HEADER + FOOTER
        self._left = self._axes(0.005, low, high, FOOTER / whole, height / whole, UNKNOWN + 0.17)
        self._right = self._axes(0.505, low, high, FOOTER / whole, height / whole, UNKNOWN)
        top = 1.0 - 0.22 / whole
        self._title = self._figure.text(0.012, top, "", fontsize=13, weight="bold", va="center")
        self._words = self._figure.text(0.012, 1.0 - 0.47 / whole, "", fontsize=10, va="center")
        self._count = self._figure.text(0.988, top, "", fontsize=10, va="center", ha="right")
        self._figure.text(0.988, 1.0 - 0.47 / whole,
                          "left: as it is · right: as the robot knows it", fontsize=9,
                          va="center", ha="right", color="#5f6368")
        self._prepare_truth()
        self._prepare_map()
        self._shown_map = self._shown_outline = None

    def _axes(self, left, low, high, bottom, height, shade):
        axes = self._figure.add_axes((left, bottom, 0.49, height), facecolor=(shade,) * 3)
        axes.set_xlim(low[0], high[0])
        axes.set_ylim(low[1], high[1])
        axes.set_aspect("equal")
        axes.set_xticks([])
        axes.set_yticks([])
        return axes

    def _prepare_truth(self):
        self._walls = self._left.add_collection(LineCollection([], colors=WALL, linewidths=1.0))
        self._way, = self._left.plot([], [], color=WAY, linewidth=1.0)
        self._closed, = self._left.plot([], [], color=BARRED, linewidth=4.0)
        self._robot, = self._left.plot([], [], "o", color=ROBOT, markersize=6)
        self._nose, = self._left.plot([], [], color=ROBOT, linewidth=2.0)

    def _prepare_map(self):
        self._cells = None
        self._links = self._right.add_collection(
            LineCollection([], colors=PLACE, linewidths=1.2, zorder=3))
        self._places, = self._right.plot([], [], "o", color=PLACE, markersize=3.5, zorder=4)
        self._guesses = self._right.scatter([], [], color=LOST, zorder=5)
        self._goal, = self._right.plot([], [], "*", color=GOAL, markersize=13, zorder=6)
        self._believed, = self._right.plot([], [], "o", color=ROBOT, markersize=6, zorder=7)
        self._heading, = self._right.plot([], [], color=ROBOT, linewidth=2.0, zorder=7)
        self._names = []

    def _in_map(self, pose):
        return compose(self._map_from_world, pose)

    def _points(self, points):
        return np.array([self._in_map((x, y, 0.0))[:2] for x, y in points])

    def show(self, moment):
        self._title.set_text(moment.title)
        self._words.set_text(moment.words)
        self._show_truth(moment)
        self._show_map(moment)
        self._show_places(moment)

    def _show_truth(self, moment):
        if moment.outline is not self._shown_outline:
            self._shown_outline = moment.outline
            self._walls.set_segments(self._points(moment.outline).reshape(-1, 2, 2))
        track = self._track[:moment.steps]
        # A robot that is carried leaves no way.
        jumps = np.flatnonzero(np.hypot(*np.diff(track[:, :2], axis=0).T) > NOSE) + 1
        way = np.insert(track[:, :2], jumps, np.nan, axis=0)
        self._way.set_data(way[:, 0], way[:, 1])
        self._draw_robot(self._robot, self._nose, tuple(track[-1]))
        ends = self._points(moment.barred) if moment.barred else np.empty((0, 2))
        self._closed.set_data(ends[:, 0], ends[:, 1])

    @staticmethod
    def _draw_robot(disc, nose, pose):
        if pose is None:
            disc.set_data([], [])
            nose.set_data([], [])
            return
        tip = compose(pose, (NOSE, 0.0, 0.0))
        disc.set_data([pose[0]], [pose[1]])
        nose.set_data([pose[0], tip[0]], [pose[1], tip[1]])

    def _show_map(self, moment):
        self._draw_robot(self._believed, self._heading, moment.believed)
        goal = moment.goal
        self._goal.set_data([goal[0]] if goal else [], [goal[1]] if goal else [])
        if moment.map is None or moment.map is self._shown_map:
            return
        self._shown_map = moment.map
        if self._cells:
            self._cells.remove()
        limits = self._right.get_xlim(), self._right.get_ylim()
        self._cells = self._right.imshow(
            shades(moment.map), cmap="gray", vmin=0.0, vmax=1.0, interpolation="nearest",
            origin="lower", extent=extent_of(moment.map), zorder=1)
        self._right.set_xlim(*limits[0])
        self._right.set_ylim(*limits[1])

    def _show_places(self, moment):
        stands = {place.id: stand_of(place)[:2] for place in moment.graph.places}
        ends = [(stands[link.first_id], stands[link.second_id]) for link in moment.graph.links
                if link.first_id in stands and link.second_id in stands]
        self._links.set_segments(ends)
        spots = np.array(list(stands.values())).reshape(-1, 2)
        self._places.set_data(spots[:, 0], spots[:, 1])
        self._count.set_text(f"{len(stands)} places, {len(ends)} links")
        guesses = [(stands[id], share) for id, share in moment.may_be_at if id in stands]
        self._guesses.set_offsets(np.array([spot for spot, _ in guesses]).reshape(-1, 2))
        self._guesses.set_sizes([20.0 + 300.0 * share for _, share in guesses])
        for text in self._names:
            text.remove()
        # Those that the node made are numbers.
        self._names = [self._right.annotate(place.label, stands[place.id], (4, 4), fontsize=9,
                                            textcoords="offset points", weight="bold", zorder=8)
                       for place in moment.graph.places if not any(map(str.isdigit, place.label))]

    def frame(self):
        """What it shows, as an image of PIL."""
        self._figure.canvas.draw()
        return Image.fromarray(np.asarray(self._figure.canvas.buffer_rgba())).convert("RGB")

    def write(self, path):
        self._figure.savefig(path, dpi=FINE_DOTS)
