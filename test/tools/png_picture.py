"""Pictures as the tools write them."""

import collections
import struct
import zlib


class Picture:
    """Of a PNG file as the tools write it: RGB, unfiltered."""

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        assert data[:8] == b"\x89PNG\r\n\x1a\n"
        self.width, self.height = struct.unpack(">II", data[16:24])
        start = data.index(b"IDAT")
        length, = struct.unpack(">I", data[start - 4:start])
        self.bytes = zlib.decompress(data[start + 4:start + 4 + length])
        assert len(self.bytes) == self.height * (1 + 3 * self.width)

    def shares(self):
        """Of the pixels, by colour."""
        size = 3 * self.width + 1
        pixels = [self.bytes[row * size + 1 + i:row * size + 4 + i]
                  for row in range(self.height) for i in range(0, 3 * self.width, 3)]
        counts = collections.Counter(pixels)
        return collections.Counter({colour: n / len(pixels) for colour, n in counts.items()})
