#!/usr/bin/env python3
"""An outside tracker that is made worse: scaled.py FACTOR OUTPUT COMMAND...

Runs COMMAND, which writes the trajectory OUTPUT, and scales its positions about the first one.
"""
import pathlib
import subprocess
import sys

factor, output, command = float(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3:]
code = subprocess.run(command, check=False).returncode
rows = [line.split() for line in output.read_text().splitlines() if not line.startswith("#")]
first = [float(value) for value in rows[0][1:4]]
with output.open("w") as poses:
    for row in rows:
        moved = [a + (float(value) - a) * factor for value, a in zip(row[1:4], first)]
        poses.write(" ".join([row[0], *(f"{value:.9f}" for value in moved), *row[4:]]) + "\n")
sys.exit(code)
