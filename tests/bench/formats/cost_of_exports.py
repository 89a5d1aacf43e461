"""Converts a sequence to each format that is written, and prints time, files and size.

    python3 -B cost_of_exports.py SEQUENCE OUT [--edvo PROGRAM]

A line a format: seconds by the wall clock, with the wait for the disk, files and MB. OUT is made, and what is
in it can be read back by the readers of tests/tools/exports.
"""

import argparse
import pathlib
import subprocess
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]
FORMATS = {
    "tum": "tum",
    "euroc": "euroc",
    "icl-nuim": "icl-nuim",
    "icl-tum": "icl-tum",
    "tartanair": "tartanair",
    "kitti": "kitti",
    "colmap": "colmap",
    "transforms-json": "transforms-json",
    "mcap": "sequence.mcap",
    "video": "sequence.avi",
}


def files_of(path):
    return [path] if path.is_file() else [file for file in path.rglob("*") if file.is_file()]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sequence")
    parser.add_argument("out")
    parser.add_argument("--edvo", default=str(ROOT / "build/release/edvo"))
    arguments = parser.parse_args()
    out = pathlib.Path(arguments.out)
    out.mkdir(parents=True)
    print(f"{'format':18}{'s':>8}{'files':>8}{'MB':>9}")
    for kind, name in FORMATS.items():
        begin = time.perf_counter()
        words = [arguments.edvo, "convert", arguments.sequence, str(out / name), "--format", kind, "--quiet"]
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
        seconds = time.perf_counter() - begin
        files = files_of(out / name)
        size = sum(file.stat().st_size for file in files)
        print(f"{kind:18}{seconds:8.1f}{len(files):8}{size / 1e6:9.1f}", flush=True)


main()
