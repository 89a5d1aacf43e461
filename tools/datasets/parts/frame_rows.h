#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "synth/path_planning/path_check.h"
#include "synth/sequence/render_sequence.h"
#include "tools/datasets/plan.h"
#include "tools/datasets/spec.h"

namespace tools {

/// The columns of frames.csv, a row for each frame of a data set. Paths are within the data set;
/// `archive` is the tar that holds the frame's files, if any. Poses are T_world_camera. `flow_px`
/// is the median optical flow to the next frame, `blur_px` what of it happens while the shutter is
/// open, both empty for a sequence's last frame; `depth_coverage` the share of pixels that the
/// depth image has; `textured_share` that of tiles with contrast; `clearance_m` the distance to the
/// nearest surface until the next frame.
inline constexpr const char* kFrameColumns =
    "split,sequence,frame,timestamp,archive,rgb,depth,tx,ty,tz,qx,qy,qz,qw,flow_px,blur_px,"
    "depth_coverage,textured_share,clearance_m\n";

/// Makes the rows of a part's frames.
class FrameRows {
 public:
  /// Measures the part's views. What it is given must outlive it.
  FrameRows(const DatasetSequence& sequence, const synth::RenderJob& job, const DatasetPart& part,
            std::string archive);

  /// Returns the row of a frame, with a line feed. `depth_coverage` is a share, 0 to 1.
  std::string row(std::size_t frame, double depth_coverage) const;

 private:
  const DatasetSequence& sequence_;
  const synth::RenderJob& job_;
  std::size_t first_;
  std::string archive_;  ///< path within the data set; empty = files
  std::vector<synth::FrameCheck> checks_;
};

}  // namespace tools
