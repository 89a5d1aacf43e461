#pragma once

#include <cstddef>
#include <vector>

#include <opencv2/core.hpp>

#include "vo/core/image.h"
#include "vo/core/progress.h"
#include "vo/dataset/sequence.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/trajectory.h"

namespace tools {

/// The frames of a sequence in memory, so that no time that is measured holds a file.
struct Frames {
  vo::PinholeCamera camera;
  std::vector<vo::RgbdFrame> frames;
  vo::Trajectory truth;  ///< empty when there is none
};

/// The first `count` frames, or all when there are fewer.
Frames load_frames(const vo::SequenceReader& sequence, std::size_t count,
                   const vo::Progress& progress);

/// The camera that sees the same through pixels of another size.
vo::PinholeCamera resized(const vo::PinholeCamera& camera, cv::Size size);

/// The frame as that camera would have it: colour by the mean over a pixel's area, or between the
/// nearest four pixels where it grows; depth of the nearest pixel, never a mean.
vo::RgbdFrame resized(const vo::RgbdFrame& frame, cv::Size size);

}  // namespace tools
