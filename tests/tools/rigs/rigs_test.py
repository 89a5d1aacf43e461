#!/usr/bin/env python3
"""Renders rigs, converts them to EuRoC's layout, and reads both by readers that share nothing with the project:
rigs_test.py EDVO SOURCE_FOLDER WORK_FOLDER.

Exits with 77 (skipped) where python3-numpy is not installed.
"""

import json
import pathlib
import shutil
import sys

from rig_program import PATH, Program, require_same

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "exports"))
try:
    import numpy

    import euroc
    import files
    import geometry
except ImportError:
    print("skipped: python3-numpy is not installed")
    sys.exit(77)

IMAGE = "width = 96\nheight = 72\nfx = 70.0\nfy = 71.0\ncx = 47.0\ncy = 36.0\n"
TURNED = "orientation = [0.0, 0.2, 0.1, 0.9746794344808963]\n"  # x, y, z, w
STEREO = ("[imu]\nposition = [0.05, 0.01, -0.02]\norientation = [0.5, -0.5, 0.5, 0.5]\n"
          f"[[camera]]\nname = \"left\"\nposition = [0.02, 0.03, 0.04]\nstereo = \"right\"\n{IMAGE}"
          f"[[camera]]\nname = \"right\"\nposition = [0.12, 0.03, 0.04]\n{IMAGE}"
          f"[[camera]]\nname = \"fish\"\nposition = [-0.1, 0.0, 0.0]\n{TURNED}{IMAGE}"
          "distortion.model = \"kannala_brandt\"\ndistortion.k1 = -0.013\ndistortion.k2 = 0.021\n"
          f"[[camera]]\nname = \"late\"\ntime_offset = 0.1\n{IMAGE}distortion.k1 = -0.2\ndistortion.k2 = 0.05\n"
          "[camera.sensor]\npreset = \"kinect-v1\"\nshutter.exposure_time = 0.01\n")
LIGHT = "spectrum = \"infrared\"\n"
COLOR = f"[[camera]]\nname = \"color\"\nposition = [-0.02, 0.0, 0.0]\n{IMAGE}[camera.sensor]\npreset = \"kinect-v1\"\n"
INFRARED = (f"[[camera]]\nname = \"dark\"\n{TURNED}{IMAGE}{LIGHT}scene_light = 0.0\n"
            f"[[camera]]\nname = \"grey\"\nposition = [0.05, 0.0, 0.0]\n{IMAGE}{LIGHT}"
            "[camera.sensor]\npreset = \"realsense-d435\"\nshutter.readout_time = 0.02\n")
MOUNT = "position = [0.1, 0.02, -0.03]\norientation = [0.1, 0.0, 0.0, 0.99498743710662]\n"
SLIDE = f"[[projector]]\nname = \"slide\"\n{MOUNT}fov_deg = [50.0, 40.0]\npower = 20\npattern = \"slide.png\"\n"
DOTS = "[[projector]]\nname = \"dots\"\nfov_deg = [60.0, 45.0]\npower = 30.0\ndots.number = 500\ndots.diameter_deg = 0.8\n"


def pose(text):
    """The matrix of a camera of a rig written here, by its lines."""
    values = dict(line.split(" = ", 1) for line in text.splitlines() if " = " in line)
    return files.matrix_of(json.loads(values.get("position", "[0, 0, 0]")),
                           json.loads(values.get("orientation", "[0, 0, 0, 1]")))


def mounts():
    """The poses in the body of the cameras of STEREO, and that of its IMU."""
    imu, *cameras = STEREO.split("[[camera]]")
    return pose(imu), {camera.split('"')[1]: pose(camera) for camera in cameras}


def check_single_camera(edvo):
    edvo.rig("one.toml", f"[[camera]]\nname = \"only\"\n{IMAGE}")
    edvo.rig("camera.toml", IMAGE)
    options = "--channels all --sensor kinect-v1 --shutter.exposure-time 0.02 --float-depth"
    for scene in ("room", "moving_room"):
        edvo.render(scene, f"--rig one.toml {options} --out one_{scene}")
        edvo.render(scene, f"--camera camera.toml {options} --out alone_{scene}")
        require_same(edvo.work / f"one_{scene}" / "only", edvo.work / f"alone_{scene}")


def check_shares(edvo, rig):
    """Shares in any order, threads and a run that goes on make the bytes of one process."""
    for number in (3, 1, 2):
        edvo.render("moving_room", f"--rig stereo.toml {CHANNELS} --shard {number}/3 --out shared")
    require_same(rig, edvo.work / "shared")
    edvo.render("moving_room", f"--rig stereo.toml {CHANNELS} --frames 1:2 --out again")
    plan = json.loads(edvo.render("moving_room", f"--rig stereo.toml {CHANNELS} --plan --json --out again")[0])
    assert (plan["frames"], plan["there"]) == (16, 4), plan
    edvo.render("moving_room", f"--rig stereo.toml {CHANNELS} --threads 1 --out again")
    require_same(rig, edvo.work / "again")
    result = json.loads(edvo.render("moving_room", f"--rig stereo.toml {CHANNELS} --json --out again")[0])
    assert result["was_there"] and result["cameras"] == ["left", "right", "fish", "late"]
    edvo.render("moving_room", f"--rig {rig.name}/rig.toml {CHANNELS} --out from_written")
    for name in ("left", "late"):  # whose options the written file has in full
        require_same(rig / name / "depth", edvo.work / "from_written" / name / "depth")


def check_poses(rig):
    body = files.read_tum_poses(rig / "groundtruth.txt")
    for name, T_body_camera in mounts()[1].items():
        poses = files.read_tum_poses(rig / name / "groundtruth.txt")
        shift = 1 if name == "late" else 0  # by a whole frame of the path
        for (stamp, T_world_body), (own_stamp, T_world_camera) in zip(body[shift:], poses, strict=False):
            assert abs(stamp - own_stamp) < 1e-6
            assert abs(T_world_body @ T_body_camera - T_world_camera).max() < 1e-8


def check_time_offset(edvo):
    """What a camera sees a frame later is what it sees with an offset of a frame, moving things included."""
    edvo.rig("times.toml", f"[[camera]]\nname = \"now\"\n{IMAGE}[[camera]]\nname = \"then\"\ntime_offset = 0.1\n{IMAGE}")
    edvo.render("moving_room", "--rig times.toml --channels depth --out times")
    moved = 0
    for number in range(2):
        now, then, before = (numpy.load(edvo.work / f"times/{name}/truth/depth/{index:06}.npy")
                             for name, index in (("now", number + 1), ("then", number), ("now", number)))
        assert numpy.mean(abs(now - then) > 1e-4) < 1e-3
        moved += numpy.mean(abs(now - before) > 1e-4)
    assert moved > 0.1


def check_disparity(rig):
    left, right = (files.read_tum_poses(rig / name / "groundtruth.txt") for name in ("left", "right"))
    seen = 0
    for number, ((_, T_left), (_, T_right)) in enumerate(zip(left, right, strict=True)):
        depth, disparity = (numpy.load(rig / f"left/truth/{channel}/{number:06}.npy").astype(float)
                            for channel in ("depth", "disparity"))
        fates = files.read_png(rig / f"left/truth/stereo_occlusion/{number:06}.png")
        has = depth > 0
        assert (disparity[~has] == 0).all() and has.any()
        assert abs(disparity[has] - 70.0 * 0.1 / depth[has]).max() < 1e-4
        v, u = numpy.nonzero(has)
        z = depth[v, u]
        points = numpy.stack([(u - 47.0) / 70.0 * z, (v - 36.0) / 71.0 * z, z, numpy.ones_like(z)])
        x, y, z_right, _ = numpy.linalg.inv(T_right) @ T_left @ points
        column, row = 70.0 * x / z_right + 47.0, 71.0 * y / z_right + 36.0
        assert abs(column - (u - disparity[v, u])).max() < 1e-4 and abs(row - v).max() < 1e-4
        inside = (column > -0.5) & (column < 95.5)
        assert (inside == (fates[v, u] != 128)).all()
        nearest = numpy.clip(numpy.rint(column).astype(int), 0, 95)
        of_right = numpy.load(rig / f"right/truth/depth/{number:06}.npy")[v, nearest]
        visible, hidden = fates[v, u] == 0, fates[v, u] == 255
        # The nearest pixel's centre is up to half a pixel off the point.
        assert numpy.mean(abs(of_right[visible] - z_right[visible]) < 0.03 * z_right[visible]) > 0.93
        # What hides a point may be narrower than a pixel.
        beside = numpy.min([numpy.load(rig / f"right/truth/depth/{number:06}.npy")[v, numpy.clip(nearest + by, 0, 95)]
                            for by in (-1, 0, 1)], axis=0)
        assert numpy.mean(beside[hidden] < z_right[hidden]) > 0.98, numpy.mean(beside[hidden] < z_right[hidden])
        seen += visible.sum()
    assert seen > 0


def check_imu(edvo):
    """The rig's IMU measures what that of a camera at its place measures, but for noise; its states are the body's."""
    imu = STEREO.split("[[camera]]")[0]
    mount = imu.replace("[imu]\n", "")
    edvo.rig("imu.toml", f"{imu}[[camera]]\nname = \"there\"\n{mount}{IMAGE}")
    edvo.render("room", "--rig imu.toml --channels imu --out imu")
    folder = edvo.work / "imu"
    assert (folder / "imu.csv").read_bytes() == (folder / "there/imu.csv").read_bytes()
    assert (folder / "imu.toml").read_bytes() == (folder / "there/imu.toml").read_bytes()
    states, of_imu = (numpy.array([[float(value) for value in row] for row in euroc.read_list(place)]) for place in
                      (make_list(folder), make_list(folder / "there")))
    for stamp, T_world_body in files.read_tum_poses(folder / "groundtruth.txt"):
        state = states[numpy.argmin(abs(states[:, 0] - 1e9 * stamp))]
        px, py, pz, qw, qx, qy, qz = state[1:8]
        assert abs(files.matrix_of([px, py, pz], [qx, qy, qz, qw]) - T_world_body).max() < 1e-8
    # Velocity is the derivative of the body's position, which the IMU's is not.
    step = (states[2:, 0] - states[:-2, 0])[:, None] / 1e9
    assert abs((states[2:, 1:4] - states[:-2, 1:4]) / step - states[1:-1, 8:11]).max() < 1e-3
    assert abs(of_imu[:, 8:11] - states[:, 8:11]).max() > 0.01


def check_imu_noise(edvo):
    """The IMU at the body and those at cameras have noise that says nothing of each other's."""
    edvo.rig("still.toml", "".join(f"[[camera]]\nname = \"{name}\"\n{IMAGE}" for name in "ab"))
    noise = "--imu.rate 2000 --imu.accel-noise 0.01 --imu.gyro-noise 0.002"
    edvo.render("room", f"--rig still.toml --channels imu {noise} --out noisy")
    edvo.render("room", "--rig still.toml --channels imu --imu.rate 2000 --out exact")
    added = []
    for folder in (".", "a", "b"):
        noisy, exact = (numpy.loadtxt(edvo.work / rig / folder / "imu.csv", delimiter=",")[:, 1:] for rig in ("noisy", "exact"))
        added.append((noisy - exact).T)
    assert all(abs(one).max() > 0.01 for one in added)
    for first, second in ((0, 1), (0, 2), (1, 2)):
        for row in range(6):  # within 5 standard deviations of the correlation of 601 independent numbers
            correlation = numpy.corrcoef(added[first][row], added[second][row])[0, 1]
            assert abs(correlation) < 5 / 601 ** 0.5, (first, second, row, correlation)
    assert (edvo.work / "exact/imu.csv").read_bytes() == (edvo.work / "exact/a/imu.csv").read_bytes()


def check_imu_covers_cameras(edvo):
    """The IMU and the true states begin before the first row of any camera and end after the last."""
    offset, exposure, readout, height = -0.037, 0.01, 0.03, 72
    edvo.rig("early.toml", f"[[camera]]\nname = \"plain\"\n{IMAGE}[[camera]]\nname = \"early\"\ntime_offset = {offset}\n{IMAGE}"
             f"sensor.shutter.exposure_time = {exposure}\nsensor.shutter.readout_time = {readout}\n"
             f"[[camera]]\nname = \"late\"\ntime_offset = {-offset}\n{IMAGE}")
    edvo.render("room", "--rig early.toml --channels imu --out early")
    edvo.render("room", "--rig one.toml --channels imu --out punctual")
    edge = readout * (height - 1) / 2 / height + exposure / 2  # s from a stamp to the ends of its exposure
    shutil.copy(edvo.work / "early/imu.csv", edvo.work / "early/data.csv")
    for place in (make_list(edvo.work / "early"), edvo.work / "early"):
        stamps = [int(row[0]) / 1e9 for row in euroc.read_list(place)]
        assert offset - edge - 0.005 < stamps[0] <= offset - edge, stamps[0]
        assert 0.3 - offset <= stamps[-1] < 0.3 - offset + 0.005, stamps[-1]
    punctual = (edvo.work / "punctual/imu.csv").read_text().splitlines()
    assert set(punctual) < set((edvo.work / "early/imu.csv").read_text().splitlines())
    assert len(punctual) == 1 + 61, "a rig without offsets has the IMU of its path alone"


def check_negative_stamps(edvo):
    """A camera whose stamps begin below 0 is named when it is planned and rendered, and where they cannot be written."""
    scene = f"{edvo.source}/assets/room/room.gltf {PATH.replace('--quiet', '')}"
    for out in ("--plan", "--out early"):
        errors = edvo.run(f"render {scene} --rig early.toml --channels imu {out}")[1]
        assert errors.count("note: camera 'early': its first frame is at -0.037 s") == errors.count("its first frame") == 1, errors
    errors = edvo.run("convert early/early early.mcap --format mcap", 3)[1]
    assert "early/early: MCAP: expected stamps from 0" in errors, errors


def make_list(folder):
    """A folder whose data.csv are the true states of one."""
    place = folder / "states"
    place.mkdir()
    shutil.copy(folder / "truth/imu_states.csv", place / "data.csv")
    return place


def check_euroc(edvo, rig):
    edvo.run(f"convert {rig.name} {rig.name}_euroc --format euroc --quiet")
    mav = edvo.work / f"{rig.name}_euroc" / "mav0"
    T_body_imu, cameras = mounts()
    states = euroc.read_list(mav / "state_groundtruth_estimate0")
    stamps = numpy.array([int(row[0]) for row in states])
    for number, (name, T_body_camera) in enumerate(cameras.items()):
        sensor = euroc.read_sensor(mav / f"cam{number}")
        T_BS = numpy.array(euroc.numbers(sensor["data"])).reshape(4, 4)
        assert abs(T_BS - T_body_camera).max() < 1e-9
        assert sensor["distortion_model"] == ("equidistant" if name == "fish" else "radial-tangential")
        assert euroc.numbers(sensor["intrinsics"]) == [70.0, 71.0, 47.0, 36.0]
        poses = files.read_tum_poses(rig / name / "groundtruth.txt")
        images = euroc.read_list(mav / f"cam{number}")
        assert len(images) == len(poses) == 4
        for index, ((stamp, file), (second, T_world_camera)) in enumerate(zip(images, poses, strict=True)):
            assert abs(int(stamp) - 1e9 * second) < 500
            assert (files.read_png(mav / f"cam{number}/data" / file)
                    == files.read_png(rig / name / f"rgb/{index:06}.png")).all()
            nearest = numpy.argmin(abs(stamps - int(stamp)))
            assert abs(stamps[nearest] - int(stamp)) < 500, (name, stamp)
            px, py, pz, qw, qx, qy, qz = (float(value) for value in states[nearest][1:8])
            T_world_body = files.matrix_of([px, py, pz], [qx, qy, qz, qw])
            assert abs(T_world_body @ T_BS - geometry.Z_UP @ T_world_camera).max() < 1e-8
    imu = euroc.read_sensor(mav / "imu0")
    assert abs(numpy.array(euroc.numbers(imu["data"])).reshape(4, 4) - T_body_imu).max() < 1e-9
    assert [row[1:] for row in euroc.read_list(mav / "imu0")] == [row[1:] for row in euroc.read_list(imu_list(rig))]
    # The program reads it as cam0.
    edvo.run(f"convert {rig.name}_euroc read_back --format tum --quiet")
    back = files.read_tum_poses(edvo.work / "read_back/groundtruth.txt")
    for (_, T), (_, expected) in zip(back, files.read_tum_poses(rig / "left/groundtruth.txt"), strict=False):
        assert abs(T - geometry.Z_UP @ expected).max() < 1e-7 or len(back) != 4


def imu_list(rig):
    place = rig.parent / "imu_list"
    place.mkdir(exist_ok=True)
    shutil.copy(rig / "imu.csv", place / "data.csv")
    return place


def check_projectors(edvo, rig):
    """Cameras that see colours know of no projector; infrared ones see its light where it falls."""
    (edvo.work / "slide.png").write_bytes((rig / "left/rgb/000000.png").read_bytes())
    edvo.rig("active.toml", COLOR + INFRARED + SLIDE + DOTS)
    edvo.rig("passive.toml", COLOR + INFRARED)
    for name in ("active", "passive"):
        edvo.render("moving_room", f"--rig {name}.toml --channels depth --out {name}")
    active, passive = edvo.work / "active", edvo.work / "passive"
    require_same(active / "color", passive / "color")
    assert not any((passive / f"dark/rgb/{number:06}.png").read_bytes() == (active / f"dark/rgb/{number:06}.png").read_bytes()
                   for number in range(4))
    assert files.read_png(passive / "dark/rgb/000000.png").max() == 0
    for number in range(4):
        image = files.read_png(active / f"grey/rgb/{number:06}.png")
        assert (image == image[:, :, :1]).all()
    check_lit_pixels(active)
    for number in (2, 1):
        edvo.render("moving_room", f"--rig active.toml --channels depth --threads 1 --shard {number}/2 --out active_shared")
    require_same(active, edvo.work / "active_shared")
    assert (active / "projector_slide.png").read_bytes() == (edvo.work / "slide.png").read_bytes()
    edvo.render("moving_room", "--rig active/rig.toml --channels depth --out active_again")
    require_same(active / "dark/rgb", edvo.work / "active_again/dark/rgb")
    require_same(active / "grey/rgb", edvo.work / "active_again/grey/rgb")
    edvo.run("convert active active_euroc --format euroc --quiet")


def check_lit_pixels(rig):
    """In darkness a pixel is black where its point is outside of both fields of view."""
    camera = pose(INFRARED.split("[[camera]]")[1])
    depth = numpy.load(rig / "dark/truth/depth/000000.npy").astype(float)
    image = files.read_png(rig / "dark/rgb/000000.png")[:, :, 0]
    v, u = numpy.nonzero(depth > 0)
    z = depth[v, u]
    points = camera @ numpy.stack([(u - 47.0) / 70.0 * z, (v - 36.0) / 71.0 * z, z, numpy.ones_like(z)])

    def beyond(T_body_projector, fov_deg):
        """How far each point is beyond the edge of a field of view, in its half widths; below 0 within."""
        x, y, z, _ = numpy.linalg.inv(T_body_projector) @ points
        half = numpy.tan(numpy.radians(numpy.array(fov_deg) / 2))
        assert (z > 0).all()
        return numpy.maximum(abs(x) / z / half[0], abs(y) / z / half[1]) - 1

    of_slide, of_dots = beyond(pose(MOUNT), (50, 40)), beyond(numpy.eye(4), (60, 45))
    one_pixel = 0.05
    outside = (of_slide > one_pixel) & (of_dots > one_pixel)
    assert outside.sum() > 500 and image[v, u][outside].max() == 0
    inside = of_slide < -one_pixel
    assert inside.sum() > 1000 and numpy.mean(image[v, u][inside] > 0) > 0.9, numpy.mean(image[v, u][inside] > 0)


def check_notes_on_projectors(edvo):
    """Who leaves the projectors out says so, and --strict refuses it."""
    edvo.rig("still.toml", f"[[camera]]\nname = \"grey\"\n{IMAGE}{LIGHT}{DOTS}")
    edvo.rig("blind.toml", f"[[camera]]\nname = \"color\"\n{IMAGE}{DOTS}")
    for options in ("--rig still.toml --renderer rasterizer", "--rig still.toml --mode unlit", "--rig blind.toml"):
        notes = json.loads(edvo.render("room", f"{options} --json --out noted --force")[0])["notes"]
        assert any("projectors are left out" in note for note in notes), notes
        assert "projectors are left out" in edvo.render("room", f"{options} --strict --out refused", 3)[1]
        assert not (edvo.work / "refused").exists()
    edvo.render("room", "--rig still.toml --strict --out strict")


def check_notes_on_sensors(edvo):
    """What the renderer leaves out of one camera's sensor is noted, and --strict refuses it."""
    for sensor, word in (("depth.multipath.frequency = 200e6", "multipath"), ("depth.materials.min_return = 0.01", "materials")):
        edvo.rig("sensors.toml", f"[[camera]]\nname = \"plain\"\n{IMAGE}[[camera]]\nname = \"a\"\n{IMAGE}"
                 f"sensor.{sensor}\n[[camera]]\nname = \"b\"\n{IMAGE}sensor.{sensor}\n")
        rendered = edvo.render("room", "--rig sensors.toml --renderer rasterizer --json --out noted --force")[0]
        assert len([note for note in json.loads(rendered)["notes"] if f"sensor.depth.{word} is left out" in note]) == 1, rendered
        refusal = edvo.render("room", "--rig sensors.toml --renderer rasterizer --strict --out refused", 3)[1]
        assert f"sensor.depth.{word} is left out" in refusal
        assert not (edvo.work / "refused").exists()


def check_needed_textures(edvo):
    """A texture that one camera's sensor alone needs must be there."""
    scene = edvo.work / "untextured"
    scene.mkdir()
    for file in (edvo.source / "assets/room").iterdir():
        if file.suffix in (".gltf", ".bin") or file.name == "leaf.png":  # which has holes
            shutil.copy(file, scene)
    edvo.rig("seeing.toml", f"[[camera]]\nname = \"a\"\n{IMAGE}sensor.depth.materials.min_return = 0.01\n")
    for rig, code in (("one.toml", 0), ("seeing.toml", 3)):
        errors = edvo.run(f"render {scene}/room.gltf {PATH} --rig {rig} --mode depth --out depth_only", code)[1]
        assert code == 0 or "floor_planks.png" in errors, errors


def check_refusals(edvo, rig):
    """What is wrong is named with file and element, exit code 3, and nothing is left behind."""
    camera = f"[[camera]]\nname = \"a\"\n{IMAGE}"
    (edvo.work / "broken.png").write_bytes((edvo.work / "slide.png").read_bytes()[:500])
    for text, words in (
            (camera + camera, ["bad.toml:9", "'a'"]),
            (camera + "T_body_camera = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 2, 0], [0, 0, 0, 1]]\n", ["'a'", "rotation"]),
            (camera + "distortion.model = \"pinhole\"\n", ["bad.toml:9", "distortion.model"]),
            (camera + "focus = 1.0\n", ["bad.toml:9", "focus"]),
            (camera + "sensor.focus = 1.0\n", ["bad.toml:9", "focus"]),
            (camera + "sensor.depth.step = -1.0\n", ["'a'", "step"]),
            (STEREO.replace("0.12, 0.03", "-0.12, 0.03"), ["'left'", "positive baseline"]),
            (STEREO.replace("0.12, 0.03", "0.02, 0.03"), ["'left'", "positive baseline"]),
            (STEREO.replace("0.12, 0.03", "0.12, 0.04"), ["'left'", "rectified"]),
            (camera + DOTS + DOTS, ["bad.toml:15", "projector 'dots'", "name of its own"]),
            (camera + DOTS + "brightness = 2.0\n", ["bad.toml:15", "brightness"]),
            (camera + DOTS.replace("30.0", "-1.0"), ["bad.toml:9: projector 'dots': power", "-1"]),
            (camera + DOTS.replace("[60.0", "[180.0"), ["'dots': fov_deg", "180"]),
            (camera + LIGHT + DOTS.replace("0.8", "0.001"), ["'dots': dots.diameter_deg", "at least"]),
            (camera + SLIDE.replace("slide.png", "stripes"), ["'slide': pattern", "stripes", "random_dots"]),
            (camera + SLIDE.replace("slide.png", "missing.png"), ["bad.toml:9: projector 'slide': pattern", "missing.png"]),
            (camera + LIGHT + SLIDE.replace("slide.png", "broken.png"), ["'slide': pattern", "broken.png"]),
            (camera + "spectrum = \"red\"\n", ["bad.toml:9", "spectrum", "infrared"]),
            (camera + "scene_light = 0.5\n", ["'a': scene_light"]),
            ("", ["bad.toml", "[[camera]]"])):
        edvo.rig("bad.toml", text)
        _, errors = edvo.render("room", "--rig bad.toml --channels depth --out bad", 3)
        assert all(word in errors for word in words), errors
        assert not (edvo.work / "bad").exists() and not (edvo.work / "bad.part").exists()
    assert "missing.toml" in edvo.render("room", "--rig missing.toml --out bad", 3)[1]
    assert "partner" in edvo.render("room", "--rig one.toml --channels disparity --out bad", 3)[1]
    assert "--rig" in edvo.render("room", "--size 64x48 --channels disparity --out bad", 2)[1]
    edvo.render("room", "--rig one.toml --size 64x48 --out bad", 2)
    assert "is a rig, expected" in edvo.run(f"track {rig.name} --out e.txt", 3)[1]
    assert f"{rig.name}/left" in edvo.run(f"convert {rig.name} out --format kitti", 3)[1]
    assert not (edvo.work / "bad").exists() and not (edvo.work / "out").exists()


CHANNELS = "--channels depth,flow,imu,disparity,stereo_occlusion"


def main():
    program, source, work = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    edvo = Program(program, source, work)
    edvo.rig("stereo.toml", STEREO)
    edvo.render("moving_room", f"--rig stereo.toml {CHANNELS} --out rig")
    rig = work / "rig"
    check_single_camera(edvo)
    check_shares(edvo, rig)
    check_poses(rig)
    check_time_offset(edvo)
    check_disparity(rig)
    check_imu(edvo)
    check_imu_noise(edvo)
    check_imu_covers_cameras(edvo)
    check_negative_stamps(edvo)
    check_euroc(edvo, rig)
    check_projectors(edvo, rig)
    check_notes_on_projectors(edvo)
    check_notes_on_sensors(edvo)
    check_needed_textures(edvo)
    check_refusals(edvo, rig)
    return 0


if __name__ == "__main__":
    sys.exit(main())
