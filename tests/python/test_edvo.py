#!/usr/bin/env python3
"""Tests of the Python module edvo: against the program, closed forms and identities.

EDVO_PROGRAM is the program edvo, EDVO_ASSETS the folder of our own scenes.
"""

import ast
import copy
import gc
import os
import pathlib
import subprocess
import tempfile
import unittest
import weakref

import numpy as np

import edvo

ASSETS = pathlib.Path(os.environ["EDVO_ASSETS"])
SIZE = (160, 120)


def small_camera():
    return edvo.Camera(width=SIZE[0], height=SIZE[1], fx=130, fy=130, cx=79.5, cy=59.5)


def looking_down_minus_z(position):
    """T_world_camera of a camera whose axes are x, -y, -z of the world."""
    pose = np.diag([1.0, -1.0, -1.0, 1.0])
    pose[:3, 3] = position
    return pose


def textured_plane(shift_px, depth_m):
    """A smooth texture moved by some pixels, and a flat depth."""
    u, v = np.meshgrid(np.arange(SIZE[0]) + shift_px, np.arange(SIZE[1]))
    grey = 120 + 60 * np.tanh(2 * np.sin(0.21 * u + 0.07 * v)) + 50 * np.tanh(2 * np.sin(0.17 * v - 0.09 * u))
    return grey.clip(0, 255).astype(np.uint8), np.full((SIZE[1], SIZE[0]), depth_m, np.float32)


def delay_depth(depth_list, delay_s):
    """Moves the stamps of a list of depth images."""
    lines = [line.split() for line in depth_list.read_text().splitlines() if not line.startswith("#")]
    depth_list.write_text("".join(f"{float(stamp) + delay_s:.6f} {name}\n" for stamp, name in lines))


class Arrays(unittest.TestCase):
    def test_depth_in_units_is_depth_in_metres(self):
        trajectories = []
        for units in (False, True):
            odometry = edvo.RgbdOdometry(small_camera())
            for i in range(4):
                image, depth = textured_plane(0.5 * i, 2.0)
                odometry.track(i / 30, image, (depth * 5000).astype(np.uint16) if units else depth)
            trajectories.append(odometry.trajectory.to_tum())
        self.assertEqual(*trajectories)

    def test_a_plane_that_moves_by_half_a_pixel_is_a_camera_that_moves(self):
        odometry = edvo.RgbdOdometry(small_camera())
        for i in range(5):
            image, depth = textured_plane(0.5 * i, 2.0)
            result = odometry.track(i / 30, image, depth)
        self.assertEqual(result.status, "tracked")
        # 2 px at 2 m and f = 130 px are 30.8 mm.
        self.assertAlmostEqual(result.T_world_camera[0, 3], 2 * 2 / 130, delta=0.001)

    def test_an_image_is_kept_alive_and_given_back(self):
        image, depth = textured_plane(0, 2.0)
        alive = weakref.ref(image)
        odometry = edvo.RgbdOdometry(small_camera())
        odometry.track(0, image, depth)
        del image, odometry
        gc.collect()
        self.assertIsNone(alive())

    def test_rows_may_be_apart_and_pixels_may_not(self):
        image, depth = textured_plane(0, 2.0)
        wide = np.zeros((SIZE[1], SIZE[0] + 16), np.uint8)
        wide[:, :SIZE[0]] = image
        apart = edvo.RgbdOdometry(small_camera()).track(0, wide[:, :SIZE[0]], depth)
        self.assertEqual(apart.status, "initialized")
        with self.assertRaisesRegex(edvo.Error, "image: its pixels are apart"):
            edvo.RgbdOdometry(small_camera()).track(0, image[:, ::-1], depth)

    def test_other_types_are_named(self):
        image, depth = textured_plane(0, 2.0)
        with self.assertRaisesRegex(edvo.Error, "image: is 120 x 160 of float32, expected .* uint8"):
            edvo.RgbdOdometry(small_camera()).track(0, depth, depth)
        with self.assertRaisesRegex(edvo.Error, "expected .* float32"):
            edvo.RgbdOdometry(small_camera()).track(0, image, depth.astype(np.float64))


class Options(unittest.TestCase):
    def test_attributes_keys_and_toml_are_the_same(self):
        options = edvo.TrackerOptions("paper")
        options.align.max_iterations = 7
        self.assertEqual(options.get("align.max_iterations"), 7)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "options.toml"
            path.write_text(options.to_toml())
            self.assertEqual(edvo.TrackerOptions.from_toml(path), options)
        self.assertEqual(edvo.TrackerOptions.from_dict({"align": {"max_iterations": 7}}, "paper"), options)
        self.assertNotEqual(edvo.TrackerOptions("paper"), options)

    def test_a_copy_is_another(self):
        options = edvo.TrackerOptions()
        other = copy.copy(options)
        other.align.max_iterations = 3
        self.assertNotEqual(options.align.max_iterations, 3)

    def test_an_unknown_key_names_the_nearest(self):
        with self.assertRaisesRegex(edvo.Error, "max_iterations"):
            edvo.TrackerOptions().set("align.max_iteration", 3)
        with self.assertRaises(AttributeError):
            edvo.TrackerOptions().aling = 3

    def test_errors_have_a_kind(self):
        with self.assertRaises(edvo.Error) as caught:
            edvo.read_trajectory("/nonexistent.txt")
        self.assertEqual(caught.exception.kind, "input")


class Trajectories(unittest.TestCase):
    def test_errors_over_time_have_the_statistics(self):
        random = np.random.default_rng(4)
        stamps = np.arange(40) / 10
        poses = np.repeat(np.eye(4)[None], 40, axis=0)
        poses[:, :3, 3] = np.cumsum(random.normal(0, 0.1, (40, 3)), axis=0)
        noisy = poses.copy()
        noisy[:, :3, 3] += random.normal(0, 0.01, (40, 3))
        errors = edvo.evaluate(edvo.Trajectory(stamps, poses), edvo.Trajectory(stamps, noisy))
        self.assertAlmostEqual(errors.ate.rmse, np.sqrt(np.mean(errors.ate_over_time**2)), places=12)
        self.assertAlmostEqual(errors.rpe_translation.rmse, np.sqrt(np.mean(errors.rpe_translation_over_time**2)), places=12)
        distances = np.linalg.norm(errors.aligned.positions - poses[:, :3, 3], axis=1)
        np.testing.assert_allclose(errors.ate_over_time, distances, atol=1e-12)

    def test_what_is_no_rigid_motion_is_refused(self):
        with self.assertRaisesRegex(edvo.Error, "no rigid motion"):
            edvo.Trajectory([0.0], [np.diag([2.0, 2.0, 2.0, 1.0])])


class Laboratory(unittest.TestCase):
    def test_depth_of_a_view_is_that_of_another_seen_from_there(self):
        """A point of one view's depth, moved to a second camera, lies where the second view measures it."""
        renderer = edvo.Renderer(edvo.Scene(str(ASSETS / "plane_and_box/plane_and_box.gltf")), exposure=1)
        camera = small_camera()
        first, second = looking_down_minus_z([0, 1, 4]), looking_down_minus_z([0, 1, 3.5])
        depths = [renderer.render(camera, pose, ["depth"])["depth"] for pose in (first, second)]
        # On the axis of both cameras depth shrinks by what the camera has moved.
        middle = (SIZE[1] // 2, SIZE[0] // 2)
        self.assertGreater(depths[0][middle], 0)
        self.assertAlmostEqual(float(depths[0][middle] - depths[1][middle]), 0.5, delta=0.01)

    def test_actors_walk_as_the_program_lets_them(self):
        walker = {"file": str(ASSETS / "walker/walker.gltf"), "path": [[-0.5, 0, 0.5], [0.5, 0, 0.5]], "speed": 1.5}
        scene = edvo.Scene(str(ASSETS / "plane_and_box/plane_and_box.gltf"), actors=[walker])
        with tempfile.TemporaryDirectory() as folder:
            actor = pathlib.Path(folder) / "actor.toml"
            actor.write_text(f'[[actor]]\nfile = "{walker["file"]}"\npath = {walker["path"]}\nspeed = 1.5\n')
            sequence = pathlib.Path(folder) / "sequence"
            subprocess.run([os.environ["EDVO_PROGRAM"], "render", ASSETS / "plane_and_box/plane_and_box.gltf", "--actor", actor,
                            "--path", "still", "--move.eye", "0,1,4", "--move.target", "0,1,0", "--rate", "10",
                            "--duration", "0.4", "--size", "80x60", "--float-depth", "--out", sequence, "--quiet"],
                           check=True, stdout=subprocess.DEVNULL)
            camera = edvo.load_camera(str(sequence / "camera.toml"))
            pose = looking_down_minus_z([0, 1, 4])
            for frame in (0, 4):
                depth = edvo.Renderer(scene).render(camera, pose, ["depth"], time=frame / 10)["depth"]
                np.testing.assert_allclose(depth, np.load(sequence / f"depth_float/{frame:06}.npy"), atol=1e-6)
        with self.assertRaisesRegex(edvo.Error, "actor"):
            edvo.Scene(str(ASSETS / "plane_and_box/plane_and_box.gltf"), actors=[{"file": walker["file"]}])

    def test_depth_beyond_goes_through_a_window(self):
        renderer = edvo.Renderer(edvo.Scene(str(ASSETS / "kitchen/kitchen.gltf")))
        frame = renderer.render(small_camera(), looking_down_minus_z([0.6, 1.5, 1.5]), ["depth", "depth_beyond"])
        middle = (SIZE[1] // 2, SIZE[0] // 2)
        self.assertAlmostEqual(float(frame["depth"][middle]), 3.73, delta=1e-3)  # the pane at z = -2.23
        self.assertAlmostEqual(float(frame["depth_beyond"][middle]), 7.73, delta=1e-3)  # the view behind it

    def test_program_and_module_track_to_the_same_bytes(self):
        program = os.environ["EDVO_PROGRAM"]
        with tempfile.TemporaryDirectory() as folder:
            sequence = os.path.join(folder, "sequence")
            subprocess.run([program, "render", ASSETS / "room/room.gltf", "--path", "pan", "--move.eye", "0.8,1.4,1.2",
                            "--move.target", "0,0.9,-1.5", "--rate", "10", "--duration", "1", "--size", "160x120",
                            "--out", sequence, "--quiet"], check=True)
            delay_depth(pathlib.Path(sequence) / "depth.txt", -0.008)
            estimate = os.path.join(folder, "estimate.txt")
            subprocess.run([program, "track", sequence, "--out", estimate, "--quiet"], check=True, stdout=subprocess.DEVNULL)
            read = edvo.Sequence(sequence)
            frames, arrays = edvo.RgbdOdometry(read.camera), edvo.RgbdOdometry(read.camera)
            for frame in read:
                self.assertAlmostEqual(frame.depth_delay, -0.008, delta=1e-9)
                frames.track(frame)
                arrays.track(frame.timestamp, frame.image, frame.depth, depth_delay=frame.depth_delay)
            for odometry in (frames, arrays):
                self.assertEqual(odometry.trajectory.to_tum(), pathlib.Path(estimate).read_text())
            self.assertEqual(len(read), len(frames.trajectory))

    def test_depth_that_is_no_number_is_none(self):
        image, depth = textured_plane(0, 2.0)
        holes, numbers = depth.copy(), depth.copy()
        holes[40:60, 30:90] = 0
        numbers[40:60, 30:90] = np.nan
        numbers[40:50, 30:90] = np.inf
        poses = []
        for measured in (holes, numbers):
            odometry = edvo.RgbdOdometry(small_camera())
            odometry.track(0.0, image, measured)
            moved, _ = textured_plane(1.5, 2.0)
            poses.append(odometry.track(1 / 30, moved, measured).T_world_camera)
        np.testing.assert_array_equal(*poses)
        with self.assertRaisesRegex(edvo.Error, "timestamp"):
            odometry.track(float("nan"), image, depth)

    def test_a_map_is_arrays(self):
        odometry = edvo.MonoOdometry(small_camera(), edvo.MonoOptions(bootstrap="rgbd"))
        for i in range(4):
            image, depth = textured_plane(0.5 * i, 2.0)
            result = odometry.track(i / 30, image, depth if i == 0 else None)
        self.assertEqual(result.state, "tracking")
        inverse_depth = odometry.map["inverse_depth"][odometry.map["state"] == 3]
        np.testing.assert_allclose(np.median(inverse_depth), 0.5, atol=0.01)


class Stubs(unittest.TestCase):
    def test_stubs_name_what_the_module_has(self):
        tree = ast.parse((pathlib.Path(edvo.__file__).parent / "_edvo.pyi").read_text())
        named = {}
        for node in tree.body:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                named[node.name] = {part.name for part in node.body
                                    if isinstance(part, ast.FunctionDef) and not part.name.startswith("__")}
            elif isinstance(node, ast.FunctionDef):
                named[node.name] = set()
        for name in edvo.__all__:
            if name.startswith("__"):
                continue
            self.assertIn(name, named)
            if isinstance(getattr(edvo, name), type) and not issubclass(getattr(edvo, name), Exception):
                own = {part for part in vars(getattr(edvo, name)) if not part.startswith("_")}
                inherited = {"keys", "get", "set", "help", "update", "to_dict", "to_toml", "update_from_toml",
                             "from_toml", "from_dict"}
                self.assertEqual(own - inherited, named[name], name)


if __name__ == "__main__":
    unittest.main()
