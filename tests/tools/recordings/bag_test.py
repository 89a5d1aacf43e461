"""python3 bag_test.py EDVO SCENE FOLDER: bags that ROS' own rosbag writes of a rendered sequence, in each of
its compressions, with raw and with compressed images, are tracked as the sequence is, and their poses are
read; of one that was not closed or is cut, what is whole. Skipped (77) without ROS' modules."""

import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

try:
    import rosbag
    from ros_bag import FRAME, camera_info, compressed_images, header, lines_of, poses, raw_images, stamp_of, write_bag
except ImportError as error:
    print(f"skipped: {error} (python3-rosbag, python3-sensor-msgs, python3-nav-msgs, python3-tf2-msgs)")
    sys.exit(77)


def run(edvo, *arguments):
    result = subprocess.run([edvo, *map(str, arguments)], capture_output=True, text=True, check=False)
    assert result.returncode == 0, f"{arguments}: {result.stderr}"
    return result.stdout


def tracked(edvo, sequence, *options):
    out = sequence.with_name(sequence.name + ".estimate.txt")
    run(edvo, "track", sequence, "--preset", "paper", "--quiet", "--force", "--out", out, *options)
    return out.read_text()


def assert_near(poses, expected, what):
    """Depth in m as floats of 32 bits is rounded otherwise than depth of 16 bits: less than 1 um."""
    lines, others = poses.splitlines()[1:], expected.splitlines()[1:]
    assert len(lines) == len(others), what
    for line, other in zip(lines, others):
        pairs = zip(map(float, line.split()), map(float, other.split()))
        assert max(abs(a - b) for a, b in pairs) < 1e-6, f"{what}: {line}, expected {other}"


def main():
    edvo, scene, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    tum = folder / "tum"
    orbit = "--path orbit --orbit.centre=-0.95,0.5,0.3 --orbit.radius 1.2 --orbit.height 0.8"
    size = "--rate 30 --duration 0.2 --size 160x120 --samples 1 --quiet"
    run(edvo, "render", scene, *orbit.split(), *size.split(), "--out", tum)
    expected = tracked(edvo, tum)
    camera = ("--camera", tum / "camera.toml")
    info = header(camera_info(tum), stamp_of(lines_of(tum / "rgb.txt")[0][0]))
    for compression in ("none", "bz2", "lz4"):
        bag = folder / f"{compression}.bag"
        messages = [*raw_images(tum), *poses(tum), ("/camera/rgb/camera_info", info)]
        write_bag(bag, messages, compression)
        assert_near(tracked(edvo, bag), expected, compression)  # by its CameraInfo
        assert_near(tracked(edvo, bag, *camera), expected, compression)
    bag = folder / "compressed.bag"
    write_bag(bag, compressed_images(tum), "lz4")
    assert tracked(edvo, bag, *camera) == expected, "compressed images"
    check_poses(edvo, folder, tum)
    check_damage(edvo, folder, camera)
    print("bags: three compressions, compressed images, four kinds of poses, cut and not closed")


def check_poses(edvo, folder, tum):
    """The poses of each topic are the truth; converting the bag to TUM's format gives it, too."""
    for topic in ("/pose", "/odom", "/transform", "/tf", f"/tf:world.{FRAME}"):
        out = folder / "poses.txt"
        run(edvo, "convert", f"{folder / 'none.bag'}:{topic}", out, "--format", "tum", "--force", "--quiet")
        assert out.read_text() == (tum / "groundtruth.txt").read_text(), topic
    run(edvo, "convert", folder / "none.bag", folder / "back", "--format", "tum", "--quiet")
    truth = (tum / "groundtruth.txt").read_text()
    assert (folder / "back" / "groundtruth.txt").read_text() == truth, "of /tf below world"


def check_damage(edvo, folder, camera):
    """A bag without its index, as one that was not closed, has all frames; a cut one those before."""
    whole = (folder / "lz4.bag").read_bytes()
    expected = (folder / "lz4.bag.estimate.txt").read_text().splitlines()
    with rosbag.Bag(str(folder / "lz4.bag")) as bag:
        index = bag._index_data_pos
    at = whole.index(b"index_pos=") + len("index_pos=")
    unclosed = bytearray(whole[:index])
    unclosed[at : at + 8] = bytes(8)
    for name, data in (("unclosed.bag", bytes(unclosed)), ("cut.bag", whole[: index * 3 // 4])):
        (folder / name).write_bytes(data)
        lines = tracked(edvo, folder / name, *camera).splitlines()
        assert lines == expected[: len(lines)] and len(lines) >= 3, f"{name}: {lines}"
    result = run(edvo, "track", folder / "cut.bag", *camera, "--preset", "paper", "--force", "--out",
                 folder / "cut.txt")
    assert "is cut at byte" in result, result


if __name__ == "__main__":
    main()
