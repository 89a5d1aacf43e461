#!/usr/bin/env python3
"""Renders a rig with an equirectangular camera, and reads it by formulas that share nothing with the project:
panoramas_test.py EDVO SOURCE_FOLDER WORK_FOLDER.

Exits with 77 (skipped) where python3-numpy is not installed.
"""

import json
import pathlib
import shutil
import sys

from rig_program import Program, require_same

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "exports"))
try:
    import numpy

    import files
except ImportError:
    print("skipped: python3-numpy is not installed")
    sys.exit(77)

WIDTH, HEIGHT = 192, 96
IMAGE = f"projection = \"equirectangular\"\nwidth = {WIDTH}\nheight = {HEIGHT}\n"
PINHOLE = "width = 96\nheight = 96\nfx = 48.0\nfy = 48.0\ncx = 47.5\ncy = 47.5\n"
PANORAMA = f"[[camera]]\nname = \"round\"\n{IMAGE}"
# A cube map about the same place: the rotation of each face to the body, rows of a matrix.
FACES = {"front": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "back": [[-1, 0, 0], [0, 1, 0], [0, 0, -1]],
         "right": [[0, 0, 1], [0, 1, 0], [-1, 0, 0]], "left": [[0, 0, -1], [0, 1, 0], [1, 0, 0]],
         "up": [[1, 0, 0], [0, 0, -1], [0, 1, 0]], "down": [[1, 0, 0], [0, 0, 1], [0, -1, 0]]}
CHANNELS = "--exposure 1 --channels depth,normal,instance,flow,occlusion,moving"


def rig_text():
    text = PANORAMA
    for name, rows in FACES.items():
        matrix = [row + [0] for row in rows] + [[0, 0, 0, 1]]
        text += f"[[camera]]\nname = \"{name}\"\nT_body_camera = {json.dumps(matrix)}\n{PINHOLE}"
    return text


def rays():
    """The unit rays of the pixels of the panorama, camera axes: x right, y down, z forward."""
    v, u = numpy.mgrid[0:HEIGHT, 0:WIDTH]
    longitude = 2 * numpy.pi * ((u + 0.5) / WIDTH - 0.5)
    from_up = numpy.pi * (v + 0.5) / HEIGHT
    return numpy.stack([numpy.sin(from_up) * numpy.sin(longitude), -numpy.cos(from_up),
                        numpy.sin(from_up) * numpy.cos(longitude)], axis=-1)


def pixels(points):
    """Where the panorama images points, px."""
    x, y, z = (points[..., i] for i in range(3))
    return (WIDTH * (numpy.arctan2(x, z) / (2 * numpy.pi) + 0.5) - 0.5,
            HEIGHT * numpy.arctan2(numpy.hypot(x, z), -y) / numpy.pi - 0.5)


def read_flow(path):
    data = path.read_bytes()
    assert data[:4] == b"PIEH"
    return numpy.frombuffer(data, "<f4", offset=12).reshape(HEIGHT, WIDTH, 2).astype(float)


def channel(camera, name, index):
    path = camera / f"truth/{name}/{index:06}"
    return numpy.load(f"{path}.npy") if name in ("depth", "normal") else files.read_png(f"{path}.png")


def check_against_cube(rig):
    """Every channel at the panorama's pixels is that of the face in the direction, at its nearest pixel."""
    for index in range(2):
        depth = channel(rig / "round", "depth", index).astype(float)
        assert (depth > 0).mean() > 0.9
        compared = 0
        for name, rows in FACES.items():
            face = rays() @ numpy.array(rows, dtype=float)  # R^T d
            inside = face[..., 2] > abs(face[..., :2]).max(axis=-1)
            x, y, z = face[inside].T
            column, row = (numpy.clip(numpy.rint(48.0 * a / z + 47.5).astype(int), 0, 95) for a in (x, y))
            distance = channel(rig / name, "depth", index).astype(float)[row, column] / z
            off = abs(distance - depth[inside])
            assert numpy.mean(off < 0.03 * depth[inside] + 0.01) > 0.93, (name, numpy.mean(off < 0.03 * depth[inside]))
            for ids in ("instance", "moving"):
                same = channel(rig / name, ids, index)[row, column] == channel(rig / "round", ids, index)[inside]
                assert same.mean() > 0.93, (name, ids, same.mean())
            normals = channel(rig / name, "normal", index)[row, column]  # world axes
            turn = numpy.einsum("ij,ij->i", normals, channel(rig / "round", "normal", index)[inside])
            assert numpy.mean(turn > 0.999) > 0.85, (name, numpy.mean(turn > 0.999))
            grey, other = (files.read_png(rig / camera / f"rgb/{index:06}.png").mean(axis=2) for camera in (name, "round"))
            assert numpy.median(abs(grey[row, column] - other[inside])) < 8
            compared += inside.sum()
        assert compared == WIDTH * HEIGHT


def check_flow(rig):
    """Flow leads to the pixel of the point as the next camera sees it, by the shorter way round."""
    poses = files.read_tum_poses(rig / "round/groundtruth.txt")
    (_, T_now), (_, T_next) = poses[0], poses[1]
    depth = channel(rig / "round", "depth", 0).astype(float)
    points = depth[..., None] * rays()
    T = numpy.linalg.inv(T_next) @ T_now
    column, row = pixels(points @ T[:3, :3].T + T[:3, 3])
    v, u = numpy.mgrid[0:HEIGHT, 0:WIDTH]
    du = (column - u + WIDTH / 2) % WIDTH - WIDTH / 2
    flow = read_flow(rig / "round/truth/flow/000000.flo")
    at_rest = (channel(rig / "round", "moving", 0) == 0) & (depth > 0)
    assert at_rest.mean() > 0.5
    assert abs(flow[..., 0] - du)[at_rest].max() < 1e-3, abs(flow[..., 0] - du)[at_rest].max()
    assert abs(flow[..., 1] - (row - v))[at_rest].max() < 1e-3
    assert ((u + flow[..., 0])[at_rest] > WIDTH - 0.5).any() or ((u + flow[..., 0])[at_rest] < -0.5).any()
    fates = channel(rig / "round", "occlusion", 0)
    assert not (fates == 128).any()  # nothing is outside


def check_shares(edvo, rig):
    """Shares, one thread, and a camera rendered alone make the same bytes."""
    for number in (2, 1):
        edvo.render("moving_room", f"--rig round.toml {CHANNELS} --threads 1 --shard {number}/2 --out shared")
    require_same(rig, edvo.work / "shared")
    edvo.rig("camera.toml", IMAGE)
    edvo.render("moving_room", f"--camera camera.toml {CHANNELS} --out alone")
    require_same(rig / "round", edvo.work / "alone")
    edvo.render("moving_room", f"--camera {rig.name}/round/camera.toml {CHANNELS} --out from_written")
    require_same(rig / "round", edvo.work / "from_written")
    edvo.render("moving_room", f"--rig {rig.name}/rig.toml {CHANNELS} --out again")
    require_same(rig / "round", edvo.work / "again/round")


def check_readers(edvo, rig):
    """What tracks or converts refuses the camera by the name of its file; a rig leaves it out with a note."""
    camera = f"{rig.name}/round"
    words = (f"{camera}/camera.toml: expected a pinhole camera", "projection = \"equirectangular\"")
    formats = ("euroc", "tum", "icl-nuim", "icl-tum", "tartanair", "kitti", "colmap", "transforms-json", "mcap", "video")
    for command in ([f"track {camera} --out e.txt", f"track {camera} --mode mono --out e.txt"]
                    + [f"{command} --camera tum-fr1"
                       for command in (f"track {camera} --out e.txt", f"convert {camera} out --format tartanair",
                                       f"depth {camera} --out out")]
                    + [f"convert {camera} out{'.avi' if name == 'video' else ''} --format {name}" for name in formats]):
        errors = edvo.run(command, 3)[1]
        assert all(word in errors for word in words), (command, errors)
        assert not any((edvo.work / name).exists() for name in ("out", "out.avi", "e.txt"))
    output, errors = edvo.run(f"convert {rig.name} euroc --format euroc --quiet")
    assert "camera 'round' is left out" in output + errors, output + errors
    assert sorted(path.name for path in (edvo.work / "euroc/mav0").glob("cam*")) == [f"cam{i}" for i in range(6)]
    assert ((edvo.work / "euroc/mav0/cam0/data").glob("*.png").__next__().read_bytes()
            in [path.read_bytes() for path in (rig / "front/rgb").glob("*.png")])
    edvo.rig("alone.toml", PANORAMA)
    edvo.render("room", "--rig alone.toml --mode depth --out only")
    assert "expected a camera of the rig that is a pinhole" in edvo.run("convert only out --format euroc", 3)[1]


def check_refusals(edvo):
    """What such a camera cannot have is named with file and camera, exit code 3, and nothing is left behind."""
    for text, options, words in (
            (PANORAMA + "fx = 9.0\n", "", ["bad.toml:6: fx", "equirectangular"]),
            (PANORAMA.replace(f"height = {HEIGHT}", "height = 95"), "", ["camera 'round'", "twice as wide as high", "192x95"]),
            (PANORAMA.replace("equirectangular", "cylinder"), "", ["bad.toml:3", "projection", "equirectangular"]),
            (PANORAMA + "stereo = \"round\"\n", "", ["camera 'round'", "stereo"]),
            (PANORAMA + "[camera.sensor]\npreset = \"kinect-v1\"\n", "", ["camera 'round': sensor: sensor.", "pinhole"]),
            (PANORAMA, "--lens.blur 0.5", ["camera 'round': sensor: sensor.lens.blur", "pinhole"]),
            (PANORAMA, "--renderer rasterizer", ["camera 'round': rasterizer", "pinhole"])):
        edvo.rig("bad.toml", text)
        errors = edvo.render("room", f"--rig bad.toml {options} --out bad", 3)[1]
        assert all(word in errors for word in words), errors
        assert not (edvo.work / "bad").exists() and not (edvo.work / "bad.part").exists()
    for options, word in (("--sensor kinect-v1", "pinhole"), ("--renderer rasterizer", "pinhole"),
                          ("--channels disparity", "stereo partner")):
        assert word in edvo.render("room", f"--camera camera.toml {options} --out bad", 2)[1]
        assert not (edvo.work / "bad").exists() and not (edvo.work / "bad.part").exists()


def main():
    program, source, work = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    edvo = Program(program, source, work)
    edvo.rig("round.toml", rig_text())
    edvo.render("moving_room", f"--rig round.toml {CHANNELS} --out rig")
    rig = work / "rig"
    check_against_cube(rig)
    check_flow(rig)
    check_shares(edvo, rig)
    check_readers(edvo, rig)
    check_refusals(edvo)
    return 0


if __name__ == "__main__":
    sys.exit(main())
