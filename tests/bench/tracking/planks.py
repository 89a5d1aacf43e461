#!/usr/bin/env python3
"""planks.py OUT: what the tracker says of a motion along which nothing changes but noise.

Makes a corridor of planks in OUT and films its wall 2 s long, 0.6 m along the planks and 0.4 m across them, by a small sensor's
noise and as a Kinect sees it. Prints of each the RMSE of the absolute error, the greatest error of a pose that was called
sure, the frames that were not, and the median and the greatest `noise_share` of the frame log."""

import argparse
import base64
import csv
import json
import pathlib
import random
import statistics
import struct
import subprocess

LENGTH, HEIGHT, WIDTH = 12, 2.6, 3  # m, of the corridor along x, y and z
SENSORS = {
    "small sensor": "noise.full_well = [6000.0, 6000.0, 6000.0]\nnoise.read_noise = [15.0, 15.0, 15.0]\nnoise.pixel_gain = 0.01",
    "kinect-v1": 'preset = "kinect-v1"',
}
MOTIONS = {"along": (0.6, 0, 0), "across": (0, 0.4, 0)}  # m
SCENARIO = """why = "a wall of planks, filmed {motion} them"
[scene]
gltf = "{scene}"
[camera]
width = 320
height = 240
fov_deg = 62.0
[path]
kind = "dolly"
rate = 30.0
duration = 2.0
move.eye = [-0.3, 1.1, 0.6]
move.target = [-0.3, 0.9, -1.0]
move.by = [{by[0]}, {by[1]}, {by[2]}]
move.ramp = 0.2
[render]
samples = 4
[sensor]
{sensor}
"""


def planks(chance):
    """Yield the borders across a wall, as shares of it, and the brightness of its planks."""
    begin = 0.0
    while begin < 1:
        end = min(1.0, begin + chance.uniform(0.012, 0.055))
        yield begin, end, chance.uniform(0.05, 0.6)
        begin = end


def corners(side, share):
    """Return the two corners of a plank's border, m; `share` goes across floor, walls and ceiling."""
    across = (share - 0.5) * WIDTH if side in ("floor", "ceiling") else share * HEIGHT
    y, z = {"floor": (0, across), "ceiling": (HEIGHT, across), "far": (across, -WIDTH / 2),
            "near": (across, WIDTH / 2)}[side]
    return (-LENGTH / 2, y, z), (LENGTH / 2, y, z)


def corridor():
    """Return the corridor as glTF: planks of one colour each, which shows as it is."""
    chance = random.Random(3)
    positions, colours, indices = [], [], []
    for side in ("floor", "ceiling", "far", "near"):
        for begin, end, brightness in planks(chance):
            first = len(positions)
            positions += [*corners(side, begin), *corners(side, end)]
            colours += 4 * [3 * (brightness,)]
            indices += [first, first + 1, first + 3, first, first + 3, first + 2]
    count = len(positions)
    data = b"".join(struct.pack("<3f", *row) for row in positions + colours) + struct.pack(f"<{len(indices)}H", *indices)
    views = [(0, 12 * count), (12 * count, 12 * count), (24 * count, 2 * len(indices))]
    bounds = {name: [of(row[k] for row in positions) for k in range(3)] for name, of in (("min", min), ("max", max))}
    return json.dumps({
        "asset": {"version": "2.0"},
        "extensionsUsed": ["KHR_materials_unlit"],
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 1}, "indices": 2, "material": 0}]}],
        "materials": [{"doubleSided": True, "extensions": {"KHR_materials_unlit": {}}}],
        "buffers": [{"byteLength": len(data),
                     "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
        "bufferViews": [{"buffer": 0, "byteOffset": at, "byteLength": size} for at, size in views],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": count, "type": "VEC3", **in_single_precision(bounds)},
            {"bufferView": 1, "componentType": 5126, "count": count, "type": "VEC3"},
            {"bufferView": 2, "componentType": 5123, "count": len(indices), "type": "SCALAR"},
        ],
    })


def in_single_precision(bounds):
    """Return the bounds as single precision has them, which glTF's validators compare."""
    return {name: list(struct.unpack("<3f", struct.pack("<3f", *values))) for name, values in bounds.items()}


def mean_of(metrics, name):
    """Return a metric of the results of `edvo test`, in mm, wherever they have it."""
    if isinstance(metrics, dict):
        if name in metrics:
            value = metrics[name]
            return 1e3 * (value["mean"] if isinstance(value, dict) else value)
        metrics = metrics.values()
    if not isinstance(metrics, (str, int, float, type(None))):
        for part in metrics:
            found = mean_of(part, name)
            if found is not None:
                return found
    return None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--edvo", default="build/release/edvo")
    arguments = parser.parse_args()
    edvo, out = pathlib.Path(arguments.edvo).resolve(), arguments.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    scene = out / "planks.gltf"
    scene.write_text(corridor())
    print("                        ATE, mm  worst sure, mm  not sure  share, median  greatest")
    for motion, by in MOTIONS.items():
        for sensor, table in SENSORS.items():
            name = f"{motion}_{sensor.replace(' ', '_')}"
            scenario = out / f"{name}.toml"
            scenario.write_text(SCENARIO.format(motion=motion, by=[float(x) for x in by], sensor=table, scene=scene))
            results, cache, log = out / f"{name}.json", out / name, out / f"{name}.csv"
            subprocess.run([edvo, "test", scenario, "--bounds", "none", "--cache", cache, "--again", "--json", results, "--quiet"],
                           check=True, stdout=subprocess.DEVNULL)
            sequence = next((cache / "sequences").glob("*/sequence.toml")).parent
            subprocess.run([edvo, "track", sequence, "--out", out / f"{name}.txt", "--frame-log", log, "--force", "--quiet"],
                           check=False, stdout=subprocess.DEVNULL)  # 5 where frames are uncertain
            frames = list(csv.DictReader(log.open()))[1:]
            shares = [float(frame["noise_share"]) for frame in frames]
            doubted = sum(frame["status"] != "tracked" for frame in frames)
            metrics = json.loads(results.read_text())
            print(f"{motion:7} {sensor:13} {mean_of(metrics, 'ate_rmse_m'):10.1f} {mean_of(metrics, 'sure_error_max_m'):15.1f}"
                  f" {doubted:4} of {len(frames)} {statistics.median(shares):13.2f} {max(shares):9.2f}", flush=True)


if __name__ == "__main__":
    main()
