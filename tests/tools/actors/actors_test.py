#!/usr/bin/env python3
"""Renders the walking figure of assets/ through a scene and reads what is written: actors_test.py EDVO SOURCE_FOLDER
WORK_FOLDER.

Exits with 77 (skipped) where python3-numpy is not installed.
"""

import json
import pathlib
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
try:
    import numpy
    from png_file import read_png
except ImportError:
    print("skipped: python3-numpy is not installed")
    sys.exit(77)

SPEED = 1.25  # m/s
RATE = 4      # Hz
FRAMES = 5
DEPTH = 4     # m from the camera to the plane of the path
FOCAL = 160   # px
CAMERA = f"--size 128x96 --intrinsics {FOCAL},{FOCAL},63.5,47.5 --path still --move.eye 0,0.9,{DEPTH} --move.target 0,0.9,0 " \
         f"--rate {RATE} --duration 1 --samples 1"
ACTOR = f"""[[actor]]
file = "walker.gltf"
animation = "walker"
skinned = true
path = [[-0.8, 0, 0], [0.8, 0, 0]]
speed = {SPEED}
"""


class Program:
    def __init__(self, program, work):
        self.program, self.work = program, work

    def run(self, words, exit_code=0):
        done = subprocess.run([self.program, *words.split()], cwd=self.work, capture_output=True, text=True, check=False)
        assert done.returncode == exit_code, f"edvo {words}: exit code {done.returncode}: {done.stderr}"
        return done.stderr

    def contents(self, folder):
        root = self.work / folder
        return {path.relative_to(root): path.read_bytes() for path in sorted(root.rglob("*")) if path.is_file()}


def read_flow(path):
    """Middlebury's: a tag, width and height, then u and v of each pixel."""
    data = path.read_bytes()
    assert data[:4] == b"PIEH"
    width, height = numpy.frombuffer(data, "<i4", 2, 4)
    return numpy.frombuffer(data, "<f4", 2 * width * height, 12).reshape(height, width, 2)


def prepare(work, source):
    """The figure, a file with actors, and a white wall of 12 x 12 m at z = -1."""
    for path in (source / "assets/walker").iterdir():
        shutil.copy(path, work)
    (work / "actor.toml").write_text(ACTOR, encoding="utf-8")
    corners = numpy.array([[-6, -6, -1], [6, -6, -1], [6, 6, -1], [-6, 6, -1]], "<f4")
    binary = corners.tobytes() + numpy.array([0, 1, 2, 0, 2, 3], "<u2").tobytes()
    (work / "wall.bin").write_bytes(binary)
    (work / "wall.gltf").write_text(json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"name": "wall", "mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"uri": "wall.bin", "byteLength": len(binary)}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
        "accessors": [{"bufferView": 0, "type": "VEC3", "componentType": 5126, "count": 4,
                       "min": [-6, -6, -1], "max": [6, 6, -1]},
                      {"bufferView": 1, "type": "SCALAR", "componentType": 5123, "count": 6}]}), encoding="utf-8")


def check_truth(edvo):
    """Who moves, by labels, ids, depth and flow; how far, by the speed."""
    edvo.run(f"render wall.gltf {CAMERA} --actor actor.toml --channels depth,instance,material,moving,flow --out walk")
    walk = edvo.work / "walk/truth"
    labels = json.loads((walk / "labels.json").read_text(encoding="utf-8"))
    assert labels["files"] == ["wall.gltf", "walker.gltf"], labels["files"]
    assert [(one["file"], one["path"]) for one in labels["instances"]] == [(0, "wall"), (1, "walker")]
    middles, means = [], []
    for frame in range(FRAMES):
        ids = read_png(walk / f"instance/{frame:06}.png")
        figure = ids == 2
        assert figure.sum() > 300, figure.sum()
        assert ((read_png(walk / f"moving/{frame:06}.png") == 255) == figure).all(), f"frame {frame}"
        depth = numpy.load(walk / f"depth/{frame:06}.npy")
        assert (depth[~figure] == DEPTH + 1).all()
        assert (abs(depth[figure] - DEPTH) < 0.45).all()
        # The head and the trunk stay where the figure is; the limbs swing about it.
        columns = numpy.nonzero(figure)[1]
        middles.append((columns.min() + columns.max()) / 2)
        if frame + 1 < FRAMES:
            flow = read_flow(walk / f"flow/{frame:06}.flo")
            assert (abs(flow[~figure]) < 1e-6).all(), "the wall rests"
            means.append(numpy.median(flow[figure][:, 0] * depth[figure]) / FOCAL)  # m within a frame
    expected = SPEED / RATE
    assert max(abs(mean - expected) for mean in means) < 0.06, means
    moved = (middles[-1] - middles[0]) * DEPTH / FOCAL
    assert abs(moved - SPEED) < 0.15, f"{moved} m in 1 s"
    manifest = (edvo.work / "walk/sequence.toml").read_text(encoding="utf-8")
    assert 'actor.0.file = "walker.gltf"' in manifest and "actor.0.speed = 1.25" in manifest


def check_bytes(edvo):
    """The same bytes on any number of threads and from shards."""
    words = f"render wall.gltf {CAMERA} --actor actor.toml --channels all --sensor kinect-v1"
    edvo.run(f"{words} --out one --threads 1")
    edvo.run(f"{words} --out two --threads 2")
    for shard in (2, 1):
        edvo.run(f"{words} --out shards --shard {shard}/2")
    assert edvo.contents("one") == edvo.contents("two") == edvo.contents("shards")


def check_path(edvo):
    """A camera that rests on the figure's way is run into; without the figure it is a metre from everything."""
    words = "path check wall.gltf --path still --move.eye 0,0.9,0.05 --move.target 0,0.9,-3 --rate 20 --duration 1.25 " \
            "--limit.min-clearance 0.3"
    edvo.run(words)
    edvo.run(f"{words} --actor actor.toml", 4)


def check_bad_input(edvo):
    def refusal(text):
        (edvo.work / "bad.toml").write_text(text, encoding="utf-8")
        err = edvo.run(f"render wall.gltf {CAMERA} --actor bad.toml --out bad", 3)
        assert not (edvo.work / "bad").exists() and not (edvo.work / "bad.part").exists()
        return err

    assert "speed: is 0, expected a positive number" in refusal(ACTOR.replace("speed = 1.25", "speed = 0"))
    assert "bad.toml:3: actor: path: has 1 points" in refusal(ACTOR.replace(", [0.8, 0, 0]]", "]"))
    assert 'has no animation "run", expected one of 0 "walker"' in refusal(ACTOR.replace('"walker"\n', '"run"\n'))
    no_skin = ACTOR.replace("walker.gltf", "wall.gltf").replace('animation = "walker"\n', "")
    assert "wall.gltf: has no mesh that a skin bends" in refusal(no_skin)
    no_animation = ACTOR.replace("walker.gltf", "wall.gltf").replace("skinned = true\n", "")
    assert 'wall.gltf: has no animation "walker", expected none' in refusal(no_animation)
    assert "absent.gltf" in refusal(ACTOR.replace("walker.gltf", "absent.gltf"))
    assert "bad.toml:3: unknown key 'actor.0.sped'; the nearest known key is actor.0.speed" in refusal(
        '[[actor]]\nfile = "walker.gltf"\nsped = 1\n')
    assert "bad.toml: expected a table [[actor]]" in refusal("\n")


def main():
    program, source, work = (pathlib.Path(word).resolve() for word in sys.argv[1:])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    edvo = Program(program, work)
    prepare(work, source)
    check_truth(edvo)
    check_bytes(edvo)
    check_path(edvo)
    check_bad_input(edvo)
    return 0


if __name__ == "__main__":
    sys.exit(main())
