#include "tests/unit/view/random_options.h"

#include <gtest/gtest.h>

#include <cmath>

#include "viewer/view/commands.h"

namespace barrido::view::testing {
namespace {

template <class Value>
bool same(const Value& a, const Value& b) {
  return a == b;
}

bool same(const scene::UserLight& a, const scene::UserLight& b) {
  return a.space == b.space && a.position == b.position && a.direction == b.direction &&
         a.light.kind == b.light.kind && a.light.color == b.light.color &&
         a.light.exact_intensity == b.light.exact_intensity && a.light.range == b.light.range &&
         a.light.inner_cone_rad == b.light.inner_cone_rad &&
         a.light.outer_cone_rad == b.light.outer_cone_rad && a.light.attenuation == b.light.attenuation &&
         a.light.spot_exponent == b.light.spot_exponent;
}

bool same(const scene::MaterialOverride& a, const scene::MaterialOverride& b) {
  return a.base_color == b.base_color && a.metallic == b.metallic && a.roughness == b.roughness &&
         a.exact.ambient == b.exact.ambient && a.exact.diffuse == b.exact.diffuse &&
         a.exact.specular == b.exact.specular && a.exact.emission == b.exact.emission &&
         a.exact.shininess == b.exact.shininess;
}

bool same(const scene::CameraChoice& a, const scene::CameraChoice& b) {
  return a.ignore_file_cameras == b.ignore_file_cameras && a.position == b.position &&
         a.focal_point == b.focal_point && a.view_angle_deg == b.view_angle_deg && a.up == b.up &&
         a.view_up == b.view_up && a.orthographic_height == b.orthographic_height &&
         a.azimuth_deg == b.azimuth_deg && a.elevation_deg == b.elevation_deg;
}

bool same(const std::optional<cli::FogChoice>& a, const std::optional<cli::FogChoice>& b) {
  if (a.has_value() != b.has_value()) return false;
  return !a || (a->state.mode == b->state.mode && a->state.start == b->state.start &&
                a->state.end == b->state.end && a->state.density == b->state.density &&
                a->color_shown == b->color_shown);
}

}  // namespace

float RandomOptions::number(float largest) {
  const float magnitude = share() * largest;
  return coin() ? magnitude : -magnitude;
}

float RandomOptions::share() { return static_cast<float>(engine_() >> 8) * 0x1p-24f; }

glm::vec3 RandomOptions::vector(float largest) {
  return {number(largest), number(largest), number(largest) + 0.5f};
}

glm::vec3 RandomOptions::color(float largest) {
  return {share() * largest, share() * largest, share() * largest};
}

/// As the window keeps them: what the command line can say.
scene::UserLight RandomOptions::light() {
  using Kind = scene::Light::Kind;
  scene::UserLight user;
  user.space = coin() ? scene::UserLight::Space::camera : scene::UserLight::Space::world;
  user.light.kind = static_cast<Kind>(whole(3));
  if (coin()) user.light.color = color(3.0f);
  user.light.exact_intensity = number(4.0f);
  if (user.light.kind != Kind::point) user.direction = vector(2.0f);
  if (user.light.kind == Kind::directional) return user;
  user.position = vector(100.0f);
  user.light.attenuation = std::array{share() + 0.01f, share(), share()};
  if (coin()) user.light.range = share() * 10.0f;
  if (user.light.kind == Kind::spot) {
    if (coin()) user.light.spot_exponent = share() * 100.0f;
    user.light.outer_cone_rad = share() * 1.5f;
    if (!user.light.spot_exponent) user.light.inner_cone_rad = user.light.outer_cone_rad * share();
  }
  return canonical(user);
}

void RandomOptions::set_camera(cli::RenderOptions& options) {
  scene::CameraChoice& camera = options.settings.camera;
  const int kind = whole(4);
  if (kind == 0) options.cameras = {whole(3)};
  if (kind == 1) camera.ignore_file_cameras = true;
  if (kind >= 2) {
    camera.ignore_file_cameras = true;
    camera.position = vector(1e3f);
    if (coin()) camera.focal_point = vector(1e-3f);
    if (coin()) options.cameras = {whole(3)};
  }
  if (coin()) {
    camera.view_angle_deg = 1.0f + share() * 169.0f;
  } else if (coin()) {
    camera.orthographic_height = share() + 1e-3f;
  }
  if (coin()) camera.view_up = vector(1.0f);
  if (coin()) camera.up = vector(1.0f);
  if (coin()) camera.azimuth_deg = number(360.0f);
  if (coin()) camera.elevation_deg = number(90.0f);
}

void RandomOptions::set_looks(scene::RenderSettings& s) {
  s.flat_at = static_cast<pipeline::FlatAt>(whole(2));
  s.cheap_phong_power = static_cast<pipeline::CheapPhongPower>(whole(2));
  s.lighting = static_cast<pipeline::SpecularModel>(whole(2));
  s.color_interpolation = static_cast<pipeline::ColorInterpolation>(whole(2));
  s.texture_interpolation = static_cast<pipeline::TextureInterpolation>(whole(2));
  if (coin()) s.min_filter = static_cast<raster::MinFilter>(whole(8));
  if (coin()) s.max_anisotropy = 1 + whole(raster::kMaxAnisotropy);
  if (coin()) s.displacement.source = coin() ? "constant" : "a folder/it's $here.png";
  if (coin()) s.displacement.scale = number(10.0f);
  if (coin()) s.displacement.bias = number(10.0f);
  if (coin()) s.displacement.pieces = 1 + whole(scene::kMaxDisplacedPieces);
  if (coin()) s.mag_filter = static_cast<raster::MagFilter>(whole(2));
  if (coin()) s.cull = static_cast<pipeline::CullFace>(whole(3));
  if (coin()) s.crease_angle_deg = share() * 180.0f;
  s.textures = coin();
  s.maps.drawn = coin();
  s.wireframe = coin();
  s.transparency = static_cast<scene::Transparency>(whole(2));
  s.overlays = {coin(), coin(), coin(), coin()};
  s.color_management = static_cast<scene::ColorManagement>(whole(2));
  s.exposure_ev = coin() ? number(32.0f) : 0.0f;
  s.tone_map = static_cast<raster::ToneMap>(whole(2));
}

void RandomOptions::set_texture(cli::RenderOptions& options) {
  scene::TextureChoice& texture = options.settings.texture;
  if (coin()) texture.tiles = static_cast<raster::TileChange>(whole(4));
  if (coin()) {
    texture.mapping.emplace();
    texture.mapping->surface = static_cast<raster::MappingSurface>(1 + whole(4));
    texture.mapping->ray = static_cast<raster::MappingRay>(whole(4));
    texture.mapping->at_vertices = coin();
    texture.mapping->axis = vector(1.0f);
    if (coin()) texture.mapping->centre = vector(10.0f);
    if (coin()) texture.mapping->size = share() + 1e-3f;
    texture.mapping->repeats = {share() + 0.5f, -share() - 0.5f};
    texture.mapping->offset = {share(), number(3.0f)};
  }
  if (coin()) {
    options.texture_path = "a folder/it's $here.png";
    return;
  }
  scene::SolidTexture solid = scene::standard_solid(static_cast<raster::PatternKind>(whole(5)));
  if (coin()) solid.scale = share() + 1e-3f;
  if (coin()) solid.axis = vector(1.0f);
  solid.space = static_cast<scene::SolidTexture::Space>(whole(3));
  if (coin()) solid.pattern.colors[1] = {share(), share(), share(), coin() ? 1.0f : share()};
  if (solid.pattern.kind >= raster::PatternKind::noise && coin()) solid.pattern.octaves = 1 + whole(16);
  if (solid.pattern.kind >= raster::PatternKind::wood && coin()) solid.pattern.turbulence = number(4.0f);
  texture.solid = solid;
}

void RandomOptions::set_material(scene::MaterialOverride& material) {
  if (coin()) material.base_color = color(1.0f);
  if (coin()) material.metallic = share();
  if (coin()) material.roughness = share();
  if (coin()) material.exact.ambient = color(2.0f);
  if (coin()) material.exact.diffuse = color(2.0f);
  if (coin()) material.exact.specular = color(2.0f);
  if (coin()) material.exact.emission = color(2.0f);
  if (coin()) material.exact.shininess = share() * 1e4f;
}

void RandomOptions::set_samples(scene::RenderSettings& s) {
  scene::SampleChoice& samples = s.samples;
  samples.count = 1 + whole(4096);
  samples.sampling = static_cast<scene::Sampling>(whole(3));
  samples.order = static_cast<raster::FilterOrder>(whole(2));
  samples.seed = whole(1'000'000'000);
  samples.adaptive_threshold = share();
  samples.adaptive_depth = 1 + whole(4);
  samples.corners_only = coin();
  // The samples of adaptive sampling have no filter, time and lens.
  if (samples.sampling == scene::Sampling::adaptive) return;
  if (coin()) samples.filter.kind = static_cast<raster::PixelFilterKind>(whole(5));
  samples.filter.radius = coin() ? raster::default_radius(samples.filter.kind) : 0.01f + share() * 7.9f;
  if (coin()) samples.shutter = scene::Shutter{-share(), share()};
  const int lens = whole(3);
  if (lens == 1) samples.lens_radius = share();
  if (lens == 2) samples.f_stop = 0.01f + share();
  const int focus = lens == 0 ? 0 : whole(3);
  if (focus == 1) samples.focus_distance = share() + 1e-3f;
  if (focus == 2) samples.focus_pixel = scene::PixelPlace{whole(s.width), whole(s.height)};
}

cli::RenderOptions RandomOptions::next() {
  cli::RenderOptions options;
  scene::RenderSettings& s = options.settings;
  s.width = 1 + whole(4000);
  s.height = 1 + whole(4000);
  options.shadings = {static_cast<pipeline::ShadeModel>(whole(4))};
  if (coin()) options.views = {static_cast<inspect::StructureView>(whole(inspect::kStructureViewCount))};
  set_looks(s);
  if (coin()) set_samples(s);
  set_camera(options);
  if (coin()) set_material(s.material);
  if (coin()) set_texture(options);
  for (int i = whole(4); i > 0; --i) s.lights.push_back(light());
  if (s.lights.empty()) s.no_lights = coin();
  if (coin()) s.lights_off = {0, 2 + whole(5)};
  if (coin()) s.ambient = color(1.0f);
  if (coin()) {
    s.dynamic_environment = true;
  } else if (coin()) {
    options.environment_path = "a folder/it's $here";
    if (coin()) s.background = scene::Background::environment;
  }
  if (coin() && s.background == scene::Background::color) {
    options.background_shown = std::array{share(), share(), share(), coin() ? 1.0f : share()};
  }
  if (coin()) {
    cli::FogChoice fog;
    fog.state.enabled = true;
    fog.state.mode = static_cast<raster::FogMode>(whole(3));
    if (fog.state.mode == raster::FogMode::linear) {
      fog.state.start = share();
      fog.state.end = 2.0f + share();
    } else {
      fog.state.density = share();
    }
    if (coin()) fog.color_shown = std::array{share(), share(), share()};
    options.fog = fog;
  }
  if (coin()) options.time_s = std::ldexp(static_cast<double>(engine_()), -30);
  if (coin()) options.animation = whole(3);
  if (coin()) options.settings.variant = "variant " + std::to_string(whole(3));
  return options;
}

void expect_same(const cli::RenderOptions& a, const cli::RenderOptions& b) {
#define EXPECT_SAME(field) EXPECT_TRUE(same(a.field, b.field)) << #field
  EXPECT_SAME(shadings);
  EXPECT_SAME(views);
  EXPECT_SAME(environment_path);
  EXPECT_SAME(background_shown);
  EXPECT_SAME(fog);
  EXPECT_SAME(cameras);
  EXPECT_SAME(time_s);
  EXPECT_SAME(animation);
  EXPECT_SAME(settings.variant);
  EXPECT_SAME(settings.width);
  EXPECT_SAME(settings.height);
  EXPECT_SAME(settings.flat_at);
  EXPECT_SAME(settings.cheap_phong_power);
  EXPECT_SAME(settings.lighting);
  EXPECT_SAME(settings.color_interpolation);
  EXPECT_SAME(settings.texture_interpolation);
  EXPECT_SAME(settings.min_filter);
  EXPECT_SAME(settings.mag_filter);
  EXPECT_SAME(settings.max_anisotropy);
  EXPECT_SAME(settings.displacement.source);
  EXPECT_SAME(settings.displacement.scale);
  EXPECT_SAME(settings.displacement.bias);
  EXPECT_SAME(settings.displacement.pieces);
  EXPECT_SAME(settings.textures);
  EXPECT_SAME(settings.maps.drawn);
  EXPECT_SAME(settings.camera);
  EXPECT_SAME(settings.no_lights);
  EXPECT_SAME(settings.lights_off);
  EXPECT_SAME(settings.ambient);
  EXPECT_SAME(settings.dynamic_environment);
  EXPECT_SAME(settings.background);
  EXPECT_SAME(settings.cull);
  EXPECT_SAME(settings.wireframe);
  EXPECT_SAME(settings.transparency);
  EXPECT_SAME(settings.overlays.edges);
  EXPECT_SAME(settings.overlays.normals);
  EXPECT_SAME(settings.overlays.light_markers);
  EXPECT_SAME(settings.overlays.mapping);
  EXPECT_SAME(settings.material);
  EXPECT_SAME(texture_path);
  EXPECT_SAME(settings.texture.solid);
  EXPECT_SAME(settings.texture.mapping);
  EXPECT_SAME(settings.texture.tiles);
  EXPECT_SAME(settings.crease_angle_deg);
  EXPECT_SAME(settings.color_management);
  EXPECT_SAME(settings.exposure_ev);
  EXPECT_SAME(settings.tone_map);
  EXPECT_SAME(settings.samples);
#undef EXPECT_SAME
  ASSERT_EQ(a.settings.lights.size(), b.settings.lights.size());
  for (std::size_t i = 0; i < a.settings.lights.size(); ++i) {
    EXPECT_TRUE(same(a.settings.lights[i], b.settings.lights[i])) << "light " << i;
  }
}

}  // namespace barrido::view::testing
