// libmeshoptimizer behind a C interface, as a module that is loaded when a model holds compressed buffer
// views. What the library asserts is checked here before, since a failed assertion would end the program.
// Must not know: anything of Barrido but the interface.
#include <meshoptimizer.h>

#include "pipeline/files/module_guard.h"
#include "pipeline/gltf/meshopt_module/interface.h"

namespace {

using barrido::module::set_error;

/// Why the library must not be asked; empty when it may. The limits are those of the extension's text, in the
/// lists of its modes and filters.
std::string problem_of(const BarridoMeshoptView& view) {
  const std::string stride = "byteStride " + std::to_string(view.stride);
  if (view.mode == BARRIDO_MESHOPT_ATTRIBUTES) {
    if (view.stride == 0 || view.stride > 256 || view.stride % 4 != 0) {
      return stride + " of attributes is not a multiple of 4 up to 256";
    }
  } else {
    if (view.stride != 2 && view.stride != 4) return stride + " of indices is neither 2 nor 4";
    if (view.filter != BARRIDO_MESHOPT_NONE) return "indices have no filter";
  }
  if (view.mode == BARRIDO_MESHOPT_TRIANGLES && view.count % 3 != 0) {
    return std::to_string(view.count) + " indices are no whole triangles";
  }
  if (view.filter == BARRIDO_MESHOPT_OCTAHEDRAL && view.stride != 4 && view.stride != 8) {
    return stride + " of the octahedral filter is neither 4 nor 8";
  }
  if (view.filter == BARRIDO_MESHOPT_QUATERNION && view.stride != 8) {
    return stride + " of the quaternion filter is not 8";
  }
  constexpr unsigned char kLaterVertexCodec = 0xa1;
  if (view.mode == BARRIDO_MESHOPT_ATTRIBUTES && view.size > 0 && view.bytes[0] == kLaterVertexCodec &&
      MESHOPTIMIZER_VERSION < 230) {
    return "its vertex codec of version 1 is unknown to this libmeshoptimizer";
  }
  return {};
}

/// The library's return value: 0 when all went well.
int decode_stream(const BarridoMeshoptView& view, void* out) {
  switch (view.mode) {
    case BARRIDO_MESHOPT_ATTRIBUTES:
      return meshopt_decodeVertexBuffer(out, view.count, view.stride, view.bytes, view.size);
    case BARRIDO_MESHOPT_TRIANGLES:
      return meshopt_decodeIndexBuffer(out, view.count, view.stride, view.bytes, view.size);
    default:
      return meshopt_decodeIndexSequence(out, view.count, view.stride, view.bytes, view.size);
  }
}

void apply_filter(const BarridoMeshoptView& view, void* out) {
  if (view.filter == BARRIDO_MESHOPT_OCTAHEDRAL) meshopt_decodeFilterOct(out, view.count, view.stride);
  if (view.filter == BARRIDO_MESHOPT_QUATERNION) meshopt_decodeFilterQuat(out, view.count, view.stride);
  if (view.filter == BARRIDO_MESHOPT_EXPONENTIAL) meshopt_decodeFilterExp(out, view.count, view.stride);
}

int decode(const BarridoMeshoptView* view, void* out, BarridoModuleError* error) {
  return barrido::module::guarded(error, [&]() -> int {
    if (std::string problem = problem_of(*view); !problem.empty()) {
      set_error(error, std::move(problem));
      return 0;
    }
    if (decode_stream(*view, out) != 0) {
      set_error(error, "the compressed bytes are damaged or cut off");
      return 0;
    }
    apply_filter(*view, out);
    return 1;
  });
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const BarridoMeshoptFunctions* barrido_meshopt_functions(
    void) {
  static const BarridoMeshoptFunctions functions{BARRIDO_MESHOPT_INTERFACE_VERSION, decode};
  return &functions;
}
