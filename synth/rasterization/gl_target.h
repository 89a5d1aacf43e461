#pragma once

#include <array>
#include <cstdint>

#include <opencv2/core.hpp>

#include "synth/rasterization/gl_functions.h"

namespace synth {

/// Two float images, one of numbers and a reversed float depth buffer to draw to.
class GlTarget {
 public:
  explicit GlTarget(const GlFunctions& gl);

  void bind(const cv::Size& size);  ///< px
  void clear() const;               ///< to zero: nothing, infinitely far

  /// The shaders' output 0 or 1; good until the next is read.
  const cv::Mat_<cv::Vec4f>& read_color() { return read(GL_COLOR_ATTACHMENT0); }
  const cv::Mat_<cv::Vec4f>& read_surface() { return read(GL_COLOR_ATTACHMENT1); }

  /// The shaders' output 2: 0 where nothing was drawn.
  const cv::Mat_<std::int32_t>& read_meshes();

 private:
  const cv::Mat_<cv::Vec4f>& read(GLenum attachment);

  const GlFunctions& gl_;
  cv::Size size_;
  cv::Mat_<cv::Vec4f> image_;  ///< read last
  cv::Mat_<std::int32_t> meshes_;
  GLuint frame_buffer_ = 0;
  std::array<GLuint, 4> buffers_{};  ///< colour, surface, meshes, depth
};

}  // namespace synth
