"""Runs of every command that writes a file or prints JSON, on inputs that take no time."""

import dataclasses

SCENARIO = """why = "its text has <, & and \\"quotes\\""
[scene]
gltf = "room/room.gltf"
[camera]
width = 160
height = 120
[path]
kind = "orbit"
rate = 15.0
duration = 1.2
orbit.centre = [-0.95, 0.5, 0.3]
orbit.radius = 1.2
orbit.height = 0.8
[render]
samples = 1
"""
RGBD = """[expect]
tracked_fraction = { min = 1.0 }
ate_rmse_m.max = 0.05
"""
IMPOSSIBLE = """[expect]
ate_rmse_m.max = 0.0
"""
MONO = """[odometry]
mode = "mono"
mono.bootstrap = "rgbd"
[expect]
tracked_fraction = { min = 0.5 }
"""
CLASSES = """[[class]]
name = "seat"
nodes = ["*chair*", "*sofa*"]
materials = ["fabric*"]
"""
SCENARIOS = {"good.toml": SCENARIO + RGBD, "bad.toml": SCENARIO + IMPOSSIBLE,
             "mono.toml": 'channels = "class"\n' + SCENARIO + MONO + CLASSES,
             "broken.toml": "why = 3\n"}
DATASET = """name = "small"
seeds = 2
part_frames = 2
channels = "flow"
[camera]
width = 64
height = 48
[path]
rate = 10
duration = 0.3
[scenes.box]
gltf = "assets/plane_and_box/plane_and_box.gltf"
[paths.orbit]
kind = "orbit"
orbit.radius = 2.0
[paths.nowhere]
kind = "explore"
explore.clearance = 50.0
"""
IMAGE = "width = 64\nheight = 48\nfx = 50.0\nfy = 50.0\ncx = 31.5\ncy = 23.5\n"
FILES = {"classes.toml": CLASSES, **{f"scenarios/{name}": text for name, text in SCENARIOS.items()}, "dataset.toml": DATASET,
         "archives.toml": DATASET.replace("part_frames", "tar = true\npart_frames"),
         "pair.toml": "".join(f"[[camera]]\nname = \"{name}\"\n{IMAGE}" for name in ("left", "right")),
         "pairs.toml": DATASET.replace("[camera]\nwidth = 64\nheight = 48\n", "").replace("seeds = 2", "rig = \"pair.toml\"")}


@dataclasses.dataclass
class Run:
    """A run of a command, in the folder of the test. `words` are as a shell reads them, {edvo} is the
    program. With `json` its stdout is a document of that schema and nothing else."""

    words: str
    json: str = ""
    exit_codes: tuple = (0,)
    camera: bool = False  # reads a camera of OpenNI2, in whose place a driver shows `sequence`
    video: bool = False  # writes a video, which needs OpenCV's videoio
    slurm: bool = False  # calls sbatch, in whose place a script prints the number of a job


ROOM = "assets/room/room.gltf"
PATH = "--path orbit --orbit.centre=-0.95,0.5,0.3 --orbit.radius 1.2 --orbit.height 0.8 --rate 15 --duration 1.2"
RENDER = f"render {ROOM} {PATH} --size 160x120 --samples 1"
TEST = "test --cache cache"

RUNS = [
    Run(f"inspect {ROOM} --json", "inspect"),
    Run(f"path check {ROOM} {PATH} --json", "path_check"),
    Run(f"{RENDER} --plan --json", "render_plan"),
    Run(f"{RENDER} --channels all --float-depth --out sequence --json -", "render"),
    Run(f"{RENDER} --channels imu --out imu --json", "render"),
    Run(f"{RENDER} --channels class --classes classes.toml --out classes --json", "render"),
    Run(f"{RENDER} --channels velocity --sensor kinect-v1 --out kinect --json", "render"),
    Run("convert sequence euroc --format euroc --json", "convert"),
    Run("convert sequence icl --format icl-nuim --json", "convert"),
    Run("convert sequence icl_tum --format icl-tum --json", "convert"),
    Run("convert sequence sequence.mcap --format mcap --points --compression none --json", "convert"),
    Run("convert sequence.mcap from_mcap --format tum --json", "convert"),
    Run("convert sequence sequence.avi --format video --json", "convert", video=True),
    Run("convert euroc tum --format tum --json", "convert"),
    Run("convert sequence tartanair --format tartanair --json", "convert"),
    Run("convert sequence kitti --format kitti --json", "convert"),
    Run("convert sequence colmap --format colmap --json", "convert"),
    Run("convert sequence nerf --format transforms-json --json", "convert"),
    Run("track sequence --out track.txt --frame-log track.csv --time-log track_times.csv --debug-images 6 --save-map map.ply --json", "track"),
    Run("record openni2 recorded --frames 3 --json", "record", camera=True),
    Run("track openni2 --frames 3 --out camera.txt --frame-log camera.csv --json", "track", (0, 5), camera=True),
    Run("track sequence --out again.txt --save-map map.pcd --quiet"),
    Run("track sequence --mode mono --bootstrap rgbd --out mono.txt --frame-log mono.csv --save-map mono.pcd --json",
        "track"),
    Run("track sequence --out /dev/stderr --json"),
    Run("evaluate sequence/groundtruth.txt track.txt --json", "evaluate"),
    Run("evaluate sequence/groundtruth.txt mono.txt --align sim3 --interval 5f --sequence sequence "
        "--estimate-offset --json", "evaluate"),
    Run("evaluate euroc/mav0/state_groundtruth_estimate0/data.csv track.txt --format euroc,tum --json", "evaluate"),
    Run("convert track.txt track_kitti.txt --format kitti --json", "convert_trajectory"),
    Run("convert track_kitti.txt track_euroc.csv --format euroc --times track_kitti_times.txt --json", "convert_trajectory"),
    Run("evaluate sequence/groundtruth.txt track_euroc.csv --evo-ape ape.zip --json", "evaluate"),
    Run("run scenarios/good.toml --out run --report-times --json", "run"),
    Run("run scenarios/bad.toml --out run_bad --json", "run", (4,)),
    Run("run scenarios/mono.toml --out run_mono --json", "run"),
    Run("depth sequence --out depth --every 6 --json", "depth"),
    Run("depth sequence --track --bootstrap rgbd --out depth_tracked --every 6 --json", "depth"),
    Run(f"{TEST} scenarios/good.toml scenarios/mono.toml --seeds 2 --junit junit.xml --report test.html --json -",
        "results"),
    Run(f"{TEST} scenarios --junit junit_bad.xml --report test_bad.html --json -", "results", (3,)),
    Run(f"{TEST} scenarios/good.toml --seeds 4 --json four.json"),
    Run(f"{TEST} scenarios/good.toml --seeds 2 --trials trials --shard 2/2"),
    Run(f"{TEST} scenarios/good.toml --seeds 2 --trials trials --shard 1/2"),
    Run(f"{TEST} scenarios/good.toml --seeds 2 --collect trials --json -", "results"),
    Run(f"{TEST} scenarios/good.toml --seeds 2 --baseline baseline.json --update-baseline --json two.json"),
    Run(f"{TEST} scenarios/good.toml --tracker '{{edvo}} track {{sequence}} --preset paper --out {{output}}' "
        "--junit outside.xml --report outside.html --json outside.json --baseline baseline.json", exit_codes=(0, 4)),
    Run("compare two.json four.json --json -", "comparison"),
    Run("compare two.json outside.json --json", "comparison", (0, 4)),
    Run("compare four.json --halves 10 --json", "self_comparison"),
    Run("submit --test scenarios/good.toml --out tests --shards 2 --max-array 2", slurm=True),
    Run("submit --sweep scenarios/good.toml --set odometry.preset=paper,default --out sweeps --shards 2 --max-array 2", slurm=True),
    Run("cache list --cache cache --json -", "cache"),
    Run("cache verify --cache cache --json", "cache"),
    Run("sweep scenarios/good.toml --set odometry.tracker.pyramid.levels=2,3 --cache cache --out sweep --json",
        "study"),
    Run("sweep scenarios/good.toml --set odometry.preset=paper,default --cache cache --trials swept --shard 1/2"),
    Run("sweep scenarios/good.toml --set odometry.preset=paper,default --cache cache --trials swept"),
    Run("sweep scenarios/good.toml --set odometry.preset=paper,default --cache cache --collect swept --out collected --json",
        "study"),
    Run("budget scenarios/good.toml --set sensor.noise.full_well=6000,6000,6000 --seeds 1 --top 1 --cache cache "
        "--out budget --json", "study"),
    Run("basin scenarios/good.toml --cache cache --out basin --json", "study"),
    *(Run(f"ablate sequence --study {study} --max-frames 6 --out ablate --json", "study")
      for study in ("points", "detectors", "levels", "residuals", "time", "stress", "mono")),
    Run("bench sequence --frames 8 --repeat 1 --growth --out bench.json --json", "bench"),
    Run("bench-render assets/plane_and_box/plane_and_box.gltf --size 64x48 --json", "bench_render"),
    Run("sensor-check --frames 2 --out sensors --json", "sensor_check"),
    Run("train-edges assets/white_room/white_room.gltf --views 2 --out forest.yml.gz --json", "train_edges"),
    Run("train-edges assets/white_room/white_room.gltf --views 2 --evaluate forest.yml.gz --json", "edge_detectors"),
    Run("dataset plan dataset.toml --json", "dataset_estimate"),
    Run("dataset plan dataset.toml --simulate nodes=2,processors=4,mtbf_h=0.01 --json", "dataset_estimate"),
    Run("dataset render dataset.toml --out set --shard 1/2 --json", "dataset_render"),
    Run("dataset status dataset.toml --out set --shards 2 --json", "dataset_status", (5,)),
    Run("dataset render dataset.toml --out set --json", "dataset_render"),
    Run("dataset merge dataset.toml --out set --json", "dataset_merge"),
    Run("dataset verify set --json", "dataset_verify"),
    Run("dataset plan pairs.toml --json", "dataset_estimate"),
    Run("dataset render pairs.toml --out pairs --json", "dataset_render"),
    Run("dataset merge pairs.toml --out pairs --json", "dataset_merge"),
    Run("dataset render archives.toml --out archives"),  # which are left as parts
    Run("cache prune --max-size 0 --cache cache --json", "cache"),
]
