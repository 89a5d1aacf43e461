#!/usr/bin/env python3
"""planted_faults.py ROOT: tools/check_layers.py must name each fault planted in a copy of the sources."""

import pathlib
import shutil
import subprocess
import sys
import tempfile

FAULTS = {  # what is planted: (file, text to replace, its replacement, what the check must say)
    "an include that points up": (
        "vo/core/image.cpp", '#include "vo/core/image.h"',
        '#include "vo/core/image.h"\n#include "vo/tracking/tracker.h"',
        "vo/core may not include vo/tracking/tracker.h"),
    "vo that knows synth": (
        "vo/odometry/rgbd_odometry.cpp", '#include "vo/odometry/rgbd_odometry.h"',
        '#include "vo/odometry/rgbd_odometry.h"\n#include "synth/scene/scene.h"',
        "vo/odometry may not include synth/scene/scene.h"),
    "a cycle of folders": (
        "vo/core/CMakeLists.txt", "edvo_module(PUBLIC", "edvo_module(USES vo/image PUBLIC",
        "vo/core -> "),
    "a use without an include": (
        "vo/evaluation/CMakeLists.txt", "USES vo/core", "USES vo/core vo/image",
        "uses vo/image but includes none of its headers"),
    "a hidden library": (
        "tools/plot/table.cpp", '#include "tools/plot/table.h"',
        '#include "tools/plot/table.h"\n#include <png.h>', "png.h may only be included in"),
}


def copy_sources(root, copy):
    for part in ("vo", "synth", "tools"):
        shutil.copytree(root / part, copy / part, ignore=shutil.ignore_patterns("web"))
    shutil.copy(root / "CONVENTIONS.md", copy)


def check(root, copy):
    command = [sys.executable, root / "tools/check_layers.py", copy]
    return subprocess.run(command, capture_output=True, text=True)


def main(root):
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "edvo"
        copy.mkdir()
        copy_sources(root, copy)
        for name, (file, old, new, expected) in FAULTS.items():
            path = copy / file
            text = path.read_text()
            if old not in text:
                print(f"{name}: cannot be planted, {file} lacks {old!r}")
                failures += 1
                continue
            path.write_text(text.replace(old, new, 1))
            result = check(root, copy)
            path.write_text(text)
            if result.returncode != 1 or expected not in result.stdout:
                print(f"{name}: exit {result.returncode}, expected 1 and {expected!r} in\n{result.stdout}")
                failures += 1
        clean = check(root, copy)
        if clean.returncode != 0:
            print(f"without a fault: exit {clean.returncode}, expected 0:\n{clean.stdout}")
            failures += 1
    return failures


if __name__ == "__main__":
    sys.exit(1 if main(pathlib.Path(sys.argv[1]).resolve()) else 0)
