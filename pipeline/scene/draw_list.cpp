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

DrawList collect_draws(const Scene& scene, const std::vector<int>& nodes, const Pose& pose,
                       std::optional<float> crease_angle_deg, const SurfaceOptions& options,
                       GeometryCache& geometry, TextureCache& textures) {
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
      const auto variant = primitive.variant_materials.find(options.variant);
      draw.material = variant != primitive.variant_materials.end() ? variant->second : primitive.material;
      draw.world_from_object = pose.world_from_node[static_cast<std::size_t>(node)];
      PreparedGeometry* prepared = nullptr;
      const bool deformed = is_deformed(scene, node, primitive);
      if (deformed) {
        list.deformed.push_back(
            prepare_deformed(primitive, deform(scene, pose, node, primitive), crease_angle_deg));
        prepared = list.deformed.back().get();
        if (prepared->deformed.in_world_space) draw.world_from_object = glm::mat4(1.0f);
      } else {
        prepared = &geometry.get(mesh, static_cast<int>(i), crease_angle_deg);
      }
      draw.mirrored = mirrors(draw.world_from_object);
      draw.center = prepared->center;
      const SurfaceUse use{&primitive, draw.material, prepared->geometry.normal.data != nullptr,
                           prepared->colors.data != nullptr, scale_of(scene, draw)};
      for (SurfaceState& surface : make_surfaces(scene, use, options, textures)) {
        draw.surface = std::move(surface);
        PreparedGeometry* drawn = prepared;
        if (draw.surface.normal_unit != kNone && !has_tangents(*prepared, draw.surface.tangents)) {
          const TangentUse& tangents = draw.surface.tangents;
          if (deformed) {
            auto own = prepare_tangents(*prepared, tangents);
            drawn = own.get();
            if (own) list.deformed.push_back(std::move(own));
          } else {
            drawn = geometry.get(mesh, static_cast<int>(i), crease_angle_deg, tangents);
          }
          if (drawn == nullptr) {
            drop_normal_map(draw.surface);
            drawn = prepared;
          }
        }
        draw.geometry = geometry_for(*drawn, draw.surface);
        if (draw.surface.placed_unit != kNone) {
          place_texture(*drawn, geometry.box_of(mesh), options, draw, list);
        }
        list.draws.push_back(draw);
      }
    }
  }
  return list;
}

}  // namespace barrido::scene
