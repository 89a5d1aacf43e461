"""Readers of files that share nothing with the project's own."""

import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from png_file import read_png  # noqa: E402, F401  (beside the folders of the tests that read images)


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
