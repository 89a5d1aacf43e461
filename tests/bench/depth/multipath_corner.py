#!/usr/bin/env python3
"""multipath_corner.py EDVO OUT [--size 640x480] [--frequencies 20e6,80e6,200e6]: multipath interference in a corner.

Renders the corner of assets/white_room by the program EDVO, with and without sensor.depth.multipath, on one thread, and
prints for each frequency how far the depth of one wall is off, by the distance from the corner: the mean and, of two
renderings with other seeds, the noise of the estimate; then the CPU time of a frame. Writes OUT/multipath.json and,
where matplotlib is installed, OUT/multipath.svg."""

import argparse
import json
import pathlib
import resource
import shutil
import subprocess

import numpy as np

SCENE = pathlib.Path(__file__).parents[3] / "assets/white_room/white_room.gltf"
FOV_DEG = 60
EYE = np.array([-0.8, 1.4, 0.8])
TARGET = np.array([2.0, 1.2, -1.75])
WALL_X, CORNER_Z = 2.0, -1.75  # m: the wall x = 2 meets the one at z = -1.75
HEIGHTS = 1.4, 1.8  # m, above the furniture, below the lamp
BINS = (0, 0.05, 0.1, 0.2, 0.3, 0.5, 0.8, 1.2, 2)  # m from the corner


def depth_of(program, out, size, options):
    """Return the float depth of the view, m, and the CPU time of the program, s."""
    shutil.rmtree(out, ignore_errors=True)
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    view = ["--path", "still", "--duration", "0.01", "--fov", str(FOV_DEG), "--size", size]
    view += [f"--move.{name}=" + ",".join(map(str, place)) for name, place in (("eye", EYE), ("target", TARGET))]
    subprocess.run([program, "render", SCENE, *view, "--mode", "depth", "--float-depth", "--threads", "1", "--quiet",
                    "--no-sync", "--out", out, *options], check=True, stdout=subprocess.DEVNULL)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    return np.load(out / "depth_float/000000.npy"), seconds


def points_of(depth):
    """Return the world's coordinates of what each pixel sees, m."""
    height, width = depth.shape
    focal = width / 2 / np.tan(np.radians(FOV_DEG / 2))
    u, v = np.meshgrid(np.arange(width) - (width - 1) / 2, np.arange(height) - (height - 1) / 2)
    forward = (TARGET - EYE) / np.linalg.norm(TARGET - EYE)
    right = np.cross(forward, [0, 1, 0])
    right /= np.linalg.norm(right)
    down = np.cross(forward, right)
    rays = (u / focal)[..., None] * right + (v / focal)[..., None] * down + forward
    return EYE + depth[..., None] * rays


def multipath(frequency, seed):
    return ["--depth.multipath.frequency", str(frequency), "--depth.multipath.seed", str(seed)]


def profile_of(errors, distances):
    """Return the mean error, m, and the noise of it, m, in each bin of distances from the corner."""
    rows = []
    for low, high in zip(BINS, BINS[1:]):
        inside = (distances >= low) & (distances < high)
        first, second = errors[0][inside], errors[1][inside]
        rows.append({"from_m": low, "to_m": high, "error_m": float((first.mean() + second.mean()) / 2),
                     "noise_m": float((first - second).std() / np.sqrt(2))})
    return rows


def plot(curves, path):
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams["svg.fonttype"] = "none"  # text stays text
    matplotlib.rcParams["svg.hashsalt"] = "edvo"  # names of parts are the same each time
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(5, 3.5))
    for frequency, (distances, errors) in curves.items():
        axes.plot(100 * distances, 1000 * errors, label=f"{frequency / 1e6:g} MHz")
    axes.axhline(0, color="black", linewidth=0.5)
    axes.set_xlabel("distance from the corner [cm]")
    axes.set_ylabel("error of depth [mm]")
    axes.grid(True, alpha=0.3)
    axes.legend()
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})


def curve_of(errors, distances):
    """Return the median error at steps of 2 cm from the corner."""
    steps = np.arange(0, 2, 0.02)
    places = np.digitize(distances, steps)
    seen = [i for i in range(1, len(steps)) if (places == i).sum() > 10]
    return steps[seen] - 0.01, np.array([np.median(errors[places == i]) for i in seen])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--size", default="640x480")
    parser.add_argument("--frequencies", default="20e6,80e6,200e6")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    folder = arguments.out / "sequence"
    exact, seconds_without = depth_of(arguments.program, folder, arguments.size, [])
    points = points_of(exact)
    on_wall = (abs(points[..., 0] - WALL_X) < 1e-3) & (points[..., 1] > HEIGHTS[0]) & (points[..., 1] < HEIGHTS[1])
    distances = points[..., 2][on_wall] - CORNER_Z
    result, curves, seconds = {}, {}, []
    for frequency in map(float, arguments.frequencies.split(",")):
        errors = []
        for seed in (1, 2):
            depth, spent = depth_of(arguments.program, folder, arguments.size, multipath(frequency, seed))
            errors.append((depth - exact)[on_wall])
            seconds.append(spent - seconds_without)
        result[f"{frequency:g}"] = profile_of(errors, distances)
        curves[frequency] = curve_of(errors[0], distances)
        print(f"{frequency / 1e6:g} MHz")
        for row in result[f"{frequency:g}"]:
            print(f"  {100 * row['from_m']:5.0f} to {100 * row['to_m']:3.0f} cm: {1000 * row['error_m']:7.1f} mm, "
                  f"noise {1000 * row['noise_m']:.1f} mm")
    print(f"CPU time of a frame of {arguments.size}: {np.mean(seconds):.1f} s more than {seconds_without:.1f} s")
    result["cpu_s"] = {"without": seconds_without, "more": float(np.mean(seconds))}
    (arguments.out / "multipath.json").write_text(json.dumps(result, indent=1) + "\n")
    shutil.rmtree(folder)
    try:
        plot(curves, arguments.out / "multipath.svg")
    except ImportError:
        print("no plot: matplotlib is not installed")


if __name__ == "__main__":
    main()
