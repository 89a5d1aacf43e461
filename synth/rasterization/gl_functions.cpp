#include "synth/rasterization/gl_functions.h"

#include "vo/core/error.h"

namespace synth {

GlFunctions::GlFunctions(const std::function<void*(const char*)>& find) {
#define EDVO_GL_FIND(name)                                   \
  name = reinterpret_cast<decltype(name)>(find("gl" #name)); \
  vo::require((name) != nullptr, "OpenGL: expected 4.5 or later, no gl" #name);
  EDVO_GL_FUNCTIONS(EDVO_GL_FIND)
#undef EDVO_GL_FIND
}

}  // namespace synth
