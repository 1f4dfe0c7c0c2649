"""Moments of a demonstration, and the animation and the picture that are made of them."""
from dataclasses import dataclass, field
from typing import Optional

from PIL import Image

from demo_tools.scene import INKS, Scene

FRAME_TIME = 90   # of the animation [ms]
LAST_TIME = 3000  # of the frame it ends with [ms]
GREYS = 24
TINTS = (1.0, 0.75, 0.5, 0.25)  # of each ink, on white


def palette_of(inks):
    """An image of PIL that has greys, and the inks in several tints."""
    colours = [[round(255 * grey / (GREYS - 1))] * 3 for grey in range(GREYS)]
    for ink in inks:
        parts = [int(ink[at:at + 2], 16) for at in (1, 3, 5)]
        colours += [[round(255 - tint * (255 - part)) for part in parts] for tint in TINTS]
    colours += [colours[0]] * (256 - len(colours))
    image = Image.new("P", (1, 1))
    image.putpalette(sum(colours, []))
    return image


@dataclass
class Moment:
    """Everything in the frame world that is true, in the map's what the place memory says."""
    title: str
    words: str
    steps: int                # of the track until then
    outline: list
    map: Optional[object]     # nav_msgs/OccupancyGrid
    graph: object             # place_memory/PlaceGraph
    believed: Optional[tuple]  # where it has the robot; None: it does not know
    may_be_at: list = field(default_factory=list)  # else: ids of places, and probabilities
    goal: Optional[tuple] = None
    barred: Optional[tuple] = None  # ends of a door that is closed


class Film:
    """Takes a moment every so often, of simulated time."""

    def __init__(self, truth, mapper):
        self._truth = truth
        self._mapper = mapper
        self._moments = []
        self._due = 0.0
        self._pace = 0.0
        self.title = ""
        self.words = ""    # what happens now
        self.goal = None   # in the map
        self.barred = None

    def begin(self, title, pace):
        """From now on a moment each `pace` seconds."""
        self.title, self.words, self.goal = title, "", None
        self._pace = pace
        self._due = 0.0

    def take_if_due(self):
        now = self._truth.time()
        if self._pace <= 0.0 or now < self._due:
            return
        self._due = now + self._pace
        self.take()

    def take(self):
        known = self._mapper.pose(self._truth.time())
        self._moments.append(Moment(
            self.title, self.words, len(self._truth.track), self._truth.outline, self._mapper.map,
            self._mapper.graph, known[0] if known else None,
            [] if known else self._mapper.believed(), self.goal, self.barred))

    def write(self, animation, picture):
        """The moments as GIF, and the last one as PNG."""
        if len(self._moments) < 2:
            self.take()
            self.take()
        scene = Scene(self._truth.track, self._truth.outline)
        frames = []
        for moment in self._moments:
            scene.show(moment)
            frames.append(scene.frame())
        # One palette for all, so that what stays is the same in each frame, and costs nothing.
        palette = palette_of(INKS)
        frames = [frame.quantize(palette=palette, dither=Image.NONE) for frame in frames]
        times = [FRAME_TIME] * (len(frames) - 1) + [LAST_TIME]
        frames[0].save(animation, save_all=True, append_images=frames[1:], duration=times, loop=0)
        scene.write(picture)
