#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace synth {

enum class GlBackEnd { osmesa, egl };

constexpr auto enum_names(GlBackEnd) {
  return std::array{std::pair{GlBackEnd::osmesa, "osmesa"}, std::pair{GlBackEnd::egl, "egl"}};
}

/// An OpenGL 4.5 core context without a window, rendered on the CPU (Mesa's llvmpipe) or by what
/// EGL's surfaceless platform provides. Mesa is loaded when a context is made, so that the program
/// starts without it.
class GlContext {
 public:
  /// Creates a context. Throws vo::Error if that fails, naming the package if a library is missing.
  explicit GlContext(GlBackEnd back_end);

  /// Creates a context by OSMesa or, if that is absent (Mesa 25.1 dropped it), by EGL. Throws
  /// vo::Error if both fail.
  static std::unique_ptr<GlContext> make();

  void* find_function(const char* name) const { return find_function_(name); }

  /// Makes a context current in this thread for its lifetime; no other thread may do so meanwhile.
  class Current {
   public:
    explicit Current(const GlContext& context) : context_(context) { context.set_current_(true); }
    ~Current() { context_.set_current_(false); }
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;
    Current(Current&&) = delete;
    Current& operator=(Current&&) = delete;

   private:
    const GlContext& context_;
  };

 private:
  void open_osmesa();
  void open_egl();

  std::shared_ptr<void> library_;  ///< OSMesa or EGL; outlives the context
  std::shared_ptr<void> context_;
  std::function<void*(const char*)> find_function_;
  std::function<void(bool)> set_current_;
};

}  // namespace synth
