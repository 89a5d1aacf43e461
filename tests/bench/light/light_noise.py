#!/usr/bin/env python3
"""light_noise.py OUT [--samples 4,16,64,256] [--reference 4096]: noise of path tracing against its time.

Renders a box with a lamp by `edvo` (its Python module, e.g. PYTHONPATH=build/release/python), with and without its
denoiser, and, where Blender is installed, by Cycles, one thread each, and prints for each number of samples the CPU
time, the noise and the change of brightness: the root-mean-square difference, and that of the means, from the same
renderer's picture of --reference samples without a denoiser, over its mean, in pixels below the lamp's brightness. Writes OUT/noise.json and, where matplotlib is installed, OUT/noise.svg."""

import argparse
import functools
import json
import pathlib
import shutil

import numpy as np

from lamp_box import VIEW, lamp_box
from renderers import render_by_cycles, render_by_edvo

LAMP = 6  # radiance; what is brighter is the lamp or shows it


def curve_of(render, scene, samples, converged):
    """Return a list of samples, CPU seconds, noise and change of brightness beside the converged picture."""
    is_lit = converged.max(axis=-1) < LAMP
    mean = converged[is_lit].mean()
    curve = []
    for count in samples:
        picture, seconds = render(scene, VIEW, count)
        error = (picture - converged)[is_lit]
        noise = float(np.sqrt((error**2).mean()) / mean)
        curve.append({"samples": count, "cpu_s": seconds, "noise": noise, "brighter": float(error.mean() / mean)})
    return curve


def seconds_at(noise, curve):
    """Return the CPU seconds after which a curve has this noise, interpolated in logarithms, beyond its ends too."""
    points = [(np.log(point["noise"]), np.log(point["cpu_s"])) for point in curve]
    pairs = list(zip(points, points[1:]))
    first, second = next((pair for pair in pairs if pair[1][0] <= np.log(noise)), pairs[-1])
    slope = (second[1] - first[1]) / (second[0] - first[0])
    return float(np.exp(first[1] + slope * (np.log(noise) - first[0])))


def plot(curves, path):
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams["svg.fonttype"] = "none"  # text stays text
    matplotlib.rcParams["svg.hashsalt"] = "edvo"  # names of parts are the same each time
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(5, 3.5))
    for name, curve in curves.items():
        axes.loglog([p["cpu_s"] for p in curve], [p["noise"] for p in curve], "o-", label=name)
    axes.set_xlabel("CPU time [s]")
    axes.set_ylabel("noise, rms over mean")
    axes.grid(True, which="both", alpha=0.3)
    axes.legend()
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--samples", default="4,16,64,256")
    parser.add_argument("--reference", type=int, default=4096)
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    scene = arguments.out.resolve() / "lamp_box.gltf"
    scene.write_text(lamp_box())
    samples = [int(count) for count in arguments.samples.split(",")]
    denoised = functools.partial(render_by_edvo, denoise=True)
    renderers = {"edvo": {"edvo": render_by_edvo, "edvo, denoised": denoised}}
    if shutil.which("blender"):
        renderers["Cycles"] = {"Cycles": render_by_cycles}
    curves, converged = {}, {}
    print("renderer        samples   CPU s   noise  brighter")
    for name, variants in renderers.items():
        converged[name], _ = variants[name](scene, VIEW, arguments.reference)
        for variant, render in variants.items():
            curves[variant] = curve_of(render, scene, samples, converged[name])
            for point in curves[variant]:
                print(f"{variant:14} {point['samples']:8} {point['cpu_s']:7.2f} {point['noise']:7.4f} "
                      f"{point['brighter']:9.4f}")
    if "Cycles" in curves:
        for variant in ("edvo", "edvo, denoised"):
            for point in curves[variant]:
                point["cycles_s_over"] = seconds_at(point["noise"], curves["Cycles"]) / point["cpu_s"]
                print(f"{variant:14} {point['samples']:8}: Cycles takes {point['cycles_s_over']:.2f} times as long")
    result = {"curves": curves}
    if len(converged) == 2:
        ours, theirs = converged["edvo"], converged["Cycles"]
        is_lit = (ours.max(axis=-1) < LAMP) & (theirs.max(axis=-1) < LAMP)
        result["mean_ratio"] = float(ours[is_lit].mean() / theirs[is_lit].mean())
        result["median_difference"] = float(np.median(np.abs(ours - theirs)[is_lit]) / theirs[is_lit].mean())
        print(f"mean of edvo's over mean of Cycles': {result['mean_ratio']:.4f}; "
              f"median difference {result['median_difference']:.4f} of the mean")
    (arguments.out / "noise.json").write_text(json.dumps(result, indent=1) + "\n")
    try:
        plot(curves, arguments.out / "noise.svg")
    except ImportError:
        print("no plot: matplotlib is not installed")


if __name__ == "__main__":
    main()
