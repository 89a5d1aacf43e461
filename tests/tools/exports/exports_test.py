#!/usr/bin/env python3
"""Renders sequences, converts them to the formats of other programs and reads each by a reader that shares
nothing with the project: exports_test.py EDVO SOURCE_FOLDER WORK_FOLDER.

Exits with 77 (skipped) where python3-numpy is not installed.
"""

import pathlib
import shutil
import subprocess
import sys
import tomllib

try:
    import benchmarks
    import colmap
    import euroc
    import icl_nuim
    import transforms_json
except ImportError:
    print("skipped: python3-numpy is not installed")
    sys.exit(77)

PATH = ("--path orbit --orbit.centre=-0.95,0.5,0.3 --orbit.radius 1.2 --orbit.height 0.8 --rate 15 --duration 0.4 "
        "--samples 4")
LENSES = {
    "brown_conrady": "k1 = -0.28\nk2 = 0.07\np1 = 0.001\np2 = -0.002",
    "brown_conrady, rational": "k1 = -0.1\nk2 = 0.02\np1 = 0.001\np2 = -0.002\nk3 = 0.01\nk4 = 0.12\nk5 = 0.01\nk6 = 0.002",
    "kannala_brandt": "k1 = -0.013\nk2 = 0.021\nk3 = -0.012\nk4 = 0.0021",
}


class Folder:
    """A folder for outputs, and the program that makes them."""

    def __init__(self, program, source, work):
        self.program, self.source, self.work = program, source, work

    def edvo(self, words):
        subprocess.run([self.program, *words.split()], cwd=self.work, check=True, stdout=subprocess.DEVNULL)

    def rendered(self, name, camera):
        self.edvo(f"render {self.source}/assets/room/room.gltf {PATH} {camera} --float-depth --quiet --out {name}")
        return self.work / name

    def converted(self, sequence, format_name):
        out = self.work / f"{sequence.name}_{format_name}"
        self.edvo(f"convert {sequence.name} {out.name} --format {format_name} --quiet")
        return out


def check_all(folder, sequence):
    """Every format, of one sequence."""
    transforms_json.check(folder.converted(sequence, "transforms-json"), sequence)
    colmap.check(folder.converted(sequence, "colmap"), sequence)
    tartanair = folder.converted(sequence, "tartanair")
    camera = tomllib.loads((tartanair / "camera.toml").read_text())
    assert all(value == 0 for name, value in camera["distortion"].items() if name != "model")
    focal, centre = (camera["fx"], camera["fy"]), (camera["cx"], camera["cy"])
    views = benchmarks.check_tartanair(tartanair, sequence, focal, centre)
    benchmarks.check_kitti(folder.converted(sequence, "kitti"), sequence, [view.depth for view in views])
    euroc.check(folder.converted(sequence, "euroc"), sequence)
    icl_nuim.check(icl_nuim.read_rendered(folder.converted(sequence, "icl-nuim")), sequence, "icl-nuim")
    icl_nuim.check(icl_nuim.read_tum_compatible(folder.converted(sequence, "icl-tum")), sequence, "icl-tum")


def main():
    program, source, work = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    folder = Folder(program, source, work)
    check_all(folder, folder.rendered("pinhole", "--size 160x120"))
    for number, (name, coefficients) in enumerate(LENSES.items()):
        print(f"{name}:")
        model = name.split(",")[0]
        lens = "\n".join("distortion." + line for line in coefficients.splitlines())
        (work / f"lens{number}.toml").write_text(
            f'width = 160\nheight = 120\nfx = 110.0\nfy = 112.0\ncx = 78.0\ncy = 61.0\n'
            f'distortion.model = "{model}"\n{lens}\n', encoding="utf-8")
        check_all(folder, folder.rendered(f"lens{number}", f"--camera lens{number}.toml"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
