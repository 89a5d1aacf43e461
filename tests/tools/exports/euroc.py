"""Reads EuRoC's folders by what their documentation says."""

import csv
import re

import numpy

import files
import geometry


def read_sensor(folder):
    """The values of a sensor.yaml as text, by their names; data of T_BS is `data`."""
    text = (folder / "sensor.yaml").read_text()
    return {name: value.split("#")[0].strip() for name, value in re.findall(r"^ *(\w+): (.+)$", text, re.M)}


def numbers(text):
    return [float(word) for word in text.strip("[]").split(",")]


def read_list(folder):
    """The rows of a data.csv."""
    with open(folder / "data.csv", newline="", encoding="utf-8") as lines:
        return [row for row in csv.reader(lines) if not row[0].startswith("#")]


def read_views(folder):
    """Stamps in ns and views of all frames."""
    camera, depth_camera = (read_sensor(folder / "mav0" / name) for name in ("cam0", "depth0"))
    assert camera["camera_model"] == "pinhole"
    assert camera["intrinsics"] == depth_camera["intrinsics"]
    fu, fv, cu, cv = numbers(camera["intrinsics"])
    model, names = {"radial-tangential": ("opencv", ("k1", "k2", "p1", "p2")),
                    "equidistant": ("fisheye", ("k1", "k2", "k3", "k4"))}[camera["distortion_model"]]
    lens = dict(zip(names, numbers(camera["distortion_coefficients"]), strict=True), model=model)
    T_body_camera = numpy.array(numbers(camera["data"])).reshape(4, 4)
    units = float(depth_camera["depth_units_per_m"])
    images, depths, states = (read_list(folder / "mav0" / name)
                              for name in ("cam0", "depth0", "state_groundtruth_estimate0"))
    views = []
    for image, depth, state in zip(images, depths, states, strict=True):
        assert image[0] == depth[0] == state[0] == image[1].removesuffix(".png")
        px, py, pz, qw, qx, qy, qz = (float(value) for value in state[1:8])
        T_world_body = files.matrix_of([px, py, pz], [qx, qy, qz, qw])
        pixels = files.read_png(folder / "mav0/cam0/data" / image[1])
        assert list(pixels.shape[1::-1]) == numbers(camera["resolution"])
        views.append(geometry.View(pixels, files.read_png(folder / "mav0/depth0/data" / depth[1]) / units,
                                   T_world_body @ T_body_camera, (fu, fv), (cu, cv), lens))
    return [int(row[0]) for row in images], views


def check(folder, source):
    stamps, views = read_views(folder)
    for stamp, view, (second, T_world_camera) in zip(stamps, views, files.read_tum_poses(source / "groundtruth.txt"),
                                                     strict=True):
        assert abs(stamp - 1e9 * second) < 500
        assert abs(view.T - geometry.Z_UP @ T_world_camera).max() < 1e-8
    geometry.require_agreement(views[0], views[3], "euroc")
