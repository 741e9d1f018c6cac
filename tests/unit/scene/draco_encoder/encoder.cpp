#include "tests/unit/scene/draco_encoder/encoder.h"

#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>

#include <algorithm>
#include <memory>

namespace {

draco::DataType data_type(int component_type) {
  switch (component_type) {
    case 5120:
      return draco::DT_INT8;
    case 5121:
      return draco::DT_UINT8;
    case 5122:
      return draco::DT_INT16;
    case 5123:
      return draco::DT_UINT16;
    case 5125:
      return draco::DT_UINT32;
    default:
      return draco::DT_FLOAT32;
  }
}

int add_attribute(const DracoTestAttribute& from, std::uint32_t points, draco::Mesh& mesh) {
  static constexpr draco::GeometryAttribute::Type kKinds[] = {
      draco::GeometryAttribute::POSITION, draco::GeometryAttribute::NORMAL,
      draco::GeometryAttribute::TEX_COORD, draco::GeometryAttribute::COLOR,
      draco::GeometryAttribute::GENERIC};
  const draco::DataType type = data_type(from.component_type);
  const auto stride = static_cast<std::int64_t>(draco::DataTypeLength(type)) * from.components;
  draco::GeometryAttribute attribute;
  attribute.Init(kKinds[from.kind], nullptr, static_cast<std::uint8_t>(from.components), type,
                 from.normalized != 0, stride, 0);
  const int id = mesh.AddAttribute(attribute, true, points);
  const auto* bytes = static_cast<const std::uint8_t*>(from.elements);
  for (std::uint32_t i = 0; i < points; ++i) {
    mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), bytes + i * stride);
  }
  return id;
}

}  // namespace

std::size_t barrido_draco_test_encode(const DracoTestMesh* from, std::uint8_t* bytes, std::size_t room,
                                      std::uint32_t* ids) {
  draco::Mesh mesh;
  mesh.set_num_points(from->points);
  mesh.SetNumFaces(from->faces);
  for (std::uint32_t f = 0; f < from->faces; ++f) {
    const std::uint32_t* corner = from->indices + std::size_t{3} * f;
    mesh.SetFace(draco::FaceIndex(f),
                 {draco::PointIndex(corner[0]), draco::PointIndex(corner[1]), draco::PointIndex(corner[2])});
  }
  for (int i = 0; i < from->attribute_count; ++i) {
    const int id = add_attribute(from->attributes[i], from->points, mesh);
    ids[i] = mesh.attribute(id)->unique_id();
  }
  draco::ExpertEncoder encoder(mesh);
  encoder.SetSpeedOptions(from->speed, from->speed);
  encoder.SetEncodingMethod(from->edgebreaker != 0 ? draco::MESH_EDGEBREAKER_ENCODING
                                                   : draco::MESH_SEQUENTIAL_ENCODING);
  for (int i = 0; i < from->attribute_count; ++i) {
    if (from->quantization_bits > 0 && from->attributes[i].component_type == 5126) {
      encoder.SetAttributeQuantization(i, from->quantization_bits);
    }
  }
  draco::EncoderBuffer buffer;
  if (!encoder.EncodeToBuffer(&buffer).ok() || buffer.size() > room) return 0;
  std::copy_n(buffer.data(), buffer.size(), reinterpret_cast<char*>(bytes));
  return buffer.size();
}
