#!/usr/bin/env python3
"""simple_modes.py OUT: time of depth, base colours and direct light by edvo and by Blender's Cycles.

Renders a box with two balls and a lamp of point size, 320x240 px, one thread each, and prints the CPU time of a picture
by both renderers (edvo's Python module, e.g. PYTHONPATH=build/release/python) and how many times as long Cycles takes:
depth alone, where Cycles' least is one sample of unlit surfaces; surfaces that show their base colour, 16 samples; light
of the lamp with its shadows and no reflection after the first, 16 samples. Last come the samples alone: of 16 of 32,
without what a picture costs at its begin. The means of both pictures are printed, too, for unlit and direct light."""

import argparse
import pathlib

from lamp_box import View, point_lit_box
from renderers import render_by_cycles, render_by_edvo

VIEW = View(320, 240, 240, (0, 0, 1.8))
TIMES = 3  # of which the least counts
COUNT = 16


def least(render, *arguments, **options):
    """Return the picture and the least CPU time of some renderings."""
    done = [render(*arguments, **options) for _ in range(TIMES)]
    return done[0][0], min(seconds for _, seconds in done)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("out", type=pathlib.Path)
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    scene = arguments.out.resolve() / "point_lit_box.gltf"
    scene.write_text(point_lit_box())
    print("                     edvo, CPU s  Cycles, CPU s  times as long  mean, edvo  Cycles")

    def show(name, ours, theirs, means=""):
        print(f"{name:20} {ours:12.4f} {theirs:14.3f} {theirs / ours:14.1f}  {means}", flush=True)

    _, ours = least(render_by_edvo, scene, VIEW, 1, mode="depth", channel="depth")
    _, theirs = least(render_by_cycles, scene, VIEW, 1, reflections=0)
    show("depth", ours, theirs)
    for name, mode, reflections in (("unlit", "unlit", 0), ("direct light", "direct", 1)):
        picture, ours = least(render_by_edvo, scene, VIEW, COUNT, mode=mode)
        other, theirs = least(render_by_cycles, scene, VIEW, COUNT, reflections=reflections)
        show(f"{name}, {COUNT} samples", ours, theirs, f"{picture.mean():10.4f} {other.mean():7.4f}")
        _, ours_twice = least(render_by_edvo, scene, VIEW, 2 * COUNT, mode=mode)
        _, theirs_twice = least(render_by_cycles, scene, VIEW, 2 * COUNT, reflections=reflections)
        cells = {count: int(-(-(count**0.5) // 1)) ** 2 for count in (COUNT, 2 * COUNT)}  # edvo's are square numbers
        per_sample = (ours_twice - ours) / (cells[2 * COUNT] - cells[COUNT])
        show("  16 samples more", COUNT * per_sample, theirs_twice - theirs)


if __name__ == "__main__":
    main()
