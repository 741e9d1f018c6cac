#include "pipeline/scene/draw_list.h"

#include <cmath>
#include <utility>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "pipeline/matrix.h"
#include "raster/base/portable_math.h"

namespace barrido::scene {
namespace {

/// The geometry with the arrays that its surface asks for.
pipeline::Geometry geometry_for(PreparedGeometry& prepared, const SurfaceState& surface) {
  pipeline::Geometry geometry = prepared.geometry;
  geometry.constant_color = surface.color;
  geometry.color = colors_times(prepared, surface.color);
  if (surface.alpha_mode == AlphaMode::opaque && geometry.color.data != nullptr)
    geometry.color.components = 3;
  for (std::size_t unit = 0; unit < geometry.texcoord.size(); ++unit) {
    const int set = surface.texcoord_set[unit];
    if (set != kNone) geometry.texcoord[unit] = prepared.texcoord_sets[static_cast<std::size_t>(set)];
  }
  return geometry;
}

/// Without what the geometry has no tangents for.
void drop_normal_map(SurfaceState& surface) {
  if (surface.normal_unit == kNone) return;
  surface.units[static_cast<std::size_t>(surface.normal_unit)] = {};
  surface.normal_unit = kNone;
}

/// How much larger the draw is in the world, where its material asks for it.
float scale_of(const Scene& scene, const Draw& draw) {
  if (draw.material == kNone || !scene.materials[static_cast<std::size_t>(draw.material)].layers) return 1.0f;
  const double volume = std::abs(glm::determinant(glm::dmat3(glm::mat3(draw.world_from_object))));
  return portable_pow(static_cast<float>(volume), 1.0f / 3.0f);
}

/// Lengths of the world where the object has 1, roughly; 0 for what has collapsed.
float world_scale_of(const glm::mat4& world_from_object) {
  const double volume = std::abs(glm::determinant(glm::dmat3(glm::mat3(world_from_object))));
  return portable_pow(static_cast<float>(volume), 1.0f / 3.0f);
}

/// Coordinates of the unit that shows a procedure or is mapped.
void place_texture(const PreparedGeometry& prepared, const Box& box, const SurfaceOptions& options,
                   Draw& draw, DrawList& list) {
  const auto unit = static_cast<std::size_t>(draw.surface.placed_unit);
  const TextureChoice& choice = draw.surface.placed;
  PlacedObject object{box, prepared.rest, prepared.geometry.position, prepared.geometry.normal,
                      prepared.geometry.vertex_count};
  object.world_from_object = draw.world_from_object;
  object.world_from_object[3] += glm::vec4(glm::vec3(options.origin), 0.0f) * draw.world_from_object[3].w;
  object.eye_from_object = pipeline::product(options.eye_from_world, draw.world_from_object);
  // What is deformed into the world has no one scale; its rest pose is taken to be as large.
  object.world_scale = world_scale_of(draw.world_from_object);
  object.scene_size = options.scene_size;
  TexturePlacement placement =
      choice.mapping ? place_mapping(*choice.mapping, object) : place_solid(*choice.solid, object);
  draw.surface.placed_from_object = placement.matrix;
  raster::Mapping& mapping = draw.surface.units[unit].mapping;
  if (choice.mapping && choice.mapping->at_vertices) {
    look_from(object.eye_from_object, placement.matrix, mapping);
    list.coordinates.push_back(
        std::make_unique<std::vector<float>>(coordinates_at_vertices(mapping, placement, object)));
    placement = {{list.coordinates.back()->data(), 2, 2}, glm::mat4(1.0f)};
    mapping.surface = raster::MappingSurface::none;
  }
  draw.geometry.texcoord[unit] = placement.coordinates;
  draw.surface.texture_matrix[unit] = placement.matrix;
}

bool mirrors(const glm::mat4& matrix) { return glm::determinant(glm::dmat3(glm::mat3(matrix))) < 0.0; }

}  // namespace

namespace {

/// The vertices of a draw: the file's, deformed in this pose, displaced.
PreparedGeometry& geometry_of(const Scene& scene, const Pose& pose, Draw& draw, const DrawListInputs& inputs,
                              DrawList& list) {
  const auto index = static_cast<std::size_t>(draw.primitive);
  const Primitive& primitive = scene.meshes[static_cast<std::size_t>(draw.mesh)].primitives[index];
  const std::optional<float> crease = inputs.crease_angle_deg;
  if (!is_deformed(scene, draw.node, primitive)) {
    const std::optional<HeightMap> heights = inputs.displacer.heights_of(draw.material);
    if (heights) return inputs.displacer.displaced(draw.mesh, draw.primitive, crease, *heights);
    return inputs.geometry.get(draw.mesh, draw.primitive, crease);
  }
  list.deformed.push_back(prepare_deformed(primitive, deform(scene, pose, draw.node, primitive), crease));
  PreparedGeometry& prepared = *list.deformed.back();
  if (prepared.deformed.in_world_space) draw.world_from_object = glm::mat4(1.0f);
  if (const std::optional<HeightMap> heights = inputs.displacer.heights_of(draw.material)) {
    inputs.displacer.displace_for_frame(prepared, draw.mesh, draw.primitive, *heights);
  }
  return prepared;
}

/// The same vertices with the tangents that the draw's normal map asks for; null where there can be none.
PreparedGeometry* with_tangents(PreparedGeometry& prepared, const Draw& draw, const DrawListInputs& inputs,
                                DrawList& list) {
  const TangentUse& tangents = draw.surface.tangents;
  const bool is_of_file = prepared.deformed.positions.empty() && prepared.displaced.pieces == 0;
  if (is_of_file) return inputs.geometry.get(draw.mesh, draw.primitive, inputs.crease_angle_deg, tangents);
  auto own = prepare_tangents(prepared, tangents);
  PreparedGeometry* const drawn = own.get();
  if (own) list.deformed.push_back(std::move(own));
  return drawn;
}

}  // namespace

DrawList collect_draws(const Scene& scene, const std::vector<int>& nodes, const Pose& pose,
                       const DrawListInputs& inputs) {
  DrawList list;
  for (const int node : nodes) {
    const int mesh = scene.nodes[static_cast<std::size_t>(node)].mesh;
    if (mesh == kNone) continue;
    const std::vector<Primitive>& primitives = scene.meshes[static_cast<std::size_t>(mesh)].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const Primitive& primitive = primitives[i];
      if (primitive.vertex_count == 0) continue;
      Draw draw;
      draw.node = node;
      draw.mesh = mesh;
      draw.primitive = static_cast<int>(i);
      const auto variant = primitive.variant_materials.find(inputs.options.variant);
      draw.material = variant != primitive.variant_materials.end() ? variant->second : primitive.material;
      draw.world_from_object = pose.world_from_node[static_cast<std::size_t>(node)];
      PreparedGeometry& prepared = geometry_of(scene, pose, draw, inputs, list);
      const Displaced* displaced = prepared.displaced.pieces > 0 ? &prepared.displaced : nullptr;
      if (displaced != nullptr) {
        list.displaced_vertices += prepared.displaced.amount.size();
        list.displaced_triangles += prepared.displaced.triangles;
      }
      draw.mirrored = mirrors(draw.world_from_object);
      draw.center = prepared.center;
      const SurfaceUse use{&primitive, draw.material, prepared.geometry.normal.data != nullptr,
                           prepared.colors.data != nullptr, scale_of(scene, draw)};
      for (SurfaceState& surface : make_surfaces(scene, use, inputs.options, inputs.textures)) {
        draw.surface = std::move(surface);
        PreparedGeometry* drawn = &prepared;
        if (draw.surface.normal_unit != kNone && !has_tangents(prepared, draw.surface.tangents)) {
          drawn = with_tangents(prepared, draw, inputs, list);
          if (drawn == nullptr) {
            drop_normal_map(draw.surface);
            drawn = &prepared;
          }
        }
        draw.geometry = geometry_for(*drawn, draw.surface);
        if (draw.surface.placed_unit != kNone) {
          place_texture(*drawn, inputs.geometry.box_of(mesh), inputs.options, draw, list);
        }
        draw.displaced = drawn == &prepared ? displaced : nullptr;  // Others have other vertices.
        list.draws.push_back(draw);
      }
    }
  }
  return list;
}

}  // namespace barrido::scene
