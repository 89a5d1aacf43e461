#include "synth/rasterization/gl_target.h"

#include "vo/core/error.h"

namespace synth {
namespace {

constexpr std::array<GLenum, 4> kAttachments = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1,
                                                GL_COLOR_ATTACHMENT2, GL_DEPTH_ATTACHMENT};
constexpr std::array<GLenum, 4> kFormats = {GL_RGBA32F, GL_RGBA32F, GL_R32I, GL_DEPTH_COMPONENT32F};

}  // namespace

GlTarget::GlTarget(const GlFunctions& gl) : gl_(gl) {
  gl.GenFramebuffers(1, &frame_buffer_);
  gl.GenRenderbuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
  gl.BindFramebuffer(GL_FRAMEBUFFER, frame_buffer_);
  gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  gl.DepthFunc(GL_GREATER);
  gl.Enable(GL_DEPTH_TEST);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
}

void GlTarget::bind(const cv::Size& size) {
  if (size == size_) {
    return;
  }
  size_ = size;
  for (std::size_t i = 0; i < buffers_.size(); ++i) {
    gl_.BindRenderbuffer(GL_RENDERBUFFER, buffers_[i]);
    gl_.RenderbufferStorage(GL_RENDERBUFFER, kFormats[i], size.width, size.height);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, kAttachments[i], GL_RENDERBUFFER, buffers_[i]);
  }
  gl_.DrawBuffers(3, kAttachments.data());
  vo::require(gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE,
              "OpenGL: no float frame buffer of ", size.width, "x", size.height, " px");
  gl_.Viewport(0, 0, size.width, size.height);
}

void GlTarget::clear() const {
  constexpr std::array<float, 4> kZero{};
  gl_.ClearBufferfv(GL_COLOR, 0, kZero.data());
  gl_.ClearBufferfv(GL_COLOR, 1, kZero.data());
  constexpr std::array<GLint, 4> kNothing{};
  gl_.ClearBufferiv(GL_COLOR, 2, kNothing.data());
  gl_.ClearBufferfv(GL_DEPTH, 0, kZero.data());
}

const cv::Mat_<cv::Vec4f>& GlTarget::read(GLenum attachment) {
  image_.create(size_);
  gl_.ReadBuffer(attachment);
  gl_.ReadPixels(0, 0, size_.width, size_.height, GL_RGBA, GL_FLOAT, image_.data);
  vo::require(gl_.GetError() == GL_NO_ERROR, "OpenGL: the picture was not drawn");
  return image_;
}

const cv::Mat_<std::int32_t>& GlTarget::read_meshes() {
  meshes_.create(size_);
  gl_.ReadBuffer(GL_COLOR_ATTACHMENT2);
  gl_.ReadPixels(0, 0, size_.width, size_.height, GL_RED_INTEGER, GL_INT, meshes_.data);
  vo::require(gl_.GetError() == GL_NO_ERROR, "OpenGL: the picture was not drawn");
  return meshes_;
}

}  // namespace synth
