#pragma once

#include <array>

#include <opencv2/core.hpp>

#include "synth/gl_functions.h"

namespace synth {

/// Two float images and a reversed float depth buffer to draw to.
class GlTarget {
 public:
  explicit GlTarget(const GlFunctions& gl);

  void bind(const cv::Size& size);  ///< px
  void clear() const;               ///< to zero: nothing, infinitely far

  /// The shaders' output 0 or 1; good until the next is read.
  const cv::Mat_<cv::Vec4f>& read_color() { return read(GL_COLOR_ATTACHMENT0); }
  const cv::Mat_<cv::Vec4f>& read_surface() { return read(GL_COLOR_ATTACHMENT1); }

 private:
  const cv::Mat_<cv::Vec4f>& read(GLenum attachment);

  const GlFunctions& gl_;
  cv::Size size_;
  cv::Mat_<cv::Vec4f> image_;  ///< read last
  GLuint frame_buffer_ = 0;
  std::array<GLuint, 3> buffers_{};  ///< colour, surface, depth
};

}  // namespace synth
