#include "synth/rasterization/gl_context.h"

#include <array>
#include <cstdint>
#include <vector>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/osmesa.h>
#include <dlfcn.h>

#include "vo/core/error.h"

namespace synth {
namespace {

constexpr int kMajor = 4;
constexpr int kMinor = 5;

// The library stays loaded when its last context is gone: the drivers that it opened keep their
// displays until the process ends, and their memory would leak if the variables that point to it
// were unloaded.
std::shared_ptr<void> open_library(const std::vector<const char*>& names, const char* package) {
  for (const char* name : names) {
    if (void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) {
      return {library, [](void* opened) { dlclose(opened); }};
    }
  }
  vo::fail("OpenGL: ", names.front(), " cannot be loaded, expected Debian's package ", package);
}

template <typename Function>
Function find(const std::shared_ptr<void>& library, const char* name) {
  void* address = dlsym(library.get(), name);
  vo::require(address != nullptr, "OpenGL: the library has no ", name);
  return reinterpret_cast<Function>(address);
}

}  // namespace

GlContext::GlContext(GlBackEnd back_end) {
  if (back_end == GlBackEnd::osmesa) {
    open_osmesa();
  } else {
    open_egl();
  }
}

std::unique_ptr<GlContext> GlContext::make() {
  try {
    return std::make_unique<GlContext>(GlBackEnd::osmesa);
  } catch (const vo::Error& osmesa) {
    try {
      return std::make_unique<GlContext>(GlBackEnd::egl);
    } catch (const vo::Error& egl) {
      vo::fail("rasterizer: no OpenGL without a window here (", osmesa.what(), "; ", egl.what(),
               ")");
    }
  }
}

void GlContext::open_osmesa() {
  library_ = open_library({"libOSMesa.so.8", "libOSMesa.so.6"}, "libosmesa6");
  const auto create =
      find<decltype(&OSMesaCreateContextAttribs)>(library_, "OSMesaCreateContextAttribs");
  const auto destroy = find<decltype(&OSMesaDestroyContext)>(library_, "OSMesaDestroyContext");
  const auto make_current = find<decltype(&OSMesaMakeCurrent)>(library_, "OSMesaMakeCurrent");
  const auto address = find<decltype(&OSMesaGetProcAddress)>(library_, "OSMesaGetProcAddress");
  const std::array attributes = {OSMESA_FORMAT,
                                 OSMESA_RGBA,
                                 OSMESA_PROFILE,
                                 OSMESA_CORE_PROFILE,
                                 OSMESA_CONTEXT_MAJOR_VERSION,
                                 kMajor,
                                 OSMESA_CONTEXT_MINOR_VERSION,
                                 kMinor,
                                 0};
  const OSMesaContext context = create(attributes.data(), nullptr);
  vo::require(context != nullptr, "OpenGL: OSMesa gives no context of version 4.5");
  context_ = std::shared_ptr<void>(context, [destroy, library = library_](void* made) {
    destroy(static_cast<OSMesaContext>(made));
  });
  find_function_ = [address](const char* name) { return reinterpret_cast<void*>(address(name)); };
  const auto pixel = std::make_shared<std::uint32_t>(0);  // OSMesa's own framebuffer, not drawn to
  set_current_ = [context, make_current, pixel](bool on) {
    const GLboolean done = on ? make_current(context, pixel.get(), GL_UNSIGNED_BYTE, 1, 1)
                              : make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    vo::require(done || !on, "OpenGL: OSMesa's context cannot be made current");
  };
}

void GlContext::open_egl() {
  library_ = open_library({"libEGL.so.1"}, "libegl1 with libegl-mesa0");
  const auto address = find<decltype(&eglGetProcAddress)>(library_, "eglGetProcAddress");
  const auto get_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(address("eglGetPlatformDisplayEXT"));
  vo::require(get_display != nullptr, "OpenGL: EGL knows no platforms");
  const EGLDisplay display =
      get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  const auto initialize = find<decltype(&eglInitialize)>(library_, "eglInitialize");
  vo::require(display != EGL_NO_DISPLAY && initialize(display, nullptr, nullptr) == EGL_TRUE,
              "OpenGL: EGL has no surfaceless platform, expected Debian's package libegl-mesa0");
  find<decltype(&eglBindAPI)>(library_, "eglBindAPI")(EGL_OPENGL_API);
  const std::array<EGLint, 7> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                            kMajor,
                                            EGL_CONTEXT_MINOR_VERSION,
                                            kMinor,
                                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                            EGL_NONE};
  const EGLContext context = find<decltype(&eglCreateContext)>(library_, "eglCreateContext")(
      display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
  vo::require(context != EGL_NO_CONTEXT, "OpenGL: EGL gives no context of version 4.5");
  const auto destroy = find<decltype(&eglDestroyContext)>(library_, "eglDestroyContext");
  context_ = std::shared_ptr<void>(
      context, [destroy, display, library = library_](void* made) { destroy(display, made); });
  find_function_ = [address](const char* name) { return reinterpret_cast<void*>(address(name)); };
  const auto make_current = find<decltype(&eglMakeCurrent)>(library_, "eglMakeCurrent");
  set_current_ = [context, display, make_current](bool on) {
    const EGLBoolean done =
        make_current(display, EGL_NO_SURFACE, EGL_NO_SURFACE, on ? context : EGL_NO_CONTEXT);
    vo::require(done == EGL_TRUE || !on, "OpenGL: EGL's context cannot be made current");
  };
}

}  // namespace synth
