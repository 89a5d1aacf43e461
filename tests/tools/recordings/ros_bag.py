"""Messages of ROS that hold a TUM folder, and bags of them by ROS' own rosbag (python3-rosbag, python3-sensor-msgs,
python3-nav-msgs, python3-tf2-msgs)."""

import struct

import genpy
import rosbag
from geometry_msgs.msg import PoseStamped, TransformStamped
from nav_msgs.msg import Odometry
from png_file import read_png
from sensor_msgs.msg import CameraInfo, CompressedImage, Image
from tf2_msgs.msg import TFMessage

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


def image_of(pixels, stamp, encoding):
    message = header(Image(width=pixels.shape[1], height=pixels.shape[0], encoding=encoding), stamp)
    if encoding == "32FC1":
        pixels = (pixels / UNITS_PER_M).astype("<f4")
    message.step = pixels[0].nbytes
    message.data = pixels.tobytes()
    return message


def raw_images(tum, read=read_png):
    """Images as rgb8 or mono8, and depth in m as floats."""
    for stamp, name in lines_of(tum / "rgb.txt"):
        pixels = read(tum / name)
        encoding = "rgb8" if pixels.ndim == 3 else "mono8"
        yield "/camera/rgb/image_color", image_of(pixels, stamp_of(stamp), encoding)
    for stamp, name in lines_of(tum / "depth.txt"):
        yield "/camera/depth/image", image_of(read(tum / name), stamp_of(stamp), "32FC1")


def compressed_images(tum, message_format="rgb8; png compressed bgr8"):
    """PNGs as they lie in the folder, said to be of a format of image_transport."""
    for stamp, name in lines_of(tum / "rgb.txt"):
        message = CompressedImage(format=message_format, data=(tum / name).read_bytes())
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
