#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include <glm/geometric.hpp>

#include "pipeline/assembly_input.h"
#include "pipeline/inspect/corner_vertex.h"
#include "pipeline/inspect/fragment_census.h"
#include "pipeline/inspect/view_observers.h"
#include "pipeline/scene/draw_state.h"
#include "raster/reference/fragment.h"
#include "raster/reference/fragment_walk.h"
#include "raster/reference/level_of_detail.h"
#include "raster/reference/mapping.h"
#include "raster/reference/sampling.h"
#include "raster/reference/wide_filters.h"

namespace barrido::inspect {
namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

/// Distance from the eye along the line of sight.
float eye_distance(const scene::View& view, const CensusFragment& fragment) {
  const auto steps = static_cast<float>(fragment.place.x - fragment.place.along.anchor);
  if (!scene::is_parallel(view)) {
    return 1.0f / fragment.place.along.quantities[raster::kRecordQ].at(steps);
  }
  const float ndc = 2.0f * raster::reference::interpolated_depth(fragment.place) - 1.0f;
  const glm::mat4& m = view.clip_from_eye;
  return (m[3][2] - ndc) / m[2][2];
}

/// The unit whose picture one would call the surface's: its own before an environment.
int picture_unit(const raster::FragmentState& state) {
  int environment = raster::kAbsent;
  for (int unit = 0; unit < raster::kMaxTextureUnits; ++unit) {
    if (!raster::has_picture(state, unit)) continue;
    const raster::Texture& texture = *state.texture_units[static_cast<std::size_t>(unit)].texture;
    if (texture.is_cube()) {
      environment = unit;
    } else if (texture.width() > 1 || texture.height() > 1) {
      return unit;
    }
  }
  return environment;
}

float mip_level(const CensusFragment& fragment) {
  const raster::FragmentState& state = *fragment.place.chunk.state;
  const int unit = picture_unit(state);
  if (unit == raster::kAbsent) return kNothing;
  const float lod = raster::reference::level_of_detail(state, unit, fragment.place.along, fragment.place.x);
  const raster::TextureUnit& texture = state.texture_units[static_cast<std::size_t>(unit)];
  if (!raster::has_wide_filter(texture)) return raster::reference::choose_levels(texture, lod).level();
  return raster::reference::choose_wide_levels(
             texture, lod,
             raster::reference::coordinate_slopes(state, unit, fragment.place.along, fragment.place.x))
      .level();
}

/// log2 of how many texels of its picture a pixel is wide.
float texel_density(const CensusFragment& fragment) {
  const raster::FragmentState& state = *fragment.place.chunk.state;
  const int unit = picture_unit(state);
  if (unit == raster::kAbsent) return kNothing;
  return raster::reference::level_of_detail(state, unit, fragment.place.along, fragment.place.x);
}

/// The unit whose two coordinates a view can show: that of a picture or of a pattern on a surface.
int flat_unit(const raster::FragmentState& state) {
  for (int unit = 0; unit < raster::kMaxTextureUnits; ++unit) {
    if (!raster::is_active(state, unit)) continue;
    if (raster::texcoord_kind(state, unit) == raster::TexcoordKind::plain) return unit;
  }
  return raster::kAbsent;
}

/// (s, t) before tiles are changed.
std::array<float, 2> coordinates_of(const CensusFragment& fragment, int unit) {
  const raster::FragmentState& state = *fragment.place.chunk.state;
  raster::reference::Fragment one;
  raster::reference::interpolate(fragment.place, one);
  const float* at = one.varying + state.varyings.at(raster::Meaning::texcoord, unit);
  const raster::Mapping& mapping = state.texture_units[static_cast<std::size_t>(unit)].mapping;
  if (mapping.surface == raster::MappingSurface::none) return {at[0], at[1]};
  raster::reference::Point normal{};
  if (raster::needs_normal(mapping)) {
    std::copy_n(one.varying + state.varyings.at(raster::Meaning::normal), 3, normal.begin());
  }
  return raster::reference::mapped_coordinates(
      mapping, raster::reference::reach_surface(mapping, {at[0], at[1], at[2]}, normal));
}

/// Their place in the tile as a colour; white where the pixel meets the tile's border.
std::optional<Rgb8> coordinate_color(const CensusFragment& fragment) {
  const raster::FragmentState& state = *fragment.place.chunk.state;
  const int unit = flat_unit(state);
  if (unit == raster::kAbsent) return std::nullopt;
  const std::array<float, 2> st = coordinates_of(fragment, unit);
  float extent[3];
  raster::reference::pixel_extent(state, unit, fragment.place.along, fragment.place.x, extent);
  Rgb8 color{0, 0, 96};
  for (std::size_t c = 0; c < 2; ++c) {
    const float part = st[c] - std::floor(st[c]);
    const float width = std::min(extent[c], 0.1f);
    if (part < width || part > 1.0f - width) return Rgb8{255, 255, 255};
    color[c] = static_cast<std::uint8_t>(part * 255.0f + 0.5f);
  }
  return color;
}

/// For each chunk, the first number of its draw's polygons.
std::vector<std::uint32_t> first_numbers(const std::vector<FrameChunk>& chunks) {
  std::vector<std::uint32_t> first(chunks.size(), 0);
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    first[i] = i > 0 && chunks[i].draw == chunks[i - 1].draw ? first[i - 1] : next;
    const std::vector<std::uint32_t>& sources = chunks[i].chunk->sources;  // ascending
    if (!sources.empty()) next = std::max(next, first[i] + sources.back() + 1);
  }
  return first;
}

using Normal = std::array<float, 3>;

/// The normal that maps leave, where there are any.
std::optional<glm::vec3> mapped_normal(const CensusFragment& fragment, int normal) {
  std::optional<raster::reference::Fragment> one;
  for (const raster::FragmentStage& stage : fragment.place.chunk.state->stages) {
    if ((stage.kind->writes & set_of(raster::Meaning::normal)) == 0) continue;
    if (!one) raster::reference::interpolate(fragment.place, one.emplace());
    stage.kind->scalar(stage, *one, nullptr);
  }
  if (!one) return std::nullopt;
  return glm::vec3(one->varying[normal], one->varying[normal + 1], one->varying[normal + 2]);
}

Normal normal_of_varyings(const CensusFragment& fragment) {
  const raster::FragmentState& state = *fragment.place.chunk.state;
  const int normal = state.varyings.at(raster::Meaning::normal);
  if (normal == raster::kAbsent) return {kNothing, kNothing, kNothing};
  const auto steps = static_cast<float>(fragment.place.x - fragment.place.along.anchor);
  glm::vec3 n(0.0f);
  for (int k = 0; k < 3; ++k) {
    const auto quantity = static_cast<std::size_t>(raster::kRecordVaryings + normal + k);
    n[k] = fragment.place.along.quantities[quantity].at(steps);  // times 1/w, which is of no matter here
  }
  n = mapped_normal(fragment, normal).value_or(n);
  if ((fragment.place.primitive.flat_and_facing & raster::kBackFacing) != 0) n = -n;
  const float length = std::sqrt(glm::dot(n, n));
  if (!(length > 0.0f)) return {kNothing, kNothing, kNothing};
  return {n.x / length, n.y / length, n.z / length};
}

Normal normal_of_polygon(const CensusFragment& fragment, bool at_provoking) {
  const FrameChunk& chunk = fragment.chunk;
  const pipeline::SurfaceVertex* surfaces = chunk.draw->vertices.surfaces;
  if (surfaces == nullptr || !chunk.draw->plan->needs_normal) return {kNothing, kNothing, kNothing};
  const std::uint32_t source = chunk.chunk->sources[fragment.place.primitive_number];
  const pipeline::AssemblyInput input{*chunk.draw->plan, chunk.draw->geometry, chunk.draw->vertices};
  glm::vec3 n(0.0f);
  const auto add = [&](std::uint32_t vertex) {
    const float(&corner)[3] = surfaces[vertex].normal;
    n += glm::vec3(corner[0], corner[1], corner[2]);
  };
  if (at_provoking) {
    add(input.provoking_vertex(source));
  } else {
    for (std::uint32_t k = 0; k < input.corner_count(); ++k) add(input.corner_vertex(source, k));
  }
  const bool two_sided = chunk.draw->plan->illumination && chunk.draw->plan->illumination->two_sided;
  if (two_sided && faces_back(chunk, fragment.place.primitive, source)) n = -n;
  const float length = std::sqrt(glm::dot(n, n));
  if (!(length > 0.0f)) return {kNothing, kNothing, kNothing};
  return {n.x / length, n.y / length, n.z / length};
}

void count_triangles(ViewValues& values) {
  std::set<float> seen;
  for (const float value : values.values) {
    if (value == value) seen.insert(value);
  }
  values.total = seen.size();
}

}  // namespace

void look_at_front(const scene::ObservedFrame& frame, ViewValues& values) {
  const std::vector<FrameChunk> chunks = chunks_of(frame);
  const std::vector<std::uint32_t> first_of_chunk = first_numbers(chunks);
  CensusEvents events;
  events.drawn = [&](const CensusFragment& fragment) {
    float& value = values.values[fragment.pixel];
    if (fragment.chunk.origin->backdrop) return;
    if (values.view == StructureView::depth) {
      value = eye_distance(frame.view, fragment);
    } else if (values.view == StructureView::mip_level) {
      value = mip_level(fragment);
    } else if (values.view == StructureView::texel_density) {
      value = texel_density(fragment);
    } else if (values.view == StructureView::coordinates) {
      const std::optional<Rgb8> color = coordinate_color(fragment);
      values.colors[fragment.pixel] = packed(color.value_or(kNothingColor));
      value = color ? 0.0f : kNothing;
    } else {
      const std::uint32_t source = fragment.chunk.chunk->sources[fragment.place.primitive_number];
      value = static_cast<float>(first_of_chunk[fragment.place.chunk_number] + source);
    }
  };
  take_census(frame, chunks, events);
  if (values.view == StructureView::triangles) count_triangles(values);
}

void look_at_normals(const scene::ObservedFrame& frame, bool at_provoking, ViewValues& values) {
  CensusEvents events;
  events.drawn = [&](const CensusFragment& fragment) {
    if (fragment.chunk.origin->backdrop) return;
    const bool flat = fragment.chunk.draw->plan->origin.flat;
    const Normal n = flat ? normal_of_polygon(fragment, at_provoking) : normal_of_varyings(fragment);
    values.normals[fragment.pixel] = n;
    values.values[fragment.pixel] = n[0];
  };
  take_census(frame, chunks_of(frame), events);
}

}  // namespace barrido::inspect
