#include "viewer/barrido/map_spec.h"

#include "pipeline/pictures/image_io.h"
#include "pipeline/scene/names.h"
#include "raster/names.h"
#include "viewer/barrido/spec_keys.h"
#include "viewer/barrido/text_format.h"

namespace barrido::cli {
namespace {

using scene::UserMap;

constexpr unsigned kAnyMap = 1, kBump = 2;

constexpr SpecKey<UserMap> kKeys[] = {
    {"repeat", kAnyMap | kBump,
     [](UserMap& map, std::string_view text) {
       const auto [u, v] = parse_tuple<2>(text, "U,V", -1e6, 1e6);
       if (u == 0.0f || v == 0.0f) throw ValueError("expected numbers other than 0");
       map.repeat = {u, v};
     },
     [](const UserMap& map) {
       return map.repeat == glm::vec2(1.0f) ? std::string()
                                            : shortest(map.repeat.x) + "," + shortest(map.repeat.y);
     }},
    {"height", kBump,
     [](UserMap& map, std::string_view text) {
       map.height = static_cast<float>(parse_number(text, -1e6, 1e6));
     },
     [](const UserMap& map) {
       return map.height == UserMap().height ? std::string() : shortest(map.height);
     }},
    {"form", kBump,
     [](UserMap& map, std::string_view text) { map.form = parse_name<raster::BumpForm>(text); },
     [](const UserMap& map) {
       return map.form == UserMap().form ? std::string() : std::string(name_of(map.form));
     }},
};

UserMap parse(std::string_view spec, unsigned kind) {
  const std::vector<std::string_view> pieces = split(spec, ':');
  if (pieces[0].empty()) throw ValueError("expected the path of a picture");
  UserMap map;
  map.path = pieces[0];
  read_keys<UserMap>(map, std::span(pieces).subspan(1), kKeys, {"PATH:KEY=VALUE:...", "this map"}, kind);
  return map;
}

/// The red becomes the alpha of white.
void make_opacity(scene::PixelBytes& rgba) {
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    rgba[i + 3] = rgba[i];
    rgba[i] = rgba[i + 1] = rgba[i + 2] = 255;
  }
}

void load(std::optional<UserMap>& map, MapTexels texels, const scene::RenderSettings& settings,
          scene::Budget* budget) {
  constexpr std::uint64_t kBytesAPixel = 14;  // as it is decoded, and with its mip levels
  if (!map || map->picture) return;
  scene::ImageLimits limits;
  limits.budget = budget;
  limits.bytes_a_pixel = kBytesAPixel;
  scene::Image image = scene::read_image(map->path, limits);
  if (texels == MapTexels::opacity) make_opacity(image.rgba);
  raster::TextureOptions options;
  const bool srgb = settings.color_management == scene::ColorManagement::srgb;
  if (texels == MapTexels::colors && srgb) options.encoding = raster::Encoding::srgb;
  map->picture = std::make_shared<const raster::Texture>(
      raster::Texture::make_2d({image.width, image.height, image.rgba}, options));
}

}  // namespace

UserMap parse_bump(std::string_view spec) { return parse(spec, kBump); }
UserMap parse_map(std::string_view spec) { return parse(spec, kAnyMap); }
std::string bump_text(const UserMap& map) { return write_keys<UserMap>(map.path, map, kKeys, kBump); }
std::string map_text(const UserMap& map) { return write_keys<UserMap>(map.path, map, kKeys, kAnyMap); }

std::vector<std::string> map_paths(const scene::RenderSettings& settings) {
  std::vector<std::string> paths;
  for (const auto* map : {&settings.maps.bump, &settings.maps.transparency, &settings.maps.specularity}) {
    if (*map) paths.push_back((*map)->path);
  }
  return paths;
}

void load_maps(scene::RenderSettings& settings, scene::Budget* budget) {
  scene::MapOverride& maps = settings.maps;
  load(maps.bump, MapTexels::values, settings, budget);
  load(maps.transparency, MapTexels::opacity, settings, budget);
  load(maps.specularity, MapTexels::colors, settings, budget);
}

}  // namespace barrido::cli
