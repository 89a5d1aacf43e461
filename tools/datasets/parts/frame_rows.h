#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "synth/path_planning/path_check.h"
#include "synth/sequence/render_sequence.h"
#include "tools/datasets/plan.h"
#include "tools/datasets/sequence_jobs.h"
#include "tools/datasets/spec.h"

namespace tools {

/// Returns the first line of frames.csv, the columns of a row for each frame of a data set. Paths
/// are within the data set; `archive` is the tar that holds the frame's files, if any. Poses are
/// T_world_camera. `flow_px` is the median optical flow to the next frame, `blur_px` what of it
/// happens while the shutter is open, both empty for a sequence's last frame; `depth_coverage` the
/// share of pixels that the depth image has; `textured_share` that of tiles with contrast;
/// `clearance_m` the distance to the nearest surface until the next frame. Of a rig, whose cameras'
/// frames of one number follow each other, the name of the camera is the last column.
std::string frame_columns(const DatasetSpec& spec);

/// Makes the rows of a camera's frames in a part.
class FrameRows {
 public:
  /// Measures the part's views by a camera of the sequence's job. What it is given must outlive it.
  FrameRows(const DatasetSequence& sequence, const SequenceJob& job, std::size_t camera,
            const DatasetPart& part, std::string archive);

  /// Returns the row of a frame, with a line feed. `depth_coverage` is a share, 0 to 1.
  std::string row(std::size_t frame, double depth_coverage) const;

 private:
  const DatasetSequence& sequence_;
  const synth::RenderJob& job_;
  std::string camera_;  ///< name of the rig's camera; empty where there is none
  std::size_t first_;
  std::string archive_;  ///< path within the data set; empty = files
  std::vector<synth::FrameCheck> checks_;
};

}  // namespace tools
