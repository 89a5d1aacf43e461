#!/usr/bin/env python3
"""render_and_track.py SCENE.gltf: render a camera that turns in a scene, track it, and compare with the truth."""

import sys

import numpy as np

import edvo

camera = edvo.Camera(width=320, height=240, fx=260, fy=260, cx=159.5, cy=119.5)
renderer = edvo.Renderer(edvo.Scene(sys.argv[1]), exposure=1)
odometry = edvo.RgbdOdometry(camera)
truth = []
for i in range(20):
    angle = 0.01 * i  # rad about the vertical axis; the camera's y axis points down, the world's up
    pose = np.diag([1.0, -1.0, -1.0, 1.0])
    pose[:3, :3] = [[np.cos(angle), 0, np.sin(angle)], [0, -1, 0], [np.sin(angle), 0, -np.cos(angle)]]
    pose[:3, 3] = [0.002 * i, 1.4, 1.2]
    frame = renderer.render(camera, pose)
    odometry.track(i / 30, frame["image"], frame["depth"])
    truth.append(pose)
truth = edvo.Trajectory([i / 30 for i in range(20)], truth)
print(f"ATE {1000 * edvo.evaluate(truth, odometry.trajectory, interval=0.3).ate.rmse:.3f} mm")
