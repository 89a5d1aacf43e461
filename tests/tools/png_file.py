"""A reader of PNG that shares nothing with the project's own: by zlib and the PNG specification."""

import pathlib
import struct
import zlib

import numpy


def paeth(left, above, corner):
    estimate = left + above - corner
    distances = abs(estimate - left), abs(estimate - above), abs(estimate - corner)
    return (left, above, corner)[distances.index(min(distances))]


def unfilter(kind, line, before, step):
    """Undoes one line's filter (PNG specification, 9.2), in place."""
    for i in range(len(line)):
        left = line[i - step] if i >= step else 0
        above = before[i]
        corner = before[i - step] if i >= step else 0
        line[i] = (line[i] + (0, left, above, (left + above) // 2, paeth(left, above, corner))[kind]) & 255


def read_png(path):
    """Pixels of a PNG of 8 or 16 bits, grey or RGB: rows, columns[, 3]."""
    data = pathlib.Path(path).read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", f"{path} is no PNG"
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        assert zlib.crc32(kind + body) == struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0], path
        if kind == b"IHDR":
            width, height, bits, colour, _, _, interlaced = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
        at += 12 + length
    assert not interlaced and colour in (0, 2) and bits in (8, 16), path
    channels = 1 if colour == 0 else 3
    step = channels * bits // 8
    raw = zlib.decompress(packed)
    before, rows = bytearray(width * step), []
    for row in range(height):
        begin = row * (1 + width * step)
        line = bytearray(raw[begin + 1:begin + 1 + width * step])
        unfilter(raw[begin], line, before, step)
        rows.append(bytes(line))
        before = line
    pixels = numpy.frombuffer(b"".join(rows), ">u2" if bits == 16 else "u1")
    return pixels.reshape((height, width) if channels == 1 else (height, width, 3))
