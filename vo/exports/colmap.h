#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "vo/dataset/sequence_source.h"
#include "vo/exports/sparse_points.h"
#include "vo/files/output.h"

namespace vo {

/// Writes a sequence as a model of COLMAP (Schönberger & Frahm, CVPR 2016) in its text format:
///     images/000000_1305031102.175304.png    the frame's number and its stamp, s
///     sparse/0/cameras.txt                   PINHOLE, OPENCV, FULL_OPENCV or OPENCV_FISHEYE
///     sparse/0/images.txt                    T_camera_world, and where it sees which point
///     sparse/0/points3D.txt                  points of `SparsePoints` that two frames see
/// COLMAP's pixels are counted from the image's corner, half a pixel more than the project's own.
/// Every frame needs a pose; without depth the model has no points.
class ColmapModel {
 public:
  /// The source must outlive it.
  explicit ColmapModel(const SequenceSource& source);

  std::vector<NamedBytes> encode_frame(std::size_t index, const RgbdFrame& frame);
  std::vector<NamedBytes> encode_lists() const;

 private:
  const SequenceSource& source_;
  std::vector<std::string> names_;  ///< of the images
  SparsePoints points_;
};

}  // namespace vo
