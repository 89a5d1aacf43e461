"""Data sets as Python's own hashlib, tarfile and csv read them, made by one process and by many, killed and resumed.

    dataset_test.py EDVO REPOSITORY SCRATCH
"""

import csv
import hashlib
import json
import os
import shutil
import signal
import subprocess
import sys
import tarfile

from dataset_program import EDVO, REPOSITORY, SCRATCH, edvo, files_of

try:
    import numpy
except ImportError:
    print("skipped: python3-numpy was not found")
    sys.exit(77)

sys.path += [str(REPOSITORY / "tests/tools"), str(REPOSITORY / "tests/tools/exports")]
import files  # noqa: E402  (of tests/tools/exports)
import png_file  # noqa: E402

SPEC = """
name = "small"
about = "A small data set."
seeds = 2
part_frames = 3
{more}
[camera]
width = 64
height = 48
[path]
rate = 10
duration = {duration}
[scenes.box]
gltf = "{assets}/plane_and_box/plane_and_box.gltf"
licence = "CC0-1.0, of edvo"
[scenes.moving]
gltf = "{assets}/moving_room/moving_room.gltf"
split = "test"
[paths.orbit]
kind = "orbit"
orbit.radius = 2.0
[paths.walk]
scenes = "moving"
kind = "explore"
[sensors.kinect]
preset = "kinect-v1"
scenes = "box"
[sensors.plain]
"""


def write_spec(name, more="", duration=0.8, **changes):
    text = SPEC.format(more=more, duration=duration, assets=REPOSITORY / "assets")
    for old, new in changes.values():
        assert old in text
        text = text.replace(old, new)
    (SCRATCH / name).write_text(text)
    return name


def require_same(a, b):
    files_a, files_b = files_of(SCRATCH / a), files_of(SCRATCH / b)
    assert files_a.keys() == files_b.keys(), files_a.keys() ^ files_b.keys()
    differing = [name for name in files_a if files_a[name] != files_b[name]]
    assert not differing, differing


def require_clean(*names):
    """Nothing is left beside what was made."""
    stray = [p.name for p in SCRATCH.iterdir() if p.name not in names and not p.name.endswith(".toml")]
    assert not stray, stray


def check_shares():
    """Any number of shares, in any order, on any number of threads, gives the bytes of one process."""
    write_spec("small.toml")
    edvo("render", "small.toml", "--out", "one")
    edvo("merge", "small.toml", "--out", "one")
    for k in (3, 1, 2):
        out = edvo("status", "small.toml", "--out", "three", "--shards", 3, "--json", code=5)
        assert str(k) in json.loads(out[:out.rindex("}") + 1])["missing_shards"] or k != 3
        edvo("render", "small.toml", "--out", "three", "--shard", f"{k}/3", "--threads", k)
    out = edvo("render", "small.toml", "--out", "three", "--shards", 3, env={"SLURM_ARRAY_TASK_ID": "2"})
    assert "share 2 of 3" in out, out
    edvo("merge", "small.toml", "--out", "three")
    require_same("one", "three")
    assert "there already" in edvo("merge", "small.toml", "--out", "three")
    require_clean("one", "three")


def check_checksums():
    lines = (SCRATCH / "one/checksums.sha256").read_text().splitlines()
    names = set()
    for line in lines:
        digest, name = line.split("  ", 1)
        assert hashlib.sha256((SCRATCH / "one" / name).read_bytes()).hexdigest() == digest, name
        names.add(name)
    assert names | {"checksums.sha256"} == files_of(SCRATCH / "one").keys()
    edvo("verify", "one")


def check_index():
    """The rows of frames.csv are those of the sequences: poses, stamps, images, depth's coverage, flow."""
    with open(SCRATCH / "one/frames.csv") as text:
        rows = list(csv.DictReader(text))
    by_sequence = {}
    for row in rows:
        by_sequence.setdefault((row["split"], row["sequence"]), []).append(row)
    names = sorted(name for _, name in by_sequence)
    assert names == [
        "box_orbit_kinect_0", "box_orbit_kinect_1", "box_orbit_plain_0", "box_orbit_plain_1", "moving_orbit_plain_0",
        "moving_orbit_plain_1", "moving_walk_plain_0", "moving_walk_plain_1"], names
    for (split, name), frames in by_sequence.items():
        folder = SCRATCH / "one" / split / name.split("_")[0] / name
        truth = files.read_tum_poses(folder / "groundtruth.txt")
        assert len(truth) == len(frames) == 9
        for i, (row, (stamp, T_world_camera)) in enumerate(zip(frames, truth, strict=True)):
            T = files.matrix_of([float(row[k]) for k in ("tx", "ty", "tz")],
                                [float(row[k]) for k in ("qx", "qy", "qz", "qw")])
            assert abs(T - T_world_camera).max() < 1e-8 and abs(float(row["timestamp"]) - stamp) < 1e-9
            depth = png_file.read_png(SCRATCH / "one" / row["depth"])
            assert abs(float(row["depth_coverage"]) - (depth > 0).mean()) < 1e-9
            assert (SCRATCH / "one" / row["rgb"]).exists() and int(row["frame"]) == i
            assert (row["flow_px"] == "") == (i == 8) and (i == 8 or float(row["flow_px"]) > 0)
        blurs = name.split("_")[2] == "kinect"
        assert all((float(row["blur_px"]) > 0) == blurs for row in frames[:-1])
    with open(SCRATCH / "one/sequences.csv") as text:
        for row in csv.DictReader(text):
            frames = by_sequence[row["split"], row["sequence"]]
            flow = numpy.mean([float(f["flow_px"]) for f in frames[:-1]])
            steps = numpy.diff([[float(f[k]) for k in ("tx", "ty", "tz")] for f in frames], axis=0)
            assert abs(float(row["flow_px"]) - flow) < 1e-9 * max(flow, 1)
            assert abs(float(row["length_m"]) - numpy.linalg.norm(steps, axis=1).sum()) < 1e-9
            assert row["licence"] == ("CC0-1.0; of edvo" if row["scene"] == "box" else "not stated")


def check_as_rendered():
    """A sequence has the bytes that `edvo render` gives it."""
    subprocess.run([EDVO, "render", REPOSITORY / "assets/plane_and_box/plane_and_box.gltf", "--camera",
                    SCRATCH / "one/train/box/box_orbit_plain_0/camera.toml", "--path", "orbit", "--orbit.radius", "2", "--rate", "10", "--duration", "0.8", "--out",
                    SCRATCH / "rendered", "--quiet"], check=True, capture_output=True)
    ours = files_of(SCRATCH / "one/train/box/box_orbit_plain_0")
    theirs = files_of(SCRATCH / "rendered")
    theirs.pop(".edvo-files")
    assert ours == theirs, [name for name in ours.keys() | theirs.keys() if ours.get(name) != theirs.get(name)]
    shutil.rmtree(SCRATCH / "rendered")


def check_damage():
    """One flipped byte is found, in the data set and in a part."""
    image = SCRATCH / "three/test/moving/moving_walk_plain_0/rgb/000003.png"
    damaged = bytearray(image.read_bytes())
    damaged[len(damaged) // 2] ^= 1
    image.write_bytes(damaged)
    (SCRATCH / "three/stray.txt").write_text("not ours")
    out = edvo("verify", "three", code=4)
    assert "moving_walk_plain_0/rgb/000003.png is not as it was made" in out and "stray.txt" in out and "2 problems" in out
    shutil.rmtree(SCRATCH / "three")
    edvo("render", "small.toml", "--out", "three")
    (image,) = SCRATCH.glob("three.part/parts/*/moving_walk_plain_0-001/moving_walk_plain_0/rgb/000003.png")
    image.write_bytes(damaged)
    assert "moving_walk_plain_0-001" in edvo("merge", "small.toml", "--out", "three", code=5)
    edvo("render", "small.toml", "--out", "three")
    edvo("merge", "small.toml", "--out", "three")
    require_same("one", "three")
    shutil.rmtree(SCRATCH / "three")


def check_kills():
    """Killed at its first, second, ... part, and begun again each time, it gives the same bytes and leaves nothing."""
    for parts in (1, 4, 9):
        with subprocess.Popen([EDVO, "dataset", "render", "small.toml", "--out", "killed", "--quiet"], cwd=SCRATCH) as run:
            while run.poll() is None and len(list(SCRATCH.glob("killed.part/parts/000/[!.]*"))) < parts:
                pass
            run.send_signal(signal.SIGKILL)
    assert run.returncode == -signal.SIGKILL
    twice = [subprocess.Popen([EDVO, "dataset", "render", "small.toml", "--out", "killed", "--quiet"], cwd=SCRATCH)
             for _ in range(2)]  # two tasks that make the same parts at once
    assert [run.wait() for run in twice] == [0, 0]
    edvo("merge", "small.toml", "--out", "killed")
    require_same("one", "killed")
    require_clean("one", "killed")
    shutil.rmtree(SCRATCH / "killed")


def check_archives():
    """An archive has the bytes of the files, grouped by frame as WebDataset groups them."""
    write_spec("tar.toml", more="tar = true")
    edvo("render", "tar.toml", "--out", "tar")
    edvo("merge", "tar.toml", "--out", "tar")
    edvo("verify", "tar")
    with open(SCRATCH / "tar/frames.csv") as text:
        rows = list(csv.DictReader(text))
    plain = list(csv.DictReader(open(SCRATCH / "one/frames.csv")))
    for row, file_row in zip(rows, plain, strict=True):
        with tarfile.open(SCRATCH / "tar" / row["archive"]) as archive:
            keys = [name.split(".")[0] for name in archive.getnames()]
            assert keys == sorted(keys) and all(archive.getmember(name).isreg() for name in archive.getnames())
            for kind in ("rgb", "depth"):
                assert row[kind].split(".")[0] == f"{row['sequence']}/{int(row['frame']):06}"
                assert archive.extractfile(row[kind]).read() == (SCRATCH / "one" / file_row[kind]).read_bytes()
    tars = subprocess.run(["tar", "tf", SCRATCH / "tar" / rows[0]["archive"]], capture_output=True, text=True, check=True)
    assert tars.stderr == "" and len(tars.stdout.splitlines()) == 6


def check_formats_and_channels():
    write_spec("formats.toml", more='formats = "euroc, mcap"\nchannels = "flow, imu"', duration=0.2,
               only=("seeds = 2", "seeds = 1"))
    edvo("render", "formats.toml", "--out", "formats")
    edvo("merge", "formats.toml", "--out", "formats")
    edvo("verify", "formats")
    folder = SCRATCH / "formats/train/box"
    assert (folder / "box_orbit_plain_0.euroc/mav0/cam0/sensor.yaml").exists()
    assert (folder / "box_orbit_plain_0/truth/flow/000000.flo").exists()
    assert (folder / "box_orbit_plain_0/imu.csv").exists()
    subprocess.run([EDVO, "convert", folder / "box_orbit_plain_0.mcap", SCRATCH / "back", "--format", "tum", "--quiet"],
                   check=True, capture_output=True)
    for image in (folder / "box_orbit_plain_0/rgb").iterdir():
        assert (png_file.read_png(image) == png_file.read_png(SCRATCH / "back/rgb" / image.name)).all()
    shutil.rmtree(SCRATCH / "back")


def check_filter():
    """What the filter leaves out is named with its reason, in the plan and on the card."""
    write_spec("filtered.toml", more="[filter]\nmax_mean_flow_px = 1.3")
    plan = edvo("plan", "filtered.toml")
    flows = {row["sequence"]: float(row["flow_px"]) for row in csv.DictReader(open(SCRATCH / "one/sequences.csv"))}
    kept = {name for name, flow in flows.items() if flow <= 1.3}
    left_out = {line.split(": ")[1] for line in plan.splitlines() if line.startswith("left out")}
    assert left_out and kept and len(left_out) + len(kept) == len(flows) and not left_out & kept, (left_out, kept, flows)


ACTOR = """[[actor]]
file = "{assets}/walker/walker.gltf"
path = [[-0.5, 0, -0.3], [0.5, 0, -0.3]]
"""


def check_actors():
    """An actor goes through the scenes that it names alone, as `edvo render --actor` lets it."""
    actor = ACTOR.format(assets=REPOSITORY / "assets")
    (SCRATCH / "actor.toml").write_text(actor)
    write_spec("acted.toml", more=actor + 'scenes = "box"')
    edvo("render", "acted.toml", "--out", "acted")
    edvo("merge", "acted.toml", "--out", "acted")
    subprocess.run([EDVO, "render", REPOSITORY / "assets/plane_and_box/plane_and_box.gltf", "--actor", SCRATCH / "actor.toml",
                    "--camera", SCRATCH / "acted/train/box/box_orbit_plain_0/camera.toml", "--path", "orbit", "--orbit.radius", "2",
                    "--rate", "10", "--duration", "0.8", "--out", SCRATCH / "rendered", "--quiet"], check=True, capture_output=True)
    theirs = files_of(SCRATCH / "rendered")
    theirs.pop(".edvo-files")
    assert files_of(SCRATCH / "acted/train/box/box_orbit_plain_0") == theirs
    walked = "train/box/box_orbit_plain_0/depth/000004.png"
    assert (SCRATCH / "acted" / walked).read_bytes() != (SCRATCH / "one" / walked).read_bytes()
    assert files_of(SCRATCH / "acted/test") == files_of(SCRATCH / "one/test")
    for folder in ("rendered", "acted"):
        shutil.rmtree(SCRATCH / folder)


def check_environment():
    """An environment is a file of the spec's folder, and another one is another data set."""
    header, grey = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n", bytes([128, 128, 128, 129])
    (SCRATCH / "sky.hdr").write_bytes(header + 8 * grey)
    write_spec("lit.toml", duration=0.2, lit=('licence = "CC0', 'environment = "sky.hdr"\nlicence = "CC0'))
    edvo("render", "lit.toml", "--out", "lit")
    (SCRATCH / "sky.hdr").write_bytes(header + 7 * grey + bytes([128, 128, 128, 130]))
    assert "other values of scenes.box environment;" in edvo("status", "lit.toml", "--out", "lit", code=6)
    (SCRATCH / "sky.hdr").unlink()
    shutil.rmtree(SCRATCH / "lit.part")


FULL_DISK = """set -e
mount -t tmpfs -o size=$1 tmpfs full
cd full
code=0
"$edvo" dataset render ../small.toml --out set --quiet 2> ../said || code=$?
echo "$code"
find . -name '.box*' -o -name '.moving*' | wc -l
ls set.part/parts/000 2> /dev/null | wc -l
code=0
"$edvo" dataset merge ../small.toml --out set --quiet > /dev/null 2>&1 || code=$?
echo "$code"
mount -o remount,size=100m tmpfs .
"$edvo" dataset render ../small.toml --out set --quiet > /dev/null
"$edvo" dataset merge ../small.toml --out set --quiet > /dev/null
cp -r set ../was_full
"""


def check_full_disk():
    """A disk that is full ends `render` with 75 and leaves no part of a part; with more room the same commands go on,
    with the bytes of one process. The disk is a file system of some hundred kB that only the commands see."""
    if os.geteuid() != 0 or subprocess.run(["unshare", "-m", "true"], capture_output=True).returncode != 0:
        print("check_full_disk skipped: mounting a file system needs root")
        return
    (SCRATCH / "full").mkdir()
    for size, least in (("40k", 0), ("300k", 1)):
        run = subprocess.run(["unshare", "-m", "sh", "-c", FULL_DISK, "sh", size], cwd=SCRATCH, check=True, text=True,
                             capture_output=True, env={**os.environ, "edvo": EDVO})
        code, partial, there, merged = map(int, run.stdout.split())
        said = (SCRATCH / "said").read_text()
        assert (code, partial) == (75, 0) and there >= least and "No space left on device" in said, (size, run.stdout, said)
        assert merged == 5, (size, merged)  # parts are missing
        require_same("one", "was_full")
        shutil.rmtree(SCRATCH / "was_full")
    (SCRATCH / "said").unlink()
    (SCRATCH / "full").rmdir()


def check_node_without_opengl():
    """A share on a machine whose OpenGL cannot be loaded says so, ends with 3 and leaves nothing; another machine makes
    its own share and then that one, with the bytes of one process."""
    write_spec("gl.toml", more="[render]\nkind = \"rasterizer\"\n", duration=0.2, still=("preset = \"kinect-v1\"\n", ""))
    run = subprocess.run([EDVO, "dataset", "render", "gl.toml", "--out", "drawn"], cwd=SCRATCH, capture_output=True, text=True)
    if "no OpenGL" in run.stderr:
        print("check_node_without_opengl skipped: no machine here has OpenGL")
        shutil.rmtree(SCRATCH / "drawn.part")
        return
    assert run.returncode == 0, run.stderr
    edvo("merge", "gl.toml", "--out", "drawn")
    blind = SCRATCH / "blind"
    blind.mkdir()
    for library in ("libOSMesa.so.8", "libOSMesa.so.6", "libEGL.so.1"):
        (blind / library).write_text("no library\n")
    said = edvo("render", "gl.toml", "--out", "mixed", "--shard", "2/2", env={"LD_LIBRARY_PATH": str(blind)}, code=3)
    assert "rasterizer: no OpenGL without a window here" in said and "libosmesa6" in said, said
    assert not list((SCRATCH / "mixed.part/parts").rglob("*box*")), list((SCRATCH / "mixed.part/parts").rglob("*"))
    edvo("render", "gl.toml", "--out", "mixed", "--shard", "1/2")
    assert "shares that lack one: 2" in edvo("status", "gl.toml", "--out", "mixed", "--shards", 2, code=5)
    edvo("merge", "gl.toml", "--out", "mixed", code=5)
    edvo("render", "gl.toml", "--out", "mixed", "--shard", "2/2")
    edvo("merge", "gl.toml", "--out", "mixed")
    require_same("drawn", "mixed")
    for folder in ("drawn", "mixed", "blind"):
        shutil.rmtree(SCRATCH / folder)


def check_merges():
    """Merges at the same time make one data set, and what one leaves that was killed at its very end goes with the next."""
    edvo("render", "small.toml", "--out", "crowd")
    shutil.copy(SCRATCH / "crowd.part/plan.json", SCRATCH / "kept-plan.json")
    crowd = [subprocess.Popen([EDVO, "dataset", "merge", "small.toml", "--out", "crowd", "--quiet"], cwd=SCRATCH,
                              stdout=subprocess.DEVNULL) for _ in range(4)]
    assert [run.wait() for run in crowd] == [0, 0, 0, 0]
    require_same("one", "crowd")
    (SCRATCH / ".crowd.partial-edvo/parts/000/box_orbit_plain_0-000").mkdir(parents=True)
    (SCRATCH / "crowd.part/parts").mkdir(parents=True)
    (SCRATCH / "kept-plan.json").rename(SCRATCH / "crowd.part/plan.json")
    assert "there already" in edvo("merge", "small.toml", "--out", "crowd")
    assert not (SCRATCH / "crowd.part").exists() and not list(SCRATCH.glob(".crowd*"))
    require_same("one", "crowd")
    shutil.rmtree(SCRATCH / "crowd")


def check_bad_input():
    for change, message in (
            (("kind = \"explore\"", "kind = \"explorer\""), "bad.toml:24: path.kind"),
            (("orbit.radius = 2.0", "orbit.radius = -2.0"), "bad.toml:21: orbit: expected radius above 0"),
            (("split = \"test\"", "split = \"te st\""), "split"),
            (("scenes = \"box\"", "scenes = \"bux\""), "there is no 'bux'"),
            (("seeds = 2", "seeds = 0"), "bad.toml:4: seeds: expected 1 to"),
            (("seeds = 2", "seedz = 2"), "seedz"),
            (("plane_and_box.gltf", "missing.gltf"), "missing.gltf does not exist"),
            (("part_frames = 3", "[[actor]]\nfile = \"nobody.gltf\"\npath = [[0, 0, 0], [1, 0, 0]]"), "nobody.gltf does not exist"),
            (("part_frames = 3", "[[actor]]\nfile = \"nobody.gltf\"\nscenes = \"bux\""), "actor.scenes: there is no 'bux'"),
            (("part_frames = 3", "[[actor]]\nscenes = \"box\""), "bad.toml:6: actor: expected a file"),
            (("[paths.orbit]", "[paths.'or_bit']"), "or_bit"),
            (("part_frames = 3", "part_frames = 3\nformats = \"tum\""), "bad.toml:6: formats"),
            (("part_frames = 3", "part_frames = 3\n[filter]\nmin_clearance = -1.0"), "bad.toml:7: path check: expected limits"),
            (("part_frames = 3", "part_frames = 3\nchannels = \"flaw\""), "bad.toml:6: ")):
        name = write_spec("bad.toml", change=change)
        out = edvo("plan", name, code=3)
        assert "bad.toml" in out and message in out, (change, out)
    kinect = ("preset = \"kinect-v1\"\n", "")
    sky = ("split = \"test\"", "split = \"test\"\nenvironment = \"sky:40\"")
    for changes, message in (({}, "box_orbit_kinect_0: rasterizer: cannot draw motion blur"),
                             ({"kinect": kinect, "sky": sky}, "moving_orbit_plain_0: rasterizer: cannot draw an environment")):
        name = write_spec("bad.toml", more="render.kind = \"rasterizer\"", **changes)
        out = edvo("render", name, "--out", "refused", code=3)
        assert f"bad.toml: {message}" in out and not (SCRATCH / "refused.part").exists(), out
    edvo("render", "small.toml", "--out", "begun", "--shard", "1/8")
    write_spec("small.toml", change=("orbit.radius = 2.0", "orbit.radius = 2.5"))
    for action in ("render", "status", "merge"):
        out = edvo(action, "small.toml", "--out", "begun", code=6)
        assert "other values of paths.orbit.orbit.radius;" in out, out
    write_spec("small.toml")
    edvo("render", "small.toml", "--out", "begun", "--shard", "9/8", code=2)
    (SCRATCH / "one-other").mkdir()
    edvo("render", "small.toml", "--out", "one-other", code=6)
    edvo("verify", "begun.part", code=3)


def check_own_folders():
    """A folder that has the name of an unfinished data set is not removed, nor written into, unless it is one."""
    mine = SCRATCH / "own.part"
    mine.mkdir()
    (mine / "mine").write_text("precious")
    assert "own.part: is no unfinished data set" in edvo("render", "small.toml", "--out", "own", code=3)
    assert [entry.name for entry in mine.iterdir()] == ["mine"]
    mine.rename(SCRATCH / "elsewhere")
    edvo("render", "small.toml", "--out", "own")
    edvo("merge", "small.toml", "--out", "own")
    assert not mine.exists()
    (SCRATCH / "elsewhere").rename(mine)
    edvo("merge", "small.toml", "--out", "own")
    assert (mine / "mine").read_text() == "precious"


def main():
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    for check in (check_shares, check_checksums, check_index, check_as_rendered, check_damage, check_kills, check_merges,
                  check_full_disk, check_node_without_opengl, check_archives,
                  check_formats_and_channels, check_filter, check_actors, check_environment, check_bad_input,
                  check_own_folders):
        check()
        print(check.__name__, "ok", flush=True)
    shutil.rmtree(SCRATCH)


if __name__ == "__main__":
    main()
