#pragma once

#include <array>
#include <cstdint>

#include <opencv2/core.hpp>

#include "synth/rasterization/gl_functions.h"

namespace synth {

/// A framebuffer with two float images, an integer image and a reversed float depth buffer.
class GlTarget {
 public:
  explicit GlTarget(const GlFunctions& gl);

  void bind(const cv::Size& size);  ///< resizes the images to `size`, px
  void clear() const;               ///< sets all to zero: no mesh, infinitely far

  /// Returns the fragment shader's output 0, valid until output 0 or 1 is read again.
  const cv::Mat_<cv::Vec4f>& read_color() { return read(GL_COLOR_ATTACHMENT0); }
  /// Returns the fragment shader's output 1, valid until output 0 or 1 is read again.
  const cv::Mat_<cv::Vec4f>& read_surface() { return read(GL_COLOR_ATTACHMENT1); }

  /// Returns the fragment shader's output 2, the mesh numbers; 0 where nothing was drawn.
  const cv::Mat_<std::int32_t>& read_meshes();

 private:
  const cv::Mat_<cv::Vec4f>& read(GLenum attachment);

  const GlFunctions& gl_;
  cv::Size size_;
  cv::Mat_<cv::Vec4f> image_;  ///< output 0 or 1, as read last
  cv::Mat_<std::int32_t> meshes_;
  GLuint frame_buffer_ = 0;
  std::array<GLuint, 4> buffers_{};  ///< renderbuffers: colour, surface, meshes, depth
};

}  // namespace synth
