#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/pictures/scene_view.h"
#include "vo/core/image.h"
#include "vo/odometry/track_sequence.h"

namespace tools {

/// A WebP file and what its colours mean.
struct ValuePicture {
  std::string webp;
  std::array<double, 2> range{};  ///< the values that are darkest and brightest
};

/// Pictures of one frame, WebP files of one size; empty where there is nothing to show.
struct FramePictures {
  double timestamp = 0;  ///< s
  cv::Size size;         ///< px
  std::string colour;
  std::string edges;            ///< transparent but for the edges
  std::string residual_before;  ///< of the first reference's points where the alignment started
  std::string residual_after;
  ValuePicture depth;                ///< range in m, far to near
  ValuePicture inverse_depth;        ///< range in 1/m; estimated from images alone
  ValuePicture inverse_depth_truth;  ///< in the same range

  std::size_t bytes() const;
};

struct GalleryOptions {
  std::size_t max_bytes = 1'400'000;  ///< of all pictures together
  int max_width = 320;                ///< px; pictures are of the pyramid's level that fits
};

/// Pictures of every n-th frame, n being the least power of two that keeps them within the limit,
/// and what those frames saw of the scene. Same frames, same gallery.
class FrameGallery {
 public:
  explicit FrameGallery(const GalleryOptions& options = {}) : options_(options) {}

  vo::FrameObserver observer();  ///< refers to this gallery

  /// Beside the picture of the frame at that time, if there is one: inverse depths of the
  /// estimate and of the truth, both depth images of one size.
  void add_inverse_depth(double timestamp, const vo::DepthImage& depth,
                         const vo::DepthImage& true_depth);

  const std::vector<FramePictures>& pictures() const { return pictures_; }
  const std::vector<SceneView>& views() const { return views_; }
  std::size_t stride() const { return stride_; }  ///< frames from picture to picture

 private:
  std::size_t bytes() const;
  void thin_out();

  GalleryOptions options_;
  std::size_t seen_ = 0;
  std::size_t stride_ = 1;
  std::vector<FramePictures> pictures_;
  std::vector<SceneView> views_;  ///< of the pictures' frames
};

}  // namespace tools
