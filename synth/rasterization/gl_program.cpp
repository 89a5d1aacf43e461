#include "synth/rasterization/gl_program.h"

#include <array>

#include "vo/core/error.h"

namespace synth {
namespace {

constexpr GLsizei kLongestLog = 2048;

/// Throws vo::Error with the log that `get_log` gives of an object unless its status is good.
template <typename GetStatus, typename GetLog>
void require_good(GLuint object, GLenum status, GetStatus get_status, GetLog get_log,
                  const char* complaint) {
  GLint is_good = 0;
  get_status(object, status, &is_good);
  if (is_good == 0) {
    std::array<char, kLongestLog> log{};
    get_log(object, kLongestLog, nullptr, log.data());
    vo::fail("OpenGL: ", complaint, ": ", log.data());
  }
}

GLuint compile(const GlFunctions& gl, GLenum kind, const char* source) {
  const GLuint shader = gl.CreateShader(kind);
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  require_good(shader, GL_COMPILE_STATUS, gl.GetShaderiv, gl.GetShaderInfoLog,
               "a shader does not compile");
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
  require_good(program_, GL_LINK_STATUS, gl.GetProgramiv, gl.GetProgramInfoLog,
               "the shaders do not link");
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
