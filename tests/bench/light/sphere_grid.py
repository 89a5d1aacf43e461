#!/usr/bin/env python3
"""sphere_grid.py OUT [--samples 1024]: balls of all metalness and roughness by edvo and by Blender's Cycles.

25 balls in a box with a lamp: metallic 0 to 1 from left to right, roughness 0.1 to 1 from top to bottom. Prints for
each ball, and for the whole picture, the mean magnitude of the renderers' difference over the mean of Cycles', after
a common exposure, in means of blocks of pixels, which have less noise. Writes OUT/sphere_grid.png with both pictures and ten times their difference.
Needs edvo's Python module (PYTHONPATH=build/release/python), blender and python3-matplotlib."""

import argparse
import pathlib

import numpy as np

from lamp_box import View, ball, lit_box, material
from renderers import render_by_cycles, render_by_edvo

VIEW = View(200, 150, 120, (0, 0, 1.8))
BLOCK = 5  # px
STEPS, SPACING, RADIUS, DISTANCE = 5, 0.5, 0.22, 2.4  # balls a row, m, m, m before the camera
COLOUR = (0.8, 0.5, 0.2)
ROUGHEST, SMOOTHEST = 1.0, 0.1
LAMP = 3  # radiance; what is brighter is the lamp


def place_of(step):
    return (step - (STEPS - 1) / 2) * SPACING


def sphere_grid():
    document = lit_box(1.2, 6)
    for row in range(STEPS):
        roughness = SMOOTHEST + (ROUGHEST - SMOOTHEST) * row / (STEPS - 1)
        for column in range(STEPS):
            centre = (place_of(column), -place_of(row), VIEW.eye[2] - DISTANCE)
            # A hair below 1: `material` makes Lambert's of what is no metal and fully rough.
            document.add(ball(centre, RADIUS), material(COLOUR, column / (STEPS - 1), min(roughness, 0.999)))
    return document.text()


def pixels_of_ball(row, column):
    """Return the slice of pixels in the square within a ball's outline."""
    half = round(0.65 * RADIUS / DISTANCE * VIEW.focal)
    u = round((VIEW.width - 1) / 2 + place_of(column) / DISTANCE * VIEW.focal)
    v = round((VIEW.height - 1) / 2 + place_of(row) / DISTANCE * VIEW.focal)
    return slice(v - half, v + half + 1), slice(u - half, u + half + 1)


def blocks_of(picture):
    """Return the means of a picture's whole blocks."""
    height, width = (size // BLOCK for size in picture.shape[:2])
    cut = picture[: height * BLOCK, : width * BLOCK]
    return cut.reshape(height, BLOCK, width, BLOCK, -1).mean(axis=(1, 3))


def difference(ours, theirs):
    ours, theirs = blocks_of(ours), blocks_of(theirs)
    return 100 * np.abs(ours - theirs).mean() / theirs.mean()


def show(ours, theirs, white, path):
    import matplotlib

    matplotlib.use("agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(1, 3, figsize=(15, 4.2))
    for axis, picture, title in zip(
        axes, (ours, theirs, 10 * np.abs(ours - theirs)), ("edvo", "Cycles", "difference, times 10")
    ):
        axis.imshow(np.clip(picture / white, 0, 1) ** (1 / 2.2))
        axis.set_title(title)
        axis.set_axis_off()
    figure.tight_layout()
    figure.savefig(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--samples", type=int, default=1024)
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    scene = arguments.out.resolve() / "sphere_grid.gltf"
    scene.write_text(sphere_grid())
    ours, _ = render_by_edvo(scene, VIEW, arguments.samples)
    theirs, _ = render_by_cycles(scene, VIEW, arguments.samples)
    is_lit = (ours.max(axis=-1) < LAMP) & (theirs.max(axis=-1) < LAMP)
    exposure = theirs[is_lit].mean() / ours[is_lit].mean()
    ours = ours * exposure
    print("mean difference in % of the mean; metallic 0 to 1 from left to right, roughness from top to bottom")
    for row in range(STEPS):
        balls = [pixels_of_ball(row, column) for column in range(STEPS)]
        print(*(f"{difference(ours[pixels], theirs[pixels]):7.2f}" for pixels in balls))
    lit = is_lit[..., np.newaxis]
    print(f"all pixels but the lamp's: {difference(ours * lit, theirs * lit):.2f}; edvo's exposure {exposure:.4f}")
    show(ours, theirs, np.percentile(theirs[is_lit], 99), arguments.out / "sphere_grid.png")


if __name__ == "__main__":
    main()
