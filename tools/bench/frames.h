#pragma once

#include <cstddef>
#include <vector>

#include <opencv2/core.hpp>

#include "synth/sequence/render_sequence.h"
#include "vo/core/image.h"
#include "vo/core/progress.h"
#include "vo/dataset/sequence.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/trajectory.h"

namespace tools {

/// Frames of a sequence in memory, so that measured times contain no file access.
struct Frames {
  vo::PinholeCamera camera;
  std::vector<vo::RgbdFrame> frames;
  vo::Trajectory truth;  ///< ground-truth poses; empty if the sequence has none
};

/// Loads the first `count` frames, or all when there are fewer.
Frames load_frames(const vo::SequenceReader& sequence, std::size_t count,
                   const vo::Progress& progress);

/// Renders the first `count` frames of a job into a temporary folder and loads them.
Frames render_frames(synth::RenderJob job, std::size_t count, const vo::Progress& rendering,
                     const vo::Progress& loading);

/// Returns the camera with the same field of view and an image of `size`.
vo::PinholeCamera resized(const vo::PinholeCamera& camera, cv::Size size);

/// Returns the frame scaled to `size`: colour averaged over areas when it shrinks, else
/// interpolated bilinearly; depth of the nearest pixel, because averages would mix surfaces.
vo::RgbdFrame resized(const vo::RgbdFrame& frame, cv::Size size);

}  // namespace tools
