"""Reads a model of COLMAP from its text format as COLMAP documents it, and has COLMAP itself read it."""

import shutil
import subprocess

import numpy

import files
import geometry

NAMES = {"PINHOLE": (), "OPENCV": ("k1", "k2", "p1", "p2"), "OPENCV_FISHEYE": ("k1", "k2", "k3", "k4"),
         "FULL_OPENCV": ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6")}


def lines_of(path):
    return [line for line in path.read_text().splitlines() if not line.startswith("#")]


def read_camera(path):
    """Size, focal lengths, principal point (the first pixel's centre is 0) and lens of the only camera."""
    (line,) = lines_of(path)
    number, model, *values = line.split()
    values = [float(value) for value in values]
    lens = dict(zip(NAMES[model], values[6:], strict=True))
    lens["model"] = "fisheye" if model == "OPENCV_FISHEYE" else "opencv"
    assert number == "1"
    return values[:2], values[2:4], (values[4] - 0.5, values[5] - 0.5), lens


def read_images(path):
    """Of each image: its name, T_camera_world, and rows of pixel and point."""
    lines, images = lines_of(path), {}
    for pose, points in zip(lines[::2], lines[1::2], strict=True):
        number, *values, camera, name = pose.split()
        w, x, y, z, *position = (float(value) for value in values)
        assert camera == "1"
        seen = numpy.array(points.split(), float).reshape(-1, 3)
        images[int(number)] = name, files.matrix_of(position, (x, y, z, w)), seen
    return images


def check_points(folder, images, camera):
    """Every element of a track is where the camera sees its point; colours are the images' own."""
    _, focal, centre, lens = camera
    points = {}
    for line in lines_of(folder / "sparse/0/points3D.txt"):
        number, *rest = line.split()
        points[int(number)] = numpy.array(rest[:6], float), numpy.array(rest[7:], int).reshape(-1, 2)
    pixels = {number: files.read_png(folder / "images" / name) for number, (name, _, _) in images.items()}
    worst, differences, elements = 0.0, [], 0
    for number, (values, track) in points.items():
        assert len(set(track[:, 0])) == len(track) >= 2, f"point {number}: {track}"
        for image, index in track:
            _, T_camera_world, seen = images[image]
            assert int(seen[index, 2]) == number
            x, y, z, _ = T_camera_world @ numpy.append(values[:3], 1)
            xd, yd = geometry.distort(lens, x / z, y / z)
            u, v = focal[0] * xd + centre[0], focal[1] * yd + centre[1]
            worst = max(worst, abs(u + 0.5 - seen[index, 0]), abs(v + 0.5 - seen[index, 1]))
            elements += 1
            differences.append(abs(pixels[image][round(v), round(u)].astype(float) - values[3:]).max())
    assert sum(len(seen) for _, _, seen in images.values()) == elements, "images.txt and points3D.txt disagree"
    print(f"colmap: {len(points)} points, {elements / len(points):.1f} images each, at most {worst:.4f} px off, "
          f"median difference of colour {numpy.median(differences):.1f}")
    assert len(points) > 30 and worst < 0.01 and numpy.median(differences) < 10


def check_program(folder, count):
    """COLMAP's own reader."""
    if not shutil.which("colmap"):
        print("skipped: colmap is not installed")
        return
    done = subprocess.run(["colmap", "model_analyzer", "--path", folder / "sparse/0"], capture_output=True, text=True,
                          env={"QT_QPA_PLATFORM": "offscreen", "HOME": str(folder)}, check=True)
    report = done.stdout + done.stderr
    print(*[line for line in report.splitlines() if ":" in line], sep="\n")
    assert f"Registered images: {count}" in report
    assert float(report.partition("Mean reprojection error: ")[2].partition("px")[0]) < 0.01


def check(folder, source):
    camera = read_camera(folder / "sparse/0/cameras.txt")
    images = read_images(folder / "sparse/0/images.txt")
    truth = files.read_tum_poses(source / "groundtruth.txt")
    assert len(images) == len(truth)
    for number, (name, T_camera_world, _) in images.items():
        stamp, T_world_camera = truth[number - 1]
        assert float(name.removesuffix(".png").split("_")[1]) == stamp
        assert abs(T_camera_world @ T_world_camera - numpy.eye(4)).max() < 1e-8
    check_points(folder, images, camera)
    check_program(folder, len(images))
