#!/usr/bin/env python3
"""denoised_frames.py EDVO OUT [--samples 4,16,64] [--around 0,1,2,4] [--reference 16384]: denoising by the frames around.

Renders the box of light_noise.py by `edvo render --mode path --denoise`, nine frames of a camera that moves past it and
nine of one at rest, with the light of as many frames before and after as --around says, and prints for each number of
samples the CPU time of a frame; the noise and the change of brightness of the moving camera's middle frame: the
root-mean-square difference, and that of the means, from its picture of --reference samples without a denoiser, over its
mean; and the flicker, the root-mean-square change from frame to frame of the camera at rest over the square root of 2,
likewise. Colours are of 8 bits; pixels that the exposure saturates are left out."""

import argparse
import math
import pathlib
import resource
import subprocess

import cv2
import numpy as np

from lamp_box import VIEW, lamp_box

FRAMES = 9
MIDDLE = FRAMES // 2
SATURATED = 0.95


def pose(step):
    """Return a line's position and quaternion: a camera that looks along -z, `step` frames past the middle."""
    half = 0.01 * step  # rad, of a turn about the vertical
    position = (0.03 * step, 0.01 * step, VIEW.eye[2] - 0.02 * step)
    return " ".join(f"{value:.9f}" for value in (*position, math.cos(half), 0, -math.sin(half), 0))


def render(edvo, folder, path, samples, *options):
    """Render the box; return the CPU seconds."""
    begun = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(
        [edvo, "render", path.with_name("lamp_box.gltf"), "--trajectory", path, "--out", folder, "--force",
         "--size", f"{VIEW.width}x{VIEW.height}",
         "--intrinsics", f"{VIEW.focal},{VIEW.focal},{(VIEW.width - 1) / 2},{(VIEW.height - 1) / 2}",
         "--mode", "path", "--bounces", "8", "--ambient", "0", "--exposure", "0.6", "--samples", str(samples), *options],
        check=True, capture_output=True)
    ended = resource.getrusage(resource.RUSAGE_CHILDREN)
    return ended.ru_utime + ended.ru_stime - begun.ru_utime - begun.ru_stime


def linear(folder, frame):
    """Return a frame's linear colours, 0 to 1."""
    image = cv2.imread(str(folder / f"rgb/{frame:06d}.png")).astype(float) / 255
    return np.where(image <= 0.04045, image / 12.92, ((image + 0.055) / 1.055) ** 2.4)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("edvo")
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--samples", default="4,16,64")
    parser.add_argument("--around", default="0,1,2,4")
    parser.add_argument("--reference", type=int, default=16384)
    arguments = parser.parse_args()
    out = arguments.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    (out / "lamp_box.gltf").write_text(lamp_box())
    moving, still, middle = out / "moving.txt", out / "still.txt", out / "middle.txt"
    moving.write_text("".join(f"{i}.0 {pose(i - MIDDLE)}\n" for i in range(FRAMES)))
    still.write_text("".join(f"{i}.0 {pose(0)}\n" for i in range(FRAMES)))
    middle.write_text(f"0.0 {pose(0)}\n")
    render(arguments.edvo, out / "reference", middle, arguments.reference)
    reference = linear(out / "reference", 0)
    is_shown = reference.max(axis=-1) < SATURATED
    mean = reference[is_shown].mean()
    print("samples  around  CPU s a frame   noise  brighter  flicker")
    for samples in arguments.samples.split(","):
        for around in arguments.around.split(","):
            options = ("--denoise", "--denoise-frames", around)
            seconds = render(arguments.edvo, out / "moving", moving, samples, *options)
            render(arguments.edvo, out / "still", still, samples, *options)
            error = (linear(out / "moving", MIDDLE) - reference)[is_shown] / mean
            seen = np.array([linear(out / "still", i)[is_shown] for i in range(FRAMES)]) / mean
            flicker = np.sqrt((np.diff(seen, axis=0) ** 2).mean() / 2)
            print(f"{samples:>7} {around:>7} {seconds / FRAMES:14.3f} {np.sqrt((error**2).mean()):7.3f} "
                  f"{100 * error.mean():7.1f} % {flicker:8.3f}", flush=True)


if __name__ == "__main__":
    main()
