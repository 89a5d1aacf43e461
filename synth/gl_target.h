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

  cv::Mat_<cv::Vec4f> read_color() const;    ///< the shaders' output 0
  cv::Mat_<cv::Vec4f> read_surface() const;  ///< output 1

 private:
  cv::Mat_<cv::Vec4f> read(GLenum attachment) const;

  const GlFunctions& gl_;
  cv::Size size_;
  GLuint frame_buffer_ = 0;
  std::array<GLuint, 3> buffers_{};  ///< colour, surface, depth
};

}  // namespace synth
