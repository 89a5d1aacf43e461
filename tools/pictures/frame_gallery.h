#pragma once

#include <cstddef>
#include <vector>

#include "tools/pictures/frame_pictures.h"
#include "tools/pictures/scene_view.h"
#include "vo/core/image.h"
#include "vo/sequence_odometry/track_sequence.h"

namespace tools {

struct GalleryOptions {
  std::size_t max_bytes = 1'400'000;  ///< greatest total size of the pictures
  int max_width = 320;                ///< px; selects the pyramid level that is drawn
};

/// Pictures of every n-th frame, n being the least power of two that keeps them within the size
/// limit, and the scene points that those frames saw. It depends only on the frames.
class FrameGallery {
 public:
  explicit FrameGallery(const GalleryOptions& options = {}) : options_(options) {}

  vo::FrameObserver observer();  ///< callback that adds frames; refers to this gallery

  /// Adds estimated and true inverse depth to the pictures of the frame at that time, if it has
  /// any; both depth images have equal size.
  void add_inverse_depth(double timestamp, const vo::DepthImage& depth,
                         const vo::DepthImage& true_depth);

  const std::vector<FramePictures>& pictures() const { return pictures_; }
  const std::vector<SceneView>& views() const { return views_; }
  std::size_t stride() const { return stride_; }  ///< distance between pictures, frames

 private:
  std::size_t bytes() const;
  void thin_out();

  GalleryOptions options_;
  std::size_t seen_ = 0;
  std::size_t stride_ = 1;
  std::vector<FramePictures> pictures_;
  std::vector<SceneView> views_;  ///< points seen by the pictures' frames
};

}  // namespace tools
