"""Data sets whose sequences a rig takes: the bytes of `edvo render --rig`, whatever the shares, and an index of all cameras.

    rig_dataset_test.py EDVO REPOSITORY SCRATCH
"""

import csv
import json
import shutil
import subprocess
import tarfile

from dataset_test import EDVO, REPOSITORY, SCRATCH, edvo, files, files_of, numpy, png_file, require_same

IMAGE = "width = 64\nheight = 48\nfx = 50.0\nfy = 50.0\ncx = 31.5\ncy = 23.5\n"
RIG = f"""[imu]
position = [0.05, 0.0, 0.0]
[[camera]]
name = "left"
stereo = "right"
{IMAGE}
[[camera]]
name = "right"
position = [0.1, 0.0, 0.0]
{IMAGE}
[[camera]]
name = "round"
projection = "equirectangular"
width = 48
height = 24
sensor.preset = "perfect"
[[camera]]
name = "late"
time_offset = 0.05
{IMAGE}
sensor.preset = "azure-kinect"
"""
CAMERAS = ["left", "right", "round", "late"]
# A camera that sees what the body has in front, and one that looks the other way.
BOTH_WAYS = f"[[camera]]\nname = \"front\"\n{IMAGE}[[camera]]\nname = \"back\"\norientation = [0.0, 1.0, 0.0, 0.0]\n{IMAGE}"
SLIDE = ("[[projector]]\nname = \"slide\"\nfov_deg = [50.0, 40.0]\npattern = \"slide.png\"\n"
         f"[[camera]]\nname = \"grey\"\nspectrum = \"infrared\"\n{IMAGE}")
SPEC = """name = "pairs"
rig = "rigs/pair.toml"
seeds = 2
part_frames = 4
channels = "depth, disparity, imu"
[path]
rate = 10
duration = 0.8
[scenes.room]
gltf = "{assets}/moving_room/moving_room.gltf"
[paths.orbit]
kind = "orbit"
orbit.centre = [-0.95, 0.5, 0.3]
orbit.radius = 1.2
orbit.height = 0.8
[sensors.kinect]
preset = "kinect-v1"
"""
RENDER = ("--path orbit --orbit.centre=-0.95,0.5,0.3 --orbit.radius 1.2 --orbit.height 0.8 --rate 10 --duration 0.8 "
          "--sensor kinect-v1 --channels depth,disparity,imu --quiet")
EFFECTS = ["noise", "depth.normal", "depth.lateral", "depth.axial", "depth.multipath",
           "depth.disparity", "depth.flying", "depth.holes"]
FRAMES = 9


def write(name, text):
    path = SCRATCH / name
    path.parent.mkdir(exist_ok=True)
    path.write_text(text)
    return name


def write_spec(name, *changes):
    text = SPEC.format(assets=REPOSITORY / "assets")
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    return write(name, text)


def make(spec, out):
    edvo("render", spec, "--out", out)
    edvo("merge", spec, "--out", out)
    edvo("verify", out)


def render(rig, out, options=RENDER):
    subprocess.run([EDVO, "render", REPOSITORY / "assets/moving_room/moving_room.gltf", "--rig", rig, *options.split(),
                    "--out", out], cwd=SCRATCH, check=True, capture_output=True)
    return {name: text for name, text in files_of(SCRATCH / out).items() if not name.endswith(".edvo-files")}


def rows_of(name):
    with open(SCRATCH / name) as text:
        return list(csv.DictReader(text))


def check_shares():
    """Shares in any order, and one that is begun again, give the bytes of one process; a damaged camera is found."""
    make(write_spec("pairs.toml"), "one")
    edvo("render", "pairs.toml", "--out", "two", "--shard", "2/2", "--threads", 1)
    status = edvo("status", "pairs.toml", "--out", "two", "--shards", 2, code=5)
    assert "3 of 6 parts" in status and "lack one: 1" in status, status
    edvo("render", "pairs.toml", "--out", "two", "--shard", "1/2")
    (image,) = SCRATCH.glob("two.part/parts/*/room_orbit_kinect_1-002/room_orbit_kinect_1/right/rgb/000007.png")
    image.write_bytes(image.read_bytes()[:-1])
    assert "room_orbit_kinect_1-002" in edvo("merge", "pairs.toml", "--out", "two", code=5)
    make("pairs.toml", "two")
    require_same("one", "two")


def check_as_rendered():
    """A sequence has the bytes that `edvo render --rig` gives it; no two cameras of all sequences share a seed."""
    for seed in range(2):
        seeds = " ".join([f"--seed {seed * len(CAMERAS)}", *(f"--{effect}.seed {seed}" for effect in EFFECTS)])
        rendered = render("rigs/pair.toml", f"rendered_{seed}", f"{RENDER} {seeds}")
        ours = files_of(SCRATCH / f"one/train/room/room_orbit_kinect_{seed}")
        assert ours == rendered, [name for name in ours.keys() | rendered.keys() if ours.get(name) != rendered.get(name)]
        assert {"rig.toml", "groundtruth.txt", "imu.csv", "left/truth/disparity/000008.npy"} <= ours.keys()
    seeds = [line for name in SCRATCH.glob("one/train/room/*/rig.toml") for line in name.read_text().splitlines()
             if line.startswith("sensor.seed ")]
    assert len(set(seeds)) == 2 * len(CAMERAS), seeds


def check_index():
    """frames.csv has a row for each camera's frame, as its own files have it; sequences and the plan count all."""
    rows = rows_of("one/frames.csv")
    assert len(rows) == 2 * FRAMES * len(CAMERAS)
    for seed, sequence in enumerate(rows_of("one/sequences.csv")):
        of_sequence = [row for row in rows if row["sequence"] == sequence["sequence"]]
        assert [row["camera"] for row in of_sequence] == FRAMES * CAMERAS
        folder = SCRATCH / "one/train/room" / f"room_orbit_kinect_{seed}"
        for camera in CAMERAS:
            of_camera = [row for row in of_sequence if row["camera"] == camera]
            truth = files.read_tum_poses(folder / camera / "groundtruth.txt")
            for number, (row, (stamp, T_world_camera)) in enumerate(zip(of_camera, truth, strict=True)):
                position = [float(row[key]) for key in ("tx", "ty", "tz")]
                T = files.matrix_of(position, [float(row[key]) for key in ("qx", "qy", "qz", "qw")])
                assert abs(T - T_world_camera).max() < 1e-8 and abs(float(row["timestamp"]) - stamp) < 1e-9
                assert int(row["frame"]) == number
                assert row["rgb"] == f"train/room/{row['sequence']}/{camera}/rgb/{number:06}.png"
                depth = png_file.read_png(SCRATCH / "one" / row["depth"])
                assert abs(float(row["depth_coverage"]) - (depth > 0).mean()) < 1e-9
        assert int(sequence["frames"]) == FRAMES * len(CAMERAS) and float(sequence["duration_s"]) == 0.8
        left = [[float(row[key]) for key in ("tx", "ty", "tz")] for row in of_sequence if row["camera"] == "left"]
        length = numpy.linalg.norm(numpy.diff(left, axis=0), axis=1).sum()
        assert abs(float(sequence["length_m"]) - length) < 1e-9
        flow = numpy.mean([float(row["flow_px"]) for row in of_sequence if row["flow_px"]])
        assert abs(float(sequence["flow_px"]) - flow) < 1e-9 * flow
    plan = json.loads(edvo("plan", "pairs.toml", "--json", "--quiet"))
    assert (plan["sequences"], plan["frames"], plan["parts"]) == (2, len(rows), 6), plan
    of_frames = [path for path in (SCRATCH / "one/train").rglob("*") if path.stem.isdecimal()]
    size = sum(path.stat().st_size for path in of_frames)
    # The left camera's frames alone have disparity, a sixth of all bytes.
    assert plan["files"] == len(of_frames) and abs(plan["bytes"] - size) < 0.05 * size, (plan, len(of_frames), size)
    kept = json.loads((SCRATCH / "one/dataset.json").read_text())
    assert kept["cameras"] == len(CAMERAS) and [one["frames"] for one in kept["sequences"]] == [FRAMES, FRAMES]


def check_archives():
    """The frames of all cameras at one time are one sample of an archive."""
    make(write_spec("tar.toml", ("seeds = 2", "tar = true")), "tar")
    for row in rows_of("tar/frames.csv"):
        with tarfile.open(SCRATCH / "tar" / row["archive"]) as archive:
            names = archive.getnames()
            assert names == sorted(names, key=lambda name: name.split(".")[0]) and len(set(names)) == len(names)
            for kind in ("rgb", "depth"):
                number = f"{int(row['frame']):06}"
                assert row[kind] == f"{row['sequence']}/{number}.{row['camera']}.{kind}.png"
                plain = SCRATCH / "one/train/room" / row["sequence"] / row["camera"] / kind / f"{number}.png"
                assert archive.extractfile(row[kind]).read() == plain.read_bytes()


def check_euroc():
    """With `formats` a sequence is what `edvo convert` makes of the folder of its rig, which leaves out what is round."""
    make(write_spec("euroc.toml", ("seeds = 2", "formats = \"euroc\"")), "euroc")
    subprocess.run([EDVO, "convert", "one/train/room/room_orbit_kinect_0", "converted", "--format", "euroc", "--quiet"],
                   cwd=SCRATCH, check=True, capture_output=True)
    ours = files_of(SCRATCH / "euroc/train/room/room_orbit_kinect_0.euroc")
    theirs = files_of(SCRATCH / "converted")
    theirs.pop(".edvo-files")
    ours.pop(".edvo-files", None)
    assert ours == theirs and "mav0/cam2/data.csv" in ours and "mav0/cam3/data.csv" not in ours
    assert "mav0/imu0/data.csv" in ours


def check_filter():
    """The filter holds every camera to its limits, and names the one that does not keep them."""
    write("rigs/both.toml", BOTH_WAYS)
    alone = BOTH_WAYS.split("[[camera]]")[1]
    write("rigs/front.toml", "[[camera]]" + alone)
    shares = {}
    for rig in ("front", "both"):
        name = write_spec("look.toml", ("pair.toml", f"{rig}.toml"), ("channels = \"depth, disparity, imu\"", ""))
        make(name, rig)
        for row in rows_of(f"{rig}/frames.csv"):
            shares.setdefault((rig, row["camera"]), []).append(float(row["textured_share"]))
    front, back = min(shares["both", "front"]), min(shares["both", "back"])
    assert shares["front", "front"] == shares["both", "front"] and back < front, (front, back)
    limit = f"[filter]\nmin_textured_share = {(front + back) / 2}\n[path]"
    for rig, left_out in (("front", 0), ("both", 2)):
        name = write_spec("filtered.toml", ("pair.toml", f"{rig}.toml"), ("channels = \"depth, disparity, imu\"", ""),
                          ("[path]", limit))
        plan = edvo("plan", name)
        assert plan.count("camera 'back': min_textured_share") == left_out and f"{2 - left_out} of 2" in plan, plan


def check_changed_rig():
    """The file of the rig and its patterns belong to what a data set is begun with."""
    slide = SCRATCH / "one/train/room/room_orbit_kinect_0/left/rgb/000000.png"
    write("rigs/slide.toml", SLIDE)
    shutil.copy(slide, SCRATCH / "rigs/slide.png")
    name = write_spec("slide.toml", ("pair.toml", "slide.toml"), (", disparity", ""), ("seeds = 2", "seeds = 1"))
    make(name, "slide")
    options = RENDER.replace(",disparity", "")
    assert files_of(SCRATCH / "slide/train/room/room_orbit_kinect_0") == render("rigs/slide.toml", "slide_rendered", options)
    edvo("render", name, "--out", "begun", "--shard", "1/3")
    shutil.copy(slide.with_name("000001.png"), SCRATCH / "rigs/slide.png")
    assert "other values of rig pattern of projector slide;" in edvo("status", name, "--out", "begun", code=6)
    shutil.copy(slide, SCRATCH / "rigs/slide.png")
    write("rigs/slide.toml", SLIDE + "time_offset = 0.01\n")
    assert "other values of rig file;" in edvo("render", name, "--out", "begun", code=6)


def check_bad_input():
    write("rigs/broken.toml", "[[camera]]\nname = \"left\"\nwidth = 64\nheigth = 48\n")
    write("rigs/mono.toml", f"[[camera]]\nname = \"only\"\n{IMAGE}")
    write("rigs/negative.toml", RIG.replace("stereo = \"right\"", "stereo = \"right\"\nsensor.shutter.readout_time = -1.0"))
    write("rigs/preset.toml", RIG.replace("cy = 23.5\n", "cy = 23.5\nsensor.preset = \"azure-kinect\"\n", 2))
    write("rigs/seed.toml", RIG + "sensor.seed = 5\n")
    write("rigs/lost.toml", SLIDE)
    write("rigs/around.toml", "[[camera]]\nname = \"round\"\nprojection = \"equirectangular\"\nwidth = 48\nheight = 24\n")
    (SCRATCH / "rigs/slide.png").unlink()
    for change, message in (
            (("pair.toml", "none.toml"), "rigs/none.toml does not exist, expected the file of a rig"),
            (("pair.toml", "broken.toml"), "rigs/broken.toml:4: unknown key 'heigth'"),
            (("pair.toml", "mono.toml"), "rig: channels: disparity: expected a camera of the rig that names its partner"),
            (("pair.toml", "negative.toml"), "camera 'left': sensor: "),
            (("pair.toml", "preset.toml"), "sensors.kinect.preset: changes nothing"),
            (("pair.toml", "seed.toml"), "camera 'late': sensor.seed: expected none where a data set has seeds = 2"),
            (("pair.toml", "lost.toml"), "slide.png"),
            (("\"rigs/pair.toml\"", "3"), "rig"),
            (("[path]", "[camera]\nfov_deg = 57.0\n[path]"), "bad.toml:7: camera.fov_deg: expected none beside rig"),
            (("preset =", "camera.width = 320\npreset ="), "sensors.kinect.camera.width: expected none beside rig"),
            (("seeds = 2", "seeds = 2\nrender.kind = \"rasterizer\""), "camera 'left': rasterizer: cannot draw motion blur"),
            (("pair.toml\"", "around.toml\"\nformats = \"euroc\""), "formats: expected a camera of the rig that is a pinhole"),
            (("seeds = 2", "formats = \"euroc, mcap\""), "formats: mcap: holds one camera, expected euroc alone")):
        out = edvo("plan", write_spec("bad.toml", change), code=3)
        assert "bad.toml" in out and message in out, (change, out)


def main():
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    write("rigs/pair.toml", RIG)
    for check in (check_shares, check_as_rendered, check_index, check_archives, check_euroc, check_filter, check_changed_rig,
                  check_bad_input):
        check()
        print(check.__name__, "ok", flush=True)
    shutil.rmtree(SCRATCH)


if __name__ == "__main__":
    main()
