"""One picture of a glTF file by edvo (its Python module, e.g. PYTHONPATH=build/release/python) and by Blender's
Cycles, one thread each, without tone curves."""

import os
import pathlib
import subprocess
import time

import numpy as np

import edvo

REFLECTIONS = 8


def render_by_edvo(scene, view, samples, denoise=False, mode="path", channel="radiance"):
    """Return the radiance of edvo's picture, or another of its channels, and the CPU time, s."""
    options = edvo.RenderOptions()
    options.mode, options.samples, options.ambient, options.bounces = mode, samples, 0, REFLECTIONS
    options.denoise = denoise
    cx, cy = (view.width - 1) / 2, (view.height - 1) / 2
    camera = edvo.Camera(width=view.width, height=view.height, fx=view.focal, fy=view.focal, cx=cx, cy=cy)
    pose = np.diag([1.0, -1.0, -1.0, 1.0])
    pose[:3, 3] = view.eye
    renderer = edvo.Renderer(edvo.Scene(str(scene)), options, exposure=1)
    begun = time.process_time()
    frame = renderer.render(camera, pose, ["image" if channel == "radiance" else channel])
    picture = np.array(frame[channel])
    return picture, time.process_time() - begun


def render_by_cycles(scene, view, samples, reflections=REFLECTIONS):
    """Return the radiance of Cycles' picture and its CPU time, s, without that of its start; without reflections
    surfaces show their base colour."""
    script = pathlib.Path(__file__).with_name("render_by_cycles.py")
    out = scene.with_name("cycles.npy")
    command = ["blender", "-b", "-P", script, "--", scene, out, str(samples), str(reflections)]
    command += [str(number) for number in (*view[:3], *view.eye)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    seconds = [float(line.split()[1]) for line in done.stdout.splitlines() if line.startswith("CPU ")]
    picture = np.load(out)
    os.remove(out)
    return picture, seconds[0]
