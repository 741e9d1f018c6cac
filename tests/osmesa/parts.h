// Internal to the generator: meshes, cameras, textures and lights to make scenes of.
#pragma once

#include "tests/osmesa/generator.h"

namespace barrido::crosscheck {

// Meshes in about [-1, 1]³, with colours, normals and texture coordinates of both units.

/// Independent triangles of random corners. `spread` is the size of one.
Mesh soup(RandomBits& random, int triangles, float spread);
/// A plane of cells × cells quads, bent by `bump`, as an indexed list of triangles.
Mesh bent_plane(RandomBits& random, int cells, float bump, float texture_scale);
/// A closed sphere; the outside is counter-clockwise.
Mesh sphere(RandomBits& random, int slices);
/// Gives the mesh tangents and, where asked for, bitangents of its own.
void add_tangents(RandomBits& random, Mesh& mesh, bool with_bitangents);
/// Planar polygons in one of OpenGL's modes, indexed or not.
Mesh in_mode(RandomBits& random, pipeline::PrimitiveMode mode);
/// Points or lines scattered over the box.
Mesh scattered(RandomBits& random, pipeline::PrimitiveMode mode, int elements);

glm::mat4 translation(float x, float y, float z);
glm::mat4 random_rotation(RandomBits& random);
glm::mat4 random_placement(RandomBits& random);

/// Camera and placement; depth test on. The mesh still has to be given.
DrawCall perspective_draw(RandomBits& random, const ScenePair& pair);
/// w is 1 everywhere.
DrawCall affine_draw(RandomBits& random, const ScenePair& pair);
DrawCall any_draw(RandomBits& random, const ScenePair& pair);

glm::vec4 random_color(RandomBits& random, float low = 0.0f, float high = 1.0f);
raster::TextureOptions random_wraps(RandomBits& random);
/// One of several patterns and sizes, powers of two or not; `side` 0 chooses it.
const raster::Texture* add_texture(RandomBits& random, ScenePair& pair, const raster::TextureOptions& options,
                                   int side = 0, bool smooth = false);
const raster::Texture* add_cube(RandomBits& random, ScenePair& pair, bool mipmaps);

enum class LightKind { directional, point, spot };
/// A light in front of the box that the draws above look at.
pipeline::Light random_light(RandomBits& random, LightKind kind);
LightKind any_kind(RandomBits& random);
pipeline::Material random_material(RandomBits& random);

/// 0^0 in the specular term, where the halfway vector lies behind a surface of shininess 0, is 1 by
/// ARB_vertex_program and 0 in llvmpipe: such draws get a shininess of 1.
void avoid_zero_power(DrawCall& draw);

// Generators of features, one file a group.
/// All functions, sources, operands and scales.
void generate_texture_env_combine(RandomBits& random, raster::TextureUnit& unit);
std::span<const Feature> geometry_features();
std::span<const Feature> lighting_features();
std::span<const Feature> texture_features();
std::span<const Feature> map_features();
std::span<const Feature> procedure_features();
std::span<const Feature> fragment_features();

}  // namespace barrido::crosscheck
