// What single keys do to the options.
#include "viewer/view/commands.h"

#include <gtest/gtest.h>

#include "viewer/barrido/render_option_table.h"

namespace barrido::view {
namespace {

using pipeline::ShadeModel;

const char* const kRoom = BARRIDO_SOURCE_DIR "/models/room.glb";
const char* const kTeapot = BARRIDO_SOURCE_DIR "/models/teapot.glb";

TEST(Commands, ShadingGoesRoundBothWays) {
  cli::RenderOptions options;
  options.shadings = {ShadeModel::flat};
  for (const ShadeModel next :
       {ShadeModel::gouraud, ShadeModel::cheap_phong, ShadeModel::phong, ShadeModel::flat}) {
    cli::step_option(options, "--shading", 1);
    EXPECT_EQ(options.shadings, std::vector{next});
  }
  cli::step_option(options, "--shading", -1);
  EXPECT_EQ(options.shadings, std::vector{ShadeModel::phong});
}

TEST(Commands, FiltersBeginWithTheFiles) {
  cli::RenderOptions options;
  cli::step_option(options, "--min-filter", 1);
  EXPECT_EQ(options.settings.min_filter, raster::MinFilter::nearest);
  cli::step_option(options, "--min-filter", -1);
  EXPECT_FALSE(options.settings.min_filter);
  cli::step_option(options, "--min-filter", -1);
  EXPECT_EQ(options.settings.min_filter, raster::MinFilter::corners);
  cli::step_option(options, "--min-filter", 1);
  EXPECT_FALSE(options.settings.min_filter);
}

TEST(Commands, LightsAreSwitchedByNumber) {
  cli::RenderOptions options;
  toggle_light(options, 2);
  toggle_light(options, 0);
  EXPECT_EQ(options.settings.lights_off, (std::vector{0, 2}));
  toggle_light(options, 2);
  EXPECT_EQ(options.settings.lights_off, std::vector{0});
}

TEST(Commands, ExposureStaysWithinTheOptionsBounds) {
  cli::RenderOptions options;
  for (int i = 0; i < 100; ++i) cli::step_option(options, "--exposure", 0.5f);
  EXPECT_EQ(options.settings.exposure_ev, 32.0f);
}

TEST(Commands, FogBeginsBeforeTheSceneAndEndsBehindIt) {
  Viewer viewer({});
  viewer.open({kTeapot});
  step_fog(viewer);
  ASSERT_TRUE(viewer.active().fog);
  const raster::FogState fog = viewer.active().fog->state;
  EXPECT_EQ(fog.mode, raster::FogMode::linear);
  const Look look = viewer.look().value();
  const double distance = glm::length(look.eye.position - look.bounds.center);
  EXPECT_LT(fog.start, distance);
  EXPECT_GT(fog.end, distance + look.bounds.radius);
  step_fog(viewer);
  EXPECT_EQ(viewer.active().fog->state.mode, raster::FogMode::exp);
  step_fog(viewer);
  EXPECT_EQ(viewer.active().fog->state.mode, raster::FogMode::exp2);
  step_fog(viewer);
  EXPECT_FALSE(viewer.active().fog);
}

TEST(Commands, EnvironmentsGoRound) {
  cli::RenderOptions options;
  options.environment_path = "sky";
  Viewer viewer(options);
  toggle_environment_background(viewer);
  EXPECT_EQ(viewer.active().settings.background, scene::Background::environment);
  step_environment(viewer);
  EXPECT_EQ(viewer.active().environment_path, "");
  EXPECT_EQ(viewer.active().settings.background, scene::Background::color);
  step_environment(viewer);
  EXPECT_TRUE(viewer.active().settings.dynamic_environment);
  step_environment(viewer);
  EXPECT_FALSE(viewer.active().settings.dynamic_environment);
  EXPECT_EQ(viewer.active().environment_path, "sky");
}

/// Lights taken over for editing light the scene as they did in the file, but for the rounding of angles.
TEST(Commands, LightsTakenOverLookTheSame) {
  for (const char* const model : {kRoom, kTeapot}) {
    cli::RenderOptions options;
    options.settings.width = options.settings.height = 64;
    Viewer viewer(options);
    viewer.open({model});
    const Picture before = viewer.draw();
    take_over_lights(viewer);
    EXPECT_FALSE(viewer.active().settings.lights.empty());
    const Difference difference = difference_of(before, viewer.draw());
    EXPECT_LE(difference.largest, 1) << model;
    EXPECT_EQ(viewer.message, "");
  }
}

TEST(Commands, RemovingALightKeepsTheOthersOnOrOff) {
  cli::RenderOptions options;
  options.settings.lights.resize(4);
  options.settings.lights_off = {0, 2, 3};
  remove_light(options, 2);
  EXPECT_EQ(options.settings.lights.size(), 3u);
  EXPECT_EQ(options.settings.lights_off, (std::vector{0, 2}));
  remove_light(options, 3);
  EXPECT_EQ(options.settings.lights.size(), 3u);
}

}  // namespace
}  // namespace barrido::view
