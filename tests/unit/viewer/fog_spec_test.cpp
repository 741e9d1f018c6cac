// Fog from text.
#include <gtest/gtest.h>

#include "viewer/barrido/frame_plan.h"
#include "viewer/barrido/specs.h"
#include "viewer/barrido/values.h"

namespace barrido::cli {
namespace {

TEST(FogSpec, TheThreeModes) {
  const FogChoice linear = parse_fog("linear:2,10:0.5,0.25,1");
  EXPECT_TRUE(linear.state.enabled);
  EXPECT_EQ(linear.state.mode, raster::FogMode::linear);
  EXPECT_EQ(linear.state.start, 2.0f);
  EXPECT_EQ(linear.state.end, 10.0f);
  EXPECT_EQ(linear.color_shown, (std::array<float, 3>{0.5f, 0.25f, 1.0f}));

  const FogChoice exponential = parse_fog("exp:0.25");
  EXPECT_EQ(exponential.state.mode, raster::FogMode::exp);
  EXPECT_EQ(exponential.state.density, 0.25f);
  EXPECT_FALSE(exponential.color_shown.has_value());

  EXPECT_EQ(parse_fog("exp2:1:0,0,0").state.mode, raster::FogMode::exp2);
}

TEST(FogSpec, MistakesAreRefused) {
  for (const char* text : {"", "linear", "linear:", "linear:1", "linear:1,1", "linear:1,2,3",
                           "linear:1,2:0,0", "linear:1,2:0,0,2", "linear:1,2:0,0,0:1", "linear:a,b", "exp",
                           "exp:-1", "exp:nan", "exp:1,2", "exp3:1", "exp2:1:red", "linear:1,inf"}) {
    EXPECT_THROW(parse_fog(text), ValueError) << text;
  }
}

TEST(FogSpec, WithoutAColourItTakesTheBackgroundWhoeverGaveThat) {
  RenderOptions options;
  options.fog = parse_fog("exp:0.5");
  EXPECT_TRUE(resolved_settings(options).fog_takes_background);
  options.fog = parse_fog("exp:0.5:1,0.5,0");
  const scene::RenderSettings settings = resolved_settings(options);
  EXPECT_FALSE(settings.fog_takes_background);
  EXPECT_EQ(settings.fog->color, (std::array{1.0f, 0.5f, 0.0f, 1.0f}));
}

}  // namespace
}  // namespace barrido::cli
