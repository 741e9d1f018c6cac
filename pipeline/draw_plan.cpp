#include "pipeline/draw_plan.h"

#include <algorithm>
#include <cmath>

#include "pipeline/bounded.h"
#include "pipeline/checks.h"
#include "pipeline/fragment_shading.h"
#include "pipeline/map_stages.h"
#include "pipeline/matrix.h"
#include "pipeline/primitive_mode.h"

namespace barrido::pipeline {
namespace {

Viewport resolved(const Viewport& viewport, FrameSize frame) {
  Viewport v = viewport;
  if (v.width == 0) v.width = frame.width;
  if (v.height == 0) v.height = frame.height;
  return v;
}

raster::Topology topology_of(const State& state, PrimitiveMode mode) {
  if (mode == PrimitiveMode::points) return raster::Topology::points;
  if (!is_polygonal(mode)) return raster::Topology::lines;
  return state.polygon_mode == PolygonMode::fill   ? raster::Topology::triangles
         : state.polygon_mode == PolygonMode::line ? raster::Topology::lines
                                                   : raster::Topology::points;
}

/// Triangles and lines are clipped to a guard band that is wider than the viewport; what sticks out of the
/// viewport is cut off by the scissor. (Points are drawn whole when their middle is inside.)
raster::Scissor scissor_of(const State& state, const Viewport& viewport, FrameSize frame,
                           raster::Topology topology) {
  const bool covers_frame = viewport.x <= 0 && viewport.y <= 0 &&
                            viewport.x + viewport.width >= frame.width &&
                            viewport.y + viewport.height >= frame.height;
  if (covers_frame || topology == raster::Topology::points) return state.scissor;
  const raster::Scissor view{true, viewport.x, viewport.y, viewport.width, viewport.height};
  if (!state.scissor.enabled) return view;
  const raster::Scissor& s = state.scissor;
  const auto end = [](int begin, int size) { return static_cast<std::int64_t>(begin) + size; };
  const int x = std::max(s.x, view.x);
  const int y = std::max(s.y, view.y);
  const std::int64_t width = std::min(end(s.x, s.width), end(view.x, view.width)) - x;
  const std::int64_t height = std::min(end(s.y, s.height), end(view.y, view.height)) - y;
  return {true, x, y, static_cast<int>(std::max<std::int64_t>(width, 0)),
          static_cast<int>(std::max<std::int64_t>(height, 0))};
}

raster::FragmentState fragment_state(const State& state) {
  raster::FragmentState f;
  f.texture_units = state.texture_units;
  for (raster::TextureUnit& unit : f.texture_units) {
    unit.strength = bounded(unit.strength);
    if (unit.role == raster::TextureRole::occlusion) unit.strength = std::clamp(unit.strength, 0.0f, 1.0f);
  }
  f.clamp_colors = state.clamp_colors;
  f.fog = state.fog;
  f.alpha_test = state.alpha_test;
  f.depth = state.depth;
  f.polygon_offset = state.polygon_offset;
  f.blend = state.blend;
  f.sorted = state.sorted;
  f.color_mask = state.color_mask;
  return f;
}

CullRule cull_rule(const State& state) {
  const CullFace cull = state.cull_face;
  return {cull == CullFace::none || cull == CullFace::back, cull == CullFace::none || cull == CullFace::front,
          state.front_face == FrontFace::counter_clockwise};
}

/// Eye from object space for normals, with GL_RESCALE_NORMAL's factor 1/√(m31² + m32² + m33²) of the inverse
/// (OpenGL 1.3, section 2.10.3).
glm::mat3 eye_normals(const State& state) {
  glm::dmat3 m = normal_matrix(bounded(glm::dmat4(state.eye_from_object)));
  if (state.rescale_normal) {
    const glm::dvec3 row = m[2];  // column 3 of the transposed inverse
    const double length = std::sqrt(row.x * row.x + row.y * row.y + row.z * row.z);
    if (length > 0.0) m /= length;
  }
  // What is normalized afterwards may be scaled first, so that no element is out of bounds.
  double largest = 0.0;
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(m[c][r]));
  }
  if (state.normalize && largest > 0.0) m /= largest;
  return {bounded(m[0]), bounded(m[1]), bounded(m[2])};
}

VertexTransform vertex_transform(const State& state, const Geometry& geometry, const Viewport& viewport) {
  VertexTransform t;
  t.eye_from_object = bounded(glm::dmat4(state.eye_from_object));
  t.clip_from_object =
      bounded(glm::dmat4(product(bounded(glm::dmat4(state.clip_from_eye)), t.eye_from_object)));
  t.eye_normal_from_object = eye_normals(state);
  t.normalize = state.normalize;
  t.unit_w = has_unit_w(state, geometry);
  const glm::mat4& m = state.eye_from_object;
  t.unit_eye_w = geometry.position.components < 4 && m[0][3] == 0.0f && m[1][3] == 0.0f && m[2][3] == 0.0f &&
                 m[3][3] == 1.0f;
  t.depth_clamp = state.depth_clamp;
  for (const glm::vec4& plane : state.clip_planes) {  // plane · (M p) = (Mᵀ plane) · p
    t.planes[t.plane_count++] =
        bounded(glm::transpose(glm::dmat4(t.eye_from_object)) * glm::dvec4(bounded(glm::dvec4(plane))));
  }
  t.window_scale = {0.5f * static_cast<float>(viewport.width), 0.5f * static_cast<float>(viewport.height),
                    0.5f * (viewport.depth_far - viewport.depth_near)};
  t.window_offset = {static_cast<float>(viewport.x) + t.window_scale.x,
                     static_cast<float>(viewport.y) + t.window_scale.y,
                     0.5f * (viewport.depth_near + viewport.depth_far)};
  return t;
}

TexcoordPlan texcoord_plan(const TextureCoordinates& rules, raster::TexcoordKind kind) {
  TexcoordPlan plan;
  plan.is_on = true;
  plan.kind = kind;
  plan.rules = rules;
  plan.rules.matrix = bounded(glm::dmat4(rules.matrix));
  bool generated = false;
  for (TexGenCoordinate& c : plan.rules.generation) {
    c.object_plane = bounded(glm::dvec4(c.object_plane));
    c.eye_plane = bounded(glm::dvec4(c.eye_plane));
    generated |= c.enabled;
  }
  plan.as_given = !generated && rules.matrix == glm::mat4(1.0f);
  if (plan.as_given && plan.kind != raster::TexcoordKind::projective) {
    plan.given_components = floats_of(plan.kind);
  }
  return plan;
}

raster::FlatColors constant_colors(const glm::vec4& color, bool clamp) {
  raster::FlatColors flat{};
  for (int c = 0; c < 4; ++c) {
    flat.color[c] = clamp ? std::clamp(bounded(color[c]), 0.0f, 1.0f) : bounded(color[c]);
  }
  return flat;
}

/// Samples up to this share beyond the sides of the view lie in a pixel's reach. 1 where none do.
glm::vec2 side_reach(const raster::SampleReach& reach, const Viewport& viewport) {
  const auto beside = [](int least, int most, int pixels) {
    const int units = std::max({0, -least, most - raster::kSubpixelUnits});
    return 1.0f + 2.0f * static_cast<float>(units) /
                      (static_cast<float>(raster::kSubpixelUnits) * static_cast<float>(std::max(pixels, 1)));
  };
  return {beside(reach.least.x, reach.most.x, viewport.width),
          beside(reach.least.y, reach.most.y, viewport.height)};
}

}  // namespace

DrawPlan::DrawPlan(const State& state, const Geometry& geometry, FrameSize frame,
                   FragmentCounters& fragment_counters)
    : point_size(state.point_size),
      line_width(state.line_width),
      clamp_colors(state.clamp_colors),
      cull(cull_rule(state)),
      counters(&fragment_counters) {
  check(state);
  check(geometry);
  const Viewport viewport = resolved(state.viewport, frame);
  topology = topology_of(state, geometry.mode);
  transform = vertex_transform(state, geometry, viewport);
  transform.side_reach = side_reach(frame.reach, viewport);
  cull.keep_between_centers = !frame.reach.is_center();
  const bool has_colors = geometry.color.data != nullptr;
  if (state.lighting.enabled) {
    illumination = compile_illumination(state.lighting, has_colors ? nullptr : &geometry.constant_color);
    illumination->mode = &shading_mode(state.shade_model);
    illumination->cheap_phong_power = state.cheap_phong_power;
  }
  const Illumination* lit = illumination ? &*illumination : nullptr;
  origin = color_origin(state, lit != nullptr, has_colors);
  constant_color = constant_colors(geometry.constant_color, clamp_colors);

  fragment = fragment_state(state);
  fragment.scissor = scissor_of(state, viewport, frame, topology);
  fragment.separate_specular = lit != nullptr && lit->separate_specular;
  plan_texcoords(state, geometry);
  plan_tangents(state, geometry);
  plan_stages();
  fragment.varyings = lay_out(state, geometry, fragment.stages);

  needs_normal = lit != nullptr || fragment.varyings.has(raster::Meaning::normal);
  needs_point = (lit != nullptr && lit->needs_position) || state.fog.enabled;
  needs_color = lit != nullptr ? lit->tracks_color : has_colors;
  for (const TexcoordPlan& texcoord : texcoords) {
    for (const TexGenCoordinate& c : texcoord.rules.generation) {
      if (!texcoord.is_on || !c.enabled) continue;
      needs_eye |= c.mode == TexGenMode::eye_linear;
      needs_point |= c.mode == TexGenMode::sphere_map || c.mode == TexGenMode::reflection_map;
      needs_normal |= c.mode >= TexGenMode::sphere_map;
    }
  }
  const bool two_sided = lit != nullptr && lit->two_sided && is_polygonal(geometry.mode);
  has_back_side = two_sided && cull.keep_back && origin.at_vertices;
  marks_back_faces = two_sided && origin.at_fragments;
}

/// Only Phong's fragments have a normal to change, and only fragments that are lit have ambient light of
/// their own.
bool DrawPlan::uses(raster::TextureRole role) const {
  using Role = raster::TextureRole;
  switch (role) {
    case Role::environment:
      return true;
    case Role::normal:
    case Role::bump:
      return origin.at_fragments && !origin.at_vertices;
    case Role::occlusion:
      return origin.at_fragments;
    case Role::shine:
      break;
  }
  return fragment.separate_specular;
}

void DrawPlan::plan_texcoords(const State& state, const Geometry& geometry) {
  for (std::size_t unit = 0; unit < texcoords.size(); ++unit) {
    const raster::TextureUnit& u = state.texture_units[unit];
    if ((u.texture == nullptr && u.procedure == nullptr) || !uses(u.role)) continue;
    texcoords[unit] = texcoord_plan(state.texture_coordinates[unit], texcoord_kind(state, geometry, unit));
  }
}

/// What the maps of normals and heights want to know of the surface.
void DrawPlan::plan_tangents(const State& state, const Geometry& geometry) {
  for (std::size_t unit = 0; unit < texcoords.size(); ++unit) {
    const raster::TextureRole role = state.texture_units[unit].role;
    const bool tilts = role == raster::TextureRole::normal || role == raster::TextureRole::bump;
    if (!texcoords[unit].is_on || !tilts) continue;
    if (!is_flat(texcoords[unit].kind)) {
      if (role == raster::TextureRole::normal) {
        throw std::invalid_argument("texture unit " + std::to_string(unit) +
                                    ": normals come from a picture, not from a cube map or a solid");
      }
      eye_gradient = solid_gradient(state, unit);
      continue;
    }
    if (geometry.tangent.data == nullptr) {
      throw std::invalid_argument("texture unit " + std::to_string(unit) +
                                  " changes normals, but the geometry has no tangents");
    }
    needs_tangents = true;
    unit_tangents |= role == raster::TextureRole::normal;
    has_bitangent = geometry.bitangent.data != nullptr;
  }
}

/// The journey of the draw's fragments. What changes a normal or weakens a light comes before the light.
void DrawPlan::plan_stages() {
  std::vector<raster::FragmentStage> before_colors;
  for (std::size_t unit = 0; unit < texcoords.size(); ++unit) {
    if (!texcoords[unit].is_on) continue;
    if (const auto stage = map_stage(*this, static_cast<int>(unit))) before_colors.push_back(*stage);
  }
  if (origin.at_fragments) before_colors.push_back(light_stage(*this));
  raster::StageInputs inputs;
  inputs.color = origin.makes_vertex_colors() && !origin.flat;
  inputs.specular = inputs.color && fragment.separate_specular;
  for (std::size_t unit = 0; unit < texcoords.size(); ++unit) {
    if (texcoords[unit].is_on) inputs.coordinates[unit] = floats_of(texcoords[unit].kind);
  }
  fragment.stages = raster::make_stages(fragment, before_colors, inputs);
}

}  // namespace barrido::pipeline
