"""Tracks a TUM folder in each format that holds RGB-D, and compares the poses with those of the folder.

    python3 -B clip_in_every_format.py CLIP OUT [--camera NAME] [--edvo PROGRAM]

A line a format: who wrote it, whether the trajectory has the same bytes, and the largest distance between
positions of the same frame, mm. EuRoC's lens model has four parameters: the images are written as those of a
camera without distortion and tracked with the clip's. 7-Scenes holds depth in mm and no stamps; it is compared
with a TUM folder of the same depth at its rate of 30 Hz. Needs python3-opencv and, for bags, ROS' modules. OUT is
made.
"""

import argparse
import pathlib
import shutil
import subprocess
import sys

import cv2

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path += [str(ROOT / "tests/tools"), str(ROOT / "tests/tools/recordings")]

from ros_bag import compressed_images, lines_of, poses, raw_images, write_bag  # noqa: E402

RATE_HZ = 30.0


class Clip:
    def __init__(self, arguments):
        self.edvo, self.folder = arguments.edvo, pathlib.Path(arguments.clip)
        self.out, self.camera = pathlib.Path(arguments.out), arguments.camera

    def run(self, *words):
        done = subprocess.run([self.edvo, *map(str, words), "--quiet"], capture_output=True, text=True)
        if done.returncode not in (0, 5):  # 5: a frame is lost or uncertain
            raise SystemExit(f"{' '.join(map(str, words))}: {done.stderr}")

    def tracked(self, sequence, camera=None):
        path = self.out / f"{sequence.name}.estimate.txt"
        self.run("track", sequence, "--camera", camera or self.camera, "--out", path)
        return path

    def converted(self, name, kind, camera=None):
        self.run("convert", self.folder, self.out / name, "--format", kind, "--camera", camera or self.camera)
        return self.out / name

    def camera_with(self, name, change):
        """Writes the camera with changed lines, as that of the TUM folder that was converted to."""
        lines = (self.out / "tum" / "camera.toml").read_text().splitlines()
        path = self.out / name
        path.write_text("".join(f"{changed}\n" for line in lines if (changed := change(line))))
        return path

    def bag(self, name, messages):
        write_bag(self.out / name, [*messages, *poses(self.folder)], "lz4")
        return self.out / name


def paired(folder):
    """Pairs of an image and the depth nearest in time, within 20 ms: (stamp, image, depth)."""
    depths = [(float(stamp), name) for stamp, name in lines_of(folder / "depth.txt")]
    for stamp, image in lines_of(folder / "rgb.txt"):
        nearest = min(depths, key=lambda depth: abs(depth[0] - float(stamp)))
        if abs(nearest[0] - float(stamp)) < 0.02:
            yield stamp, folder / image, folder / nearest[1]


def pixels_of(path):
    pixels = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
    return pixels if pixels.ndim == 2 else pixels[:, :, ::-1]


def depth_mm(path):
    """Depth of TUM's unit, 1/5000 m, in whole mm."""
    return ((pixels_of(path).astype("uint32") + 2) // 5).astype("uint16")


def write_millimetres(clip):
    """Writes the clip's pairs as 7-Scenes does, and as a TUM folder with the stamps that 7-Scenes has."""
    seven, tum = clip.out / "seven_scenes", clip.out / "tum_of_mm"
    for folder in (seven, tum / "rgb", tum / "depth"):
        folder.mkdir(parents=True)
    lists = {"rgb": [], "depth": []}
    for i, (_, image, depth) in enumerate(paired(clip.folder)):
        millimetres = depth_mm(depth)
        shutil.copy(image, seven / f"frame-{i:06d}.color.png")
        cv2.imwrite(str(seven / f"frame-{i:06d}.depth.png"), millimetres)
        shutil.copy(image, tum / f"rgb/{i:06d}.png")
        cv2.imwrite(str(tum / f"depth/{i:06d}.png"), millimetres)
        for kind, lines in lists.items():
            lines.append(f"{i / RATE_HZ!r} {kind}/{i:06d}.png\n")
    for kind, lines in lists.items():
        (tum / f"{kind}.txt").write_text("".join(lines))
    return seven, tum


def positions(path):
    return [tuple(map(float, line[1:4])) for line in lines_of(path)]


def compare(name, writer, path, expected):
    pairs = list(zip(positions(path), positions(expected)))
    count = len(positions(path)), len(positions(expected))
    worst = max(sum((a - b) ** 2 for a, b in zip(*pair)) ** 0.5 for pair in pairs)
    same = "same bytes" if path.read_bytes() == expected.read_bytes() else "differs"
    print(f"{name:28}{writer:28}{count[0]:5} of {count[1]}  {same:12}{1000 * worst:9.4f}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("clip")
    parser.add_argument("out")
    parser.add_argument("--camera", default="tum-fr1")
    parser.add_argument("--edvo", default=str(ROOT / "build/release/edvo"))
    arguments = parser.parse_args()
    clip = Clip(arguments)
    clip.out.mkdir(parents=True)
    expected = clip.tracked(clip.folder)
    print(f"{'format':28}{'written by':28}{'poses':>12}  {'trajectory':12}{'mm':>9}")
    for kind, name in (("tum", "tum"), ("mcap", "clip.mcap")):
        compare(kind, "edvo convert", clip.tracked(clip.converted(name, kind)), expected)
    undistorted = clip.camera_with("undistorted.toml", lambda line: "" if "distortion" in line else line)
    compare("euroc", "edvo convert", clip.tracked(clip.converted("euroc", "euroc", undistorted)), expected)
    bag = clip.bag("compressed.bag", compressed_images(clip.folder, "mono8; png compressed "))
    compare("ROS 1 bag, PNG", "rosbag", clip.tracked(bag), expected)
    bag = clip.bag("raw.bag", raw_images(clip.folder, pixels_of))
    compare("ROS 1 bag, raw, 32FC1", "rosbag", clip.tracked(bag), expected)
    seven, tum = write_millimetres(clip)
    in_mm = clip.camera_with("mm.toml", lambda line: line.replace("5000", "1000"))
    compare("7-Scenes, against TUM of mm", "this program", clip.tracked(seven, in_mm), clip.tracked(tum, in_mm))


main()
