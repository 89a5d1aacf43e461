"""The simplest file of OpenEXR: scan lines of one colour, 32-bit floats without compression."""

import struct

CHANNELS = ("B", "G", "R")  # in the order that the format asks for
FLOAT = 2


def attribute(name, kind, value):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value


def small_exr(width, height, rgb):
    """Returns the bytes of an image of this size and colour, which are linear numbers of red, green and blue."""
    channels = b"".join(name.encode() + b"\0" + struct.pack("<iB3xii", FLOAT, 0, 1, 1) for name in CHANNELS) + b"\0"
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    header = struct.pack("<ii", 20000630, 2) + b"".join([
        attribute("channels", "chlist", channels),
        attribute("compression", "compression", b"\0"),
        attribute("dataWindow", "box2i", window),
        attribute("displayWindow", "box2i", window),
        attribute("lineOrder", "lineOrder", b"\0"),
        attribute("pixelAspectRatio", "float", struct.pack("<f", 1)),
        attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0)),
        attribute("screenWindowWidth", "float", struct.pack("<f", 1)),
    ]) + b"\0"
    colour = dict(zip("RGB", rgb))
    pixels = b"".join(struct.pack("<f", colour[name]) * width for name in CHANNELS)
    first = len(header) + 8 * height
    offsets = b"".join(struct.pack("<Q", first + v * (8 + len(pixels))) for v in range(height))
    lines = b"".join(struct.pack("<ii", v, len(pixels)) + pixels for v in range(height))
    return header + offsets + lines
