// Textures, lights and materials of the generated scenes.
#include "tests/osmesa/parts.h"

namespace barrido::crosscheck {
namespace {

using pipeline::Light;

/// Pattern of one picture: smooth ramps, noise, or a checkerboard with noise.
std::vector<std::uint8_t> picture(RandomBits& random, int width, int height, int pattern) {
  std::vector<std::uint8_t> rgba;
  const int a = random.between(20, 200);
  const int b = random.between(20, 200);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 4; ++c) {
        const int ramp = (a * x / width + b * y / height + 37 * c) / 2;
        const int dark = (x + y) % 2 == 0 ? 0 : 200;
        const int value = pattern == 0   ? ramp
                          : pattern == 1 ? random.between(0, 255)
                                         : dark + random.between(0, 55);
        rgba.push_back(static_cast<std::uint8_t>(value));
      }
    }
  }
  return rgba;
}

glm::vec3 direction(RandomBits& random) {
  const float x = random.number(-1, 1);
  const float y = random.number(-1, 1);
  return {x, y, random.number(0.1f, 1.2f)};
}

}  // namespace

raster::TextureOptions random_wraps(RandomBits& random) {
  raster::TextureOptions options;
  options.wrap_s = random.one_of_first<raster::Wrap>(5);
  options.wrap_t = random.one_of_first<raster::Wrap>(5);
  for (float& c : options.border_color) c = static_cast<float>(random.between(0, 255)) / 255.0f;
  return options;
}

const raster::Texture* add_texture(RandomBits& random, ScenePair& pair, const raster::TextureOptions& options,
                                   int side, bool smooth) {
  const auto any = [&random] { return random.pick({1, 2, 4, 8, 16, 32, 64, 5, 12, 20, 33}); };
  const int width = side != 0 ? side : any();
  const int height = side != 0 ? side : any();
  const auto texels = picture(random, width, height, smooth ? 0 : random.between(0, 2));
  pair.textures.push_back(
      std::make_unique<raster::Texture>(raster::Texture::make_2d({width, height, texels}, options)));
  return pair.textures.back().get();
}

const raster::Texture* add_cube(RandomBits& random, ScenePair& pair, bool mipmaps) {
  const int side = random.pick({1, 4, 8, 16, 24, 32});
  raster::TextureOptions options;
  options.seamless = false;
  options.mipmaps = mipmaps;
  options.wrap_s = options.wrap_t = raster::Wrap::clamp_to_edge;
  std::array<std::vector<std::uint8_t>, raster::kCubeFaces> texels;
  std::array<raster::Pixels8, raster::kCubeFaces> faces;
  for (std::size_t face = 0; face < faces.size(); ++face) {
    texels[face] = picture(random, side, side, random.between(0, 2));
    faces[face] = {side, side, texels[face]};
  }
  pair.textures.push_back(std::make_unique<raster::Texture>(raster::Texture::make_cube(faces, options)));
  return pair.textures.back().get();
}

Light random_light(RandomBits& random, LightKind kind) {
  Light light;
  light.ambient = random_color(random, 0.0f, 0.2f);
  light.diffuse = random_color(random, random.chance(10) ? -0.4f : 0.0f, 0.9f);
  light.specular = random_color(random);
  light.position = {direction(random), 0};
  if (kind == LightKind::directional) return light;
  const glm::vec3 d = direction(random);
  light.position = {3.0f * d.x, 3.0f * d.y, 2.0f * d.z - 3.0f, 1.0f};
  light.constant_attenuation = random.number(0.3f, 1.2f);
  light.linear_attenuation = random.chance(60) ? random.number(0, 0.3f) : 0.0f;
  light.quadratic_attenuation = random.chance(60) ? random.number(0, 0.1f) : 0.0f;
  if (kind == LightKind::point) return light;
  light.spot_direction = glm::vec3(0, 0, -4) - glm::vec3(light.position);
  light.spot_cutoff_deg = random.number(20, 90);
  light.spot_exponent = random.chance(80) ? random.number(0, 40) : 0.0f;
  return light;
}

LightKind any_kind(RandomBits& random) { return random.one_of_first<LightKind>(3); }

pipeline::Material random_material(RandomBits& random) {
  pipeline::Material m;
  m.ambient = random_color(random, 0.0f, 0.5f);
  m.diffuse = random_color(random);
  m.specular = random_color(random);
  m.emission = random_color(random, 0.0f, 0.2f);
  m.shininess = random.chance(15) ? 0.0f : random.number(1, 128);
  return m;
}

}  // namespace barrido::crosscheck
