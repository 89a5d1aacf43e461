#pragma once

#include <functional>

// The prototypes only give the OpenGL functions' types; none is linked.
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES 1
#endif
#include <GL/glcorearb.h>

namespace synth {

/// Lists the OpenGL 4.5 core functions in use. They are looked up in the context, as the functions
/// that libraries export may belong to another one.
// clang-format off
#define EDVO_GL_FUNCTIONS(X) \
  X(ActiveTexture) \
  X(AttachShader) \
  X(BindBuffer) \
  X(BindFramebuffer) \
  X(BindRenderbuffer) \
  X(BindTexture) \
  X(BindVertexArray) \
  X(BufferData) \
  X(CheckFramebufferStatus) \
  X(ClearBufferfv) \
  X(ClearBufferiv) \
  X(ClipControl) \
  X(CompileShader) \
  X(CreateProgram) \
  X(CreateShader) \
  X(DeleteShader) \
  X(DepthFunc) \
  X(DrawBuffers) \
  X(DrawElements) \
  X(Enable) \
  X(EnableVertexAttribArray) \
  X(FramebufferRenderbuffer) \
  X(GenBuffers) \
  X(GenFramebuffers) \
  X(GenRenderbuffers) \
  X(GenTextures) \
  X(GenVertexArrays) \
  X(GetError) \
  X(GetProgramInfoLog) \
  X(GetProgramiv) \
  X(GetShaderInfoLog) \
  X(GetShaderiv) \
  X(GetString) \
  X(GetUniformLocation) \
  X(LinkProgram) \
  X(PixelStorei) \
  X(ReadBuffer) \
  X(ReadPixels) \
  X(RenderbufferStorage) \
  X(ShaderSource) \
  X(TexImage2D) \
  X(TexParameteri) \
  X(Uniform1f) \
  X(Uniform1i) \
  X(Uniform3f) \
  X(Uniform4f) \
  X(Uniform4fv) \
  X(UniformMatrix3fv) \
  X(UniformMatrix4fv) \
  X(UseProgram) \
  X(VertexAttrib4f) \
  X(VertexAttribPointer) \
  X(Viewport)
// clang-format on

/// OpenGL's functions, which work on the context that is current in the thread.
struct GlFunctions {
  /// Looks all functions up; `find` returns an address by name. Throws vo::Error if one is missing.
  explicit GlFunctions(const std::function<void*(const char*)>& find);

// NOLINTNEXTLINE(bugprone-macro-parentheses): the name of a member
#define EDVO_GL_MEMBER(name) decltype(&::gl##name) name;
  EDVO_GL_FUNCTIONS(EDVO_GL_MEMBER)
#undef EDVO_GL_MEMBER
};

}  // namespace synth
