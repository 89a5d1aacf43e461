#pragma once

#include <vector>

#include "synth/sequence/render_sequence.h"
#include "vo/rigs/rig.h"

namespace synth {

/// Everything that determines the sequences of a rig, and the share of them to render now.
struct RigJob {
  vo::Rig rig;
  /// The sequence of a camera at the body: its poses and path are the body's, T_world_body, its
  /// sensor is what those of the rig's cameras start from, its camera is not used. The share is one
  /// of the body's poses, of which every camera takes a frame.
  RenderJob body;
};

/// Returns the job of each camera's sequence, as if it were rendered alone, in the rig's order. The
/// pixels' channels of a stereo pair go to the cameras that name a partner, the rig's projectors to
/// infrared cameras, where the renderer draws their light; their patterns are made only then. Each
/// camera's sensor has noise of its own, and so has the IMU at it, also from the body's. Throws
/// vo::Error naming the camera whose options are out of range or not for its projection, or whose
/// lens or shutter the renderer cannot draw, the projector whose pattern cannot be made, where the
/// patterns have more than 2^26 px in all, and where a channel of pairs is asked for and no camera
/// has a partner.
std::vector<RenderJob> camera_jobs(const RigJob& job);

/// Returns the textures that the images and channels of any of the cameras depend on, for which the
/// body needs neither poses nor a scene. Throws as `camera_jobs` does of a sensor.
NeededTextures needed_textures(const RigJob& job);

}  // namespace synth
