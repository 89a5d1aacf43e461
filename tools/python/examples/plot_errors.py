#!/usr/bin/env python3
"""plot_errors.py GROUNDTRUTH ESTIMATE PICTURE: draw the path from above and the errors over time."""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import edvo

truth, estimate = (edvo.read_trajectory(path) for path in sys.argv[1:3])
errors = edvo.evaluate(truth, estimate)
figure, (path, over_time) = plt.subplots(1, 2, figsize=(11, 4), width_ratios=(1, 2), layout="constrained")
for trajectory, name in ((truth, "truth"), (errors.aligned, "estimate, aligned")):
    path.plot(trajectory.positions[:, 0], trajectory.positions[:, 1], label=name)
path.set(xlabel="x, m", ylabel="y, m", aspect="equal", title="Path")
path.legend(loc="upper center", bbox_to_anchor=(0.5, -0.2))
first = errors.timestamps[0]
over_time.plot(errors.timestamps - first, 1000 * errors.ate_over_time, label="ATE")
over_time.plot(errors.rpe_timestamps - first, 1000 * errors.rpe_translation_over_time, label="RPE over 1 s")
over_time.set(xlabel="time, s", ylabel="error, mm", title="Errors")
over_time.legend()
figure.savefig(sys.argv[3], dpi=120)
