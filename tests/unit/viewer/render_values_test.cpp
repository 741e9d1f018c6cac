// Each option of `barrido render` by itself: what its values become, and which values it refuses.
#include <array>

#include <gtest/gtest.h>

#include "pipeline/names.h"
#include "viewer/barrido/render_options.h"

namespace barrido::cli {
namespace {

RenderOptions parse(const std::string& option, const std::string& value) {
  return parse_render_options(std::vector<std::string>{"a.glb", "-o", "a.png", option, value});
}

RenderOptions parse_flag(const std::string& option) {
  return parse_render_options(std::vector<std::string>{"a.glb", "-o", "a.png", option});
}

scene::RenderSettings settings(const std::string& option, const std::string& value) {
  return parse(option, value).settings;
}

struct Refused {
  const char* option;
  const char* value;
};

/// Each must be told in one line that names the option and the value.
const Refused kRefused[] = {
    {"--resolution", "0,5"},
    {"--resolution", "16385,1"},
    {"--resolution", "1,16385"},
    {"--resolution", "5"},
    {"--resolution", "5,5,5"},
    {"--resolution", "5,5x"},
    {"--resolution", "-5,5"},
    {"--resolution", "nan,5"},
    {"--resolution", "1e3,5"},
    {"--resolution", "640x480"},
    {"--shading", ""},
    {"--shading", "phnog"},
    {"--shading", "flat,"},
    {"--shading", "flat,flat"},
    {"--shading", "flat,all"},
    {"--flat-at", "vertex"},
    {"--cheap-phong-power", "pixels"},
    {"--lighting", "gouraud"},
    {"--color-interpolation", "affine"},
    {"--texture-interpolation", "screen"},
    {"--min-filter", "trilinear"},
    {"--min-filter", "LINEAR"},
    {"--mag-filter", "linear-mipmap-linear"},
    {"--environment", ""},
    {"--bump", ""},
    {"--bump", ":height=1"},
    {"--bump", "a.png:form=flat"},
    {"--bump", "a.png:repeat=0,1"},
    {"--bump", "a.png:height=1:height=2"},
    {"--specularity-map", "a.png:height=1"},
    {"--transparency-map", "a.png:repeat=1"},
    {"--background", "1,1"},
    {"--background", "1,1,1.5"},
    {"--background", "0,0,0,-1"},
    {"--background", "white"},
    {"--fog", "linear"},
    {"--light", "sun"},
    {"--ambient", "1,1"},
    {"--ambient", "-1,0,0"},
    {"--camera-index", "-1"},
    {"--camera-index", "0,0"},
    {"--camera-index", "first"},
    {"--camera-index", "1,"},
    {"--camera-position", "1,2"},
    {"--camera-position", "1,2,inf"},
    {"--camera-focal-point", "x"},
    {"--camera-view-angle", "0"},
    {"--camera-view-angle", "180"},
    {"--up", "Up"},
    {"--up", "0,0,0"},
    {"--up", "+W"},
    {"--azimuth", "361"},
    {"--azimuth", "nan"},
    {"--elevation", "91"},
    {"--turntable", "0"},
    {"--turntable", "1.5"},
    {"--scene", "-1"},
    {"--time", "-1"},
    {"--time", "soon"},
    {"--frames", "5:4"},
    {"--frames", "5"},
    {"--frames", "1:2:3"},
    {"--frames", "-1:2"},
    {"--frames", "0:1000000"},
    {"--animation", "-1"},
    {"--cull", "both"},
    {"--crease-angle", "181"},
    {"--crease-angle", "-1"},
    {"--color-management", "linear"},
    {"--exposure", "33"},
    {"--exposure", "1EV"},
    {"--tone-map", "aces"},
    {"--threads", "0"},
    {"--threads", "1025"},
    {"--threads", "all"},
    {"--simd", "mmx"},
    {"--visibility-first", "yes"},
    {"--compression", "10"},
    {"--compression", "-1"},
};

TEST(RenderValues, ImpossibleValuesAreRefused) {
  for (const Refused& refused : kRefused) {
    const std::string where = std::string(refused.option) + ": '" + refused.value + "': ";
    try {
      parse(refused.option, refused.value);
      ADD_FAILURE() << where << "was accepted";
    } catch (const UsageError& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.substr(0, where.size()), where);
      EXPECT_GT(message.size(), where.size() + 8) << "no reason in: " << message;
      EXPECT_EQ(message.find('\n'), std::string::npos);
    }
  }
  EXPECT_THROW(parse("--fps", "0"), UsageError);
  EXPECT_THROW(parse_flag("--stats=xml"), UsageError);
}

TEST(RenderValues, Output) {
  EXPECT_EQ(settings("--resolution", "1,16384").width, 1);
  EXPECT_EQ(settings("--resolution", "1,16384").height, 16384);
  EXPECT_EQ(parse("--compression", "9").png_compression, 9);
  EXPECT_TRUE(parse("--sheet", "b.glb").sheet);
  EXPECT_TRUE(parse_flag("--hash").hash);
  EXPECT_TRUE(parse_flag("--quiet").quiet);
  EXPECT_EQ(parse_flag("--stats").stats, StatsFormat::text);
  EXPECT_EQ(parse_flag("--stats=text").stats, StatsFormat::text);
  EXPECT_EQ(parse_flag("--stats=json").stats, StatsFormat::json);
}

TEST(RenderValues, Shading) {
  using pipeline::ShadeModel;
  EXPECT_EQ(parse("--shading", "gouraud").shadings, std::vector{ShadeModel::gouraud});
  EXPECT_EQ(parse("--shading", "phong,flat").shadings, (std::vector{ShadeModel::phong, ShadeModel::flat}));
  EXPECT_EQ(parse("--shading", "all").shadings,
            (std::vector{ShadeModel::flat, ShadeModel::gouraud, ShadeModel::cheap_phong, ShadeModel::phong}));
  for (const ShadeModel model : parse("--shading", "all").shadings) {
    EXPECT_EQ(parse("--shading", std::string(name_of(model))).shadings, std::vector{model});
  }
  EXPECT_EQ(settings("--flat-at", "centroid").flat_at, pipeline::FlatAt::centroid);
  EXPECT_EQ(settings("--flat-at", "provoking").flat_at, pipeline::FlatAt::provoking_vertex);
  EXPECT_EQ(settings("--cheap-phong-power", "pixel").cheap_phong_power, pipeline::CheapPhongPower::pixel);
  EXPECT_EQ(settings("--cheap-phong-power", "vertex").cheap_phong_power, pipeline::CheapPhongPower::vertex);
  EXPECT_EQ(settings("--lighting", "phong").lighting, pipeline::SpecularModel::phong);
  EXPECT_EQ(settings("--lighting", "blinn").lighting, pipeline::SpecularModel::blinn);
  EXPECT_EQ(settings("--color-interpolation", "screen").color_interpolation,
            pipeline::ColorInterpolation::screen);
  EXPECT_EQ(settings("--color-interpolation", "perspective").color_interpolation,
            pipeline::ColorInterpolation::perspective);
  EXPECT_EQ(settings("--crease-angle", "30.5").crease_angle_deg, 30.5f);
  EXPECT_EQ(settings("--cull", "none").cull, pipeline::CullFace::none);
  EXPECT_EQ(settings("--cull", "back").cull, pipeline::CullFace::back);
  EXPECT_EQ(settings("--cull", "front").cull, pipeline::CullFace::front);
  EXPECT_TRUE(parse_flag("--wireframe").settings.wireframe);
  EXPECT_EQ(parse("--fog", "exp:0.5").fog->state.density, 0.5f);
}

TEST(RenderValues, Textures) {
  using raster::MinFilter;
  const std::pair<const char*, MinFilter> filters[] = {
      {"nearest", MinFilter::nearest},
      {"linear", MinFilter::linear},
      {"nearest-mipmap-nearest", MinFilter::nearest_mipmap_nearest},
      {"linear-mipmap-nearest", MinFilter::linear_mipmap_nearest},
      {"nearest-mipmap-linear", MinFilter::nearest_mipmap_linear},
      {"linear-mipmap-linear", MinFilter::linear_mipmap_linear}};
  for (const auto& [name, filter] : filters) EXPECT_EQ(settings("--min-filter", name).min_filter, filter);
  EXPECT_EQ(settings("--mag-filter", "nearest").mag_filter, raster::MagFilter::nearest);
  EXPECT_EQ(settings("--mag-filter", "linear").mag_filter, raster::MagFilter::linear);
  EXPECT_FALSE(parse_flag("--no-textures").settings.textures);
  EXPECT_EQ(settings("--texture-interpolation", "affine").texture_interpolation,
            pipeline::TextureInterpolation::affine);
  EXPECT_EQ(settings("--texture-interpolation", "perspective").texture_interpolation,
            pipeline::TextureInterpolation::perspective);
  EXPECT_FALSE(parse_flag("--no-maps").settings.maps.drawn);
  const scene::UserMap bump = *settings("--bump", "a b.png:height=-0.5:form=blinn:repeat=2,3").maps.bump;
  EXPECT_EQ(bump.path, "a b.png");
  EXPECT_EQ(bump.height, -0.5f);
  EXPECT_EQ(bump.form, raster::BumpForm::blinn);
  EXPECT_EQ(bump.repeat, glm::vec2(2, 3));
  EXPECT_EQ(settings("--transparency-map", "t.png").maps.transparency->path, "t.png");
  EXPECT_EQ(settings("--specularity-map", "s.png:repeat=4,1").maps.specularity->repeat, glm::vec2(4, 1));
  EXPECT_EQ(parse("--environment", "sky.hdr").environment_path, "sky.hdr");
  EXPECT_FALSE(parse("--environment", "sky.hdr").settings.dynamic_environment);
  EXPECT_TRUE(parse("--environment", "dynamic").settings.dynamic_environment);
  EXPECT_EQ(parse("--environment", "dynamic").environment_path, "");
}

TEST(RenderValues, LightsAndColours) {
  EXPECT_EQ(settings("--ambient", "0.1,0.2,3").ambient, glm::vec3(0.1f, 0.2f, 3.0f));
  EXPECT_TRUE(parse_flag("--no-lights").settings.no_lights);
  EXPECT_EQ(parse("--background", "0.1,0.2,1").background_shown, (std::array<float, 4>{0.1f, 0.2f, 1, 1}));
  EXPECT_EQ(parse("--background", "0,0,0,0").background_shown, (std::array<float, 4>{0, 0, 0, 0}));
  EXPECT_EQ(settings("--color-management", "none").color_management, scene::ColorManagement::none);
  EXPECT_EQ(settings("--color-management", "srgb").color_management, scene::ColorManagement::srgb);
  EXPECT_EQ(settings("--exposure", "+1.5").exposure_ev, 1.5f);
  EXPECT_EQ(settings("--exposure", "-2").exposure_ev, -2.0f);
  EXPECT_EQ(settings("--tone-map", "reinhard").tone_map, raster::ToneMap::reinhard);
}

TEST(RenderValues, Camera) {
  EXPECT_EQ(parse("--camera-index", "2,0").cameras, (std::vector<int>{2, 0}));
  EXPECT_TRUE(parse("--camera-index", "all").all_cameras);
  EXPECT_TRUE(settings("--camera-index", "none").camera.ignore_file_cameras);
  EXPECT_EQ(settings("--camera-position", "-1,2,3").camera.position, glm::dvec3(-1, 2, 3));
  EXPECT_EQ(settings("--camera-focal-point", "1e3,0,-.5").camera.focal_point, glm::dvec3(1000, 0, -0.5f));
  EXPECT_EQ(settings("--camera-view-angle", "45").camera.view_angle_deg, 45.0f);
  EXPECT_EQ(settings("--up", "+Z").camera.up, glm::vec3(0, 0, 1));
  EXPECT_EQ(settings("--up", "-X").camera.up, glm::vec3(-1, 0, 0));
  EXPECT_EQ(settings("--up", "Y").camera.up, glm::vec3(0, 1, 0));
  EXPECT_EQ(settings("--up", "0,1,1").camera.up, glm::vec3(0, 1, 1));
  EXPECT_EQ(settings("--azimuth", "-30").camera.azimuth_deg, -30.0f);
  EXPECT_EQ(settings("--elevation", "15").camera.elevation_deg, 15.0f);
  EXPECT_EQ(parse("--turntable", "36").turntable, 36);
  EXPECT_EQ(settings("--scene", "1").scene_index, 1);
}

TEST(RenderValues, AnimationAndExecution) {
  EXPECT_EQ(parse("--time", "2.5").time_s, 2.5);
  EXPECT_EQ(parse("--frames", "3:9").frames->first, 3);
  EXPECT_EQ(parse("--frames", "3:9").frames->last, 9);
  EXPECT_EQ(parse("--animation", "2").animation, 2);
  const std::vector<std::string> words{"a.glb", "-o", "a.png", "--frames", "1:2", "--fps", "23.976"};
  EXPECT_EQ(parse_render_options(words).frames_per_second, 23.976);
  EXPECT_EQ(parse("--threads", "3").threads, 3);
  EXPECT_EQ(parse("--simd", "auto").simd, raster::SimdTarget::automatic);
  for (const raster::SimdTarget target : raster::available_simd_targets()) {
    EXPECT_EQ(parse("--simd", std::string(raster::name_of(target))).simd, target);
  }
  EXPECT_FALSE(settings("--visibility-first", "off").visibility_first);
  EXPECT_TRUE(settings("--visibility-first", "on").visibility_first);
}

TEST(RenderValues, InstructionsThatAreNotThereAreNamed) {
  const auto available = raster::available_simd_targets();
  const raster::SimdTarget absent =
      std::count(available.begin(), available.end(), raster::SimdTarget::neon) > 0 ? raster::SimdTarget::avx2
                                                                                   : raster::SimdTarget::neon;
  try {
    parse("--simd", std::string(raster::name_of(absent)));
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("this machine has not got it; it has scalar"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace barrido::cli
