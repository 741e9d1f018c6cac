// Which surfaces of a scene are displaced, and by what: the user's wish, or the materials' own. Displaced
// surfaces that no pose deforms are kept from frame to frame, and all of them within an account of memory.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/scene/displacement.h"
#include "pipeline/scene/render_scene.h"
#include "pipeline/scene/texture_cache.h"

namespace barrido::scene {

/// Farthest that the settings or the scene's materials move any point, in meshes' own units.
float farthest_displacement(const Scene& scene, const UserDisplacement& user);

class Displacer {
 public:
  Displacer(const Scene& scene, TextureCache& textures) : scene_(scene), textures_(textures) {}

  /// A frame is about to be prepared. Warnings go to `warnings`, which must live until the next.
  void begin_frame(const RenderSettings& settings, std::vector<std::string>& warnings);

  /// The heights of surfaces of this material (kNone: the default one); none where it is not displaced.
  std::optional<HeightMap> heights_of(int material);

  /// The primitive as it is in the file, displaced; the same one while the settings stay. @throws LimitError.
  PreparedGeometry& displaced(int mesh, int primitive, std::optional<float> crease_angle_deg,
                              const HeightMap& heights);

  /// Vertices of this frame alone. @throws LimitError.
  void displace_for_frame(PreparedGeometry& geometry, int mesh, int primitive, const HeightMap& heights);

 private:
  struct Kept {
    std::vector<float> key;
    const raster::Texture* picture = nullptr;
    std::optional<SolidTexture> solid;
    std::uint64_t bytes = 0;
    std::unique_ptr<PreparedGeometry> geometry;
  };

  /// @return bytes that it takes.
  std::uint64_t displace_within(PreparedGeometry& geometry, int mesh, int primitive,
                                const HeightMap& heights);

  const Scene& scene_;
  TextureCache& textures_;
  UserDisplacement user_;
  std::vector<std::string>* warnings_ = nullptr;
  std::uint64_t allowed_ = 0;
  std::uint64_t kept_bytes_ = 0;
  std::uint64_t frame_bytes_ = 0;
  std::map<std::pair<int, int>, Kept> kept_;  ///< By mesh and primitive
};

}  // namespace barrido::scene
