#include "pipeline/scene/displacer.h"

#include <algorithm>
#include <cmath>

#include "pipeline/files/budget.h"
#include "pipeline/files/error.h"

namespace barrido::scene {
namespace {

/// What the user says of the scale, the bias and the pieces counts more than what a material says.
Displacement with_user(Displacement by, const UserDisplacement& user) {
  by.scale = user.scale.value_or(by.scale);
  by.bias = user.bias.value_or(by.bias);
  by.pieces = user.pieces.value_or(by.pieces);
  return by;
}

float farthest(const Displacement& by) { return std::max(std::abs(by.bias), std::abs(by.bias + by.scale)); }

std::string name_of_primitive(int mesh, int primitive) {
  return "meshes[" + std::to_string(mesh) + "].primitives[" + std::to_string(primitive) + "]";
}

}  // namespace

float farthest_displacement(const Scene& scene, const UserDisplacement& user) {
  if (!user.source.empty()) return farthest(with_user({}, user));
  float most = 0.0f;
  for (const Material& material : scene.materials) {
    if (material.displacement) most = std::max(most, farthest(with_user(material.displacement->by, user)));
  }
  return most;
}

void Displacer::begin_frame(const RenderSettings& settings, std::vector<std::string>& warnings) {
  user_ = settings.displacement;
  warnings_ = &warnings;
  allowed_ = Budget({settings.max_memory, std::nullopt}).allowed_memory();
  frame_bytes_ = 0;
}

std::optional<HeightMap> Displacer::heights_of(int material) {
  HeightMap heights;
  if (!user_.source.empty()) {
    heights.picture = user_.picture.get();
    heights.solid = user_.solid;
    heights.by = with_user({}, user_);
    return heights;
  }
  if (material == kNone) return std::nullopt;
  const auto& own = scene_.materials[static_cast<std::size_t>(material)].displacement;
  if (!own) return std::nullopt;
  heights.by = with_user(own->by, user_);
  if (own->texture.texture == kNone) return heights;
  if (!textures_.usable(own->texture.texture)) return std::nullopt;  // That its picture is missing was told.
  TexelUse use;
  use.channels = TexelUse::Channels::red;
  heights.picture = &textures_.get(own->texture.texture, use);
  heights.transform = own->texture.transform;
  heights.texcoord_set = own->texture.texcoord_set;
  return heights;
}

PreparedGeometry& Displacer::displaced(int mesh, int primitive, std::optional<float> crease_angle_deg,
                                       const HeightMap& heights) {
  const Primitive& source =
      scene_.meshes[static_cast<std::size_t>(mesh)].primitives[static_cast<std::size_t>(primitive)];
  std::vector<float> key{crease_angle_deg.value_or(-1.0f), heights.by.scale, heights.by.bias,
                         static_cast<float>(heights.by.pieces), static_cast<float>(heights.texcoord_set)};
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) key.push_back(heights.transform[c][r]);
  }
  Kept& kept = kept_[{mesh, primitive}];
  if (kept.geometry && kept.key == key && kept.picture == heights.picture && kept.solid == heights.solid) {
    return *kept.geometry;
  }
  kept_bytes_ -= kept.bytes;
  kept = {};
  auto geometry = prepare(source, crease_angle_deg);
  const std::uint64_t bytes = displace_within(*geometry, mesh, primitive, heights);
  kept_bytes_ += bytes;
  kept = {std::move(key), heights.picture, heights.solid, bytes, std::move(geometry)};
  return *kept.geometry;
}

void Displacer::displace_for_frame(PreparedGeometry& geometry, int mesh, int primitive,
                                   const HeightMap& heights) {
  frame_bytes_ += displace_within(geometry, mesh, primitive, heights);
}

std::uint64_t Displacer::displace_within(PreparedGeometry& geometry, int mesh, int primitive,
                                         const HeightMap& heights) {
  if (!can_displace(geometry, heights)) {
    warnings_->push_back(name_of_primitive(mesh, primitive) +
                         (heights.picture != nullptr && can_displace(geometry, {})
                              ? " has no texture coordinates: it is not displaced"
                              : " has no triangles: it is not displaced"));
    return 0;
  }
  const std::uint64_t left = allowed_ - std::min(allowed_, kept_bytes_ + frame_bytes_);
  // So that several surfaces find room.
  const int pieces = displacement_pieces(geometry, heights, left / 2);
  const std::uint64_t bytes = displacement_bytes(geometry, pieces);
  if (bytes > left) {
    throw LimitError(scene_.source, name_of_primitive(mesh, primitive),
                     "displaced with " + std::to_string(pieces) + (pieces == 1 ? " piece" : " pieces") +
                         " an edge it needs " + shown_bytes(bytes) + ", more than the " + shown_bytes(left) +
                         " of memory that are left for it (--max-memory allows more)");
  }
  displace(geometry, heights, pieces);
  return bytes;
}

}  // namespace barrido::scene
