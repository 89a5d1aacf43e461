#!/usr/bin/env python3
"""binding_overhead.py FOLDER [CAMERA]: what tracking a recorded sequence costs in Python beside what it costs in C++.

Prints the median time of a frame as the C++ odometry's own stages have it, and of all that a call from Python takes beyond
that: the arrays, the result, and what the odometry does between its stages. Images are read before the clock starts.
"""

import statistics
import sys
import time

import edvo

camera = edvo.load_camera(sys.argv[2]) if len(sys.argv) > 2 else None
sequence = edvo.Sequence(sys.argv[1], camera=camera)
frames = [(frame.timestamp, frame.image, frame.depth) for frame in sequence]
odometry = edvo.RgbdOdometry(sequence.camera)
inside, beyond = [], []
for timestamp, image, depth in frames:
    begin = time.perf_counter()
    odometry.track(timestamp, image, depth)
    total = 1000 * (time.perf_counter() - begin)
    inside.append(sum(odometry.stage_times.values()))
    beyond.append(total - inside[-1])
inside, beyond = statistics.median(inside), statistics.median(beyond)
print(f"{len(frames)} frames: {inside:.3f} ms in C++, {beyond:.3f} ms beyond (medians), {100 * beyond / inside:.2f} %")
