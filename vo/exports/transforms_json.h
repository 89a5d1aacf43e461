#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "vo/dataset/sequence_source.h"
#include "vo/files/output.h"

namespace vo {

/// Units of the depth images beside a transforms.json, 1/m: Nerfstudio takes millimetres unless it
/// is told otherwise on its command line.
inline constexpr double kTransformsDepthUnits = 1000;

/// Writes a sequence as Nerfstudio reads it: transforms.json, images/000000.png and, where frames
/// have depth, depths/000000.png (16 bit, mm, 0 is none), or .npy (float32, mm) of float depth.
///     transform_matrix  T_world_camera of a camera with x right, y up, z backwards (OpenGL's)
///     cx, cy            px from the image's corner: half a pixel more than the project's own
///     k1 ... p2         OpenCV's lens model; of OPENCV_FISHEYE k1 to k4
///     timestamp         s; this project's addition, as `depth_unit_scale_factor`, m per unit
/// Every frame needs a pose.
class TransformsJson {
 public:
  /// The source must outlive it.
  explicit TransformsJson(const SequenceSource& source) : source_(source) {}

  std::vector<NamedBytes> encode_frame(std::size_t index, const RgbdFrame& frame);
  std::vector<NamedBytes> encode_lists() const;

 private:
  const SequenceSource& source_;
  std::string frames_;  ///< elements of the array so far
  bool has_depth_ = false;
};

}  // namespace vo
