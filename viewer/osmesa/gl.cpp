#include "viewer/osmesa/gl.h"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace barrido::osmesa {
namespace {

void* open_library() {
  for (const char* name : {"libOSMesa.so.8", "libOSMesa.so"}) {
    if (void* const library = ::dlopen(name, RTLD_NOW | RTLD_LOCAL)) return library;
  }
  throw std::runtime_error(std::string("OSMesa cannot be loaded (Debian: install libosmesa6): ") +
                           ::dlerror());
}

template <class Function>
void find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(::dlsym(library, name));
  if (function == nullptr) throw std::runtime_error(std::string("OSMesa has no ") + name);
}

Gl load() {
  void* const library = open_library();
  Gl table;
#define BARRIDO_GL_FIND(name) find(library, "gl" #name, table.name);
  BARRIDO_GL_FUNCTIONS(BARRIDO_GL_FIND)
#undef BARRIDO_GL_FIND
  find(library, "OSMesaCreateContextAttribs", table.create_context);
  find(library, "OSMesaDestroyContext", table.destroy_context);
  find(library, "OSMesaMakeCurrent", table.make_current);
  return table;
}

}  // namespace

const Gl& gl() {
  static const Gl table = load();
  return table;
}

void check_error(const char* where) {
  if (const GLenum error = gl().GetError(); error != GL_NO_ERROR) {
    throw std::runtime_error("OpenGL error " + std::to_string(error) + " after " + where);
  }
}

}  // namespace barrido::osmesa
