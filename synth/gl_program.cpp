#include "synth/gl_program.h"

#include <array>

#include "vo/core/error.h"

namespace synth {
namespace {

constexpr GLsizei kLongestLog = 2048;

GLuint compile(const GlFunctions& gl, GLenum kind, const char* source) {
  const GLuint shader = gl.CreateShader(kind);
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  GLint is_good = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &is_good);
  if (is_good == 0) {
    std::array<char, kLongestLog> log{};
    gl.GetShaderInfoLog(shader, kLongestLog, nullptr, log.data());
    vo::fail("OpenGL: a shader does not compile: ", log.data());
  }
  return shader;
}

}  // namespace

GlProgram::GlProgram(const GlFunctions& gl, const char* vertex_shader,
                     const std::string& fragment_shader)
    : gl_(gl), program_(gl.CreateProgram()) {
  for (const GLuint shader : {compile(gl, GL_VERTEX_SHADER, vertex_shader),
                              compile(gl, GL_FRAGMENT_SHADER, fragment_shader.c_str())}) {
    gl.AttachShader(program_, shader);
    gl.DeleteShader(shader);
  }
  gl.LinkProgram(program_);
  GLint is_good = 0;
  gl.GetProgramiv(program_, GL_LINK_STATUS, &is_good);
  if (is_good == 0) {
    std::array<char, kLongestLog> log{};
    gl.GetProgramInfoLog(program_, kLongestLog, nullptr, log.data());
    vo::fail("OpenGL: the shaders do not link: ", log.data());
  }
}

GLint GlProgram::place_of(const std::string& name) const {
  return gl_.GetUniformLocation(program_, name.c_str());
}

void GlProgram::set(const std::string& name, int value) const {
  gl_.Uniform1i(place_of(name), value);
}

void GlProgram::set(const std::string& name, float value) const {
  gl_.Uniform1f(place_of(name), value);
}

void GlProgram::set(const std::string& name, const Eigen::Vector3f& value) const {
  gl_.Uniform3f(place_of(name), value.x(), value.y(), value.z());
}

void GlProgram::set(const std::string& name, const Eigen::Vector4f& value) const {
  gl_.Uniform4f(place_of(name), value.x(), value.y(), value.z(), value.w());
}

void GlProgram::set(const std::string& name, const std::vector<Eigen::Vector4f>& values) const {
  if (!values.empty()) {
    gl_.Uniform4fv(place_of(name), static_cast<GLsizei>(values.size()), values.front().data());
  }
}

void GlProgram::set(const std::string& name, const Eigen::Matrix3f& value) const {
  gl_.UniformMatrix3fv(place_of(name), 1, GL_FALSE, value.data());
}

void GlProgram::set(const std::string& name, const Eigen::Matrix4f& value) const {
  gl_.UniformMatrix4fv(place_of(name), 1, GL_FALSE, value.data());
}

}  // namespace synth
