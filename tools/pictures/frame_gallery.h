#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/pictures/scene_view.h"
#include "vo/core/image.h"
#include "vo/sequence_odometry/track_sequence.h"

namespace tools {

/// A WebP file and the range of values that its colours span.
struct ValuePicture {
  std::string webp;
  std::array<double, 2> range{};  ///< values shown darkest and brightest
};

/// Pictures of one frame as WebP files of equal size; empty where there is nothing to show.
struct FramePictures {
  double timestamp = 0;  ///< s
  cv::Size size;         ///< px
  std::string colour;
  std::string edges;            ///< edge pixels on a transparent background
  std::string residual_before;  ///< residuals of the first reference's points at the initial pose
  std::string residual_after;
  ValuePicture depth;                ///< depth; range in m, far to near
  ValuePicture inverse_depth;        ///< estimated inverse depth; range in 1/m
  ValuePicture inverse_depth_truth;  ///< true inverse depth in the range of inverse_depth

  std::size_t bytes() const;
};

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
