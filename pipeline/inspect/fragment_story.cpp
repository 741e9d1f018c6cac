#include "pipeline/inspect/fragment_story.h"

#include <array>

#include "pipeline/assembly_input.h"
#include "pipeline/inspect/corner_vertex.h"
#include "pipeline/inspect/illumination_story.h"
#include "pipeline/scene/triangles.h"
#include "raster/names.h"

namespace barrido::inspect {
namespace {

using pipeline::AssembledDraw;
using pipeline::reference::SurfacePoint;
using raster::Meaning;

std::string name_at(int index, const auto& list) {
  return index == scene::kNone ? std::string() : list[static_cast<std::size_t>(index)].name;
}

void tell_names(const FragmentContext& context, const scene::DrawOrigin& origin, FragmentStory& story) {
  story.backdrop = origin.backdrop;
  if (origin.backdrop) return;
  story.node = origin.node;
  story.mesh = origin.mesh;
  story.primitive = origin.primitive;
  story.material = origin.material;
  story.node_name = name_at(origin.node, context.scene.nodes);
  story.mesh_name = name_at(origin.mesh, context.scene.meshes);
  story.material_name = name_at(origin.material, context.scene.materials);
}

/// The triangle's number in the file: blended draws are sorted, so it is looked up by its corners.
std::uint32_t number_in_file(const FrameChunk& place, std::uint32_t source) {
  const pipeline::Geometry* original = place.origin->geometry;
  const std::span<const std::uint32_t> drawn = place.draw->geometry.indices;
  if (original == nullptr || original->indices.data() == drawn.data() ||
      drawn.size() < 3 * std::size_t{source} + 3) {
    return source;
  }
  const std::vector<std::uint32_t> triangles =
      scene::triangle_list(original->mode, original->indices, original->vertex_count);
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    if (std::equal(triangles.begin() + static_cast<std::ptrdiff_t>(i),
                   triangles.begin() + static_cast<std::ptrdiff_t>(i) + 3, drawn.begin() + 3 * source)) {
      return static_cast<std::uint32_t>(i / 3);
    }
  }
  return source;
}

std::string image_of(const FragmentContext& context, const FragmentStory& story, std::string_view role) {
  if (story.material == scene::kNone) return {};
  const scene::Material& material = context.scene.materials[static_cast<std::size_t>(story.material)];
  const int texture =
      role == "base color" ? material.base_color_texture.texture : material.emissive_texture.texture;
  if (texture == scene::kNone) return {};
  return name_at(context.scene.textures[static_cast<std::size_t>(texture)].image, context.scene.images);
}

/// The file's picture of a map; empty where it may be the user's.
std::string map_of(const FragmentContext& context, const FragmentStory& story, raster::TextureRole role) {
  if (story.material == scene::kNone) return {};
  const scene::Material& material = context.scene.materials[static_cast<std::size_t>(story.material)];
  const int texture = role == raster::TextureRole::normal      ? material.normal_texture.texture
                      : role == raster::TextureRole::occlusion ? material.occlusion_texture.texture
                                                               : scene::kNone;
  if (texture == scene::kNone) return {};
  return name_at(context.scene.textures[static_cast<std::size_t>(texture)].image, context.scene.images);
}

TextureStory tell_texture(const FragmentContext& context, const AssembledDraw& draw,
                          const FragmentStory& story, std::size_t unit) {
  const raster::TextureUnit& state = draw.plan->fragment.texture_units[unit];
  TextureStory texture;
  if (state.procedure != nullptr) {
    texture.role = state.procedure == &raster::kSolidPattern || state.procedure == &raster::kSurfacePattern
                       ? name_of(state.pattern.kind)
                       : state.procedure->name;
    return texture;
  }
  texture.cube = state.texture->is_cube();
  texture.width = state.texture->width();
  texture.height = state.texture->height();
  texture.levels = state.texture->level_count();
  if (state.role != raster::TextureRole::environment) {
    texture.role = name_of(state.role);
    texture.image = map_of(context, story, state.role);
    return texture;
  }
  texture.role = texture.cube                                        ? "environment"
                 : state.env_mode == raster::TextureEnvMode::combine ? "constant"
                 : state.env_mode == raster::TextureEnvMode::add     ? "emission"
                                                                     : "base color";
  if (texture.role == "base color" || texture.role == "emission") {
    texture.image = image_of(context, story, texture.role);
  }
  return texture;
}

/// The interpolated numbers of a meaning; none where it is not interpolated.
std::span<const float> varying(const AssembledDraw& draw, const raster::reference::FragmentTrace& trace,
                               Meaning meaning) {
  const raster::VaryingList& list = draw.plan->fragment.varyings;
  if (!list.has(meaning)) return {};
  return std::span(trace.varyings)
      .subspan(static_cast<std::size_t>(list.at(meaning)), static_cast<std::size_t>(list.floats(meaning)));
}

/// The surface as the fragment's light sees it.
SurfacePoint point_of(const AssembledDraw& draw, const raster::reference::FragmentTrace& trace) {
  SurfacePoint point;
  point.normalize = true;
  point.back = trace.back_facing;
  point.normal = glm::vec3(0.0f);
  const auto take = [&](Meaning meaning, auto& into) {
    const std::span<const float> from = varying(draw, trace, meaning);
    for (std::size_t k = 0; k < from.size(); ++k) into[static_cast<int>(k)] = from[k];
  };
  take(Meaning::normal, point.normal);
  take(Meaning::eye_position, point.position);
  take(Meaning::color, point.color);
  const std::vector<float>& mapped = trace.shading.varyings;
  const raster::VaryingList& list = draw.plan->fragment.varyings;
  if (mapped.empty()) return point;
  for (int axis = 0; axis < 3 && list.has(Meaning::normal); ++axis) {
    point.normal[axis] = mapped[static_cast<std::size_t>(list.at(Meaning::normal) + axis)];
  }
  if (list.has(Meaning::occlusion)) {
    point.occlusion = {mapped.data() + list.at(Meaning::occlusion), 1};
  }
  return point;
}

/// The middle of the polygon: sums in double precision and one rounding, as flat shading makes it.
SurfacePoint centroid(const AssembledDraw& draw, const std::vector<std::uint32_t>& vertices, bool back) {
  glm::dvec3 position(0.0), normal(0.0);
  glm::dvec4 color(0.0);
  for (const std::uint32_t vertex : vertices) {
    const SurfacePoint corner = VertexAgain(draw, vertex).point(back);
    position += glm::dvec3(corner.position);
    normal += glm::dvec3(corner.normal);
    color += glm::dvec4(corner.color);
  }
  const auto count = static_cast<double>(vertices.size());
  SurfacePoint point;
  point.position = glm::vec3(position / count);
  point.normal = glm::vec3(normal / count);
  point.color = glm::vec4(color / count);
  point.normalize = true;
  point.back = back;
  return point;
}

/// The polygon's corners as flat shading counts them: of lines that are its edges, all of the polygon's.
std::vector<std::uint32_t> polygon_vertices(const AssembledDraw& draw, std::uint32_t source) {
  const pipeline::AssemblyInput input{*draw.plan, draw.geometry, draw.vertices};
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t k = 0; k < input.corner_count(); ++k) {
    vertices.push_back(input.corner_vertex(source, k) + draw.vertices.first);
  }
  return vertices;
}

void tell_illumination(const FragmentContext& context, const FrameChunk& place, std::uint32_t source,
                       FragmentStory& story) {
  const AssembledDraw& draw = *place.draw;
  if (!draw.plan->illumination) return;
  const pipeline::Illumination& model = *draw.plan->illumination;
  const LightingNames names{draw.state.lighting, context.light_names};
  const auto explain = [&](const SurfacePoint& point, std::string where) {
    story.illuminations.push_back(explain_illumination(model, point, names));
    story.illuminations.back().place = std::move(where);
  };
  const auto at_vertex = [&](std::uint32_t vertex, const std::string& prefix) {
    explain(VertexAgain(draw, vertex).point(story.back_facing), prefix + std::to_string(vertex));
  };
  const pipeline::ColorOrigin& origin = draw.plan->origin;
  if (origin.at_centroid) {
    explain(centroid(draw, polygon_vertices(draw, source), story.back_facing), "centroid");
  } else if (origin.flat) {
    const pipeline::AssemblyInput input{*draw.plan, draw.geometry, draw.vertices};
    at_vertex(input.provoking_vertex(source) + draw.vertices.first, "provoking vertex ");
  } else if (origin.at_vertices) {
    for (const CornerStory& corner : story.corners) at_vertex(corner.vertex, "vertex ");
  } else {
    explain(point_of(draw, story.trace), "fragment");
  }
  if (!origin.makes_vertex_products()) return;
  for (std::size_t k = 0; k < story.corners.size(); ++k) {
    add_products(model, VertexAgain(draw, story.corners[k].vertex).point(story.back_facing),
                 story.illuminations[k]);
  }
  story.from_products =
      explain_products(model, varying(draw, story.trace, Meaning::dots), point_of(draw, story.trace), names);
}

}  // namespace

FragmentStory tell_fragment(const FragmentContext& context, const FrameChunk& place,
                            raster::reference::FragmentTrace trace) {
  const raster::PrimitiveChunk& chunk = *place.chunk->chunk;
  const raster::PrimitiveRecord& primitive = chunk.primitives[trace.primitive];
  const std::uint32_t source = place.chunk->sources[trace.primitive];
  FragmentStory story;
  tell_names(context, *place.origin, story);
  story.triangle = number_in_file(place, source);
  story.topology = chunk.topology;
  story.of_polygon = pipeline::is_polygonal(place.draw->geometry.mode);
  story.clipped = is_clipped(chunk, primitive);
  story.back_facing = faces_back(place, primitive, source);
  story.shading = place.draw->plan->origin.name;
  story.corners = tell_corners(context, place, primitive, source);
  for (const raster::reference::UnitTrace& unit : trace.shading.units) {
    story.textures.push_back(tell_texture(context, *place.draw, story, static_cast<std::size_t>(unit.unit)));
  }
  for (const raster::reference::UnitTrace& map : trace.shading.maps) {
    story.maps.push_back(tell_texture(context, *place.draw, story, static_cast<std::size_t>(map.unit)));
  }
  story.state = *chunk.state;
  story.state.stages.clear();  // they point into the draw
  for (raster::TextureUnit& unit : story.state.texture_units) unit.texture = nullptr;
  story.trace = std::move(trace);
  if (!story.trace.outside_scissor) tell_illumination(context, place, source, story);
  return story;
}

}  // namespace barrido::inspect
