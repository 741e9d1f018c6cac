// The story of a pixel ends in the pixel: random pixels of many scenes, techniques and frame formats.
#include <filesystem>
#include <functional>

#include "pipeline/pictures/environment.h"
#include "tests/unit/inspect/inspect_fixture.h"

namespace barrido::inspect {
namespace {

using pipeline::ShadeModel;
using scene::RenderSettings;

constexpr ShadeModel kModes[] = {ShadeModel::flat, ShadeModel::gouraud, ShadeModel::cheap_phong,
                                 ShadeModel::phong};

RenderSettings small_frame(ShadeModel shading) {
  RenderSettings settings;
  settings.width = 200;
  settings.height = 140;
  settings.shading = shading;
  return settings;
}

/// In float and in 8-bit frames.
void expect_exact_in_both(const scene::Scene& scene, RenderSettings settings, int count,
                          const std::string& what) {
  settings.keep_float = true;
  expect_exact(scene, settings, count, what);
  settings.keep_float = false;
  settings.color_management = scene::ColorManagement::none;
  expect_exact(scene, settings, count, what + " in 8 bits");
}

TEST(ExactStory, EveryModelInEveryMode) {
  for (const char* name :
       {"showcase.glb", "room.glb", "suzanne.glb", "checker_ground.glb", "t_junction.glb"}) {
    const scene::Scene scene = model(name);
    for (const ShadeModel shading : kModes) expect_exact_in_both(scene, small_frame(shading), 80, name);
  }
}

struct Variant {
  const char* name;
  std::function<void(RenderSettings&)> change;
};

scene::UserLight light(scene::Light::Kind kind, const glm::vec3& position, float intensity) {
  scene::UserLight user;
  user.light.kind = kind;
  user.light.exact_intensity = intensity;
  user.light.attenuation = {{0.5f, 0.2f, 0.1f}};
  user.light.range = 12.0f;
  user.light.inner_cone_rad = 0.2f;
  user.light.outer_cone_rad = 0.6f;
  user.position = position;
  user.direction = -position;
  return user;
}

std::shared_ptr<const raster::Texture> sky() {
  const scene::CubeMapImage image = scene::read_environment(std::string(BARRIDO_SOURCE_DIR) + "/models/sky");
  std::array<raster::Pixels8, raster::kCubeFaces> faces;
  for (std::size_t face = 0; face < faces.size(); ++face) {
    faces[face] = {image.size, image.size, image.faces_rgba[face]};
  }
  return std::make_shared<const raster::Texture>(raster::Texture::make_cube(faces, {}));
}

const std::vector<Variant>& variants() {
  static const std::vector<Variant> list{
      {"screen and affine",
       [](RenderSettings& s) {
         s.color_interpolation = pipeline::ColorInterpolation::screen;
         s.texture_interpolation = pipeline::TextureInterpolation::affine;
       }},
      {"R.V, powers at vertices, provoking",
       [](RenderSettings& s) {
         s.lighting = pipeline::SpecularModel::phong;
         s.cheap_phong_power = pipeline::CheapPhongPower::vertex;
         s.flat_at = pipeline::FlatAt::provoking_vertex;
       }},
      {"lights that weaken",
       [](RenderSettings& s) {
         s.lights = {light(scene::Light::Kind::point, {2, 3, 2}, 4.0f),
                     light(scene::Light::Kind::spot, {-2, 3, 3}, 6.0f),
                     light(scene::Light::Kind::directional, {0, 1, 1}, -0.3f)};
       }},
      {"no lights, fog",
       [](RenderSettings& s) {
         s.no_lights = true;
         s.fog.emplace();
         s.fog->enabled = true;
         s.fog->mode = raster::FogMode::exp2;
         s.fog->density = 0.1f;
         s.fog->color = {0.5f, 0.6f, 0.7f, 1.0f};
       }},
      {"sky behind and mirrored, nearest mip level",
       [](RenderSettings& s) {
         s.environment = sky();
         s.background = scene::Background::environment;
         s.min_filter = raster::MinFilter::linear_mipmap_nearest;
         s.mag_filter = raster::MagFilter::nearest;
       }},
      {"dynamic environment", [](RenderSettings& s) { s.dynamic_environment = true; }},
      {"wireframe", [](RenderSettings& s) { s.wireframe = true; }},
      {"no culling", [](RenderSettings& s) { s.cull = pipeline::CullFace::none; }},
      {"front culling", [](RenderSettings& s) { s.cull = pipeline::CullFace::front; }},
      {"exposure and Reinhard",
       [](RenderSettings& s) {
         s.exposure_ev = 1.5f;
         s.tone_map = raster::ToneMap::reinhard;
       }},
      {"eye inside, clipped",
       [](RenderSettings& s) {
         s.camera.position = glm::vec3(0.1f, 1.0f, 0.4f);
         s.camera.focal_point = glm::vec3(0.0f, 0.8f, -1.0f);
         s.cull = pipeline::CullFace::none;
       }},
  };
  return list;
}

TEST(ExactStory, EveryTechnique) {
  for (const char* name : {"showcase.glb", "room.glb"}) {
    const scene::Scene scene = model(name);
    for (const Variant& variant : variants()) {
      for (const ShadeModel shading : kModes) {
        RenderSettings settings = small_frame(shading);
        settings.width = 120;
        settings.height = 90;
        variant.change(settings);
        expect_exact_in_both(scene, settings, 25, std::string(name) + ", " + variant.name);
      }
    }
  }
}

/// Masks, blending, points, lines, skins, morphs, mirrored nodes, vertex colours, two texture sets.
TEST(ExactStory, ConformanceModels) {
  const std::filesystem::path folder = std::string(BARRIDO_SOURCE_DIR) + "/../shared/assets/models";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
  for (const char* name :
       {"AlphaBlendModeTest/glTF-Binary/AlphaBlendModeTest.glb",
        "MeshPrimitiveModes/glTF/MeshPrimitiveModes.gltf", "BoxVertexColors/glTF-Binary/BoxVertexColors.glb",
        "MultiUVTest/glTF-Binary/MultiUVTest.glb", "NegativeScaleTest/glTF-Binary/NegativeScaleTest.glb",
        "TwoSidedPlane/glTF/TwoSidedPlane.gltf", "RiggedFigure/glTF-Binary/RiggedFigure.glb",
        "SimpleMorph/glTF/SimpleMorph.gltf", "UnlitTest/glTF-Binary/UnlitTest.glb",
        "TextureSettingsTest/glTF-Binary/TextureSettingsTest.glb",
        "LightsPunctualLamp/glTF/LightsPunctualLamp.gltf"}) {
    const scene::Scene scene = scene::import_gltf(folder / name, {});
    for (const ShadeModel shading : {ShadeModel::gouraud, ShadeModel::phong, ShadeModel::flat}) {
      expect_exact_in_both(scene, small_frame(shading), 60, name);
    }
  }
}

TEST(ExactStory, EveryInstructionSetTellsTheSame) {
  const scene::Scene scene = model("showcase.glb");
  scene::SceneRenderer renderer(scene);
  RenderSettings settings = small_frame(ShadeModel::cheap_phong);
  const std::vector<PixelPosition> pixels = random_pixels(settings, 12, 3);
  std::vector<std::string> first;
  for (const raster::SimdTarget target : raster::available_simd_targets()) {
    raster::set_simd_target(target);
    std::vector<std::string> told;
    for (const PixelStory& story : inspect_pixels(scene, renderer, settings, pixels)) {
      told.push_back(story_json(story));
    }
    if (first.empty()) first = told;
    EXPECT_EQ(told, first) << raster::name_of(target);
  }
  raster::set_simd_target(raster::SimdTarget::automatic);
}

}  // namespace
}  // namespace barrido::inspect
