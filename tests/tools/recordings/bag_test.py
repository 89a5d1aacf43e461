"""python3 bag_test.py EDVO SCENE FOLDER: bags that ROS' own rosbag writes of a rendered sequence, in each of
its compressions, with raw and with compressed images, are tracked as the sequence is, and their poses are
read; of one that was not closed or is cut, what is whole. Skipped (77) without ROS' modules."""

import pathlib
import shutil
import struct
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

try:
    import genpy
    import rosbag
    from geometry_msgs.msg import PoseStamped, TransformStamped
    from nav_msgs.msg import Odometry
    from sensor_msgs.msg import CameraInfo, CompressedImage, Image
    from png_file import read_png
    from tf2_msgs.msg import TFMessage
except ImportError as error:
    print(f"skipped: {error} (python3-rosbag, python3-sensor-msgs, python3-nav-msgs, python3-tf2-msgs)")
    sys.exit(77)

UNITS_PER_M = 5000
FRAME = "camera_optical"


def stamp_of(text):
    seconds, _, fraction = text.partition(".")
    return genpy.Time(int(seconds), int(fraction.ljust(9, "0")[:9]))


def lines_of(path):
    return [line.split() for line in path.read_text().splitlines() if line and line[0] != "#"]


def header(message, stamp, frame=FRAME):
    message.header.stamp = stamp
    message.header.frame_id = frame
    return message


def image_of(path, stamp, encoding):
    pixels = read_png(path)
    message = header(Image(width=pixels.shape[1], height=pixels.shape[0], encoding=encoding), stamp)
    if encoding == "32FC1":
        pixels = (pixels / UNITS_PER_M).astype("<f4")
    message.step = pixels[0].nbytes
    message.data = pixels.tobytes()
    return message


def raw_images(tum):
    for stamp, name in lines_of(tum / "rgb.txt"):
        yield "/camera/rgb/image_color", image_of(tum / name, stamp_of(stamp), "rgb8")
    for stamp, name in lines_of(tum / "depth.txt"):
        yield "/camera/depth/image", image_of(tum / name, stamp_of(stamp), "32FC1")


def compressed_images(tum):
    for stamp, name in lines_of(tum / "rgb.txt"):
        message = CompressedImage(format="rgb8; png compressed bgr8", data=(tum / name).read_bytes())
        yield "/camera/rgb/image_color/compressed", header(message, stamp_of(stamp))
    for stamp, name in lines_of(tum / "depth.txt"):
        data = struct.pack("<iff", 0, 0, 0) + (tum / name).read_bytes()
        message = CompressedImage(format="16UC1; compressedDepth png", data=data)
        yield "/camera/depth/image/compressedDepth", header(message, stamp_of(stamp))


def set_pose(position, rotation, numbers):
    position.x, position.y, position.z = numbers[:3]
    rotation.x, rotation.y, rotation.z, rotation.w = numbers[3:]


def poses(tum):
    for line in lines_of(tum / "groundtruth.txt"):
        stamp, numbers = stamp_of(line[0]), [float(number) for number in line[1:]]
        pose = header(PoseStamped(), stamp, "world")
        set_pose(pose.pose.position, pose.pose.orientation, numbers)
        yield "/pose", pose
        odometry = header(Odometry(child_frame_id=FRAME), stamp, "odom")
        set_pose(odometry.pose.pose.position, odometry.pose.pose.orientation, numbers)
        yield "/odom", odometry
        transform = header(TransformStamped(child_frame_id="/" + FRAME), stamp, "/world")
        set_pose(transform.transform.translation, transform.transform.rotation, numbers)
        yield "/transform", transform
        yield "/tf", TFMessage(transforms=[transform])


def camera_info(tum):
    values = dict(
        line.split(" = ") for line in (tum / "camera.toml").read_text().splitlines() if " = " in line
    )
    message = CameraInfo(width=int(values["width"]), height=int(values["height"]))
    fx, fy, cx, cy = (float(values[key]) for key in ("fx", "fy", "cx", "cy"))
    message.distortion_model = "plumb_bob"
    message.D = [0.0] * 5
    message.K = [fx, 0, cx, 0, fy, cy, 0, 0, 1]
    message.P = [fx, 0, cx, 0, 0, fy, cy, 0, 0, 0, 1, 0]
    return message


def stamped(topic, message):
    return message.transforms[0].header.stamp if topic == "/tf" else message.header.stamp


def write_bag(path, messages, compression):
    with rosbag.Bag(str(path), "w", compression=compression, chunk_threshold=150_000) as bag:
        for topic, message in sorted(messages, key=lambda pair: stamped(*pair).to_nsec()):
            bag.write(topic, message, stamped(topic, message))


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


main()
