// Draco behind a C interface, as a module that is loaded when a model holds meshes compressed by it. Draco
// believes the counts of a stream; the allowance sees that they cost no more than the caller allows. Must not
// know: anything of Barrido but the interface.
#include <draco/compression/decode.h>
#include <draco/mesh/mesh.h>

#include <memory>
#include <new>
#include <string>

#include "pipeline/files/module_guard.h"
#include "pipeline/gltf/draco_module/allowance.h"
#include "pipeline/gltf/draco_module/interface.h"

struct BarridoDracoMesh {
  std::unique_ptr<draco::Mesh> mesh;
};

namespace {

using barrido::module::guarded;
using barrido::module::set_error;

BarridoDracoMesh* decode(const void* bytes, size_t size, size_t max_memory, BarridoDracoCounts* counts,
                         BarridoModuleError* error) {
  const barrido::draco_module::Allowance allowance(max_memory);
  try {
    draco::DecoderBuffer buffer;
    buffer.Init(static_cast<const char*>(bytes), size);
    const auto kind = draco::Decoder::GetEncodedGeometryType(&buffer);
    if (!kind.ok() || kind.value() != draco::TRIANGULAR_MESH) {
      set_error(error, kind.ok() ? "the stream holds no triangle mesh" : kind.status().error_msg_string());
      return nullptr;
    }
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok()) {
      set_error(error, "damaged Draco stream: " + decoded.status().error_msg_string());
      return nullptr;
    }
    auto mesh = std::make_unique<BarridoDracoMesh>();
    mesh->mesh = std::move(decoded).value();
    *counts = {mesh->mesh->num_points(), mesh->mesh->num_faces()};
    return mesh.release();
  } catch (const std::bad_alloc&) {
    set_error(error, "the Draco stream asks for more memory than its accessors call for");
  } catch (const std::exception& exception) {
    set_error(error, std::string("damaged Draco stream: ") + exception.what());
  }
  return nullptr;
}

int read_indices(const BarridoDracoMesh* mesh, uint32_t* indices, BarridoModuleError* error) {
  const std::uint32_t points = mesh->mesh->num_points();
  for (draco::FaceIndex face(0); face < mesh->mesh->num_faces(); ++face) {
    for (const draco::PointIndex& point : mesh->mesh->face(face)) {
      if (point.value() >= points) {
        set_error(error, "damaged Draco stream: a face names a point that is not there");
        return 0;
      }
      *indices++ = point.value();
    }
  }
  return 1;
}

template <class Number>
bool copy_points(const draco::PointAttribute& attribute, std::uint32_t points, int components,
                 void* elements) {
  auto* out = static_cast<Number*>(elements);
  const auto bytes = static_cast<std::uint64_t>(attribute.buffer()->data_size());
  const auto stride = static_cast<std::uint64_t>(attribute.byte_stride());
  for (draco::PointIndex point(0); point < points; ++point, out += components) {
    const draco::AttributeValueIndex value = attribute.mapped_index(point);
    // What a stream maps its points to need not be there.
    if (value.value() >= attribute.size() || (std::uint64_t{value.value()} + 1) * stride > bytes)
      return false;
    if (!attribute.ConvertValue<Number>(value, static_cast<std::int8_t>(components), out)) return false;
  }
  return true;
}

bool copy_points(const draco::PointAttribute& attribute, std::uint32_t points,
                 const BarridoDracoAttribute& wanted, void* elements) {
  switch (wanted.component_type) {
    case 5120:
      return copy_points<std::int8_t>(attribute, points, wanted.components, elements);
    case 5121:
      return copy_points<std::uint8_t>(attribute, points, wanted.components, elements);
    case 5122:
      return copy_points<std::int16_t>(attribute, points, wanted.components, elements);
    case 5123:
      return copy_points<std::uint16_t>(attribute, points, wanted.components, elements);
    case 5125:
      return copy_points<std::uint32_t>(attribute, points, wanted.components, elements);
    case 5126:
      return copy_points<float>(attribute, points, wanted.components, elements);
    default:
      return false;
  }
}

int read_attribute(const BarridoDracoMesh* mesh, const BarridoDracoAttribute* wanted, void* elements,
                   BarridoModuleError* error) {
  return guarded(error, [&]() -> int {
    const draco::PointAttribute* attribute = mesh->mesh->GetAttributeByUniqueId(wanted->id);
    const std::string name = "the Draco stream's attribute " + std::to_string(wanted->id);
    if (attribute == nullptr) {
      set_error(error, name + " is not there");
    } else if (attribute->num_components() != wanted->components) {
      set_error(error, name + " has " + std::to_string(attribute->num_components()) +
                           " components, its accessor " + std::to_string(wanted->components));
    } else if (!copy_points(*attribute, mesh->mesh->num_points(), *wanted, elements)) {
      set_error(error, name + " does not fit its accessor");
    } else {
      return 1;
    }
    return 0;
  });
}

void close_mesh(BarridoDracoMesh* mesh) { delete mesh; }

}  // namespace

extern "C" __attribute__((visibility("default"))) const BarridoDracoFunctions* barrido_draco_functions(void) {
  static const BarridoDracoFunctions functions{BARRIDO_DRACO_INTERFACE_VERSION, decode, read_indices,
                                               read_attribute, close_mesh};
  return &functions;
}
