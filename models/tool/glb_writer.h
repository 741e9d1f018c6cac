// Collects meshes, pictures and nodes into one GLB file (glTF 2.0, sections 3 and 4). Enters: meshes in
// double precision and JSON for what is plain data; leaves: the bytes of the file, the same for the same
// calls. Must not know what the scenes mean.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "models/tool/mesh.h"

namespace barrido::models {

using Json = nlohmann::ordered_json;

/// A mesh and the material it is drawn with (an index from add_material).
struct Part {
  const Mesh* mesh;
  int material;
};

class GlbWriter {
 public:
  /// `title` is the scene's name.
  explicit GlbWriter(const std::string& title);

  /// Embeds a PNG and makes a texture of it that repeats, with trilinear filtering. Returns the texture.
  int add_texture(const std::string& name, std::span<const std::uint8_t> png);
  int add_material(Json material);
  int add_mesh(const std::string& name, std::span<const Part> parts);
  int add_mesh(const std::string& name, const Mesh& mesh, int material);
  /// A light of KHR_lights_punctual.
  int add_light(Json light);
  int add_camera(Json camera);
  /// A root node of the scene. Returns its index.
  int add_node(Json node);
  /// Lets a node turn about its z axis, from x to y, once in so many seconds, for ever the same speed.
  void add_turning(int node, double seconds);
  /// Names an extension in extensionsUsed; lights do so themselves.
  void declare_extension(const std::string& name);
  /// extras.barrido of the scene.
  void set_scene_extras(Json extras);

  std::vector<std::uint8_t> bytes() const;

 private:
  int add_buffer_view(std::span<const std::uint8_t> bytes, int target);
  int add_accessor(const Json& accessor);
  int add_vectors(std::span<const double> values, int components, bool with_bounds);
  int add_indices(const std::vector<std::uint32_t>& indices, std::size_t vertex_count);
  int append_to(const char* array, Json element);

  Json root_;
  std::vector<std::uint8_t> binary_;
};

/// Node placed at `position` whose −Z looks at `target`: for cameras and lights.
Json looking_node(const std::string& name, const Vec3& position, const Vec3& target);

}  // namespace barrido::models
