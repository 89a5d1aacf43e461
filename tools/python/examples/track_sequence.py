#!/usr/bin/env python3
"""track_sequence.py FOLDER [CAMERA]: track a recorded RGB-D sequence and score it against its ground truth."""

import sys

import edvo

camera = edvo.load_camera(sys.argv[2]) if len(sys.argv) > 2 else None
sequence = edvo.Sequence(sys.argv[1], camera=camera)
odometry = edvo.RgbdOdometry(sequence.camera)
for frame in sequence:
    result = odometry.track(frame)
    if result.status in ("lost", "uncertain"):
        print(f"{frame.timestamp:.6f} {result.status}: {result.reason}")
odometry.trajectory.write("estimate.txt", replace=True)
errors = edvo.evaluate(sequence.ground_truth, odometry.trajectory)
print(f"ATE {errors.ate.rmse:.4f} m, RPE over 1 s {errors.rpe_translation.rmse:.4f} m")
