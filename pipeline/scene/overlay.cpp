#include "pipeline/scene/overlay.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "pipeline/matrix.h"
#include "pipeline/scene/draw_state.h"
#include "pipeline/scene/mapping_lines.h"

namespace barrido::scene {
namespace {

/// Colours as seen.
constexpr glm::vec3 kEdgeColor{0.0f, 0.0f, 0.0f};
constexpr glm::vec3 kNormalColor{0.35f, 0.65f, 1.0f};
constexpr glm::vec3 kNegativeLightColor{0.75f, 0.2f, 0.9f};
constexpr glm::vec3 kGridColor{0.3f, 0.75f, 0.65f};
constexpr glm::vec3 kSeamColor{1.0f, 0.25f, 0.2f};

/// Parts of the bounding sphere's radius.
constexpr float kNormalLength = 0.06f;
constexpr float kMarkerSize = 0.05f;
constexpr float kRayLength = 0.3f;

/// How far lines are drawn towards the eye, in normalised device coordinates, so that the surface they lie on
/// does not hide them.
constexpr float kPull = 1e-3f;

bool has_triangles(pipeline::PrimitiveMode mode) { return mode >= pipeline::PrimitiveMode::triangles; }

/// A light's colour at full brightness; a light that takes light away has a colour of its own.
glm::vec3 seen_color(const pipeline::Light& light) {
  const glm::vec3 color(light.diffuse);
  const float most = std::max({color.r, color.g, color.b});
  if (most <= 0.0f) return kNegativeLightColor;
  return glm::max(color / most, glm::vec3(0.0f));
}

void add_vertex(std::vector<float>& values, const glm::vec3& v) {
  values.insert(values.end(), {v.x, v.y, v.z});
}

class MarkerBuilder {
 public:
  MarkerBuilder(std::vector<float>& positions, std::vector<float>& colors, const glm::vec3& color)
      : positions_(positions), colors_(colors), color_(color) {}

  void add_line(const glm::vec3& from, const glm::vec3& to) {
    add_vertex(positions_, from);
    add_vertex(positions_, to);
    add_vertex(colors_, color_);
    add_vertex(colors_, color_);
  }

  /// An octahedron.
  void add_star(const glm::vec3& center, float size) {
    const glm::vec3 x(size, 0, 0), y(0, size, 0), z(0, 0, size);
    for (const glm::vec3& pole : {y, -y}) {
      for (const glm::vec3& corner : {x, z, -x, -z}) add_line(center + pole, center + corner);
    }
    add_line(center + x, center + z);
    add_line(center + z, center - x);
    add_line(center - x, center - z);
    add_line(center - z, center + x);
  }

 private:
  std::vector<float>& positions_;
  std::vector<float>& colors_;
  glm::vec3 color_;
};

void add_marker(MarkerBuilder& builder, const pipeline::Light& light, const Sphere& bounds) {
  const auto radius = static_cast<float>(bounds.radius);
  if (light.position.w == 0.0f) {
    const glm::vec3 towards(unit_or(glm::dvec3(glm::vec3(light.position)), {0, 0, 1}));
    const glm::vec3 place = glm::vec3(bounds.center) + towards * radius;
    builder.add_star(place, radius * kMarkerSize);
    builder.add_line(place, place - towards * (radius * kRayLength));
    return;
  }
  const glm::vec3 place(light.position);
  builder.add_star(place, radius * kMarkerSize);
  const bool is_spot = light.spot_cutoff_deg <= 90.0f || light.spot_outer_cos < light.spot_inner_cos;
  if (!is_spot) return;
  const glm::vec3 direction(unit_or(glm::dvec3(light.spot_direction), {0, 0, -1}));
  builder.add_line(place, place + direction * (radius * kRayLength));
}

}  // namespace

void Overlay::draw(pipeline::Renderer& renderer, const pipeline::State& base, const SceneFrame& frame,
                   const Overlays& wanted) {
  const auto length = static_cast<float>(frame.posed.bounds.sphere.radius) * kNormalLength;
  for (const Draw& draw : frame.list.draws) {
    if (wanted.edges && has_triangles(draw.geometry.mode)) draw_edges(renderer, base, draw);
    if (wanted.normals && draw.geometry.normal.data != nullptr) draw_normals(renderer, base, draw, length);
    if (wanted.mapping && draw.surface.placed.mapping) draw_mapping(renderer, base, draw);
  }
  if (wanted.light_markers) draw_lights(renderer, base, frame);
}

glm::vec4 Overlay::color_of(const glm::vec3& seen) const {
  return glm::vec4(frame_color(seen, settings_), 1.0f);
}

/// Plain lines; z_clip moves towards the eye by kPull·w_clip.
pipeline::State Overlay::line_state(const pipeline::State& base) const {
  pipeline::State state = base;
  state.lighting = {};
  state.fog = {};
  state.shade_model = pipeline::ShadeModel::gouraud;
  state.depth = {true, false, raster::Compare::less_equal};
  for (int column = 0; column < 4; ++column) {
    state.clip_from_eye[column].z -= kPull * state.clip_from_eye[column].w;
  }
  return state;
}

void Overlay::draw_edges(pipeline::Renderer& renderer, const pipeline::State& base, const Draw& draw) {
  pipeline::State state = line_state(base);
  state.eye_from_object = pipeline::product(view_.eye_from_world, draw.world_from_object);
  state.polygon_mode = pipeline::PolygonMode::line;
  state.cull_face = settings_.cull.value_or(draw.surface.double_sided ? pipeline::CullFace::none
                                                                      : pipeline::CullFace::back);
  state.front_face = draw.mirrored ? pipeline::FrontFace::clockwise : pipeline::FrontFace::counter_clockwise;
  pipeline::Geometry geometry = draw.geometry;
  geometry.normal = geometry.color = {};
  geometry.texcoord = {};
  geometry.constant_color = color_of(kEdgeColor);
  renderer.draw(state, geometry);
}

void Overlay::draw_normals(pipeline::Renderer& renderer, const pipeline::State& base, const Draw& draw,
                           float length) {
  const pipeline::Attribute& position = draw.geometry.position;
  const pipeline::Attribute& normal = draw.geometry.normal;
  const glm::mat3 turn(draw.world_from_object);
  Lines lines;
  lines.positions.reserve(std::size_t{6} * draw.geometry.vertex_count);
  for (std::size_t i = 0; i < draw.geometry.vertex_count; ++i) {
    const float* p = position.data + i * static_cast<std::size_t>(position.stride);
    const float* n = normal.data + i * static_cast<std::size_t>(normal.stride);
    const glm::vec3 place(draw.world_from_object * glm::vec4(p[0], p[1], p[2], 1.0f));
    // Normals are turned by the inverse transpose; the cofactors of the matrix are that times a number.
    const glm::mat3 cofactors(glm::cross(turn[1], turn[2]), glm::cross(turn[2], turn[0]),
                              glm::cross(turn[0], turn[1]));
    const glm::vec3 direction(unit_or(
        glm::dvec3(cofactors * glm::vec3(n[0], n[1], n[2])) * (draw.mirrored ? -1.0 : 1.0), {0, 0, 0}));
    add_vertex(lines.positions, place);
    add_vertex(lines.positions, place + direction * length);
  }
  submit(renderer, line_state(base), std::move(lines), color_of(kNormalColor));
}

/// The intermediate surface of the draw's mapping.
void Overlay::draw_mapping(pipeline::Renderer& renderer, const pipeline::State& base, const Draw& draw) {
  const MappingLines found = mapping_lines(draw.surface.placed.mapping->surface);
  const glm::dmat4 world_from_mapping =
      glm::dmat4(draw.world_from_object) * glm::inverse(glm::dmat4(draw.surface.placed_from_object));
  Lines lines;
  for (std::size_t i = 0; i < found.places.size(); ++i) {
    add_vertex(lines.positions, glm::vec3(world_from_mapping * glm::dvec4(found.places[i], 1.0)));
    const bool is_seam = i >= found.first_of_seam;
    add_vertex(lines.colors, glm::vec3(color_of(is_seam ? kSeamColor : kGridColor)));
  }
  submit(renderer, line_state(base), std::move(lines), glm::vec4(1.0f));
}

void Overlay::draw_lights(pipeline::Renderer& renderer, const pipeline::State& base,
                          const SceneFrame& frame) {
  Lines lines;
  for (const pipeline::Light& light : frame.lights.lights) {
    MarkerBuilder builder(lines.positions, lines.colors, glm::vec3(color_of(seen_color(light))));
    const Sphere& sphere = frame.posed.bounds.sphere;
    add_marker(builder, light, {sphere.center - frame.posed.pose.origin, sphere.radius});
  }
  submit(renderer, line_state(base), std::move(lines), glm::vec4(1.0f));
}

void Overlay::submit(pipeline::Renderer& renderer, const pipeline::State& state, Lines lines,
                     const glm::vec4& color) {
  if (lines.positions.empty()) return;
  const Lines& kept = lines_.emplace_back(std::move(lines));
  pipeline::Geometry geometry;
  geometry.mode = pipeline::PrimitiveMode::lines;
  geometry.vertex_count = static_cast<std::uint32_t>(kept.positions.size() / 3);
  geometry.position = {kept.positions.data(), 3, 3};
  if (!kept.colors.empty()) geometry.color = {kept.colors.data(), 3, 3};
  geometry.constant_color = color;
  pipeline::State placed = state;
  placed.eye_from_object = view_.eye_from_world;
  renderer.draw(placed, geometry);
}

}  // namespace barrido::scene
