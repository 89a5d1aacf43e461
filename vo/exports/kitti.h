#pragma once

#include <cstddef>
#include <vector>

#include "vo/dataset/sequence_source.h"
#include "vo/files/output.h"

namespace vo {

/// Writes a sequence in the layout of KITTI's odometry benchmark (Geiger et al., CVPR 2012):
///     sequences/00/image_2/000000.png    colour; grey in image_0
///     sequences/00/calib.txt             P0 to P3: one camera, so that all are the same
///     sequences/00/times.txt             s
///     poses/00.txt                       T_first_camera, rows of the upper three
/// Its world is the first camera. Where there are poses, every frame needs one. The images are
/// rectified: the lens must be a perfect one.
class KittiOdometry {
 public:
  /// The source must outlive it.
  explicit KittiOdometry(const SequenceSource& source) : source_(source) {}

  std::vector<NamedBytes> encode_frame(std::size_t index, const RgbdFrame& frame) const;
  std::vector<NamedBytes> encode_lists() const;

 private:
  const SequenceSource& source_;
};

}  // namespace vo
