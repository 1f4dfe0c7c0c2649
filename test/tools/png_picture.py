"""Pictures as the tools write them."""

import collections
import struct
import subprocess


class Picture:
    """Of a PNG file, as ImageMagick reads it."""

    def __init__(self, path):
        with open(path, "rb") as file:
            self.width, self.height = struct.unpack(">II", file.read(24)[16:])
        self.bytes = subprocess.run(["convert", "png:" + path, "-depth", "8", "rgb:-"], check=True,
                                    stdout=subprocess.PIPE).stdout
        assert len(self.bytes) == self.height * 3 * self.width

    def shares(self):
        """Of the pixels, by colour."""
        pixels = [self.bytes[i:i + 3] for i in range(0, len(self.bytes), 3)]
        counts = collections.Counter(pixels)
        return collections.Counter({colour: n / len(pixels) for colour, n in counts.items()})
