"""Reads both forms of ICL-NUIM by what its authors' programs do."""

import re
import tomllib

import numpy

import files
import geometry

Z_TURNED = numpy.diag([1.0, 1, -1, 1])  # of a right-handed world; ICL-NUIM's is POV-Ray's, left-handed
Y_DOWN = numpy.diag([1.0, -1, 1, 1])  # of ICL-NUIM's camera, which has y up


def read_camera(folder):
    camera = tomllib.loads((folder / "camera.toml").read_text())
    assert all(value == 0 for name, value in camera.get("distortion", {}).items() if name != "model")
    return (camera["fx"], abs(camera["fy"])), (camera["cx"], camera["cy"])


def read_povray_pose(path):
    """The camera (x right, y down, z forward) in the left-handed world of the three vectors of a .txt."""
    vectors = {name: numpy.array(values.split(","), float)
               for name, values in re.findall(r"(\w+) *= \[(.*)\]'", path.read_text())}
    up, forward = (vectors[name] / numpy.linalg.norm(vectors[name]) for name in ("cam_up", "cam_dir"))
    T = numpy.eye(4)
    T[:3] = numpy.stack([numpy.cross(up, forward), -up, forward, vectors["cam_pos"]], axis=1)
    return T


def read_rendered(folder):
    """Views of all frames. Depth is as text, along the pixel's ray."""
    focal, centre = read_camera(folder)
    views = []
    for path in sorted(folder.glob("scene_00_*.txt")):
        image = files.read_png(path.with_suffix(".png"))
        rays = numpy.loadtxt(path.with_suffix(".depth")).reshape(image.shape[:2])
        v, u = numpy.indices(rays.shape)
        length = numpy.hypot(numpy.hypot((u - centre[0]) / focal[0], (v - centre[1]) / focal[1]), 1)
        views.append(geometry.View(image, rays / length, read_povray_pose(path), focal, centre, {"model": "opencv"}))
    return views


def read_tum_compatible(folder):
    focal, centre = read_camera(folder)
    (trajectory,) = folder.glob("*.gt.freiburg")
    poses = dict(files.read_tum_poses(trajectory))
    views = []
    for number, (depth, same, image) in files.read_tum_list(folder / "associations.txt"):
        assert number == float(same)
        views.append(geometry.View(files.read_png(folder / image), files.read_png(folder / depth) / 5000,
                                   poses[number] @ Y_DOWN, focal, centre, {"model": "opencv"}))
    return views


def check(views, source, name):
    for view, (_, T_world_camera) in zip(views, files.read_tum_poses(source / "groundtruth.txt"), strict=True):
        assert abs(view.T - Z_TURNED @ T_world_camera).max() < 1e-7, name
    geometry.require_agreement(views[0], views[3], name)
