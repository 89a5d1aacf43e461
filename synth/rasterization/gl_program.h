#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "synth/rasterization/gl_functions.h"

namespace synth {

/// A vertex and a fragment shader in the context that was current at construction.
class GlProgram {
 public:
  /// Compiles and links the shaders. Throws vo::Error with the compiler's or linker's log.
  GlProgram(const GlFunctions& gl, const char* vertex_shader, const std::string& fragment_shader);

  void use() const { gl_.UseProgram(program_); }  ///< makes it current for later calls

  /// Sets a uniform by name; does nothing if the shaders do not use it.
  void set(const std::string& name, int value) const;
  void set(const std::string& name, float value) const;
  void set(const std::string& name, const Eigen::Vector3f& value) const;
  void set(const std::string& name, const Eigen::Vector4f& value) const;
  void set(const std::string& name, const std::vector<Eigen::Vector4f>& values) const;
  void set(const std::string& name, const Eigen::Matrix3f& value) const;
  void set(const std::string& name, const Eigen::Matrix4f& value) const;

 private:
  GLint place_of(const std::string& name) const;

  const GlFunctions& gl_;
  GLuint program_;
};

}  // namespace synth
