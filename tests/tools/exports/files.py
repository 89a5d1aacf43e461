"""Readers of images that share nothing with the project's own: PNG by zlib, and by numpy what is numpy's."""

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


def read_tum_list(path):
    """The stamps and the files of a list."""
    lines = [line.split() for line in pathlib.Path(path).read_text().splitlines() if not line.startswith("#")]
    return [(float(words[0]), words[1:]) for words in lines]


def rotation_of(x, y, z, w):
    """The matrix of a unit quaternion."""
    return numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def matrix_of(position, quaternion):
    matrix = numpy.eye(4)
    matrix[:3, :3] = rotation_of(*quaternion)
    matrix[:3, 3] = position
    return matrix


def read_tum_poses(path):
    """The stamps and the matrices of T_world_camera."""
    return [(stamp, matrix_of([float(v) for v in rest[:3]], [float(v) for v in rest[3:7]]))
            for stamp, rest in read_tum_list(path)]
