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

/// An OpenGL 4.5 core context without a window, drawn by the processor (Mesa's llvmpipe) or
/// whatever EGL's surfaceless platform finds. Mesa is looked for when a context is made: the
/// program starts without it.
class GlContext {
 public:
  /// Throws vo::Error that says which package is missing.
  explicit GlContext(GlBackEnd back_end);

  /// OSMesa or, where that is absent (Mesa 25.1 dropped it), EGL.
  static std::unique_ptr<GlContext> make();

  void* find_function(const char* name) const { return find_function_(name); }

  /// Current in one thread as long as it lives; no other thread may make it current meanwhile.
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

  std::shared_ptr<void> library_;  ///< outlives the context
  std::shared_ptr<void> context_;
  std::function<void*(const char*)> find_function_;
  std::function<void(bool)> set_current_;
};

}  // namespace synth
