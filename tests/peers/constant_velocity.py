#!/usr/bin/env python3
"""An outside tracker of a few lines: constant_velocity.py SEQUENCE OUTPUT [SPEED]

Says that the camera moves forward at SPEED m/s (default 0) without ever turning, whatever it sees.
"""
import pathlib
import sys

sequence, output, speed = pathlib.Path(sys.argv[1]), sys.argv[2], float((sys.argv[3:] or [0])[0])
lines = (sequence / "rgb.txt").read_text().splitlines()
stamps = [line.split()[0] for line in lines if line and not line.startswith("#")]
start = float(stamps[0])
with open(output, "w") as poses:
    for stamp in stamps:
        poses.write(f"{stamp} 0 0 {speed * (float(stamp) - start):.9f} 0 0 0 1\n")
