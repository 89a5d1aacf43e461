"""Edge-direct visual odometry and its synthetic RGB-D laboratory.

    import edvo

    sequence = edvo.Sequence("rgbd_dataset_freiburg1_xyz", camera=edvo.load_camera("tum-fr1"))
    odometry = edvo.RgbdOdometry(sequence.camera)
    for frame in sequence:
        result = odometry.track(frame.timestamp, frame.image, frame.depth)
    print(edvo.evaluate(sequence.ground_truth, odometry.trajectory).ate.rmse)
"""

from . import _options
from ._edvo import (
    Camera,
    Error,
    Evaluation,
    Frame,
    MonoOdometry,
    MonoOptions,
    MonoResult,
    Renderer,
    RenderOptions,
    RgbdOdometry,
    Scene,
    Sequence,
    Statistics,
    TrackerOptions,
    TrackingResult,
    Trajectory,
    __version__,
    evaluate,
    load_camera,
    read_trajectory,
)

for _class in (Camera, TrackerOptions, MonoOptions, RenderOptions):
    _options.add_attributes(_class)

__all__ = [
    "Camera",
    "Error",
    "Evaluation",
    "Frame",
    "MonoOdometry",
    "MonoOptions",
    "MonoResult",
    "RenderOptions",
    "Renderer",
    "RgbdOdometry",
    "Scene",
    "Sequence",
    "Statistics",
    "TrackerOptions",
    "TrackingResult",
    "Trajectory",
    "__version__",
    "evaluate",
    "load_camera",
    "read_trajectory",
]
