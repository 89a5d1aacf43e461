"""Every command that writes, on inputs that take no time: what the torture disturbs."""

import dataclasses

from small_exr import small_exr

ORBIT = ("--path orbit --orbit.centre=-0.95,0.5,0.3 --orbit.radius 1.2 --orbit.height 0.8 --rate 15 "
         "--duration 0.4")
WALL = ("--path orbit --orbit.centre=0,0,0 --orbit.radius 2 --orbit.height 0.2 --rate 15 --duration 0.4")
SAMPLED = f"render {{assets}}/plane_and_box/plane_and_box.gltf {WALL} --size 64x48 --quiet"
RENDER = f"{SAMPLED} --samples 1"
TEST_SHARD = "test {inputs}/rgbd.toml --cache cache --quiet --shard 1/1 --trials trials"

SCENARIO = """why = "torture"
[scene]
gltf = "{assets}/room/room.gltf"
[camera]
width = 64
height = 48
[path]
kind = "orbit"
rate = 15.0
duration = 0.4
orbit.centre = [-0.95, 0.5, 0.3]
orbit.radius = 1.2
orbit.height = 0.8
[render]
samples = 1
[expect]
tracked_fraction.min = 0.0
"""
MONO = """[odometry]
mode = "mono"
mono.bootstrap = "rgbd"
"""
DATASET = """name = "set"
part_frames = 3
[camera]
width = 64
height = 48
[render]
samples = 1
[path]
rate = 15.0
duration = 0.4
[scenes.box]
gltf = "{assets}/plane_and_box/plane_and_box.gltf"
[paths.orbit]
kind = "orbit"
orbit.radius = 2.0
"""
NOISE = """[sensor]
noise.read_noise = [15.0, 15.0, 15.0]
noise.full_well = [5000.0, 5000.0, 5000.0]
"""
RIG = "".join(f"""[[camera]]
name = "{name}"
position = [{x}, 0.0, 0.0]
width = 64
height = 48
fx = 60.0
fy = 60.0
cx = 31.5
cy = 23.5
""" + ('stereo = "right"\n' if name == "left" else "") for name, x in (("left", 0.0), ("right", 0.1)))
FILES = {"rgbd.toml": SCENARIO, "mono.toml": SCENARIO + MONO, "noisy.toml": SCENARIO + NOISE, "set.toml": DATASET,
         "archives.toml": 'tar = true\n' + DATASET, "rig.toml": RIG}
BINARY_FILES = {"sky.exr": small_exr(8, 4, (0.2, 0.4, 0.9))}

# Made once: the inputs of the commands below.
INPUTS = [
    f"render {{assets}}/room/room.gltf {ORBIT} --size 160x120 --samples 1 --quiet --float-depth --channels imu "
    "--out {inputs}/sequence",
    "track {inputs}/sequence --out {inputs}/track.txt --quiet",
]


@dataclasses.dataclass
class Command:
    """Commands that are run one after the other in an empty folder, as a shell reads them; those of
    `before` are not disturbed. `ends` are the exit codes of an undisturbed run."""

    name: str
    words: list
    before: list = dataclasses.field(default_factory=list)
    ends: tuple = (0,)


COMMANDS = [
    Command("render", [f"{RENDER} --float-depth --channels imu,edges --out out"]),
    Command("shards", [f"{RENDER} --shard 1/2 --out out", f"{RENDER} --shard 2/2 --out out"]),
    Command("unsynced", [f"{RENDER} --no-sync --out out"]),
    Command("force", [f"{RENDER} --ambient 0.5 --force --out out"], [f"{RENDER} --out out"]),
    Command("path", [f"{RENDER} --mode path --environment sky:30 --out out"]),
    Command("denoised", [f"{SAMPLED} --samples 4 --mode path --denoise --denoise-frames 1 --environment {{inputs}}/sky.exr --out out"]),
    Command("rig", [f"render {{assets}}/plane_and_box/plane_and_box.gltf {WALL} --samples 1 --quiet "
                    "--rig {inputs}/rig.toml --channels disparity --out out"]),
    Command("run", ["run {inputs}/rgbd.toml --debug-images 3 --quiet --out out"]),
    Command("run_mono", ["run {inputs}/mono.toml --debug-images 3 --quiet --out out"]),
    Command("test", ["test {inputs}/rgbd.toml --cache cache --quiet --junit junit.xml --json results.json "
                     "--report report.html --save-baseline baseline.json"]),
    Command("test_tracker", ["test {inputs}/rgbd.toml --cache cache --quiet --bounds none --json results.json "
                             "--tracker '{edvo} track {{sequence}} --out {{output}}'"]),
    Command("test_shard", [TEST_SHARD]),
    Command("test_collect", ["test {inputs}/rgbd.toml --cache cache --quiet --collect trials --json results.json"],
            [TEST_SHARD]),
    Command("track", ["track {inputs}/sequence --out track.txt --frame-log track.csv --debug-images 3 --quiet"]),
    Command("track_map", ["track {inputs}/sequence --out track.txt --save-map map.ply --quiet"]),
    Command("track_force", ["track {inputs}/sequence --preset paper --out track.txt --debug-images 3 --force --quiet"],
            ["track {inputs}/sequence --out track.txt --debug-images 3 --quiet"]),
    Command("track_mono", ["track {inputs}/sequence --mode mono --bootstrap rgbd --out mono.txt --quiet"], ends=(0, 5)),
    Command("depth", ["depth {inputs}/sequence --out out --every 3 --quiet"]),
    Command("euroc", ["convert {inputs}/sequence out --format euroc --quiet"]),
    Command("icl_nuim", ["convert {inputs}/sequence out --format icl-nuim --quiet"]),
    Command("tartanair", ["convert {inputs}/sequence out --format tartanair --quiet"]),
    Command("kitti_odometry", ["convert {inputs}/sequence out --format kitti --quiet"]),
    Command("colmap", ["convert {inputs}/sequence out --format colmap --quiet"]),
    Command("transforms_json", ["convert {inputs}/sequence out --format transforms-json --quiet"]),
    Command("video", ["convert {inputs}/sequence out.avi --format video --quiet"]),
    Command("tum", ["convert {inputs}/sequence out --format tum --quiet"]),
    Command("mcap", ["convert {inputs}/sequence out.mcap --format mcap --points --compression lz4 --quiet"]),
    Command("ablate", ["ablate {inputs}/sequence --study levels --max-frames 4 --seeds 1 --quiet --out out"]),
    Command("sweep", ["sweep {inputs}/rgbd.toml --set odometry.tracker.pyramid.levels=2,3 --cache cache --quiet "
                      "--out out"]),
    Command("budget", ["budget {inputs}/noisy.toml --seeds 1 --cache cache --quiet --out out"]),
    Command("basin", ["basin {inputs}/rgbd.toml --cache cache --quiet --out out"]),
    Command("sensor_check", ["sensor-check --frames 1 --quiet --out out"]),
    Command("train_edges", ["train-edges {assets}/room/room.gltf --views 2 --width 64 --height 48 --tree.max-leaves 20 "
                            "--quiet --out forest.yml.gz"]),
    Command("dataset_render", ["dataset render {inputs}/set.toml --out set --quiet"],
            ["dataset plan {inputs}/set.toml --out set --quiet"]),
    Command("dataset_merge", ["dataset merge {inputs}/set.toml --out set --quiet"],
            ["dataset render {inputs}/set.toml --out set --quiet"]),
    Command("archives", ["dataset merge {inputs}/archives.toml --out set --quiet"],
            ["dataset render {inputs}/archives.toml --out set --quiet"]),
    Command("submit", ["submit {inputs}/set.toml --engine local --out set"], ends=(0, 6)),  # 6: it is there, or begun
    Command("kitti", ["convert {inputs}/track.txt kitti.txt --format kitti"]),
    Command("evo_ape", ["evaluate {inputs}/sequence/groundtruth.txt {inputs}/track.txt --evo-ape ape.zip --json"]),
    Command("evaluate", ["evaluate {inputs}/sequence/groundtruth.txt {inputs}/track.txt --json"]),
]
