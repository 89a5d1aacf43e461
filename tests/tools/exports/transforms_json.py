"""Reads transforms.json as Nerfstudio documents it, and nothing else of the folder but what it names."""

import json
import tomllib

import numpy

import files
import geometry

OPENGL = numpy.diag([1.0, -1.0, -1.0, 1.0])  # x right, y up, z backwards


def read_views(folder):
    meta = json.loads((folder / "transforms.json").read_text())
    lens = {name: meta[name] for name in ("k1", "k2", "k3", "k4", "p1", "p2") if name in meta}
    lens["model"] = {"OPENCV": "opencv", "OPENCV_FISHEYE": "fisheye"}[meta["camera_model"]]
    views = []
    for frame in meta["frames"]:
        image = files.read_png(folder / frame["file_path"])
        assert image.shape[:2] == (meta["h"], meta["w"])
        depth = frame["depth_file_path"]
        raw = numpy.load(folder / depth) if depth.endswith(".npy") else files.read_png(folder / depth)
        views.append(geometry.View(image, raw * meta["depth_unit_scale_factor"],
                                   numpy.array(frame["transform_matrix"]) @ OPENGL, (meta["fl_x"], meta["fl_y"]),
                                   (meta["cx"] - 0.5, meta["cy"] - 0.5), lens))
    return meta, views


def check(folder, source):
    meta, views = read_views(folder)
    truth = dict(files.read_tum_poses(source / "groundtruth.txt"))
    assert len(views) == len(files.read_tum_list(source / "rgb.txt"))
    for frame, view in zip(meta["frames"], views):
        assert abs(geometry.Z_UP @ truth[frame["timestamp"]] - view.T).max() < 1e-8
    if meta["fl_x"] == tomllib.loads((source / "camera.toml").read_text())["fx"]:  # not undistorted
        exact = numpy.load(source / "depth_float/000003.npy")
        assert abs(views[3].depth - exact).max() < 1e-5, "float depth is carried"
    geometry.require_agreement(views[0], views[3], "transforms-json")
