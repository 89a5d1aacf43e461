"""Reads the layouts of KITTI's odometry benchmark and of TartanAir by what their documentation says."""

import numpy

import files
import geometry

NORTH_EAST_DOWN = numpy.array([[0.0, 1, 0, 0], [0, 0, 1, 0], [1, 0, 0, 0], [0, 0, 0, 1]])  # to x right, y down, z forward


def check_kitti(folder, source, depths):
    """Depth is lent from `depths`, in m, of the same camera: KITTI has none."""
    sequence = folder / "sequences/00"
    matrices = {}
    for line in (sequence / "calib.txt").read_text().splitlines():
        name, values = line.split(":")
        matrices[name] = numpy.array(values.split(), float).reshape(3, 4)
    P = matrices["P2"]
    assert sorted(matrices) == ["P0", "P1", "P2", "P3"] and abs(P[:, 3]).max() == 0
    times = numpy.loadtxt(sequence / "times.txt")
    rows = numpy.loadtxt(folder / "poses/00.txt").reshape(-1, 3, 4)
    poses = [numpy.vstack([row, [0, 0, 0, 1]]) for row in rows]
    truth = files.read_tum_poses(source / "groundtruth.txt")
    assert numpy.allclose(times, [stamp for stamp, _ in truth], atol=1e-6)
    first = numpy.linalg.inv(truth[0][1])
    for pose, (_, T_world_camera) in zip(poses, truth, strict=True):
        assert abs(pose - first @ T_world_camera).max() < 1e-8
    views = [geometry.View(files.read_png(sequence / f"image_2/{i:06}.png"), depths[i], poses[i],
                           (P[0, 0], P[1, 1]), (P[0, 2], P[1, 2]), {"model": "opencv"}) for i in (0, 3)]
    assert len(list((sequence / "image_2").iterdir())) == len(poses)
    geometry.require_agreement(*views, "kitti")


def read_tartanair(folder, focal, centre):
    """Views of all frames; the layout has no intrinsics."""
    rows = numpy.loadtxt(folder / "pose_left.txt")
    views = []
    for i, row in enumerate(rows):
        T = NORTH_EAST_DOWN @ files.matrix_of(row[:3], row[3:]) @ NORTH_EAST_DOWN.T
        views.append(geometry.View(files.read_png(folder / f"image_left/{i:06}_left.png"),
                                   numpy.load(folder / f"depth_left/{i:06}_left_depth.npy"), T, focal, centre,
                                   {"model": "opencv"}))
    return views


def check_tartanair(folder, source, focal, centre):
    views = read_tartanair(folder, focal, centre)
    y_down = numpy.diag([1.0, -1, -1, 1])  # of the source's world, which has y up; theirs has z down
    for view, (_, T_world_camera) in zip(views, files.read_tum_poses(source / "groundtruth.txt"), strict=True):
        assert abs(view.T - y_down @ T_world_camera).max() < 1e-8
    assert len(views) == len(files.read_tum_list(source / "rgb.txt"))
    geometry.require_agreement(views[0], views[3], "tartanair")
    return views
