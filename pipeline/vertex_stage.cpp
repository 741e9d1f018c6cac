#include "pipeline/vertex_stage.h"

namespace barrido::pipeline {
namespace {

using raster::Meaning;

/// Where each varying's array stands.
class Columns {
 public:
  explicit Columns(const raster::VaryingList& varyings) : varyings_(varyings) {}

  /// Takes as many arrays as the meaning has varyings; none where it has none.
  void place(Meaning meaning, const BatchArray* arrays, int unit = 0) {
    for (int i = 0; i < varyings_.floats(meaning, unit); ++i) set(meaning, i, arrays[i], unit);
  }
  void set(Meaning meaning, int which, const float* array, int unit = 0) {
    columns_[static_cast<std::size_t>(varyings_.at(meaning, unit) + which)] = array;
  }
  const float* const* data() const { return columns_.data(); }

 private:
  const raster::VaryingList& varyings_;
  std::array<const float*, raster::kMaxVaryings> columns_{};
};

SurfacePoints surface_points(const VertexBatch& batch, int side) {
  SurfacePoints points;
  points.count = batch.count;
  points.normal = {batch.normal[0], batch.normal[1], batch.normal[2]};
  points.position = {batch.point[0], batch.point[1], batch.point[2]};
  points.color = {batch.color[0], batch.color[1], batch.color[2], batch.color[3]};
  points.back = side == 1;
  return points;
}

/// The vertices' colours as interpolated or kept: lit from one side, or as given. Primary, then secondary.
BatchArray* make_colors(const DrawPlan& plan, int side, VertexBatch& batch) {
  BatchArray* colors = plan.illumination ? batch.lit : batch.color;
  if (plan.illumination) {
    const LitColors out{{batch.lit[0], batch.lit[1], batch.lit[2], batch.lit[3]},
                        {batch.lit[4], batch.lit[5], batch.lit[6]}};
    illuminate(*plan.illumination, surface_points(batch, side), out);
  }
  const int channels = plan.illumination && plan.illumination->separate_specular ? 7 : 4;
  for (int c = 0; c < channels; ++c) bound_column(batch.count, plan.clamp_colors, colors[c]);
  return colors;
}

void make_dots(const DrawPlan& plan, int side, VertexBatch& batch) {
  std::array<float*, raster::kMaxVaryings> columns;
  const auto count = static_cast<std::size_t>(plan.fragment.varyings.floats(Meaning::dots));
  for (std::size_t i = 0; i < count; ++i) columns[i] = batch.dots[i];
  cheap_phong_dots(*plan.illumination, surface_points(batch, side), {columns.data(), count});
}

void make_coordinates(const DrawPlan& plan, const Geometry& geometry, std::uint32_t first, VertexBatch& batch,
                      Columns& columns) {
  for (std::size_t unit = 0; unit < plan.texcoords.size(); ++unit) {
    const TexcoordPlan& texcoord = plan.texcoords[unit];
    if (!texcoord.is_on) continue;
    BatchArray* coordinate = batch.coordinate[unit];
    fetch_attribute(geometry.texcoord[unit], geometry.constant_texcoord[unit], first, batch.count,
                    texcoord.given_components, true, coordinate);
    if (!texcoord.as_given) generate_coordinates(texcoord.rules, batch, coordinate);
    const int number = static_cast<int>(unit);
    columns.place(Meaning::texcoord, coordinate, number);
    if (texcoord.kind == raster::TexcoordKind::projective) {
      columns.set(Meaning::texcoord, 2, coordinate[3], number);
    }
  }
}

/// Colours of one side for flat shading, one element a vertex.
void store_flat_colors(const BatchArray* colors, bool secondary, int count, raster::FlatColors* out) {
  for (int i = 0; i < count; ++i) {
    for (int c = 0; c < 4; ++c) out[i].color[c] = colors[c][i];
    for (int c = 0; c < 3; ++c) out[i].specular[c] = secondary ? colors[4 + c][i] : 0.0f;
  }
}

void store_surfaces(const DrawPlan& plan, const VertexBatch& batch, SurfaceVertex* out) {
  for (int i = 0; i < batch.count; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      out[i].position[axis] = plan.needs_point ? batch.point[axis][i] : 0.0f;
      out[i].normal[axis] = plan.needs_normal ? batch.normal[axis][i] : 0.0f;
    }
    for (int c = 0; c < 4; ++c) out[i].color[c] = plan.needs_color ? batch.color[c][i] : 0.0f;
  }
}

void make_tangents(const DrawPlan& plan, const Geometry& geometry, std::uint32_t first, VertexBatch& batch) {
  fetch_attribute(geometry.tangent, {1, 0, 0, 1}, first, batch.count, plan.has_bitangent ? 3 : 4, true,
                  batch.tangents);
  if (plan.has_bitangent) {
    fetch_attribute(geometry.bitangent, {0, 1, 0, 0}, first, batch.count, 3, true, batch.tangents + 3);
  }
  transform_tangents(plan.transform, plan.has_bitangent, plan.unit_tangents, batch);
}

void fetch_and_transform(const DrawPlan& plan, const Geometry& geometry, std::uint32_t first,
                         VertexBatch& batch, PackedPosition* positions) {
  fetch_attribute(geometry.position, {0, 0, 0, 1}, first, batch.count, 4, false, batch.object);
  project_positions(plan.transform, batch, positions);
  if (plan.needs_eye || plan.needs_point) transform_to_eye(plan.transform, batch, plan.needs_point);
  if (plan.needs_normal) {
    fetch_attribute(geometry.normal, glm::vec4(geometry.constant_normal, 0.0f), first, batch.count, 3, true,
                    batch.normal);
    if (plan.needs_tangents) make_tangents(plan, geometry, first, batch);
    transform_normals(plan.transform, batch);
  }
  if (plan.needs_color) {
    fetch_attribute(geometry.color, geometry.constant_color, first, batch.count, 4, true, batch.color);
  }
}

}  // namespace

TransformedVertices allocate_vertices(const DrawPlan& plan, std::uint32_t first, std::uint32_t count,
                                      FrameMemory& memory) {
  TransformedVertices v;
  v.first = first;
  v.count = count;
  v.capacity = (count + kVertexPadding - 1) / kVertexPadding * kVertexPadding;
  v.stride = plan.stride();
  const std::size_t sides = static_cast<std::size_t>(v.capacity) * static_cast<std::size_t>(plan.sides());
  v.positions = memory.allocate<PackedPosition>(v.capacity);
  v.records = memory.allocate<float>(sides * static_cast<std::size_t>(v.stride));
  if (plan.origin.makes_vertex_colors() && plan.origin.flat)
    v.flat_colors = memory.allocate<raster::FlatColors>(sides);
  if (plan.origin.at_centroid) v.surfaces = memory.allocate<SurfaceVertex>(v.capacity);
  return v;
}

void run_vertex_stage(const DrawPlan& plan, const Geometry& geometry, std::uint32_t begin, int count,
                      const TransformedVertices& out) {
  VertexBatch batch;
  batch.count = count;
  const std::uint32_t first = out.first + begin;
  fetch_and_transform(plan, geometry, first, batch, out.positions + begin);

  const raster::VaryingList& varyings = plan.fragment.varyings;
  Columns columns(varyings);
  make_coordinates(plan, geometry, first, batch, columns);
  columns.place(Meaning::normal, batch.normal);
  columns.place(Meaning::tangents, batch.tangents);
  columns.place(Meaning::eye_position, batch.point);
  columns.place(Meaning::fog, &batch.point[2]);
  columns.place(Meaning::color, batch.color);
  columns.place(Meaning::dots, batch.dots);

  for (int side = 0; side < plan.sides(); ++side) {
    const std::size_t at = begin + static_cast<std::size_t>(side) * out.capacity;
    if (plan.origin.makes_vertex_colors()) {
      const BatchArray* colors = make_colors(plan, side, batch);
      columns.place(Meaning::color, colors);
      columns.place(Meaning::specular, colors + 4);
      const bool secondary = plan.fragment.separate_specular;
      if (out.flat_colors != nullptr) store_flat_colors(colors, secondary, count, out.flat_colors + at);
    }
    if (plan.origin.makes_vertex_products()) make_dots(plan, side, batch);
    store_records(batch, columns.data(), varyings.count, varyings.affine_count,
                  out.records + at * static_cast<std::size_t>(out.stride), out.stride);
  }
  if (out.surfaces != nullptr) store_surfaces(plan, batch, out.surfaces + begin);
}

}  // namespace barrido::pipeline
